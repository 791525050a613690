//! Values in Thrift's compact protocol.
//!
//! The library takes a value by the number of its field, whatever type the file states; if a number occurs
//! twice, it takes the first or the last value. Only files are accepted in which this makes no difference:
//! the numbers of fields rise, known fields have their types, and no list has truth values, which the
//! library skips as if they took no byte.
//!
//! Apache Thrift, *Compact Protocol Encoding*.

/// The greatest depth of nested values whose types are not known.
const DEPTH: usize = 32;

/// Types of values.
pub(super) const TRUE: u8 = 1;
pub(super) const FALSE: u8 = 2;
pub(super) const BYTE: u8 = 3;
pub(super) const I16: u8 = 4;
pub(super) const I32: u8 = 5;
pub(super) const I64: u8 = 6;
pub(super) const DOUBLE: u8 = 7;
pub(super) const BINARY: u8 = 8;
pub(super) const LIST: u8 = 9;
pub(super) const SET: u8 = 10;
pub(super) const MAP: u8 = 11;
pub(super) const STRUCT: u8 = 12;

/// The type of a known value.
pub(super) enum ValueType {
    /// A value that contains no others.
    Plain(u8),
    /// A truth value of a structure, which is the type itself.
    Truth,
    /// A list of such values.
    List(&'static ValueType),
    /// A structure of these fields, in the order of their numbers, from 1. It may have others.
    Struct(&'static [ValueType]),
    /// A value of any type.
    Other,
}

/// Bytes that have not been read. Every function returns `None` if they are not valid.
#[derive(Clone)]
pub(super) struct Thrift<'a> {
    pub(super) rest: &'a [u8],
}

impl Thrift<'_> {
    /// Skips a value of a known type, where the file states this type.
    pub(super) fn known(&mut self, kind: &ValueType, stated: u8) -> Option<()> {
        match (kind, stated) {
            (ValueType::Truth, TRUE | FALSE) => Some(()),
            (ValueType::Plain(kind), _) if *kind == stated => self.unknown(stated, 1),
            (ValueType::List(kind), LIST) => {
                let (count, stated) = self.list()?;
                (0..count).try_for_each(|_| self.known(kind, stated))
            }
            (ValueType::Struct(kinds), STRUCT) => self.fields(&mut |thrift, field, stated| {
                // The numbers of fields rise from 1.
                let kind = kinds.get(usize::from(field.unsigned_abs()) - 1);
                thrift.known(kind.unwrap_or(&ValueType::Other), stated)
            }),
            (ValueType::Other, _) => self.skip(stated),
            _ => None,
        }
    }

    /// Skips a value of the type that the file states.
    pub(super) fn skip(&mut self, stated: u8) -> Option<()> {
        match stated {
            TRUE | FALSE => Some(()),
            _ => self.unknown(stated, DEPTH),
        }
    }

    /// Skips a value that takes a byte at least, with values within to this depth.
    fn unknown(&mut self, stated: u8, depth: usize) -> Option<()> {
        let depth = depth.checked_sub(1)?;
        match stated {
            BYTE => self.bytes(1),
            I16 | I32 | I64 => self.varint().map(drop),
            DOUBLE => self.bytes(8),
            BINARY => {
                let length = self.varint()?;
                self.bytes(length)
            }
            LIST | SET => {
                let (count, stated) = self.list()?;
                (0..count).try_for_each(|_| self.unknown(stated, depth))
            }
            MAP => {
                let count = self.varint()?;
                if count == 0 {
                    return Some(());
                }
                let stated = self.byte()?;
                (0..count).try_for_each(|_| {
                    self.unknown(stated >> 4, depth)?;
                    self.unknown(stated & 15, depth)
                })
            }
            STRUCT => self.fields(&mut |thrift, _, stated| match stated {
                TRUE | FALSE => Some(()),
                _ => thrift.unknown(stated, depth),
            }),
            _ => None,
        }
    }

    /// The fields of a structure, by their rising numbers and the types that the file states.
    pub(super) fn fields(&mut self, read: &mut dyn FnMut(&mut Self, i16, u8) -> Option<()>) -> Option<()> {
        let mut last = 0_i16;
        loop {
            let header = self.byte()?;
            if header == 0 {
                return Some(());
            }
            let field = match header >> 4 {
                0 => i16::try_from(self.signed()?).ok()?,
                step => last.checked_add(step.into())?,
            };
            if field <= last {
                return None;
            }
            last = field;
            read(self, field, header & 15)?;
        }
    }

    /// The number of elements of a list, and their type. Each element takes a byte at least.
    pub(super) fn list(&mut self) -> Option<(usize, u8)> {
        let header = self.byte()?;
        let count = match header >> 4 {
            15 => self.varint()?,
            count => count.into(),
        };
        let count = usize::try_from(count).ok()?;
        (count <= self.rest.len()).then_some((count, header & 15))
    }

    pub(super) fn i32(&mut self) -> Option<i32> {
        i32::try_from(self.signed()?).ok()
    }

    fn signed(&mut self) -> Option<i64> {
        let zigzag = self.varint()?;
        Some((zigzag >> 1) as i64 ^ -((zigzag & 1) as i64))
    }

    /// A number in groups of seven bits, the lowest first.
    fn varint(&mut self) -> Option<u64> {
        let mut number = 0;
        for shift in (0..64).step_by(7) {
            let byte = self.byte()?;
            number |= u64::from(byte & 0x7f) << shift;
            if byte & 0x80 == 0 {
                return Some(number);
            }
        }
        None
    }

    fn byte(&mut self) -> Option<u8> {
        self.rest.split_off_first().copied()
    }

    fn bytes(&mut self, count: u64) -> Option<()> {
        self.rest.split_off(..usize::try_from(count).ok()?).map(drop)
    }
}
