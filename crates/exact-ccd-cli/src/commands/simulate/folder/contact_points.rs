//! The contacts of a time step for ParaView, as points.

use std::io;

use exact_ccd_files::{PointArray, write_vtp};
use exact_ccd_mesh::Point;
use exact_ccd_sim::{Contact, Simulation};

/// Writes the contacts of the current state: a point in the middle of each, with the distance, the normal
/// force on the first body, and both bodies.
pub(crate) fn write(simulation: &Simulation, writer: impl io::Write) -> io::Result<()> {
    let contacts = simulation.contacts();
    let middle = |contact: &Contact| -> Point {
        let [a, b] = contact.points;
        core::array::from_fn(|axis| 0.5 * (a[axis] + b[axis]))
    };
    let body = |place: usize| -> Vec<i64> {
        let bodies = contacts.iter().map(|contact| contact.bodies[place] as i64);
        bodies.collect()
    };
    let points: Vec<Point> = contacts.iter().map(middle).collect();
    let distances: Vec<f64> = contacts.iter().map(|contact| contact.distance).collect();
    let forces: Vec<Point> = contacts.iter().map(|contact| contact.force).collect();
    let (first, second) = (body(0), body(1));
    let data = [
        ("distance", PointArray::Reals(&distances)),
        ("force", PointArray::Vectors(&forces)),
        ("body", PointArray::Integers(&first)),
        ("other_body", PointArray::Integers(&second)),
    ];
    write_vtp(writer, &points, &data)
}
