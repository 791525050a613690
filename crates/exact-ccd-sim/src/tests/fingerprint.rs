//! Hashes of materials.

use std::collections::BTreeSet;

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

use crate::body::{
    AffineProperties, BodyKind, ParticleProperties, RodProperties, ShellProperties, SolidProperties,
};
use crate::digest::Hash;
use crate::energies::elasticity::SolidMaterial;

/// The hashes of a kind with a material and with changes of each of its numbers.
fn hashes<M: Serialize + DeserializeOwned>(material: &M, kind: impl Fn(M) -> BodyKind) -> Vec<String> {
    let Value::Object(fields) = serde_json::to_value(material).unwrap() else {
        panic!("a material has fields")
    };
    let hash = |fields| Hash::of(&kind(serde_json::from_value(Value::Object(fields)).unwrap()));
    let numbers = fields
        .iter()
        .filter_map(|(name, value)| Some((name, value.as_f64()?)));
    let changed = numbers.map(|(name, value)| {
        let mut fields = fields.clone();
        fields[name] = (1.5 * value).into();
        hash(fields)
    });
    let changed: Vec<String> = changed.collect();
    assert!(changed.len() > 1);
    [vec![hash(fields.clone())], changed].concat()
}

const SHELL: ShellProperties = ShellProperties {
    density: 0.1,
    young: 0.1,
    poisson: 0.1,
    thickness: 0.1,
    strain_limit: Some(0.1),
};

const ROD: RodProperties = RodProperties {
    density: 0.1,
    young: 0.1,
    radius: 0.1,
    shear: Some(0.1),
};

fn shell(material: ShellProperties) -> BodyKind {
    let faces = Vec::new();
    BodyKind::Shell { faces, material }
}

fn rod(material: RodProperties) -> BodyKind {
    let edges = Vec::new();
    BodyKind::Rod { edges, material }
}

/// All numbers are equal before, so that no number of the hash stands for another one.
#[test]
fn every_number_of_a_material_counts() {
    let particles = ParticleProperties {
        density: 0.1,
        radius: 0.1,
    };
    let affine = AffineProperties {
        density: 0.1,
        stiffness: 0.1,
    };
    let mut all = [
        hashes(&SHELL, shell),
        hashes(&ROD, rod),
        hashes(&particles, |material| BodyKind::Particles { material }),
        hashes(&affine, |material| {
            let faces = Vec::new();
            BodyKind::Affine { faces, material }
        }),
    ]
    .concat();
    for energy in SolidMaterial::ALL {
        let material = SolidProperties {
            density: 0.1,
            young: 0.1,
            poisson: 0.1,
            energy,
        };
        all.extend(hashes(&material, |material| BodyKind::Solid {
            tetrahedra: Vec::new(),
            material,
            regions: Vec::new(),
        }));
    }
    let (strain_limit, shear) = (None, None);
    all.push(Hash::of(&shell(ShellProperties {
        strain_limit,
        ..SHELL
    })));
    all.push(Hash::of(&rod(RodProperties { shear, ..ROD })));
    let distinct: BTreeSet<&String> = all.iter().collect();
    assert_eq!(distinct.len(), all.len());
}

/// A number that follows a material, as the offset does, does not stand for a parameter without a value.
#[test]
fn a_parameter_without_a_value_has_its_place() {
    let (strain_limit, shear) = (None, None);
    for (without, with) in [
        (
            shell(ShellProperties {
                strain_limit,
                ..SHELL
            }),
            shell(SHELL),
        ),
        (rod(RodProperties { shear, ..ROD }), rod(ROD)),
    ] {
        assert_ne!(Hash::of(&(&without, [0.1, 0.2])), Hash::of(&(&with, [0.2])));
    }
}
