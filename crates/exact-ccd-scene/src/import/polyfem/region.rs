//! Selections of faces by regions of space.

use exact_ccd_mesh::{Aabb, Point};
use nalgebra::Vector3;

use super::super::fault::Fault;
use super::entry::{Entry, Rule};

/// The ids that selections give to faces. The first region that contains the center of a face counts.
pub(super) struct Regions {
    regions: Vec<Region>,
}

enum Region {
    All(i64),
    Box(i64, Aabb),
    Sphere(i64, Vector3<f64>, f64),
    Cylinder(i64, [Vector3<f64>; 2], f64),
    /// The points x with n · (x − p) not below 0.
    HalfSpace(i64, Vector3<f64>, Vector3<f64>),
    /// The sides of the box within a tolerance: x, y below, x, y above, z below, z above.
    Sides(i64, f64),
}

/// The keys of a selection. The faces of a body are those of its boundary.
const RULES: [(&str, Rule); 1] = [(
    "id id_offset threshold box center radius p1 p2 axis position point normal offset relative boundary_only",
    Rule::Said,
)];

impl Regions {
    /// The selections of an entry, for a placed mesh with this box.
    pub(super) fn parse(entry: &Entry<'_>, bounds: &Aabb) -> Result<Self, Fault> {
        let regions = entry
            .list()
            .iter()
            .map(|entry| Region::parse(entry, bounds))
            .collect::<Result<_, _>>()?;
        Ok(Self { regions })
    }

    /// The id of a face.
    pub(super) fn id(&self, center: &Vector3<f64>, bounds: &Aabb) -> Option<i64> {
        self.regions.iter().find_map(|region| region.id(center, bounds))
    }
}

impl Region {
    fn parse(entry: &Entry<'_>, bounds: &Aabb) -> Result<Self, Fault> {
        if let Some(id) = entry.value.as_i64() {
            return Ok(Self::All(id));
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
        if entry.get("threshold").is_some() {
            let threshold = entry.need("threshold")?.number()?;
            let tolerance = if threshold < 0.0 { 1e-7 } else { threshold };
            let offset = entry.get("id_offset").map_or(Ok(0), |offset| offset.integer())?;
            return Ok(Self::Sides(offset, tolerance));
        }
        let id = entry.need("id")?.integer()?;
        if let Some(corners) = entry.get("box") {
            let [lower, upper] = &corners.elements()?[..] else {
                return Err(corners.invalid("two corners"));
            };
            let (lower, upper) = (place(lower.point()?).into(), place(upper.point()?).into());
            return Ok(Self::Box(id, Aabb { lower, upper }));
        }
        if let Some(center) = entry.get("center") {
            let radius = length(entry.need("radius")?.number()?);
            return Ok(Self::Sphere(id, place(center.point()?), radius));
        }
        if entry.get("radius").is_some() {
            let ends = [entry.need("p1")?.point()?, entry.need("p2")?.point()?].map(place);
            return Ok(Self::Cylinder(id, ends, length(entry.need("radius")?.number()?)));
        }
        if let Some(axis) = entry.get("axis") {
            let (axis, sign) = signed_axis(&axis)?;
            let mut position = entry.need("position")?.number()?;
            if is_relative {
                position = size[axis] * position + lower[axis];
            }
            let unit = Vector3::ith(axis, 1.0);
            return Ok(Self::HalfSpace(id, unit * position, unit * sign));
        }
        if let Some(normal) = entry.get("normal") {
            let normal = Vector3::from(normal.point()?).normalize();
            let point = match entry.get("point") {
                Some(point) => place(point.point()?),
                None => normal * entry.number_or("offset", 0.0)?,
            };
            return Ok(Self::HalfSpace(id, point, normal));
        }
        Ok(Self::All(id))
    }

    fn id(&self, x: &Vector3<f64>, bounds: &Aabb) -> Option<i64> {
        match self {
            Self::All(id) => Some(*id),
            Self::Box(id, bounds) => bounds.contains(&(*x).into()).then_some(*id),
            Self::Sphere(id, center, radius) => {
                ((x - center).norm_squared() <= radius * radius).then_some(*id)
            }
            Self::Cylinder(id, [from, to], radius) => {
                let axis = (to - from).normalize();
                let along = axis.dot(&(x - from));
                let across = (x - from - axis * along).norm_squared();
                ((0.0..=(to - from).norm()).contains(&along) && across <= radius * radius).then_some(*id)
            }
            Self::HalfSpace(id, point, normal) => ((x - point).dot(normal) >= 0.0).then_some(*id),
            Self::Sides(offset, tolerance) => {
                let Aabb { lower: l, upper: u } = bounds;
                let sides = [(0, l), (1, l), (0, u), (1, u), (2, l), (2, u)];
                let is_near =
                    |(axis, corner): &(usize, &Point)| (x[*axis] - corner[*axis]).abs() < *tolerance;
                Some(offset + 1 + sides.iter().position(is_near).unwrap_or(sides.len()) as i64)
            }
        }
    }
}

/// An axis from 0, and the sign of its direction.
fn signed_axis(entry: &Entry<'_>) -> Result<(usize, f64), Fault> {
    let expected = "an axis, such as 1, -2, \"x\" or \"-y\"";
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
        _ => Err(entry.invalid(expected)),
    }
}
