//! Lists that the library makes: contacts, pairs, and the bytes of certificates.

use exact_ccd::Point;
use exact_ccd_mesh::TriangleMesh;

use crate::border::call;
use crate::contact::Contact;
use crate::error::Status;
use crate::pair::Pair;
use crate::pointers::{Out, free, reference};

/// The contacts of a step, the earliest first.
pub struct Contacts(pub(crate) Vec<Contact>);

impl Contacts {
    /// Contacts in the step between two arrays of positions.
    pub(crate) fn of(
        mesh: &TriangleMesh,
        positions: [&[Point]; 2],
        contacts: &[exact_ccd_mesh::Contact],
    ) -> Self {
        let contacts = contacts.iter();
        Self(
            contacts
                .map(|contact| Contact::of(mesh, positions, contact))
                .collect(),
        )
    }
}

/// Pairs of primitives, sorted by kind, then by the first index, then by the second.
pub struct Pairs(pub(crate) Vec<Pair>);

/// The number of contacts, and a pointer to the first, which is valid until the list is freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_contacts_data(
    contacts: *const Contacts,
    data: *mut *const Contact,
    count: *mut usize,
) -> Status {
    // SAFETY: the documentation of the function states the promise.
    unsafe { elements(("contacts", contacts), |Contacts(all)| all, data, count) }
}

/// The number of pairs, and a pointer to the first, which is valid until the list is freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_pairs_data(
    pairs: *const Pairs,
    data: *mut *const Pair,
    count: *mut usize,
) -> Status {
    // SAFETY: the documentation of the function states the promise.
    unsafe { elements(("pairs", pairs), |Pairs(all)| all, data, count) }
}

/// The number of elements of a list, and a pointer to the first.
///
/// # Safety
/// The pointers are null, or point to a list with this name, and to places for the results.
pub(crate) unsafe fn elements<L, T>(
    (name, list): (&str, *const L),
    all: fn(&L) -> &Vec<T>,
    data: *mut *const T,
    count: *mut usize,
) -> Status {
    call(|| {
        // SAFETY: the caller's promise.
        let (list, data, count) = unsafe {
            let list = reference(name, list)?;
            (list, Out::new("data", data)?, Out::new("count", count)?)
        };
        data.write(all(list).as_ptr());
        count.write(all(list).len());
        Ok(())
    })
}

/// Frees a list of contacts. Null is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_contacts_free(contacts: *mut Contacts) {
    // SAFETY: the caller's promise.
    unsafe { free(contacts) }
}

/// Frees a list of pairs. Null is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_pairs_free(pairs: *mut Pairs) {
    // SAFETY: the caller's promise.
    unsafe { free(pairs) }
}
