//! How an array's bytes lie in a file: a length and the bytes, or a table of
//! lengths and zlib blocks.
//!
//! ```text
//! plain        n · n bytes
//! compressed   blocks · size of a block · size of the last one, 0 if full ·
//!              compressed size of each · the blocks
//! ```
//! Header words have 4 or 8 bytes, as the file's `header_type` says.

use std::borrow::Cow;
use std::io::Read;

use flate2::Compression;
use flate2::read::{ZlibDecoder, ZlibEncoder};
use rayon::prelude::*;

use super::number::ByteOrder;

/// Bytes compressed at a time: small enough to use all threads, large enough to
/// compress well.
const BLOCK: usize = 128 << 10;

/// Deflate cannot do better than 1032 to 1 (zlib's own technical notes); a
/// header that claims more is false, and is refused before anything is allocated.
const DEFLATE_LIMIT: u64 = 1032;

/// How the arrays of one file are packed.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Packing {
    /// Of header words and numbers.
    pub(crate) order: ByteOrder,
    /// Bytes a header word: 4 or 8.
    pub(crate) header_width: usize,
    /// Whether arrays come in zlib blocks.
    pub(crate) compressed: bool,
}

/// The compressed form of `bytes`, with header words of eight little-endian bytes.
pub(crate) fn compress(bytes: &[u8], level: u32) -> std::io::Result<Vec<u8>> {
    let blocks: Vec<Vec<u8>> = bytes
        .par_chunks(BLOCK)
        .map(|block| {
            let mut packed = Vec::with_capacity(block.len() / 2);
            ZlibEncoder::new(block, Compression::new(level)).read_to_end(&mut packed)?;
            Ok(packed)
        })
        .collect::<std::io::Result<_>>()?;
    let header = [blocks.len(), BLOCK, bytes.len() % BLOCK];
    let mut packed = Vec::new();
    for word in header.into_iter().chain(blocks.iter().map(Vec::len)) {
        packed.extend_from_slice(&(word as u64).to_le_bytes());
    }
    for block in blocks {
        packed.extend_from_slice(&block);
    }
    Ok(packed)
}

/// The bytes of the array that `packed` starts with; what follows it is ignored.
pub(crate) fn unpack(packed: Cow<'_, [u8]>, packing: Packing) -> Result<Cow<'_, [u8]>, String> {
    let mut words = Words { bytes: &packed, packing };
    if packing.compressed {
        return decompress(words).map(Cow::Owned);
    }
    let length = words.next()?;
    let available = words.bytes.len();
    if length > available as u64 {
        return Err(format!("is cut off: {length} bytes announced, {available} left in the file"));
    }
    let range = packing.header_width..packing.header_width + length as usize;
    Ok(match packed {
        Cow::Borrowed(bytes) => Cow::Borrowed(&bytes[range]),
        Cow::Owned(mut bytes) => {
            bytes.truncate(range.end);
            bytes.drain(..range.start);
            Cow::Owned(bytes)
        }
    })
}

/// Header words, one after the other, and what is left behind them.
struct Words<'a> {
    bytes: &'a [u8],
    packing: Packing,
}

impl Words<'_> {
    fn next(&mut self) -> Result<u64, String> {
        let width = self.packing.header_width;
        let Some((word, rest)) = self.bytes.split_at_checked(width) else {
            return Err("is cut off in its header".into());
        };
        self.bytes = rest;
        let mut wide = [0; 8];
        Ok(match self.packing.order {
            ByteOrder::Little => {
                wide[..width].copy_from_slice(word);
                u64::from_le_bytes(wide)
            }
            ByteOrder::Big => {
                wide[8 - width..].copy_from_slice(word);
                u64::from_be_bytes(wide)
            }
        })
    }
}

fn decompress(mut words: Words<'_>) -> Result<Vec<u8>, String> {
    let count = words.next()?;
    if count == 0 {
        return Ok(Vec::new());
    }
    let (block_size, last_size) = (words.next()?, words.next()?);
    if count > (words.bytes.len() / words.packing.header_width) as u64 {
        return Err(format!("announces {count} blocks, more than the file can hold"));
    }
    let sizes = (0..count).map(|_| words.next()).collect::<Result<Vec<u64>, _>>()?;
    let mut rest = words.bytes;
    let mut blocks = Vec::new();
    for (index, size) in sizes.into_iter().enumerate() {
        let Some((packed, behind)) =
            usize::try_from(size).ok().and_then(|n| rest.split_at_checked(n))
        else {
            return Err(format!(
                "is cut off: block {index} announces {size} bytes, {} left in the file",
                rest.len()
            ));
        };
        let is_last = index as u64 + 1 == count;
        let unpacked = if is_last && last_size != 0 { last_size } else { block_size };
        if unpacked > size.saturating_mul(DEFLATE_LIMIT) {
            return Err(format!(
                "announces {unpacked} bytes from the {size} of block {index}, \
                 more than zlib can pack"
            ));
        }
        blocks.push((packed, unpacked as usize));
        rest = behind;
    }
    let unpacked: Vec<Vec<u8>> = blocks
        .par_iter()
        .enumerate()
        .map(|(index, &(packed, size))| inflate(index, packed, size))
        .collect::<Result<_, _>>()?;
    Ok(unpacked.concat())
}

fn inflate(index: usize, packed: &[u8], size: usize) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::with_capacity(size);
    // One byte more than announced, to see that there is no more.
    ZlibDecoder::new(packed)
        .take(size as u64 + 1)
        .read_to_end(&mut bytes)
        .map_err(|reason| format!("has a damaged zlib block {index} ({reason})"))?;
    if bytes.len() != size {
        return Err(format!(
            "has a zlib block {index} of another size than the {size} bytes announced"
        ));
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    const PACKING: Packing =
        Packing { order: ByteOrder::Little, header_width: 8, compressed: true };

    #[test]
    fn blocks_come_back_for_lengths_round_the_block_size() {
        for length in [0, 1, BLOCK - 1, BLOCK, BLOCK + 1, 3 * BLOCK] {
            let bytes: Vec<u8> = (0..length).map(|i| ((i * i) >> 7) as u8).collect();
            let packed = compress(&bytes, 1).unwrap();
            assert_eq!(packed[..8], (length.div_ceil(BLOCK) as u64).to_le_bytes());
            assert_eq!(unpack(Cow::Owned(packed), PACKING).unwrap(), bytes);
        }
    }

    #[test]
    fn a_false_size_is_refused_before_it_is_allocated() {
        let mut packed = compress(&[7; 100], 1).unwrap();
        packed[16..24].copy_from_slice(&(1u64 << 60).to_le_bytes());
        let message = unpack(Cow::Owned(packed), PACKING).unwrap_err();
        assert!(message.contains("more than zlib can pack"), "{message}");
    }

    #[test]
    fn header_words_follow_the_byte_order() {
        let packing = Packing { order: ByteOrder::Big, header_width: 4, compressed: false };
        let bytes = [0, 0, 0, 2, 5, 6, 9];
        assert_eq!(&*unpack(Cow::Borrowed(&bytes), packing).unwrap(), [5, 6]);
    }
}
