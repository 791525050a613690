//! The order of publication in the documentation for contributors.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// The dependencies of all published crates on each other, from their manifests.
fn dependencies(crates: &Path) -> BTreeMap<String, Vec<String>> {
    let folders = fs::read_dir(crates).unwrap().map(|entry| entry.unwrap());
    let name_and_dependencies = folders.filter_map(|folder| {
        let manifest = fs::read_to_string(folder.path().join("Cargo.toml")).unwrap();
        if manifest.contains("publish = false") {
            return None;
        }
        let names = manifest.lines().filter_map(|line| {
            let name = line.split(['.', ' ', '=']).next()?;
            name.starts_with("exact-ccd").then(|| name.to_owned())
        });
        Some((folder.file_name().into_string().unwrap(), names.collect()))
    });
    name_and_dependencies.collect()
}

#[test]
fn every_crate_is_published_after_its_dependencies() {
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let page = fs::read_to_string(repository.join("CONTRIBUTING.md")).unwrap();
    let (_, list) = page.split_once("in the order of the dependencies:").unwrap();
    let order: Vec<&str> = list
        .split('`')
        .filter(|word| word.starts_with("exact-ccd"))
        .collect();
    let crates = dependencies(&repository.join("crates"));
    assert_eq!(order.len(), crates.len(), "{order:?}");
    let position = |name: &str| {
        let place = order.iter().position(|other| *other == name);
        place.unwrap_or_else(|| panic!("{name} is missing"))
    };
    for (name, dependencies) in &crates {
        for dependency in dependencies.iter().filter(|dependency| *dependency != name) {
            assert!(position(dependency) < position(name), "{name}: {dependency}");
        }
    }
    let of_sim = &crates["exact-ccd-sim"];
    assert!(of_sim.contains(&"exact-ccd-mesh".to_owned()), "{of_sim:?}");
}
