//! Names of arrays in legacy files, which end at the first blank: VTK writes
//! other bytes than printable ASCII as `%` and two hexadecimal digits.

/// A name as a legacy file spells it.
pub(super) fn encode(name: &str) -> String {
    let mut encoded = String::with_capacity(name.len());
    for byte in name.bytes() {
        match byte {
            b'%' | b'"' | 0..=32 | 127.. => encoded.push_str(&format!("%{byte:02X}")),
            _ => encoded.push(char::from(byte)),
        }
    }
    encoded
}

/// The name that a legacy file spells so; what is no code stays as it is.
pub(super) fn decode(name: &str) -> String {
    let mut bytes = Vec::with_capacity(name.len());
    let mut rest = name.as_bytes();
    while let Some((&first, behind)) = rest.split_first() {
        let code = name_code(first, behind);
        bytes.push(code.unwrap_or(first));
        rest = if code.is_some() { &behind[2..] } else { behind };
    }
    String::from_utf8(bytes).unwrap_or_else(|_| name.to_string())
}

fn name_code(first: u8, behind: &[u8]) -> Option<u8> {
    let digit = |byte: u8| char::from(byte).to_digit(16);
    match (first, behind) {
        (b'%', [high, low, ..]) => Some((digit(*high)? * 16 + digit(*low)?) as u8),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_come_back() {
        // The spelling of the second is what VTK 9.7 writes for it.
        for (name, spelled) in [("u", "u"), ("größe", "gr%C3%B6%C3%9Fe"), ("a b%", "a%20b%25")] {
            assert_eq!(encode(name), spelled);
            assert_eq!(decode(spelled), name);
        }
        assert_eq!(decode("100%"), "100%");
        assert_eq!(decode("%zz%F"), "%zz%F");
    }
}
