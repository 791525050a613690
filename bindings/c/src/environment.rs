//! The floating-point environment of the host, which the library replaces by the standard one.
//!
//! Hosts flush subnormal numbers (`-ffast-math`) or round upwards (interval arithmetic). Rust, as
//! IEEE 754, assumes neither. The control register is read at the start and at the end of each call, and
//! written only if it differs. It has the flags of exceptions too, which the library raises.

/// Sets the standard environment, and restores the caller's when it is dropped.
pub(crate) struct Environment {
    #[cfg_attr(
        not(target_arch = "x86_64"),
        expect(dead_code, reason = "no register is read")
    )]
    caller: u32,
}

#[cfg(target_arch = "x86_64")]
mod control {
    use core::arch::asm;

    /// The bits of MXCSR that change results: rounding (13, 14), FTZ (15), DAZ (6); and the
    /// exceptions that do not trap (7 to 12).
    const MASK: u32 = 0b1111_1111_1100_0000;
    const STANDARD: u32 = 0b0001_1111_1000_0000;

    pub(super) fn read() -> u32 {
        let mut register = 0_u32;
        // SAFETY: stores the register MXCSR, which every x86-64 processor has, to a local variable.
        unsafe { asm!("stmxcsr [{}]", in(reg) &raw mut register, options(nostack, preserves_flags)) };
        register
    }

    pub(super) fn write(register: u32) {
        // SAFETY: the value is the standard one, or one that was read before.
        unsafe { asm!("ldmxcsr [{}]", in(reg) &raw const register, options(nostack, preserves_flags)) };
    }

    pub(super) fn standard_if_other(register: u32) -> Option<u32> {
        (register & MASK != STANDARD).then_some(register & !MASK | STANDARD)
    }
}

impl Environment {
    #[cfg(target_arch = "x86_64")]
    #[inline]
    pub(crate) fn standard() -> Self {
        let caller = control::read();
        if let Some(standard) = control::standard_if_other(caller) {
            control::write(standard);
        }
        Self { caller }
    }

    /// On other processors the kernel detects the environment of the host, and decides in integers.
    #[cfg(not(target_arch = "x86_64"))]
    pub(crate) fn standard() -> Self {
        Self { caller: 0 }
    }
}

impl Drop for Environment {
    #[inline]
    fn drop(&mut self) {
        #[cfg(target_arch = "x86_64")]
        if control::read() != self.caller {
            control::write(self.caller);
        }
    }
}
