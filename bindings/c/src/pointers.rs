//! Pointers of the caller as references, or an error that names the argument.

use core::slice;

use exact_ccd::Point;

use crate::error::Error;

/// The array of `count` elements at `pointer`. With `count` = 0, the pointer may be null.
///
/// # Safety
/// `pointer` is null, or points to `count` elements that nobody changes during the call.
pub(crate) unsafe fn array<'a, T>(name: &str, pointer: *const T, count: usize) -> Result<&'a [T], Error> {
    if count == 0 {
        return Ok(&[]);
    }
    if count > isize::MAX as usize / size_of::<T>() {
        return Err(Error::argument(format_args!(
            "{count} elements of {name} exceed the memory"
        )));
    }
    check(name, pointer)?;
    // SAFETY: not null, aligned, not longer than the address space; the rest is the caller's promise.
    Ok(unsafe { slice::from_raw_parts(pointer, count) })
}

/// The array of `count` elements at `pointer`, to be written.
///
/// # Safety
/// `pointer` is null, or points to `count` elements that nobody else uses during the call.
pub(crate) unsafe fn array_mut<'a, T>(
    name: &str,
    pointer: *mut T,
    count: usize,
) -> Result<&'a mut [T], Error> {
    if count == 0 {
        return Ok(&mut []);
    }
    if count > isize::MAX as usize / size_of::<T>() {
        return Err(Error::argument(format_args!(
            "{count} elements of {name} exceed the memory"
        )));
    }
    check(name, pointer)?;
    // SAFETY: not null, aligned, not longer than the address space; the rest is the caller's promise.
    Ok(unsafe { slice::from_raw_parts_mut(pointer, count) })
}

/// The positions of vertices.
///
/// # Safety
/// `pointer` is null, or points to `count` points that nobody changes during the call.
pub(crate) unsafe fn positions<'a>(
    name: &str,
    pointer: *const f64,
    count: usize,
) -> Result<&'a [Point], Error> {
    // SAFETY: a point is an array of three `double`.
    unsafe { array(name, pointer.cast::<Point>(), count) }
}

/// The value at `pointer`.
///
/// # Safety
/// `pointer` is null, or points to a value of this library that nobody changes during the call.
pub(crate) unsafe fn reference<'a, T>(name: &str, pointer: *const T) -> Result<&'a T, Error> {
    check(name, pointer)?;
    // SAFETY: not null and aligned; the rest is the caller's promise.
    Ok(unsafe { &*pointer })
}

/// The value at `pointer`, to be changed.
///
/// # Safety
/// `pointer` is null, or points to a value that nobody else uses during the call.
pub(crate) unsafe fn reference_mut<'a, T>(name: &str, pointer: *mut T) -> Result<&'a mut T, Error> {
    check(name, pointer)?;
    // SAFETY: not null and aligned; the rest is the caller's promise.
    Ok(unsafe { &mut *pointer })
}

#[inline]
fn check<T>(name: &str, pointer: *const T) -> Result<(), Error> {
    if pointer.is_null() || !pointer.is_aligned() {
        let state = if pointer.is_null() { "null" } else { "not aligned" };
        return Err(Error::argument(format_args!("the pointer {name} is {state}")));
    }
    Ok(())
}
