//! From tokens to code, by recursive descent: a function for each strength of
//! binding.

use octruss_base::suggestion::suggestion;

use super::code::{Binary, Op, STACK, Unary};
use super::fault::Fault;
use super::names::{CONSTANTS, COORDINATES, FUNCTIONS, values};
use super::tokens::{Kind, Token};

/// Parentheses and signs may nest this deep, so that no text exhausts the
/// program's own stack.
const DEPTH: usize = 64;

/// The code of a whole expression.
pub(super) fn parse(tokens: &[Token]) -> Result<Vec<Op>, Fault> {
    let mut parser = Parser { tokens, at: 0, depth: 0, waiting: 0, code: Vec::new() };
    parser.or()?;
    match parser.next() {
        Token { kind: Kind::End, .. } => Ok(parser.code),
        token => Err(unexpected("an operator", token)),
    }
}

struct Parser<'a> {
    tokens: &'a [Token<'a>],
    at: usize,
    depth: usize,
    /// Values on the stack when the code so far has run.
    waiting: usize,
    code: Vec<Op>,
}

type Parsed = Result<(), Fault>;
type Level<'a> = fn(&mut Parser<'a>) -> Parsed;

impl<'a> Parser<'a> {
    fn or(&mut self) -> Parsed {
        self.left_to_right(Self::and, &[("or", |a, b| truth(a != 0.0 || b != 0.0))])
    }

    fn and(&mut self) -> Parsed {
        self.left_to_right(Self::comparison, &[("and", |a, b| truth(a != 0.0 && b != 0.0))])
    }

    fn comparison(&mut self) -> Parsed {
        const SIGNS: [(&str, Binary); 6] = [
            ("<", |a, b| truth(a < b)),
            ("<=", |a, b| truth(a <= b)),
            (">", |a, b| truth(a > b)),
            (">=", |a, b| truth(a >= b)),
            ("==", |a, b| truth(a == b)),
            ("!=", |a, b| truth(a != b)),
        ];
        self.sum()?;
        let Some(apply) = self.take(&SIGNS) else { return Ok(()) };
        self.sum()?;
        self.emit(Op::Binary(apply))?;
        let at = self.peek().at;
        if self.take(&SIGNS).is_some() {
            let message = "comparisons do not chain; join them with `and`".into();
            return Err(Fault { at, message });
        }
        Ok(())
    }

    fn sum(&mut self) -> Parsed {
        self.left_to_right(Self::product, &[("+", |a, b| a + b), ("-", |a, b| a - b)])
    }

    fn product(&mut self) -> Parsed {
        self.left_to_right(Self::sign, &[("*", |a, b| a * b), ("/", |a, b| a / b)])
    }

    fn sign(&mut self) -> Parsed {
        const SIGNS: [(&str, Unary); 3] =
            [("-", |a| -a), ("+", |a| a), ("not", |a| truth(a == 0.0))];
        match self.take(&SIGNS) {
            Some(apply) => {
                // `not x > 1` denies the comparison.
                let is_not = self.tokens[self.at - 1].text == "not";
                self.nested(if is_not { Self::comparison } else { Self::sign })?;
                self.emit(Op::Unary(apply))
            }
            None => self.power(),
        }
    }

    fn power(&mut self) -> Parsed {
        self.atom()?;
        let sign: [(&str, Binary); 1] = [("^", f64::powf)];
        if let Some(apply) = self.take(&sign) {
            // The exponent may have a sign, and further powers.
            self.nested(Self::sign)?;
            self.emit(Op::Binary(apply))?;
        }
        Ok(())
    }

    fn atom(&mut self) -> Parsed {
        let token = self.next();
        match token.kind {
            Kind::Number(number) => self.emit(Op::Number(number)),
            Kind::Name => self.name(token),
            Kind::Sign if token.text == "(" => {
                self.nested(Self::or)?;
                self.close()
            }
            _ => Err(unexpected("a number, a name or `(`", token)),
        }
    }

    fn name(&mut self, token: Token) -> Parsed {
        let name = token.text;
        let function = FUNCTIONS.iter().find(|(known, _)| *known == name);
        let is_call = self.peek().text == "(";
        if let Some(axis) = COORDINATES.iter().position(|known| *known == name) {
            return self.emit(Op::Coordinate(axis));
        }
        if let Some((_, number)) = CONSTANTS.iter().find(|(known, _)| *known == name) {
            return self.emit(Op::Number(*number));
        }
        match function {
            Some((_, op)) if is_call => self.call(token, *op),
            Some(_) => {
                let message = format!("`{name}` is a function: `{name}(…)`");
                Err(Fault { at: token.at, message })
            }
            None => Err(unknown(token, is_call)),
        }
    }

    fn call(&mut self, name: Token, op: Op) -> Parsed {
        self.next();
        let mut found = 0;
        loop {
            self.nested(Self::or)?;
            found += 1;
            let comma: [(&str, ()); 1] = [(",", ())];
            if self.take(&comma).is_none() {
                break;
            }
        }
        self.close()?;
        if found != op.operands() {
            let expected = match op.operands() {
                1 => "1 value",
                2 => "2 values",
                _ => "3 values (condition, then, else)",
            };
            let message = format!("`{}` takes {expected}, found {found}", name.text);
            return Err(Fault { at: name.at, message });
        }
        self.emit(op)
    }

    /// Operands of one strength, joined by operators from the left.
    fn left_to_right(&mut self, operand: Level<'a>, operators: &[(&str, Binary)]) -> Parsed {
        operand(self)?;
        while let Some(apply) = self.take(operators) {
            operand(self)?;
            self.emit(Op::Binary(apply))?;
        }
        Ok(())
    }

    fn nested(&mut self, inner: Level<'a>) -> Parsed {
        self.depth += 1;
        if self.depth > DEPTH {
            return Err(self.too_deep(DEPTH));
        }
        inner(self)?;
        self.depth -= 1;
        Ok(())
    }

    fn emit(&mut self, op: Op) -> Parsed {
        self.waiting = self.waiting + 1 - op.operands();
        if self.waiting > STACK {
            return Err(self.too_deep(STACK));
        }
        self.code.push(op);
        Ok(())
    }

    fn too_deep(&self, limit: usize) -> Fault {
        let at = self.tokens[self.at.saturating_sub(1)].at;
        Fault { at, message: format!("nested more than {limit} deep") }
    }

    fn close(&mut self) -> Parsed {
        match self.next() {
            Token { text: ")", .. } => Ok(()),
            token => Err(unexpected("`)`", token)),
        }
    }

    fn peek(&self) -> Token<'a> {
        self.tokens[self.at]
    }

    /// The next token; the end stays.
    fn next(&mut self) -> Token<'a> {
        let token = self.peek();
        self.at = (self.at + 1).min(self.tokens.len() - 1);
        token
    }

    /// Takes the next token if it is one of these, with what belongs to it.
    fn take<T: Copy>(&mut self, among: &[(&str, T)]) -> Option<T> {
        let found = among.iter().find(|(text, _)| *text == self.peek().text)?;
        self.next();
        Some(found.1)
    }
}

fn unexpected(expected: &str, token: Token) -> Fault {
    let found = match token.kind {
        Kind::End => "its end".into(),
        _ => format!("`{}`", token.text),
    };
    Fault { at: token.at, message: format!("expected {expected}, found {found}") }
}

fn unknown(token: Token, is_call: bool) -> Fault {
    let name = token.text;
    let message = if name == "log" {
        "unknown function `log`; write `ln` or `log10`".into()
    } else if is_call {
        let functions = FUNCTIONS.map(|(name, _)| name);
        format!("unknown function `{name}`{}", suggestion(name, &functions))
    } else {
        // So few short names that a guess would only mislead.
        format!("unknown name `{name}` (valid: {})", values().join(", "))
    };
    Fault { at: token.at, message }
}

fn truth(holds: bool) -> f64 {
    f64::from(u8::from(holds))
}
