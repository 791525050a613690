//! The shapes of a text scene.

use core::f64::consts::PI;

use exact_ccd_mesh::{Aabb, Point};
use exact_ccd_sim::{SolidMaterial, SolidProperties};
use nalgebra::Vector3;

use super::held::Piece;
use super::words::{Line, Text};
use crate::fault::{Fault, Place, Problem};
use exact_ccd_scene::description::{Placement, Rotation, Scale};

/// The most shapes of a file, so that a number in it does not exhaust the memory.
const MOST: usize = 10_000;

/// A mesh with its placement and its attributes. Angles and angular velocities are in radians.
#[derive(Clone, Debug)]
pub(super) struct Shape {
    pub(super) place: Place,
    pub(super) mesh: String,
    pub(super) placement: Placement,
    pub(super) material: Option<SolidProperties>,
    /// The linear and the angular velocity at all times.
    pub(super) moved: Option<(Place, [Point; 2])>,
    /// The linear and the angular velocity at the start.
    pub(super) initial: Option<(Place, [Point; 2])>,
    pub(super) dirichlet: Vec<Piece<RelativeBox>>,
    pub(super) neumann: Vec<Neumann>,
}

/// The vertices of the surface in a box, in fractions of the box of the mesh as it is in its file.
pub(super) type RelativeBox = Aabb;

/// An acceleration of vertices, at times from `from` to before `until`.
#[derive(Clone, Debug)]
pub(super) struct Neumann {
    pub(super) place: Place,
    pub(super) vertices: RelativeBox,
    pub(super) acceleration: Point,
    pub(super) from: f64,
    pub(super) until: f64,
}

impl Shape {
    fn new(place: Place, mesh: &str, placement: Placement) -> Self {
        Self {
            place,
            mesh: mesh.to_owned(),
            placement,
            material: None,
            moved: None,
            initial: None,
            dirichlet: Vec::new(),
            neumann: Vec::new(),
        }
    }
}

/// `shape input FILE`.
pub(super) fn one(line: &mut Line<'_>) -> Result<Shape, Fault> {
    input(line)?;
    let mesh = line.word("a mesh file")?;
    Ok(Shape::new(line.place().clone(), mesh, Placement::default()))
}

/// `shapes input N`, with a line for each shape.
pub(super) fn several(line: &mut Line<'_>, text: &mut Text<'_>) -> Result<Vec<Shape>, Fault> {
    input(line)?;
    let count = line.count("the number of shapes")?;
    if count > MOST {
        return Err(line.invalid(&count.to_string(), &format!("at most {MOST} shapes")));
    }
    (0..count)
        .map(|_| {
            let expected = format!("{count} lines with a shape each");
            attributed(text.following(line.place(), &expected)?, text)
        })
        .collect()
}

/// `shapeMatrix input NX NY NZ X Y Z`, with a line for the shape.
pub(super) fn matrix(line: &mut Line<'_>, text: &mut Text<'_>) -> Result<Vec<Shape>, Fault> {
    input(line)?;
    let mut counts = [0; 3];
    for count in &mut counts {
        *count = line.count("three numbers of shapes")?;
    }
    if counts
        .iter()
        .try_fold(1_usize, |product, &count| product.checked_mul(count))
        .is_none_or(|count| count > MOST)
    {
        return Err(line.invalid(&format!("{counts:?}"), &format!("at most {MOST} shapes")));
    }
    let corner: Point = core::array::from_fn(|_| line.optional().unwrap_or(0.0));
    let mut following = text.following(line.place(), "a line with the shape")?;
    let mesh = following.word("a mesh file")?;
    let placement = placement(&mut following)?;
    let mut first = Shape::new(following.place().clone(), mesh, placement);
    if let Some(word) = following.keyword() {
        if word != "material" {
            return Err(following.invalid(word, "`material` or the end of the line"));
        }
        first.material = Some(material(&mut following)?);
    }
    let mut shapes = Vec::new();
    for x in 0..counts[0] {
        for y in 0..counts[1] {
            for z in 0..counts[2] {
                let mut shape = first.clone();
                let step = Vector3::new(x as f64, y as f64, z as f64);
                let shift = Vector3::from(placement.translate).component_mul(&step);
                shape.placement.translate = (Vector3::from(corner) + shift).into();
                shapes.push(shape);
            }
        }
    }
    Ok(shapes)
}

fn input(line: &mut Line<'_>) -> Result<(), Fault> {
    line.word("the word `input`").map(|_| ())
}

/// Translation, angles and scale factors.
fn placement(line: &mut Line<'_>) -> Result<Placement, Fault> {
    let translate = line.numbers("three numbers of a translation")?;
    let rotate = rotation(line.numbers("three angles in degrees")?);
    let scale = Scale(line.numbers("three scale factors")?);
    Ok(Placement {
        scale,
        rotate,
        translate,
    })
}

/// The rotation about z, then about y, then about x, by angles in degrees in the order x, y, z.
pub(super) fn rotation([x, y, z]: [f64; 3]) -> Option<Rotation> {
    Rotation::about_axes(&[(Vector3::x(), x), (Vector3::y(), y), (Vector3::z(), z)])
}

fn material(line: &mut Line<'_>) -> Result<SolidProperties, Fault> {
    let [density, young, poisson] = line.numbers("density, Young's modulus and Poisson's ratio")?;
    Ok(SolidProperties {
        density,
        young,
        poisson,
        energy: SolidMaterial::NeoHookean,
    })
}

/// The velocities of a shape. The first call sets their place.
fn velocities(shape: &mut Shape, place: Place) -> &mut [Point; 2] {
    let (_, velocities) = shape.moved.get_or_insert((place, [[0.0; 3]; 2]));
    velocities
}

fn radians(degrees: Point) -> Point {
    degrees.map(|degrees| degrees / 180.0 * PI)
}

/// A shape with its attributes. `\` at the end of a line continues it.
fn attributed<'a>(mut line: Line<'a>, text: &mut Text<'a>) -> Result<Shape, Fault> {
    let mesh = line.word("a mesh file")?;
    let mut shape = Shape::new(line.place().clone(), mesh, placement(&mut line)?);
    while let Some(keyword) = line.keyword() {
        let place = line.place().clone();
        match keyword {
            "material" => shape.material = Some(material(&mut line)?),
            "linearVelocity" => velocities(&mut shape, place)[0] = line.numbers("a velocity")?,
            "angularVelocity" => {
                let degrees = line.numbers("three angular velocities in degrees per second")?;
                velocities(&mut shape, place)[1] = radians(degrees);
            }
            "initVel" => {
                let linear = line.numbers("a velocity, then three angular velocities")?;
                let angular = radians(line.numbers("a velocity, then three angular velocities")?);
                shape.initial = Some((place, [linear, angular]));
            }
            "DBC" => {
                let vertices = relative_box(&mut line)?;
                let linear = line.numbers("a box, a velocity, and three angular velocities")?;
                let angular = radians(line.numbers("a box, a velocity, and three angular velocities")?);
                let [from, until] = times(&mut line);
                shape.dirichlet.push(Piece {
                    place,
                    vertices,
                    linear,
                    angular,
                    from,
                    until,
                });
            }
            "NBC" => {
                let vertices = relative_box(&mut line)?;
                let acceleration = line.numbers("a box and an acceleration")?;
                let [from, until] = times(&mut line);
                shape.neumann.push(Neumann {
                    place,
                    vertices,
                    acceleration,
                    from,
                    until,
                });
            }
            "meshSeq" => {
                let instead = "move the shape by `linearVelocity`, `angularVelocity` or `DBC`";
                return Err(line.unsupported("a sequence of meshes", instead));
            }
            "\\" => line = text.following(&place, "attributes of the shape")?,
            _ => return Err(Problem::Unknown { program: "IPC" }.at(&place)),
        }
    }
    Ok(shape)
}

fn relative_box(line: &mut Line<'_>) -> Result<RelativeBox, Fault> {
    let expected = "the lower and the upper corner of a box, in fractions of that of the mesh";
    let (lower, upper) = (line.numbers(expected)?, line.numbers(expected)?);
    Ok(RelativeBox { lower, upper })
}

/// The times of the start and of the end, if they are given.
fn times(line: &mut Line<'_>) -> [f64; 2] {
    [
        line.optional().unwrap_or(0.0),
        line.optional().unwrap_or(f64::INFINITY),
    ]
}
