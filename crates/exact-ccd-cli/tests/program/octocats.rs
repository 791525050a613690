//! The lengths of the scene of three octocats, whose meshes come with the published data.

use std::path::{Path, PathBuf};

use exact_ccd_mesh::Aabb;
use exact_ccd_scene::Scene;
use exact_ccd_sim::{Settings, StepFilter, System};

/// The box along the axes of the bodies, without the bowl, and the lengths that follow from it are the same
/// as in the code of *Incremental Potential Contact*, whose box has a diagonal of 8.381 m.
#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn octocats_have_the_lengths_of_incremental_potential_contact() {
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let data = std::env::var_os("EXACT_CCD_DATA");
    let data = data.map_or_else(|| repository.join("../shared/data"), PathBuf::from);
    let scene = repository.join("examples/scenes/octocats.toml");
    let exact = |_: &mut Settings, _: &System| Ok(StepFilter::default());
    let scene = Scene::read(scene, Some(&data.join("meshes")), &exact).unwrap();
    let octocats = scene.simulation.system().body_vertices()[..3]
        .iter()
        .cloned()
        .flatten();
    let bounds: Aabb = octocats
        .map(|vertex| scene.simulation.system().start()[vertex as usize])
        .collect();
    let diagonal = bounds.sides().map(|side| side * side).iter().sum::<f64>().sqrt();
    assert!((diagonal - 8.381).abs() < 5e-4, "{diagonal}");
    let size = scene.simulation.system().size();
    assert!(size < diagonal, "{size}");
    let lengths = [
        scene.simulation.settings().contact_distance,
        scene.simulation.settings().tolerance,
    ];
    for (length, share) in lengths.into_iter().zip([1e-3, 1e-2]) {
        assert!(
            (length.meters(size) / (share * 8.381) - 1.0).abs() < 1e-4,
            "{length:?}"
        );
    }
}
