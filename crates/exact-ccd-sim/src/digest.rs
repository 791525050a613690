//! Hashes of values by their bits.

/// A value that a hash depends on: its numbers in a fixed order, with the length of each list and the place
/// of each variant. Equal bits have equal hashes, on every machine.
pub(crate) trait Digest {
    /// Adds the value to a hash.
    fn digest(&self, hash: &mut Hash);
}

/// The hash function FNV-1a with 64 bits: G. Fowler, L. C. Noll, K.-P. Vo, D. Eastlake, T. Hansen, *The FNV
/// Non-Cryptographic Hash Algorithm*.
pub(crate) struct Hash(u64);

impl Hash {
    /// The hash of a value, as 16 hexadecimal digits.
    pub(crate) fn of(value: &(impl Digest + ?Sized)) -> String {
        let mut hash = Self(0xcbf2_9ce4_8422_2325);
        value.digest(&mut hash);
        format!("{:016x}", hash.0)
    }

    fn add(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
}

impl Digest for u64 {
    fn digest(&self, hash: &mut Hash) {
        hash.add(&self.to_le_bytes());
    }
}

impl Digest for u32 {
    fn digest(&self, hash: &mut Hash) {
        hash.add(&self.to_le_bytes());
    }
}

impl Digest for f64 {
    fn digest(&self, hash: &mut Hash) {
        self.to_bits().digest(hash);
    }
}

impl Digest for str {
    fn digest(&self, hash: &mut Hash) {
        (self.len() as u64).digest(hash);
        hash.add(self.as_bytes());
    }
}

impl<T: Digest> Digest for [T] {
    fn digest(&self, hash: &mut Hash) {
        (self.len() as u64).digest(hash);
        self.iter().for_each(|value| value.digest(hash));
    }
}

impl<T: Digest, const N: usize> Digest for [T; N] {
    fn digest(&self, hash: &mut Hash) {
        self.iter().for_each(|value| value.digest(hash));
    }
}

impl<T: Digest> Digest for Vec<T> {
    fn digest(&self, hash: &mut Hash) {
        self.as_slice().digest(hash);
    }
}

/// An absent value is an empty list.
impl<T: Digest> Digest for Option<T> {
    fn digest(&self, hash: &mut Hash) {
        self.as_slice().digest(hash);
    }
}

impl<A: Digest, B: Digest> Digest for (A, B) {
    fn digest(&self, hash: &mut Hash) {
        self.0.digest(hash);
        self.1.digest(hash);
    }
}

impl<T: Digest + ?Sized> Digest for &T {
    fn digest(&self, hash: &mut Hash) {
        (**self).digest(hash);
    }
}
