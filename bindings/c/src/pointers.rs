//! Pointers of the caller as references and places for results, or an error that names the argument.

use core::mem::MaybeUninit;
use core::slice;

use exact_ccd::Point;

use crate::error::Error;

/// The place of a result: written, never read. It need not hold a value before, and may be the place of
/// another result: then the last one stays.
pub(crate) struct Out<T>(*mut T);

impl<T> Out<T> {
    /// # Safety
    /// `pointer` is null, or points to memory for a `T` that nobody else uses during the call.
    #[inline]
    pub(crate) unsafe fn new(name: &str, pointer: *mut T) -> Result<Self, Error> {
        check(name, pointer)?;
        Ok(Self(pointer))
    }

    /// No place for null.
    ///
    /// # Safety
    /// As for [`new`](Self::new).
    pub(crate) unsafe fn optional(name: &str, pointer: *mut T) -> Result<Option<Self>, Error> {
        if pointer.is_null() {
            return Ok(None);
        }
        // SAFETY: the caller's promise.
        unsafe { Self::new(name, pointer) }.map(Some)
    }

    #[inline]
    pub(crate) fn write(&self, value: T) {
        // SAFETY: not null and aligned; the rest is the promise of `new`.
        unsafe { self.0.write(value) }
    }
}

impl<T> Out<*mut T> {
    /// Hands a value over to the caller, who frees it by [`free`].
    pub(crate) fn give(&self, value: T) {
        self.write(Box::into_raw(Box::new(value)));
    }
}

/// Frees a value of [`Out::give`]. Null is allowed.
///
/// # Safety
/// `handle` is null, or was given by this library and is freed once.
pub(crate) unsafe fn free<T>(handle: *mut T) {
    if !handle.is_null() {
        // SAFETY: the caller's promise.
        drop(unsafe { Box::from_raw(handle) });
    }
}

/// The array of `count` elements at `pointer`. With `count` = 0, the pointer may be null.
///
/// # Safety
/// `pointer` is null, or points to `count` elements that nobody changes during the call.
pub(crate) unsafe fn array<'a, T>(name: &str, pointer: *const T, count: usize) -> Result<&'a [T], Error> {
    if count == 0 {
        return Ok(&[]);
    }
    check_array(name, pointer, count)?;
    // SAFETY: not null, aligned, not longer than the address space; the rest is the caller's promise.
    Ok(unsafe { slice::from_raw_parts(pointer, count) })
}

/// The places of `count` results at `pointer`. With `count` = 0, the pointer may be null.
///
/// # Safety
/// `pointer` is null, or points to memory for `count` elements that nobody else uses as long as the result
/// exists.
pub(crate) unsafe fn places<'a, T>(
    name: &str,
    pointer: *mut T,
    count: usize,
) -> Result<&'a mut [MaybeUninit<T>], Error> {
    if count == 0 {
        return Ok(&mut []);
    }
    check_array(name, pointer, count)?;
    // SAFETY: not null, aligned, not longer than the address space, without values; the rest is the
    // caller's promise.
    Ok(unsafe { slice::from_raw_parts_mut(pointer.cast(), count) })
}

/// No places for null.
///
/// # Safety
/// As for [`places`].
pub(crate) unsafe fn optional_places<'a, T>(
    name: &str,
    pointer: *mut T,
    count: usize,
) -> Result<&'a mut [MaybeUninit<T>], Error> {
    let count = if pointer.is_null() { 0 } else { count };
    // SAFETY: the caller's promise.
    unsafe { places(name, pointer, count) }
}

/// Writes values to the places of results, as many as there are of both.
pub(crate) fn fill<T>(places: &mut [MaybeUninit<T>], values: impl IntoIterator<Item = T>) {
    for (place, value) in places.iter_mut().zip(values) {
        place.write(value);
    }
}

/// Writes the values that exist to their places.
pub(crate) fn fill_some<T>(places: &mut [MaybeUninit<T>], values: impl IntoIterator<Item = Option<T>>) {
    for (place, value) in places.iter_mut().zip(values) {
        if let Some(value) = value {
            place.write(value);
        }
    }
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

/// The positions of vertices at both ends of a step.
///
/// # Safety
/// As for [`positions`].
pub(crate) unsafe fn ends<'a>(
    x0: *const f64,
    x1: *const f64,
    count: usize,
) -> Result<[&'a [Point]; 2], Error> {
    // SAFETY: the caller's promise.
    Ok(unsafe { [positions("x0", x0, count)?, positions("x1", x1, count)?] })
}

/// The value at `pointer`.
///
/// # Safety
/// `pointer` is null, or points to a value that nobody changes during the call.
#[inline]
pub(crate) unsafe fn reference<'a, T>(name: &str, pointer: *const T) -> Result<&'a T, Error> {
    check(name, pointer)?;
    // SAFETY: not null and aligned; the rest is the caller's promise.
    Ok(unsafe { &*pointer })
}

/// The value of a handle, to be changed.
///
/// # Safety
/// `handle` is null, or points to a value of this library that nobody else uses during the call.
pub(crate) unsafe fn reference_mut<'a, T>(name: &str, handle: *mut T) -> Result<&'a mut T, Error> {
    check(name, handle)?;
    // SAFETY: not null and aligned; the rest is the caller's promise.
    Ok(unsafe { &mut *handle })
}

fn check_array<T>(name: &str, pointer: *const T, count: usize) -> Result<(), Error> {
    if count > isize::MAX as usize / size_of::<T>() {
        return Err(Error::argument(format_args!(
            "{count} elements of {name} exceed the memory"
        )));
    }
    check(name, pointer)
}

#[inline]
fn check<T>(name: &str, pointer: *const T) -> Result<(), Error> {
    if pointer.is_null() || !pointer.is_aligned() {
        let state = if pointer.is_null() { "null" } else { "not aligned" };
        return Err(Error::argument(format_args!("the pointer {name} is {state}")));
    }
    Ok(())
}
