//! The meshes that come with the repository, and the output for them in the documentation.

use std::path::Path;

use crate::folder::{Folder, Run};
use crate::step::without_seconds;

#[test]
fn the_sheet_drapes_freely_or_not() {
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let example = |name| repository.join("examples").join(name).display().to_string();
    let (start, free, contact) = (
        example("drape_start.ply"),
        example("drape_free.ply"),
        example("drape_contact.ply"),
    );
    let step = |end: &str| Folder::new().run(&["step", &start, end]);
    assert_eq!(step(&free).status, 0);
    let run = step(&contact);
    assert_eq!(run.status, 1);
    let readme = std::fs::read_to_string(repository.join("README.md")).unwrap();
    assert!(readme.contains(without_seconds(&run)), "{run:?}");
}

#[test]
fn the_audit_in_the_documentation() {
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let arguments = ["audit", "examples/drape_start.ply", "examples/drape_contact.ply"];
    let output = Folder::new()
        .program(&arguments)
        .current_dir(&repository)
        .output();
    let run: Run = output.unwrap().into();
    assert_eq!(run.status, 1);
    let page = std::fs::read_to_string(repository.join("docs/program.md")).unwrap();
    let example = format!("$ exact-ccd {}\n{}", arguments.join(" "), without_seconds(&run));
    assert!(page.contains(&example), "{run:?}");
}
