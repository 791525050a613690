//! The types of numbers: their names in all formats, and their values in binary data.

/// The order of the bytes of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ByteOrder {
    LittleEndian,
    BigEndian,
}

/// The type of a number.
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

/// Each type with its names in PLY, in VTK's formats in lower case, and in numpy. No name has two meanings.
/// VTK writes ids as 32 bits.
const NAMES: [(Scalar, &[&str]); 11] = [
    (Scalar::I8, &["char", "int8", "signed_char", "vtktypeint8", "i1"]),
    (
        Scalar::U8,
        &["uchar", "uint8", "unsigned_char", "vtktypeuint8", "u1"],
    ),
    (Scalar::I16, &["short", "int16", "vtktypeint16", "i2"]),
    (
        Scalar::U16,
        &["ushort", "uint16", "unsigned_short", "vtktypeuint16", "u2"],
    ),
    (Scalar::I32, &["int", "int32", "vtkidtype", "vtktypeint32", "i4"]),
    (
        Scalar::U32,
        &["uint", "uint32", "unsigned_int", "vtktypeuint32", "u4"],
    ),
    (Scalar::I64, &["int64", "long", "vtktypeint64", "i8"]),
    (Scalar::U64, &["uint64", "unsigned_long", "vtktypeuint64", "u8"]),
    (Scalar::F16, &["f2"]),
    (Scalar::F32, &["float", "float32", "f4"]),
    (Scalar::F64, &["double", "float64", "f8"]),
];

/// Passes each number in some bytes to a function: `$to` of a `$number`.
macro_rules! each {
    ($bytes:expr, $order:expr, $number:ty, $take:expr, $to:expr) => {
        for &chunk in $bytes.as_chunks().0 {
            $take($to(match $order {
                ByteOrder::LittleEndian => <$number>::from_le_bytes(chunk),
                ByteOrder::BigEndian => <$number>::from_be_bytes(chunk),
            }));
        }
    };
}

impl Scalar {
    /// The type with this name.
    pub(super) fn named(name: &[u8]) -> Option<Self> {
        let has_name = |(_, names): &&(Self, &[&str])| names.iter().any(|known| known.as_bytes() == name);
        NAMES.iter().find(has_name).map(|&(scalar, _)| scalar)
    }

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

    /// The numbers as the nearest `f64`; only integers beyond 2⁵³ are rounded. Bytes after the last whole
    /// number are left out.
    pub(super) fn reals(self, bytes: &[u8], order: ByteOrder) -> Vec<f64> {
        let mut reals = Vec::with_capacity(bytes.len() / self.size());
        self.each_real(bytes, order, |real| reals.push(real));
        reals
    }

    /// The number in these bytes as [`Scalar::reals`].
    pub(super) fn real(self, bytes: &[u8], order: ByteOrder) -> f64 {
        let mut number = 0.0;
        self.each_real(bytes, order, |real| number = real);
        number
    }

    /// The numbers as integers, none for floating-point numbers. Integers above 2⁶³ − 1 become 2⁶³ − 1: as
    /// indices, they are out of range in any case.
    pub(super) fn integers(self, bytes: &[u8], order: ByteOrder) -> Vec<i64> {
        let mut integers = Vec::with_capacity(bytes.len() / self.size());
        self.each_integer(bytes, order, |integer| integers.push(integer));
        integers
    }

    /// The number in these bytes as [`Scalar::integers`].
    pub(super) fn integer(self, bytes: &[u8], order: ByteOrder) -> i64 {
        let mut number = 0;
        self.each_integer(bytes, order, |integer| number = integer);
        number
    }

    fn each_real(self, bytes: &[u8], order: ByteOrder, mut take: impl FnMut(f64)) {
        match self {
            Self::F16 => each!(bytes, order, u16, take, half),
            Self::F32 => each!(bytes, order, f32, take, f64::from),
            Self::F64 => each!(bytes, order, f64, take, f64::from),
            Self::U64 => each!(bytes, order, u64, take, |x| x as f64),
            _ => self.each_integer(bytes, order, |integer| take(integer as f64)),
        }
    }

    fn each_integer(self, bytes: &[u8], order: ByteOrder, mut take: impl FnMut(i64)) {
        match self {
            Self::I8 => each!(bytes, order, i8, take, i64::from),
            Self::U8 => each!(bytes, order, u8, take, i64::from),
            Self::I16 => each!(bytes, order, i16, take, i64::from),
            Self::U16 => each!(bytes, order, u16, take, i64::from),
            Self::I32 => each!(bytes, order, i32, take, i64::from),
            Self::U32 => each!(bytes, order, u32, take, i64::from),
            Self::I64 => each!(bytes, order, i64, take, i64::from),
            Self::U64 => each!(bytes, order, u64, take, |x| i64::try_from(x).unwrap_or(i64::MAX)),
            Self::F16 | Self::F32 | Self::F64 => {}
        }
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
