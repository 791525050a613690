//! How much memory this process has held.

use std::fs;

/// From when on the peak is looked at.
pub(crate) struct Memory {
    /// The peak until then, in bytes.
    before: Option<u64>,
}

impl Memory {
    pub(crate) fn now() -> Self {
        // Makes Linux forget the peak so far: from here on it is what is resident now. Where that is not allowed, what
        // came before hides as much of what comes after.
        let _ = fs::write("/proc/self/clear_refs", "5");
        Self { before: peak() }
    }

    /// By how many bytes the peak has risen since; `None` where the system does not tell.
    pub(crate) fn rise(&self) -> Option<u64> {
        Some(peak()?.saturating_sub(self.before?))
    }
}

/// The most bytes that were resident at a time, of the whole process. Only Linux tells.
pub(crate) fn peak() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(1024 * kibibytes)
}

/// Bytes as MiB.
pub(crate) fn mebibytes(bytes: u64) -> f64 {
    bytes as f64 / f64::from(1 << 20)
}
