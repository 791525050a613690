//! Numbers in bytes, least significant byte first.

use dashu_int::IBig;

use crate::failure::{Failure, unreadable};

/// The bytes that are still to be read.
pub struct Bytes<'a>(pub &'a [u8]);

impl<'a> Bytes<'a> {
    /// The next `count` bytes.
    ///
    /// # Errors
    /// At the end.
    pub fn take(&mut self, count: usize) -> Result<&'a [u8], Failure> {
        match self.0.split_at_checked(count) {
            Some((taken, rest)) => {
                self.0 = rest;
                Ok(taken)
            }
            None => unreadable("the file ends too early"),
        }
    }

    /// The next N bytes.
    ///
    /// # Errors
    /// At the end.
    pub fn array<const N: usize>(&mut self) -> Result<[u8; N], Failure> {
        let mut array = [0; N];
        array.copy_from_slice(self.take(N)?);
        Ok(array)
    }

    /// The next line, which is text, without the spaces around it.
    ///
    /// # Errors
    /// At the end, and for bytes that are no text.
    pub fn line(&mut self) -> Result<&'a str, Failure> {
        let length = self.0.iter().position(|&byte| byte == b'\n').unwrap_or(self.0.len());
        let line = std::str::from_utf8(self.take(length + 1)?);
        line.map_or_else(|_| unreadable("a line is not text"), |line| Ok(line.trim_ascii()))
    }

    /// The next byte.
    ///
    /// # Errors
    /// At the end.
    pub fn byte(&mut self) -> Result<u8, Failure> {
        self.array().map(|[byte]| byte)
    }

    /// A number in groups of seven bits, the least significant group first. All bytes but the last have their
    /// highest bit set.
    ///
    /// # Errors
    /// At the end, or if the number does not fit in 32 bits.
    pub fn number(&mut self) -> Result<u32, Failure> {
        let mut number = 0_u64;
        for shift in [0, 7, 14, 21, 28] {
            let byte = self.byte()?;
            number |= u64::from(byte & 127) << shift;
            if byte < 128 {
                return u32::try_from(number).or_else(|_| unreadable("a number exceeds 32 bits"));
            }
        }
        unreadable("a number has more than five bytes")
    }

    /// A time of the step.
    ///
    /// # Errors
    /// At the end, or for a number that is not in [0, 1].
    pub fn time(&mut self) -> Result<f64, Failure> {
        let bits = u64::from_le_bytes(self.array()?);
        // Numbers from 0 to 1 have the order of their bits.
        if bits > 1.0_f64.to_bits() {
            return unreadable("a time is not in [0, 1]");
        }
        Ok(f64::from_bits(bits))
    }

    /// An integer of so many bytes, in two's complement.
    ///
    /// # Errors
    /// At the end.
    pub fn integer(&mut self, count: usize) -> Result<IBig, Failure> {
        self.take(count).map(IBig::from_le_bytes)
    }
}
