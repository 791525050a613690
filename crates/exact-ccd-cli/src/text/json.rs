//! Reports as JSON.

use serde::Serialize;

/// The version of the format of all reports. It grows if a field changes its meaning or is left out.
const VERSION: u32 = 1;

#[derive(Serialize)]
struct Versioned<'a, T> {
    version: u32,
    command: &'static str,
    #[serde(flatten)]
    report: &'a T,
}

/// The report of a command as a JSON object on one line.
pub(crate) fn to_json(command: &'static str, report: &impl Serialize) -> String {
    let report = Versioned {
        version: VERSION,
        command,
        report,
    };
    serde_json::to_string(&report).expect("numbers and names only")
}
