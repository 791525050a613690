//! ParaView's collections: which file shows which time.

use std::io;

/// Writes a collection, `.pvd`, of files that show one time each: ParaView opens it as an animation.
///
/// `frames` are times, and paths of `.vtu` files as seen from where the collection will be.
///
/// ```
/// let mut pvd = Vec::new();
/// exact_ccd_mesh::write_pvd(&mut pvd, [(0.0, "0.vtu"), (0.1, "1.vtu")])?;
/// assert!(String::from_utf8_lossy(&pvd).contains(r#"<DataSet timestep="0.1" file="1.vtu"/>"#));
/// # Ok::<(), std::io::Error>(())
/// ```
///
/// # Errors
/// Those of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput) for a time that is not finite or a path with a
/// character that XML does not have.
pub fn write_pvd(
    mut writer: impl io::Write,
    frames: impl IntoIterator<Item = (f64, impl AsRef<str>)>,
) -> io::Result<()> {
    let invalid = |what: String| io::Error::new(io::ErrorKind::InvalidInput, what);
    let mut file = String::from(
        "<?xml version=\"1.0\"?>\n\
         <VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
         <Collection>\n",
    );
    for (time, path) in frames {
        let path = path.as_ref();
        if !time.is_finite() {
            return Err(invalid(format!("the time {time} is not finite")));
        }
        let path =
            escaped(path).ok_or_else(|| invalid(format!("the path {path:?} does not fit into XML")))?;
        file += &format!("<DataSet timestep=\"{time:?}\" file=\"{path}\"/>\n");
    }
    file += "</Collection>\n</VTKFile>\n";
    writer.write_all(file.as_bytes())
}

/// Text as the value of an attribute, if XML 1.0 has all of its characters.
fn escaped(text: &str) -> Option<String> {
    let mut escaped = String::new();
    for character in text.chars() {
        match character {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            '"' => escaped += "&quot;",
            '\t' | '\n' | '\r' => escaped += &format!("&#{};", u32::from(character)),
            '\0'..'\u{20}' | '\u{fffe}' | '\u{ffff}' => return None,
            _ => escaped.push(character),
        }
    }
    Some(escaped)
}
