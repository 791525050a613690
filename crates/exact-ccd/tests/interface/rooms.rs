//! The order of the modules: each imports only earlier ones. No files of this crate import each other in a
//! circle, and no files of some crates beside it in the repository.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// The modules of the crate, from the ground up. The modules of one line do not import each other.
const ORDER: &[&[&str]] = &[
    &["tables", "environment"],
    &["values"],
    &["exact"],
    &["numbers"],
    &["fixed"],
    &["filter"],
    &["decided"],
    &["decide"],
    &["vectors"],
    &["kind"],
    &["query"],
    &["collision"],
    &["answers", "exactly", "weights"],
    &["motion"],
    &["predicates", "batch", "gradient"],
    &["ccd"],
    &["lib"],
];

/// A source file: its module path, and the module paths that its code names.
struct File {
    path: Vec<String>,
    named: Vec<Vec<String>>,
}

/// The place of a module in the order.
fn rank(module: &str) -> usize {
    let place = ORDER.iter().position(|line| line.contains(&module));
    place.unwrap_or_else(|| panic!("module {module} has no place in the order"))
}

const THIS: &str = env!("CARGO_MANIFEST_DIR");

/// The source files of the crate in a folder.
fn sources(package: &Path) -> Vec<File> {
    let root = package.join("src");
    let mut folders = vec![root.clone()];
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder of sources") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let text = fs::read_to_string(&path).expect("a source file");
                let module = module_of(path.strip_prefix(&root).expect("below the root"));
                let named = named(&text, &module, path.ends_with("mod.rs"));
                files.push(File { path: module, named });
            }
        }
    }
    files
}

fn module_of(file: &Path) -> Vec<String> {
    let file: PathBuf = if file.ends_with("mod.rs") {
        file.with_file_name("")
    } else {
        file.with_extension("")
    };
    file.iter()
        .map(|part| part.to_string_lossy().into_owned())
        .collect()
}

/// The paths that begin with `crate` or `super` outside comments and re-exports. A module in a file that is
/// indented is one of tests, for which `super` is that file.
fn named(text: &str, module: &[String], is_folder: bool) -> Vec<Vec<String>> {
    let mut paths = Vec::new();
    for line in text.lines() {
        let code = line.trim_start();
        if code.starts_with("//") || code.starts_with("pub use") || code.starts_with("pub(crate) use") {
            continue;
        }
        let own = line.len() == code.len();
        for (start, base) in [("crate::", Vec::new()), ("super::", parent(module))] {
            if start == "super::" && !own {
                continue;
            }
            // In a macro for other crates, `$crate` is the name of this one.
            let is_import = |&(at, _): &(usize, &str)| !code[..at].ends_with("$d ");
            for (at, _) in code.match_indices(start).filter(is_import) {
                let rest = &code[at + start.len()..];
                let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'));
                let parts = rest[..end.unwrap_or(rest.len())].split("::");
                let parts = parts.filter(|part| !part.is_empty()).map(str::to_owned);
                let mut path: Vec<String> = base.iter().cloned().chain(parts).collect();
                // A list of modules is no path, and has no place in the order.
                if path.is_empty() {
                    path.push("crate".to_owned());
                }
                paths.push(path);
            }
        }
        // The files of a folder, imported by its own module.
        if own
            && is_folder
            && let Some(rest) = code.strip_prefix("use ")
        {
            let first = rest.split("::").next().unwrap_or_default().to_owned();
            paths.push(module.iter().cloned().chain([first]).collect());
        }
    }
    paths
}

fn parent(module: &[String]) -> Vec<String> {
    module[..module.len().saturating_sub(1)].to_vec()
}

#[test]
fn modules_name_only_those_before_them() {
    let mut arrows = 0;
    for file in sources(Path::new(THIS)) {
        let own = &file.path[0];
        for target in file.named.iter().filter_map(|path| path.first()) {
            if target != own {
                arrows += 1;
                assert!(
                    rank(target) < rank(own),
                    "{}: {target} comes later",
                    file.path.join("::")
                );
            }
        }
    }
    assert!(arrows > 200, "{arrows}");
}

#[test]
fn no_files_import_each_other_in_a_circle() {
    let this = Path::new(THIS);
    assert_no_circles(this);
    for name in ["cli", "import", "scene", "sim"] {
        let beside = this.with_file_name(format!("exact-ccd-{name}"));
        // A package is alone in its folder.
        if beside.is_dir() {
            assert_no_circles(&beside);
        }
    }
}

fn assert_no_circles(package: &Path) {
    let files = sources(package);
    let index: BTreeMap<&[String], usize> = files
        .iter()
        .enumerate()
        .map(|(i, file)| (&file.path[..], i))
        .collect();
    // The file of a path is the file of its longest beginning that names a module.
    let file_of = |path: &[String]| {
        (1..=path.len())
            .rev()
            .find_map(|n| index.get(&path[..n]).copied())
    };
    let mut imports: Vec<Vec<usize>> = files
        .iter()
        .enumerate()
        .map(|(i, file)| {
            file.named
                .iter()
                .filter_map(|path| file_of(path))
                .filter(|&j| j != i)
                .collect()
        })
        .collect();
    // Files without imports are taken away until none is left.
    let mut left: Vec<usize> = (0..files.len()).collect();
    while !left.is_empty() {
        let count = left.len();
        left.retain(|&i| !imports[i].is_empty());
        for list in &mut imports {
            list.retain(|j| left.contains(j));
        }
        let names = || left.iter().map(|&i| files[i].path.join("::")).collect::<Vec<_>>();
        assert!(
            left.len() < count,
            "{}: a circle among {:?}",
            package.display(),
            names()
        );
    }
}
