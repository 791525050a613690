//! Lists of contacts.

use crate::border::call;
use crate::contact::Contact;
use crate::error::Status;
use crate::pointers::{Out, reference};

/// The contacts of a step, the earliest first.
pub struct Contacts(pub(crate) Vec<Contact>);

/// The number of contacts, and a pointer to the first, which is valid until the list is freed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_contacts_data(
    contacts: *const Contacts,
    data: *mut *const Contact,
    count: *mut usize,
) -> Status {
    call(|| {
        // SAFETY: the documentation of the function states the promise.
        let (Contacts(contacts), data, count) = unsafe {
            let contacts = reference("contacts", contacts)?;
            let data = Out::new("data", data)?;
            (contacts, data, Out::new("count", count)?)
        };
        data.write(contacts.as_ptr());
        count.write(contacts.len());
        Ok(())
    })
}

/// Frees a list of contacts. Null is allowed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn exact_ccd_contacts_free(contacts: *mut Contacts) {
    if !contacts.is_null() {
        // SAFETY: made by `exact_ccd_detector_collisions`, and freed once: the caller's promise.
        drop(unsafe { Box::from_raw(contacts) });
    }
}
