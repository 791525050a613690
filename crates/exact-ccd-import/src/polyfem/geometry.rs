//! Meshes, obstacles and planes.

use std::rc::Rc;

use exact_ccd_mesh::{Aabb, HalfSpace, Point};
use nalgebra::Vector3;

use super::boundary::Conditions;
use super::entry::{Entry, NOTHING, Rule};
use super::material::{self, Material};
use super::region::Regions;
use super::surface::Surface;
use super::transformation::placement;
use super::volume::Volumes;
use crate::fault::Fault;
use crate::meshes::Meshes;
use exact_ccd_scene::Mesh;
use exact_ccd_scene::description::BodyDescription;
use exact_ccd_scene::description::Placement;

/// The most copies of a mesh.
const MOST: i64 = 10_000;

/// The bodies and planes of a file.
pub(super) struct Geometry {
    pub(super) bodies: Vec<BodyDescription>,
    pub(super) half_spaces: Vec<HalfSpace>,
    /// The length of the shortest edge of all surfaces, in m.
    pub(super) shortest_edge: f64,
}

/// The keys of a geometry.
const RULES: [(&str, Rule); 4] = [
    (
        "type mesh array point normal height is_obstacle enabled transformation volume_selection \
         surface_selection extract advanced",
        Rule::Said,
    ),
    ("curve_selection point_selection fps mesh_sequence", NOTHING),
    ("unit", Rule::Only("m")),
    ("n_refs", Rule::Only("0")),
];

impl Geometry {
    pub(super) fn parse(
        root: &Entry<'_>,
        conditions: &Conditions<'_>,
        meshes: &mut Meshes,
    ) -> Result<Self, Fault> {
        let materials = material::materials(root)?;
        let mut geometry = Self {
            bodies: Vec::new(),
            half_spaces: Vec::new(),
            shortest_edge: f64::INFINITY,
        };
        for entry in root.need("geometry")?.list() {
            let kind = entry.get("type");
            let kind = kind.as_ref().map_or(Ok("mesh"), Entry::text)?;
            if kind == "mesh_sequence" {
                return Err(
                    entry.unsupported("a sequence of meshes", "move a mesh by `obstacle_displacements`")
                );
            }
            entry.check(&RULES)?;
            if !entry
                .get("enabled")
                .map_or(Ok(true), |enabled| enabled.is_true())?
            {
                continue;
            }
            match kind {
                "mesh" | "mesh_array" => geometry.add(&entry, kind, conditions, &materials, meshes)?,
                "plane" => {
                    let (point, normal) = (entry.need("point")?.point()?, entry.need("normal")?.point()?);
                    geometry.half_spaces.push(HalfSpace::new(point, normal));
                }
                "ground" => {
                    let point = [0.0, entry.need("height")?.number()?, 0.0];
                    geometry.half_spaces.push(HalfSpace::new(point, [0.0, 1.0, 0.0]));
                }
                _ => return Err(entry.invalid("the type mesh, mesh_array, plane, ground or mesh_sequence")),
            }
        }
        Ok(geometry)
    }

    /// Adds the bodies of a mesh.
    fn add(
        &mut self,
        entry: &Entry<'_>,
        kind: &str,
        conditions: &Conditions<'_>,
        materials: &[Material],
        meshes: &mut Meshes,
    ) -> Result<(), Fault> {
        let is_obstacle = entry.flag("is_obstacle")?;
        check_options(entry, is_obstacle)?;
        let named = entry.need("mesh")?;
        let found = meshes
            .find(named.text()?)
            .map_err(|problem| problem.at(&named.place()));
        let (path, mesh): (_, Rc<Mesh>) = found?;
        let whole: Aabb = mesh.points.iter().copied().collect();
        let placement = entry
            .get("transformation")
            .map_or(Ok(Placement::default()), |entry| placement(&entry, whole.sides()))?;
        let mut body = BodyDescription {
            mesh: Some(path),
            ..BodyDescription::default()
        };
        if !is_obstacle {
            if mesh.tetrahedra.is_empty() {
                return Err(named.invalid("a mesh of tetrahedra, or `\"is_obstacle\": true`"));
            }
            let volumes = Volumes::parse(entry, &mesh)?;
            volumes.add_materials(materials, entry, &mut body)?;
            body.velocity = volumes.velocity(conditions, entry)?;
        }
        let points = placement.all(&mesh.points);
        self.measure(&mesh, &points);
        let bounds: Aabb = points.iter().copied().collect();
        let regions = entry
            .get("surface_selection")
            .map(|entry| Regions::parse(&entry, &bounds))
            .transpose()?;
        // All copies have the ids of the first one.
        let surface = Surface::new(&points, &mesh.faces, regions.as_ref());
        for offset in offsets(entry, kind, &bounds)? {
            let placement = placement.then(1.0, offset);
            let mut copy = body.clone().at(placement);
            if is_obstacle {
                conditions.move_obstacle(&mut copy, surface.single_id())?;
            } else {
                conditions.apply(&mut copy, &surface, &placement.all(&mesh.points))?;
            }
            self.bodies.push(copy);
        }
        Ok(())
    }

    fn measure(&mut self, mesh: &Mesh, points: &[Point]) {
        for &[a, b, c] in &mesh.faces {
            for [a, b] in [[a, b], [b, c], [c, a]] {
                let [a, b] = [a, b].map(|vertex| Vector3::from(points[vertex as usize]));
                self.shortest_edge = self.shortest_edge.min((a - b).norm());
            }
        }
    }
}

fn check_options(entry: &Entry<'_>, is_obstacle: bool) -> Result<(), Fault> {
    if let Some(extract) = entry.get("extract") {
        let is_whole = extract.text()? == "volume" || is_obstacle && extract.text()? == "surface";
        if !is_whole {
            return Err(extract.unsupported(
                "a part of a mesh",
                "write \"volume\", or \"surface\" for an obstacle",
            ));
        }
    }
    if let Some(advanced) = entry.get("advanced") {
        let rules = [
            ("normalize_mesh force_linear_geometry", NOTHING),
            ("refinement_location", Rule::Only("0.5")),
            ("min_component", Rule::Only("-1")),
        ];
        advanced.check(&rules)?;
    }
    Ok(())
}

/// The translations of the copies of a mesh.
fn offsets(entry: &Entry<'_>, kind: &str, bounds: &Aabb) -> Result<Vec<Vector3<f64>>, Fault> {
    if kind != "mesh_array" {
        return Ok(vec![Vector3::zeros()]);
    }
    let array = entry.need("array")?;
    array.check(&[("offset size relative", Rule::Said)])?;
    let mut step = Vector3::from_element(array.need("offset")?.number()?);
    if array.flag("relative")? {
        step.component_mul_assign(&Vector3::from(bounds.sides()));
    }
    let sizes = array.need("size")?;
    let counts = sizes.three(Entry::integer, "three numbers of copies")?;
    let product = counts
        .iter()
        .try_fold(1_i64, |product, &count| product.checked_mul(count));
    let is_good = counts.iter().all(|&count| count > 0) && product.is_some_and(|product| product <= MOST);
    let [x, y, z] = counts;
    if !is_good {
        return Err(sizes.invalid(&format!("numbers above 0, at most {MOST} copies")));
    }
    let copies = (0..x).flat_map(|i| (0..y).flat_map(move |j| (0..z).map(move |k| [i, j, k])));
    Ok(copies
        .map(|copy| Vector3::from(copy.map(|index| index as f64)).component_mul(&step))
        .collect())
}
