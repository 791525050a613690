//! The peak memory of this process.

use std::fs;

/// The start of a measurement of the peak.
pub(crate) struct Memory {
    /// The peak until then, in bytes.
    before: Option<u64>,
}

impl Memory {
    pub(crate) fn now() -> Self {
        // Linux resets the peak to the resident memory. Without that permission, a rise below the
        // earlier peak is not measured.
        let _ = fs::write("/proc/self/clear_refs", "5");
        Self { before: peak() }
    }

    /// The number of bytes by which the peak has risen; `None` where the system has no such figure.
    pub(crate) fn rise(&self) -> Option<u64> {
        Some(peak()?.saturating_sub(self.before?))
    }
}

/// The peak of the resident memory of the process, in bytes. Available on Linux only.
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
