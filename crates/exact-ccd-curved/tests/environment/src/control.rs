//! The floating-point environments of x86-64.

/// All environments: the default one first.
pub const ENVIRONMENTS: [u32; 8] = [0, 0x2000, 0x4000, 0x6000, 0x8040, 0xa040, 0xc040, 0xe040];

/// Sets the environment of this thread.
#[cfg(target_arch = "x86_64")]
pub fn set(environment: u32) {
    use std::arch::asm;

    // The bits that flush subnormal numbers (FTZ, DAZ), and the bits that round down, up, towards zero.
    const FLUSH: u32 = 0x8040;
    const ROUNDING: u32 = 0x6000;

    let mut control = 0_u32;
    // SAFETY: only the rounding and the treatment of subnormal numbers change, and the library detects it.
    unsafe {
        asm!("stmxcsr [{}]", in(reg) &raw mut control, options(nostack));
        control = control & !(FLUSH | ROUNDING) | environment;
        asm!("ldmxcsr [{}]", in(reg) &raw const control, options(nostack));
    }
}

/// Other processors do not have this register.
#[cfg(not(target_arch = "x86_64"))]
pub fn set(environment: u32) {
    panic!("no environment {environment:#x}: this program is for x86-64");
}
