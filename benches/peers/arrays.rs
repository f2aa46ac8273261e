//! Flat arrays as NumPy's files (version 1.0): a magic word, a line of text that
//! names type and shape, then the numbers, little end first.

use anyhow::{Context, Result, ensure};
use std::fs::{self, File};
use std::io::{BufReader, BufWriter, Read, Write};
use std::path::Path;

/// A number that such a file can hold.
pub trait Number: Sized {
    /// NumPy's name of its type.
    const TYPE: &'static str;
    /// Its bytes, little end first.
    type Bytes: AsRef<[u8]> + AsMut<[u8]> + Default;
    fn to_bytes(&self) -> Self::Bytes;
    fn from_bytes(bytes: Self::Bytes) -> Self;
}

impl Number for f64 {
    const TYPE: &'static str = "<f8";
    type Bytes = [u8; 8];
    fn to_bytes(&self) -> [u8; 8] {
        self.to_le_bytes()
    }
    fn from_bytes(bytes: [u8; 8]) -> Self {
        Self::from_le_bytes(bytes)
    }
}

/// Indices: the peers number by signed integers.
impl Number for i32 {
    const TYPE: &'static str = "<i4";
    type Bytes = [u8; 4];
    fn to_bytes(&self) -> [u8; 4] {
        self.to_le_bytes()
    }
    fn from_bytes(bytes: [u8; 4]) -> Self {
        Self::from_le_bytes(bytes)
    }
}

const MAGIC: &[u8; 8] = b"\x93NUMPY\x01\x00";
/// The text ends where the numbers may begin, at a multiple of this.
const ALIGNMENT: usize = 64;

/// Writes one array; any shape is for the reader to make.
pub fn write<N: Number>(path: &Path, numbers: impl ExactSizeIterator<Item = N>) -> Result<()> {
    let about = || format!("cannot write {}", path.display());
    let (kind, count) = (N::TYPE, numbers.len());
    let text = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({count},)}}");
    let begin = (MAGIC.len() + 2 + text.len() + 1).next_multiple_of(ALIGNMENT);
    let width = begin - MAGIC.len() - 2 - 1;
    let mut file = BufWriter::new(File::create(path).with_context(about)?);
    file.write_all(MAGIC).with_context(about)?;
    file.write_all(&(width as u16 + 1).to_le_bytes()).with_context(about)?;
    writeln!(file, "{text:width$}").with_context(about)?;
    for number in numbers {
        file.write_all(number.to_bytes().as_ref()).with_context(about)?;
    }
    file.flush().with_context(about)
}

/// Reads an array that [`write`] wrote.
pub fn read<N: Number>(path: &Path) -> Result<Vec<N>> {
    let about = || format!("cannot read {}", path.display());
    let bytes = fs::metadata(path).with_context(about)?.len() as usize;
    let mut file = BufReader::new(File::open(path).with_context(about)?);
    let (mut magic, mut length) = ([0; MAGIC.len()], [0; 2]);
    file.read_exact(&mut magic).with_context(about)?;
    file.read_exact(&mut length).with_context(about)?;
    let mut text = vec![0; u16::from_le_bytes(length).into()];
    file.read_exact(&mut text).with_context(about)?;
    let right = magic == *MAGIC && String::from_utf8_lossy(&text).contains(N::TYPE);
    ensure!(right, "{} is no array of {}, as `write` makes them", path.display(), N::TYPE);
    let rest = bytes - MAGIC.len() - length.len() - text.len();
    let number = |_| {
        let mut bytes = N::Bytes::default();
        file.read_exact(bytes.as_mut()).with_context(about)?;
        Ok(N::from_bytes(bytes))
    };
    (0..rest / size_of::<N>()).map(number).collect()
}
