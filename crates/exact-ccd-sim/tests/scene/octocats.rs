//! The lengths of the scene of three octocats, whose meshes come with the published data.

use std::path::Path;

use exact_ccd_sim::scene::Scene;

use crate::filter;

/// The box of the bodies, without the bowl, and the lengths that follow from it are those of the code of
/// *Incremental Potential Contact*, whose box has a diagonal of 8.381 m.
#[test]
fn octocats_have_the_lengths_of_incremental_potential_contact() {
    let Some(data) = std::env::var_os("EXACT_CCD_DATA") else {
        eprintln!("skipped: EXACT_CCD_DATA does not name the folder of the published data");
        return;
    };
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/scenes/octocats.toml");
    let scene = Scene::read(scene, Some(&Path::new(&data).join("meshes")), &filter).unwrap();
    let size = scene.system.size();
    assert!((size - 8.381).abs() < 5e-4, "{size}");
    let settings = &scene.settings;
    let lengths = [
        settings.contact_distance,
        settings.tolerance,
        settings.friction.static_velocity,
    ];
    for (length, share) in lengths.into_iter().zip([1e-3, 1e-2, 1e-3]) {
        assert!(
            (length.meters(size) / (share * 8.381) - 1.0).abs() < 1e-4,
            "{length:?}"
        );
    }
}
