//! Base64 as VTK files use it: several padded pieces may follow each other.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// The bytes behind `text`, whose white space does not count. Some writers
/// encode an array's header apart from its data, so padding may occur inside.
pub(crate) fn decode(text: &[u8]) -> Result<Vec<u8>, String> {
    let dense: Vec<u8> = text.iter().copied().filter(|byte| !byte.is_ascii_whitespace()).collect();
    let mut bytes = Vec::with_capacity(dense.len() / 4 * 3);
    let mut rest = dense.as_slice();
    while !rest.is_empty() {
        // A piece ends with the group of four characters that has the first padding.
        let padding = rest.iter().position(|&byte| byte == b'=').unwrap_or(rest.len());
        let end = (padding / 4 * 4 + 4).min(rest.len());
        STANDARD
            .decode_vec(&rest[..end], &mut bytes)
            .map_err(|reason| format!("is not valid base64 ({reason})"))?;
        rest = &rest[end..];
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::decode;

    #[test]
    fn pieces_with_padding_of_their_own_are_joined() {
        // RFC 4648, section 10: "f" is Zg==, "fo" is Zm8=, "foobar" is Zm9vYmFy.
        assert_eq!(decode(b" Zg==\n Zm9v YmFy\n").unwrap(), b"ffoobar");
        assert_eq!(decode(b"Zm8=Zg==").unwrap(), b"fof");
        assert_eq!(decode(b"").unwrap(), b"");
    }

    #[test]
    fn other_characters_and_cut_pieces_are_refused() {
        for text in [&b"Zm9v!mFy"[..], b"Zm9vY", b"=", b"Zg=", b"Zg==="] {
            assert!(decode(text).is_err(), "{}", String::from_utf8_lossy(text));
        }
    }
}
