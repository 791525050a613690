//! Numbers of all sizes in binary data.

use super::binary::ByteOrder;

/// The type of the numbers of an array.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    F16,
    F32,
    F64,
}

/// Decodes numbers of one size: `$to` from the bytes of a `$number`.
macro_rules! decode {
    ($bytes:expr, $order:expr, $number:ty, $to:expr) => {
        $bytes
            .as_chunks()
            .0
            .iter()
            .map(|&chunk| {
                $to(match $order {
                    ByteOrder::LittleEndian => <$number>::from_le_bytes(chunk),
                    ByteOrder::BigEndian => <$number>::from_be_bytes(chunk),
                })
            })
            .collect()
    };
}

impl Scalar {
    /// The size of a number in bytes.
    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 | Self::F16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    pub(super) fn is_integer(self) -> bool {
        !matches!(self, Self::F16 | Self::F32 | Self::F64)
    }

    /// The numbers as the nearest `f64`; only integers beyond 2⁵³ are rounded. Bytes after the last
    /// whole number are left out.
    pub(super) fn reals(self, bytes: &[u8], order: ByteOrder) -> Vec<f64> {
        match self {
            Self::I8 => decode!(bytes, order, i8, f64::from),
            Self::U8 => decode!(bytes, order, u8, f64::from),
            Self::I16 => decode!(bytes, order, i16, f64::from),
            Self::U16 => decode!(bytes, order, u16, f64::from),
            Self::I32 => decode!(bytes, order, i32, f64::from),
            Self::U32 => decode!(bytes, order, u32, f64::from),
            Self::I64 => decode!(bytes, order, i64, |x| x as f64),
            Self::U64 => decode!(bytes, order, u64, |x| x as f64),
            Self::F16 => decode!(bytes, order, u16, half),
            Self::F32 => decode!(bytes, order, f32, f64::from),
            Self::F64 => decode!(bytes, order, f64, |x| x),
        }
    }

    /// The numbers as integers, none for floating-point numbers. Those above 2⁶³ − 1 become that:
    /// they are indices, and out of range in any case.
    pub(super) fn integers(self, bytes: &[u8], order: ByteOrder) -> Option<Vec<i64>> {
        Some(match self {
            Self::I8 => decode!(bytes, order, i8, i64::from),
            Self::U8 => decode!(bytes, order, u8, i64::from),
            Self::I16 => decode!(bytes, order, i16, i64::from),
            Self::U16 => decode!(bytes, order, u16, i64::from),
            Self::I32 => decode!(bytes, order, i32, i64::from),
            Self::U32 => decode!(bytes, order, u32, i64::from),
            Self::I64 => decode!(bytes, order, i64, |x| x),
            Self::U64 => decode!(bytes, order, u64, |x| i64::try_from(x).unwrap_or(i64::MAX)),
            Self::F16 | Self::F32 | Self::F64 => return None,
        })
    }
}

/// The number with these bits in half precision (IEEE 754), exactly.
fn half(bits: u16) -> f64 {
    let sign = if bits >> 15 == 0 { 1.0 } else { -1.0 };
    let (exponent, fraction) = (i32::from(bits >> 10 & 31), f64::from(bits & 1023) / 1024.0);
    sign * match exponent {
        0 => fraction * 2.0_f64.powi(-14),
        31 if fraction == 0.0 => f64::INFINITY,
        31 => f64::NAN,
        _ => (1.0 + fraction) * 2.0_f64.powi(exponent - 15),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_precision_is_exact() {
        for (bits, number) in [
            (0x0000, 0.0),
            (0x0001, 2.0_f64.powi(-24)),
            (0x03ff, 2.0_f64.powi(-14) - 2.0_f64.powi(-24)),
            (0x0400, 2.0_f64.powi(-14)),
            (0x3c00, 1.0),
            (0x3555, 0.333251953125),
            (0xc000, -2.0),
            (0x7bff, 65504.0),
            (0x7c00, f64::INFINITY),
        ] {
            assert_eq!(half(bits), number, "{bits:x}");
        }
        assert!(half(0x8000).is_sign_negative() && half(0x7e00).is_nan());
    }
}
