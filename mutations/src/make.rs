//! A copy of the repository in which one crate has all mutations, and its test programs.

use std::collections::{BTreeSet, HashSet};
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

use crate::rewrite;

/// The function that each mutation calls: true if the environment has its number.
const MUTATED: &str = r#"
#[cfg(not(test))]
extern crate std;

#[inline]
pub(crate) fn mutated(id: u32) -> bool {
    static CHOSEN: std::sync::LazyLock<Option<u32>> =
        std::sync::LazyLock::new(|| std::env::var("EXACT_CCD_MUTATION").ok()?.parse().ok());
    *CHOSEN == Some(id)
}
"#;

/// Makes the test programs of `package` in `folder`: `mutations.tsv` lists the mutations, `programs` has the
/// programs, and `tree` the copy of the repository. Mutations that do not compile are dropped.
pub fn make(package: &str, folder: &Path) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    let folder = &folder.canonicalize()?;
    let tree = folder.join("tree");
    let mut dropped = HashSet::new();
    loop {
        let mutations = rewritten_copy(package, &tree, &dropped)?;
        let rejected = rejected(package, folder, &tree)?;
        eprintln!(
            "{} mutations; {} do not compile",
            mutations.lines().count(),
            rejected.len()
        );
        if rejected.is_empty() {
            fs::write(folder.join("mutations.tsv"), mutations)?;
            return test_programs(package, folder, &tree);
        }
        dropped.extend(rejected);
    }
}

/// Copies the files of the repository, and rewrites the crate's own. Returns the list of its mutations.
fn rewritten_copy(package: &str, tree: &Path, dropped: &HashSet<u32>) -> Result<String, Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"))
        .parent()
        .ok_or("the crate is in the repository")?;
    let listed = Command::new("git")
        .args(["ls-files", "-z"])
        .current_dir(root)
        .output()?;
    for file in String::from_utf8(listed.stdout)?.split_terminator('\0') {
        let (from, to) = (root.join(file), tree.join(file));
        if from.is_file() {
            fs::create_dir_all(to.parent().ok_or("a file is in a folder")?)?;
            fs::copy(from, to)?;
        }
    }
    let source = tree.join("crates").join(package).join("src");
    let (mut files, mut tests) = (BTreeSet::new(), BTreeSet::new());
    collect(&source, &mut files, &mut tests)?;
    let (mut list, mut next) = (String::new(), 1);
    for path in files {
        // A module of tests is a file or a folder.
        if tests
            .iter()
            .any(|module| path.starts_with(module) || path == module.with_extension("rs"))
        {
            continue;
        }
        let name = path.strip_prefix(&source)?.to_string_lossy().into_owned();
        let text = fs::read_to_string(&path)?;
        if name == "lib.rs" {
            fs::write(&path, text + MUTATED)?;
            continue;
        }
        let rewritten = rewrite::rewrite(&text, &name, next, dropped)?;
        next = rewritten.next;
        fs::write(&path, rewritten.source)?;
        for mutation in rewritten.mutations {
            list += &format!("{}\t{}\n", mutation.id, mutation.place);
        }
    }
    Ok(list)
}

/// All source files under `folder`, and the paths, without extension, of modules for tests only.
fn collect(
    folder: &Path,
    files: &mut BTreeSet<PathBuf>,
    tests: &mut BTreeSet<PathBuf>,
) -> Result<(), Box<dyn Error>> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            collect(&path, files, tests)?;
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let modules = match path.file_stem().and_then(|name| name.to_str()) {
                Some("lib" | "mod") | None => folder.to_path_buf(),
                Some(name) => folder.join(name),
            };
            for module in rewrite::test_modules(&fs::read_to_string(&path)?)? {
                tests.insert(modules.join(module));
            }
            files.insert(path);
        }
    }
    Ok(())
}

fn cargo(folder: &Path, tree: &Path, arguments: &[&str]) -> Command {
    let mut cargo = Command::new("cargo");
    cargo
        .args(arguments)
        .args(["--locked", "--message-format", "json"])
        .current_dir(tree);
    cargo
        .env("CARGO_TARGET_DIR", folder.join("target"))
        .env("RUSTFLAGS", "--allow warnings");
    cargo
}

/// The mutations before which the compiler finds an error.
fn rejected(package: &str, folder: &Path, tree: &Path) -> Result<HashSet<u32>, Box<dyn Error>> {
    let checked = cargo(folder, tree, &["check", "--lib", "--package", package]).output()?;
    let mut rejected = HashSet::new();
    for line in String::from_utf8(checked.stdout)?.lines() {
        let message = &serde_json::from_str::<Value>(line)?["message"];
        if message["level"] != "error" {
            continue;
        }
        for span in message["spans"].as_array().into_iter().flatten() {
            // Where a value is moved in a loop, the place at which it would have been replaced.
            let label = span["label"].as_str().unwrap_or_default();
            if span["is_primary"] != true && !label.contains("might get skipped") {
                continue;
            }
            let source = fs::read(tree.join(span["file_name"].as_str().ok_or("a span has a file")?))?;
            let end = span["byte_end"].as_u64().ok_or("a span has an end")? as usize;
            let start = span["byte_start"].as_u64().ok_or("a span has a start")? as usize;
            let inside = numbers(&String::from_utf8_lossy(&source[start..end]));
            if inside.is_empty() {
                rejected.extend(numbers(&String::from_utf8_lossy(&source[..start])).last());
            } else {
                rejected.extend(inside);
            }
        }
    }
    if rejected.is_empty() && !checked.status.success() {
        return Err(String::from_utf8_lossy(&checked.stderr).into());
    }
    Ok(rejected)
}

/// The numbers of all mutations in a piece of source code.
fn numbers(source: &str) -> Vec<u32> {
    let after = source.split("crate::mutated(").skip(1);
    after
        .filter_map(|rest| rest.split("u32").next()?.parse().ok())
        .collect()
}

/// The test of all bits of generated answers; it also tests the crates below the meshes.
const ANSWERS: &[&str] = &["--package", "exact-ccd-mesh", "--test", "architectures"];

/// Compiles the tests, and copies the programs.
fn test_programs(package: &str, folder: &Path, tree: &Path) -> Result<(), Box<dyn Error>> {
    eprintln!("compiling the tests of {package}");
    let programs = folder.join("programs");
    // Programs of an earlier run have other mutations.
    if programs.exists() {
        fs::remove_dir_all(&programs)?;
    }
    fs::create_dir_all(&programs)?;
    let own: &[&str] = match package {
        // The tests of the kernel that need generators or the definition are in another crate.
        "exact-ccd" => &["--package", "exact-ccd", "--package", "exact-ccd-testing"],
        _ => &["--package", package],
    };
    for tests in [own, ANSWERS] {
        let built = cargo(folder, tree, &[&["test", "--no-run"], tests].concat()).output()?;
        if !built.status.success() {
            return Err(String::from_utf8_lossy(&built.stderr).into());
        }
        for line in String::from_utf8(built.stdout)?.lines() {
            let message: Value = serde_json::from_str(line)?;
            if let (Some(program), Some(name)) =
                (message["executable"].as_str(), message["target"]["name"].as_str())
                && message["profile"]["test"] == true
            {
                fs::copy(program, programs.join(name))?;
            }
        }
    }
    Ok(())
}
