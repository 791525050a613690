//! Selections of faces by regions of space.

use exact_ccd_mesh::{Aabb, Point, vector};
use nalgebra::Vector3;

use super::entry::{Entry, Rule};
use crate::fault::Fault;

/// The keys of a selection. The faces of a body are the faces of its boundary.
const RULES: [(&str, Rule); 1] = [(
    "id id_offset threshold box center radius p1 p2 axis position point normal offset relative boundary_only",
    Rule::Said,
)];

/// The ids that selections give to faces. The first region that contains the center of a face counts.
pub(super) struct Regions {
    regions: Vec<Region>,
}

/// The id that a region gives to the face with a center.
type Region = Box<dyn Fn(&Vector3<f64>) -> Option<i64>>;

impl Regions {
    /// The selections of an entry, for a placed mesh with this box.
    pub(super) fn parse(entry: &Entry<'_>, bounds: &Aabb) -> Result<Self, Fault> {
        let regions: Result<_, Fault> = entry.list().iter().map(|entry| region(entry, *bounds)).collect();
        Ok(Self { regions: regions? })
    }

    /// The id of a face.
    pub(super) fn id(&self, center: &Vector3<f64>) -> Option<i64> {
        self.regions.iter().find_map(|region| region(center))
    }
}

fn region(entry: &Entry<'_>, bounds: Aabb) -> Result<Region, Fault> {
    if let Some(id) = entry.value.as_i64() {
        return Ok(Box::new(move |_| Some(id)));
    }
    if entry.value.is_string() || entry.get("file").is_some() {
        return Err(entry.unsupported("a selection by a file of ids", "select by a box"));
    }
    entry.check(&RULES)?;
    let (lower, size) = (Vector3::from(bounds.lower), Vector3::from(bounds.sides()));
    let is_relative = entry.flag("relative")?;
    let place = |point: Point| {
        let point = Vector3::from(point);
        if is_relative {
            size.component_mul(&point) + lower
        } else {
            point
        }
    };
    let length = |length: f64| if is_relative { size.norm() * length } else { length };
    if let Some(threshold) = entry.get("threshold") {
        let threshold = threshold.number()?;
        let tolerance = if threshold < 0.0 { 1e-7 } else { threshold };
        let offset = entry.get("id_offset").map_or(Ok(0), |offset| offset.integer())?;
        return Ok(Box::new(move |x| {
            let Aabb { lower: l, upper: u } = bounds;
            let sides = [(0, l), (1, l), (0, u), (1, u), (2, l), (2, u)];
            let is_near = |(axis, corner): &(usize, Point)| (x[*axis] - corner[*axis]).abs() < tolerance;
            let side = sides.iter().position(is_near).unwrap_or(sides.len());
            Some(offset.saturating_add(1 + side as i64))
        }));
    }
    let id = entry.need("id")?.integer()?;
    if let Some(corners) = entry.get("box") {
        let [lower, upper] = &corners.elements()?[..] else {
            return Err(corners.invalid("two corners"));
        };
        let (lower, upper) = (place(lower.point()?).into(), place(upper.point()?).into());
        let bounds = Aabb { lower, upper };
        return Ok(Box::new(move |x| bounds.contains(&(*x).into()).then_some(id)));
    }
    if let Some(center) = entry.get("center") {
        let radius = length(entry.need("radius")?.number()?);
        let center = place(center.point()?);
        return Ok(Box::new(move |x| {
            ((x - center).norm_squared() <= radius * radius).then_some(id)
        }));
    }
    if let Some(radius) = entry.get("radius") {
        let [from, to] = [entry.need("p1")?.point()?, entry.need("p2")?.point()?].map(place);
        let radius = length(radius.number()?);
        let axis = unit((to - from).into())
            .ok_or_else(|| entry.invalid("two points p1 and p2 apart from each other"))?;
        return Ok(Box::new(move |x| {
            let along = axis.dot(&(x - from));
            let across = (x - from - axis * along).norm_squared();
            ((0.0..=(to - from).norm()).contains(&along) && across <= radius * radius).then_some(id)
        }));
    }
    // The points x with n · (x − p) not below 0.
    let (point, normal) = if let Some(axis) = entry.get("axis") {
        let (axis, sign) = signed_axis(&axis)?;
        let mut position = entry.need("position")?.number()?;
        if is_relative {
            position = size[axis] * position + lower[axis];
        }
        let unit = Vector3::ith(axis, 1.0);
        (unit * position, unit * sign)
    } else if let Some(normal) = entry.get("normal") {
        let normal = unit(normal.point()?).ok_or_else(|| normal.invalid("a vector of positive length"))?;
        match entry.get("point") {
            Some(point) => (place(point.point()?), normal),
            None => (normal * entry.number_or("offset", 0.0)?, normal),
        }
    } else {
        return Ok(Box::new(move |_| Some(id)));
    };
    Ok(Box::new(move |x| ((x - point).dot(&normal) >= 0.0).then_some(id)))
}

/// The unit vector in a direction, unless it is zero.
fn unit(x: Point) -> Option<Vector3<f64>> {
    vector::unit(x).map(Vector3::from)
}

/// An axis from 0, and the sign of its direction.
fn signed_axis(entry: &Entry<'_>) -> Result<(usize, f64), Fault> {
    let text = entry.value.as_i64().map_or_else(
        || entry.value.as_str().unwrap_or_default().to_ascii_lowercase(),
        |axis| axis.to_string(),
    );
    let (sign, name) = match text.strip_prefix('-') {
        Some(name) => (-1.0, name),
        None => (1.0, text.strip_prefix('+').unwrap_or(&text)),
    };
    match name {
        "1" | "x" => Ok((0, sign)),
        "2" | "y" => Ok((1, sign)),
        "3" | "z" => Ok((2, sign)),
        _ => Err(entry.invalid("an axis, such as 1, -2, \"x\" or \"-y\"")),
    }
}
