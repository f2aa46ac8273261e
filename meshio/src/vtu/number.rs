//! The ten number types of VTK, and bytes of them widened.

use rayon::prelude::*;

/// A number type as VTK's XML files name it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum NumberType {
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Int64,
    UInt64,
    Float32,
    Float64,
}

use NumberType::*;

impl NumberType {
    const ALL: [Self; 10] =
        [Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float32, Float64];

    /// The type that files call `name`.
    pub(crate) fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }

    /// What files call it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Int8 => "Int8",
            UInt8 => "UInt8",
            Int16 => "Int16",
            UInt16 => "UInt16",
            Int32 => "Int32",
            UInt32 => "UInt32",
            Int64 => "Int64",
            UInt64 => "UInt64",
            Float32 => "Float32",
            Float64 => "Float64",
        }
    }

    /// Bytes a number.
    pub(crate) fn width(self) -> usize {
        match self {
            Int8 | UInt8 => 1,
            Int16 | UInt16 => 2,
            Int32 | UInt32 | Float32 => 4,
            Int64 | UInt64 | Float64 => 8,
        }
    }

    /// Whether it is a floating-point type.
    pub(crate) fn is_float(self) -> bool {
        matches!(self, Float32 | Float64)
    }
}

/// Which end of a number comes first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ByteOrder {
    Little,
    Big,
}

/// A whole number to widen or narrow into: `u32` vertex numbers, `i64` values …
pub(crate) trait Whole: TryFrom<i128> + Copy + Send {}
impl<T: TryFrom<i128> + Copy + Send> Whole for T {}

/// A number type that files hold.
trait Stored: Sized {
    const WIDTH: usize = size_of::<Self>();
    /// The number in the first `WIDTH` bytes.
    fn load(bytes: &[u8], order: ByteOrder) -> Self;
    fn float(self) -> f64;
    /// The same value as a whole number; `None` if it is not whole or does not fit.
    fn whole<T: Whole>(self) -> Option<T>;
}

macro_rules! stored {
    ($($number:ty, $whole:expr);* $(;)?) => {$(
        impl Stored for $number {
            #[inline]
            fn load(bytes: &[u8], order: ByteOrder) -> Self {
                let mut exact = [0; size_of::<Self>()];
                exact.copy_from_slice(bytes);
                match order {
                    ByteOrder::Little => Self::from_le_bytes(exact),
                    ByteOrder::Big => Self::from_be_bytes(exact),
                }
            }
            #[inline]
            fn float(self) -> f64 {
                self as f64
            }
            #[inline]
            fn whole<T: Whole>(self) -> Option<T> {
                let whole: fn(Self) -> Option<i128> = $whole;
                whole(self).and_then(|value| T::try_from(value).ok())
            }
        }
    )*};
}

stored! {
    i8, |v| Some(v.into());
    u8, |v| Some(v.into());
    i16, |v| Some(v.into());
    u16, |v| Some(v.into());
    i32, |v| Some(v.into());
    u32, |v| Some(v.into());
    i64, |v| Some(v.into());
    u64, |v| Some(v.into());
    f32, |v| whole_float(v.into());
    f64, whole_float;
}

/// A floating-point value that is a whole number, as such.
pub(crate) fn whole_float(value: f64) -> Option<i128> {
    (value.fract() == 0.0 && value.abs() < 1e30).then_some(value as i128)
}

/// Runs an expression with `$stored` naming the Rust type of `$kind`.
macro_rules! with_stored {
    ($kind:expr, $stored:ident => $body:expr) => {
        match $kind {
            Int8 => {
                type $stored = i8;
                $body
            }
            UInt8 => {
                type $stored = u8;
                $body
            }
            Int16 => {
                type $stored = i16;
                $body
            }
            UInt16 => {
                type $stored = u16;
                $body
            }
            Int32 => {
                type $stored = i32;
                $body
            }
            UInt32 => {
                type $stored = u32;
                $body
            }
            Int64 => {
                type $stored = i64;
                $body
            }
            UInt64 => {
                type $stored = u64;
                $body
            }
            Float32 => {
                type $stored = f32;
                $body
            }
            Float64 => {
                type $stored = f64;
                $body
            }
        }
    };
}

/// Widens numbers to floating point. `target` takes as many as `bytes` hold.
pub(crate) fn floats_from_bytes(
    bytes: &[u8],
    kind: NumberType,
    order: ByteOrder,
    target: &mut [f64],
) {
    with_stored!(kind, S => {
        // Every value converts, so there is no first one that does not.
        let _ = convert::<S, f64>(bytes, order, target, |value| Some(value.float()));
    });
}

/// Converts numbers to whole ones; the error is the position of the first that
/// is not whole or out of range.
pub(crate) fn wholes_from_bytes<T: Whole>(
    bytes: &[u8],
    kind: NumberType,
    order: ByteOrder,
    target: &mut [T],
) -> Result<(), usize> {
    with_stored!(kind, S => convert::<S, T>(bytes, order, target, |value| value.whole()))
}

fn convert<S: Stored, T: Send>(
    bytes: &[u8],
    order: ByteOrder,
    target: &mut [T],
    number: impl Fn(S) -> Option<T> + Sync,
) -> Result<(), usize> {
    const CHUNK: usize = 1 << 16;
    let refused = target
        .par_chunks_mut(CHUNK)
        .zip(bytes.par_chunks(CHUNK * S::WIDTH))
        .enumerate()
        .find_map_first(|(chunk, (target, bytes))| {
            // Told apart outside the loop, so that the loop is a plain copy or swap.
            let refused = match order {
                ByteOrder::Little => convert_chunk(bytes, target, ByteOrder::Little, &number),
                ByteOrder::Big => convert_chunk(bytes, target, ByteOrder::Big, &number),
            };
            refused.map(|position| chunk * CHUNK + position)
        });
    refused.map_or(Ok(()), Err)
}

#[inline(always)]
fn convert_chunk<S: Stored, T>(
    bytes: &[u8],
    target: &mut [T],
    order: ByteOrder,
    number: &impl Fn(S) -> Option<T>,
) -> Option<usize> {
    for (at, (slot, bytes)) in target.iter_mut().zip(bytes.chunks_exact(S::WIDTH)).enumerate() {
        match number(S::load(bytes, order)) {
            Some(value) => *slot = value,
            None => return Some(at),
        }
    }
    None
}
