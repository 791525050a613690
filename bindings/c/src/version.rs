//! The versions of the library and of its interface.

use core::ffi::{CStr, c_char};

/// The version of the binary interface. It grows with each change that a compiled caller notices.
pub const EXACT_CCD_ABI_VERSION: u32 = 3;

const VERSION: &CStr = match CStr::from_bytes_with_nul(concat!(env!("CARGO_PKG_VERSION"), "\0").as_bytes()) {
    Ok(version) => version,
    Err(_) => unreachable!(),
};

/// The version of the library, such as "0.1.0". The string is never freed.
#[unsafe(no_mangle)]
pub extern "C" fn exact_ccd_version() -> *const c_char {
    VERSION.as_ptr()
}

/// The `EXACT_CCD_ABI_VERSION` with which the library was compiled. A program that loads the library at run
/// time compares it with the number in its header.
#[unsafe(no_mangle)]
pub extern "C" fn exact_ccd_abi_version() -> u32 {
    EXACT_CCD_ABI_VERSION
}
