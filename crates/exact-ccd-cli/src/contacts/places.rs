//! Contacts as points with data.

use exact_ccd::Point;

use super::list::ContactList;

/// The points of contacts, and their data in the same order.
#[derive(Default)]
pub(crate) struct Places {
    pub(crate) points: Vec<Point>,
    pub(crate) times: Vec<f64>,
    /// Zero, if a contact has no normal.
    pub(crate) normals: Vec<Point>,
    /// 0 for vf, 1 for ee, 2 for ve, 3 for vv, 4 for ef, 5 for vh.
    pub(crate) kinds: Vec<i64>,
    /// −1 for a face that has no id in its file.
    pub(crate) ids: [Vec<i64>; 2],
}

impl ContactList {
    /// The points of the contacts.
    pub(crate) fn places(&self) -> Places {
        let mut places = Places::default();
        for record in &self.0 {
            places.points.push(record.point.unwrap_or_default());
            places.times.push(record.time.lower);
            places.normals.push(record.normal.unwrap_or_default());
            places.kinds.push(record.kind.number());
            for (ids, id) in places.ids.iter_mut().zip(record.ids) {
                ids.push(id.map_or(-1, i64::from));
            }
        }
        places
    }
}
