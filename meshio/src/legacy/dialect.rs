//! Spellings that VTK writes since version 9 and vtkio does not know.

use std::borrow::Cow;

/// Types of 64 bits in the header line of an array, and what vtkio calls them,
/// padded with blanks: bytes keep their places, which messages refer to.
const SPELLINGS: [(&[u8], &[u8]); 2] =
    [(b" vtktypeint64\n", b" long        \n"), (b" vtktypeuint64\n", b" unsigned_long\n")];

/// The bytes with the types of arrays that are called by their counts (`name 3 64 type`)
/// spelled as vtkio knows them.
/// In binary data such a line is too long to occur by chance.
pub(super) fn respelled(bytes: &[u8]) -> Cow<'_, [u8]> {
    let mut bytes = Cow::Borrowed(bytes);
    for (theirs, known) in SPELLINGS {
        let mut from = 0;
        while let Some(step) = bytes[from..].windows(theirs.len()).position(|part| part == theirs) {
            let start = from + step;
            let end = start + theirs.len();
            // OFFSETS and CONNECTIVITY, which vtkio reads in this spelling, have no counts.
            if start > 0 && bytes[start - 1].is_ascii_digit() {
                bytes.to_mut()[start..end].copy_from_slice(known);
            }
            from = end;
        }
    }
    bytes
}

#[cfg(test)]
mod tests {
    #[test]
    fn arrays_with_counts_are_respelled_in_place() {
        let bytes = b"OFFSETS vtktypeint64\nu 1 4 vtktypeint64\nw 3 4 vtktypeuint64\n";
        let expected = b"OFFSETS vtktypeint64\nu 1 4 long        \nw 3 4 unsigned_long\n";
        assert_eq!(super::respelled(bytes), &expected[..]);
    }
}
