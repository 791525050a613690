//! The answers to generated queries and steps in three numbers, which are the same on every machine:
//! `scripts/check architectures` runs the program, and `cargo test` compares the numbers too.
//!
//! The exit status is 0 if all equal the numbers recorded here. For each file of raw queries (`raw.rs`), it
//! prints a line with the digest of the answers.

mod kernel;
mod meshes;
#[cfg(not(test))]
mod raw;

/// The digest of the answers of the kernel. A change by intent is recorded anew.
const KERNEL: u64 = 0x34a9_b65f_c6b6_ce4b;
/// The digest of the stages that decide these queries. It changes with the reach of a filter.
const STAGES: u64 = 0x5431_ef8d_6296_9dbd;
/// The digest of the answers to steps of meshes.
const MESHES: u64 = 0x8387_125a_322a_943b;

#[cfg(not(test))]
fn main() -> std::process::ExitCode {
    use std::process::ExitCode;

    let mut all_right = true;
    let mut check = |name: &str, found: u64, recorded: u64| {
        println!("{name} {found:#018x}, recorded {recorded:#018x}");
        all_right &= found == recorded;
    };
    check("kernel", kernel::digest(), KERNEL);
    check("stages", kernel::stages(), STAGES);
    for threads in meshes::THREADS {
        let found = meshes::digest(threads);
        check(&format!("meshes, threads {threads}"), found, MESHES);
    }
    for path in std::env::args().skip(1) {
        match raw::digest(&path) {
            Ok(found) => println!("{path} {found:#018x}"),
            Err(error) => {
                eprintln!("{path}: {error}");
                return ExitCode::from(2);
            }
        }
    }
    ExitCode::from(u8::from(!all_right))
}

#[test]
fn the_answers_of_the_kernel_are_those_recorded() {
    assert_eq!(kernel::digest(), KERNEL);
}

#[test]
fn the_stages_of_the_kernel_are_those_recorded() {
    assert_eq!(kernel::stages(), STAGES);
}

#[test]
fn the_answers_to_steps_are_those_recorded_with_any_number_of_threads() {
    meshes::THREADS.for_each(|threads| assert_eq!(meshes::digest(threads), MESHES, "{threads} threads"));
}
