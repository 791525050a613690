//! Queries of both kinds: the answers agree with the exact path and are invariant under symmetries; the
//! parity agrees with its definition.

#![no_main]

use arbitrary::{Result, Unstructured};
use exact_ccd::{EdgeEdge, Separation, VertexFace};
use exact_ccd_fuzz::coordinate;
use exact_ccd_methods::parity::Rounded;
use libfuzzer_sys::fuzz_target;

use exact_ccd_testing::changes::{Change, nudge, scaled};
use exact_ccd_testing::contacts::{grazing, touching};
use exact_ccd_testing::kinds::{self, Renamed};
use exact_ccd_testing::laws;
use exact_ccd_testing::parity::{self, Rim};
use exact_ccd_testing::primitives::{Points, Primitives};
use exact_ccd_testing::symmetry::{self, Symmetry};

fuzz_target!(|bytes: &[u8]| {
    // Too few bytes do not make a query.
    let _ = check(&mut Unstructured::new(bytes));
});

/// The changes that make points degenerate.
struct Recipe {
    changes: Vec<Change>,
    contact: Contact,
    nudges: Vec<([usize; 3], i8)>,
}

/// A contact that is imposed at a time and place.
enum Contact {
    None,
    Touching([f64; 3]),
    Grazing([f64; 3], [f64; 2]),
}

fn check(bytes: &mut Unstructured) -> Result<()> {
    let recipe = recipe(bytes)?;
    let symmetry = symmetry(bytes)?;
    let points = points(bytes)?;
    check_kind::<VertexFace>(&recipe, &symmetry, points);
    check_kind::<EdgeEdge>(&recipe, &symmetry, points);
    Ok(())
}

fn check_kind<K: Primitives + Renamed + Rim>(recipe: &Recipe, symmetry: &Symmetry, mut points: Points) {
    recipe.changes.iter().for_each(|change| change.apply(&mut points));
    let points = match recipe.contact {
        Contact::None => points,
        Contact::Touching(place) => touching::<K>(points, place),
        Contact::Grazing(place, velocity) => grazing::<K>(points, place, velocity),
    };
    let points = nudge(points, &recipe.nudges);
    if points.as_flattened().as_flattened().iter().all(|x| x.is_finite()) {
        let query = kinds::query::<K>(&points);
        laws::checked(&query, Separation::ZERO);
        if let Ok(rounded) = Rounded::shift(&query) {
            parity::laws::assert_defined(&rounded);
        }
        symmetry::assert_symmetric::<K>(&points, Separation::ZERO, symmetry);
        laws::assert_reversible(&query, Separation::ZERO);
    }
}

/// Points with few values, so that many coordinates are equal.
fn points(bytes: &mut Unstructured) -> Result<Points> {
    let mut values = [0.0; 8];
    for value in &mut values {
        *value = coordinate(bytes)?;
    }
    let mut points = Points::default();
    for x in points.as_flattened_mut().as_flattened_mut() {
        *x = values[index(bytes, values.len())?];
    }
    Ok(points)
}

fn recipe(bytes: &mut Unstructured) -> Result<Recipe> {
    let changes = several(bytes, change)?;
    let contact = match bytes.arbitrary::<u8>()? % 4 {
        0 => Contact::Touching(place(bytes)?),
        1 => Contact::Grazing(place(bytes)?, [coordinate(bytes)?, coordinate(bytes)?]),
        _ => Contact::None,
    };
    let nudges = several(bytes, |bytes| {
        let at = [index(bytes, 2)?, index(bytes, 4)?, index(bytes, 3)?];
        Ok((at, bytes.int_in_range(-4..=4)?))
    })?;
    Ok(Recipe {
        changes,
        contact,
        nudges,
    })
}

fn several<T>(bytes: &mut Unstructured, one: impl Fn(&mut Unstructured) -> Result<T>) -> Result<Vec<T>> {
    (0..bytes.int_in_range(0..=3)?).map(|_| one(bytes)).collect()
}

fn index(bytes: &mut Unstructured, length: usize) -> Result<usize> {
    bytes.int_in_range(0..=length - 1)
}

/// A time and parameters, in sixteenths or as any fraction.
fn place(bytes: &mut Unstructured) -> Result<[f64; 3]> {
    let mut place = [0.0; 3];
    for parameter in &mut place {
        *parameter = match bytes.arbitrary::<u8>()? {
            kind @ ..0x80 => f64::from(kind % 17) / 16.0,
            _ => scaled(f64::from(bytes.arbitrary::<u32>()?), -32),
        };
    }
    Ok(place)
}

fn change(bytes: &mut Unstructured) -> Result<Change> {
    Ok(match bytes.arbitrary::<u8>()? % 8 {
        0 => Change::Rest(index(bytes, 4)?),
        1 => Change::Drift(index(bytes, 4)?),
        2 => Change::Flatten(index(bytes, 3)?),
        _ => Change::Combine {
            points: order(bytes)?,
            factors: [bytes.int_in_range(-1..=2)?, bytes.int_in_range(-1..=1)?],
            ends: [[true, true], [true, false], [false, true]][index(bytes, 3)?],
        },
    })
}

/// A permutation of 0, 1, ….
fn order<const N: usize>(bytes: &mut Unstructured) -> Result<[usize; N]> {
    let mut order = core::array::from_fn(|i| i);
    for i in 1..N {
        order.swap(i, index(bytes, i + 1)?);
    }
    Ok(order)
}

fn symmetry(bytes: &mut Unstructured) -> Result<Symmetry> {
    let exponent = |bytes: &mut Unstructured| bytes.int_in_range(-1000..=1000);
    Ok(Symmetry {
        renaming: index(bytes, 8)?,
        axes: order(bytes)?,
        mirrored: bytes.arbitrary()?,
        exponents: [exponent(bytes)?, exponent(bytes)?, exponent(bytes)?],
    })
}
