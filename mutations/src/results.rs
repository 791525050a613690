//! The outcomes of mutations, and their file.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::error::Error;
use std::fs::{self, File};
use std::io::Write;
use std::path::Path;

#[derive(Clone, PartialEq)]
pub enum Outcome {
    /// The name of a test that fails.
    Fails(String),
    /// The tests take longer than eight times their time, and two seconds more.
    NoEnd,
    Survives,
}

/// The outcome of each mutation, and the time of its tests in seconds, as the round has it.
pub type Results<'a> = BTreeMap<&'a str, (Outcome, f64)>;

/// The file of a mutation.
pub fn file_of(mutation: &str) -> &str {
    mutation.split(['\t', ':']).nth(1).unwrap_or_default()
}

/// The results of earlier runs, if there are any.
pub fn read<'a>(folder: &Path, mutations: &[&'a str]) -> Result<Results<'a>, Box<dyn Error>> {
    let path = folder.join("results.tsv");
    let text = if path.exists() {
        fs::read_to_string(path)?
    } else {
        String::new()
    };
    let places: HashMap<&str, &str> = mutations.iter().map(|mutation| (*mutation, *mutation)).collect();
    let mut results = Results::new();
    for line in text.lines() {
        let columns = line.splitn(3, '\t').collect::<Vec<_>>();
        let [outcome, seconds, mutation] = columns[..] else {
            return Err("results.tsv is damaged".into());
        };
        let mutation = places
            .get(mutation)
            .ok_or("results.tsv is of other mutations: remove it")?;
        let outcome = match outcome.strip_prefix("fails ") {
            Some(test) => Outcome::Fails(test.to_owned()),
            None if outcome == "no end" => Outcome::NoEnd,
            None => Outcome::Survives,
        };
        results.insert(mutation, (outcome, seconds.parse()?));
    }
    Ok(results)
}

/// Writes the results.
pub fn write(folder: &Path, results: &Results) -> Result<(), Box<dyn Error>> {
    let mut file = File::create(folder.join("results.tsv"))?;
    for (mutation, (outcome, seconds)) in results {
        match outcome {
            Outcome::Fails(test) => writeln!(file, "fails {test}\t{seconds}\t{mutation}")?,
            Outcome::NoEnd => writeln!(file, "no end\t{seconds}\t{mutation}")?,
            Outcome::Survives => writeln!(file, "survives\t{seconds}\t{mutation}")?,
        }
    }
    Ok(())
}

/// Prints the number of each outcome by file.
pub fn print_table(mutations: &[&str], results: &Results) {
    println!("| file | mutations | run | a test fails | no end | survive |\n|---|---:|---:|---:|---:|---:|");
    let files: BTreeSet<&str> = mutations.iter().map(|mutation| file_of(mutation)).collect();
    for name in files {
        let all = mutations
            .iter()
            .filter(|mutation| file_of(mutation) == name)
            .count();
        let of_file = || {
            results
                .iter()
                .filter(|(mutation, _)| file_of(mutation) == name)
                .map(|(_, (outcome, _))| outcome)
        };
        let count = |is: fn(&Outcome) -> bool| of_file().filter(|outcome| is(outcome)).count();
        println!(
            "| `{name}` | {all} | {} | {} | {} | {} |",
            of_file().count(),
            count(|outcome| matches!(outcome, Outcome::Fails(_))),
            count(|outcome| *outcome == Outcome::NoEnd),
            count(|outcome| *outcome == Outcome::Survives),
        );
    }
}
