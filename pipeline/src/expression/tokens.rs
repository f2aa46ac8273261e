//! Numbers, names and signs of an expression.

use super::fault::Fault;

/// A piece of the text and the byte where it begins.
#[derive(Debug, Clone, Copy)]
pub(super) struct Token<'a> {
    pub(super) at: usize,
    pub(super) text: &'a str,
    pub(super) kind: Kind,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Kind {
    Number(f64),
    Name,
    Sign,
    End,
}

/// Longer signs before those that they begin with.
const SIGNS: [&str; 15] =
    ["<=", ">=", "==", "!=", "+", "-", "*", "/", "^", "(", ")", ",", "<", ">", "="];

/// Cuts a text; the last token is the end.
pub(super) fn tokens(text: &str) -> Result<Vec<Token<'_>>, Fault> {
    let mut tokens = Vec::new();
    let mut at = 0;
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        if first.is_whitespace() {
            at += first.len_utf8();
            continue;
        }
        let (len, kind) = if let Some(len) = number_len(rest) {
            let number = rest[..len].parse().expect("digits, a point and an exponent");
            (len, Kind::Number(number))
        } else if first.is_ascii_alphabetic() || first == '_' {
            let end = rest.find(|c: char| !c.is_ascii_alphanumeric() && c != '_');
            (end.unwrap_or(rest.len()), Kind::Name)
        } else if let Some(sign) = SIGNS.iter().find(|sign| rest.starts_with(**sign)) {
            if *sign == "=" {
                return Err(Fault { at, message: "unexpected `=`; to compare, write `==`".into() });
            }
            (sign.len(), Kind::Sign)
        } else {
            return Err(Fault { at, message: format!("unexpected character `{first}`") });
        };
        tokens.push(Token { at, text: &rest[..len], kind });
        at += len;
    }
    tokens.push(Token { at, text: "", kind: Kind::End });
    Ok(tokens)
}

/// The length of the number at the start: digits with a point, then perhaps an
/// exponent with digits.
fn number_len(text: &str) -> Option<usize> {
    let digits = |from: usize| text[from..].bytes().take_while(u8::is_ascii_digit).count();
    let whole = digits(0);
    let mut len = whole;
    if text[len..].starts_with('.') {
        let fraction = digits(len + 1);
        if whole + fraction == 0 {
            return None;
        }
        len += 1 + fraction;
    }
    if len == 0 {
        return None;
    }
    if text[len..].starts_with(['e', 'E']) {
        let sign = usize::from(text[len + 1..].starts_with(['+', '-']));
        let exponent = digits(len + 1 + sign);
        if exponent > 0 {
            len += 1 + sign + exponent;
        }
    }
    Some(len)
}
