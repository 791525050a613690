//! ParaView's collections: one file for each time.

use std::io;

use super::check::invalid;
use super::xml::attribute;

/// Writes a collection, `.pvd`, with one file for each time. ParaView opens it as an animation.
///
/// `frames` are times and paths of `.vtu` files relative to the folder of the collection.
///
/// ```
/// let mut pvd = Vec::new();
/// exact_ccd_files::write_pvd(&mut pvd, [(0.0, "0.vtu"), (0.1, "1.vtu")])?;
/// assert!(String::from_utf8_lossy(&pvd).contains(r#"<DataSet timestep="0.1" file="1.vtu"/>"#));
/// # Ok::<(), std::io::Error>(())
/// ```
///
/// # Errors
/// The errors of the writer; and [`InvalidInput`](io::ErrorKind::InvalidInput) for a time that is not
/// finite or a path with a character that XML does not allow.
pub fn write_pvd(
    mut writer: impl io::Write,
    frames: impl IntoIterator<Item = (f64, impl AsRef<str>)>,
) -> io::Result<()> {
    let mut file = String::from(
        "<?xml version=\"1.0\"?>\n\
         <VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
         <Collection>\n",
    );
    for (time, path) in frames {
        if !time.is_finite() {
            return Err(invalid(format!("the time is {time}, expected a finite number")));
        }
        let path = attribute("path", path.as_ref())?;
        file += &format!("<DataSet timestep=\"{time:?}\" file=\"{path}\"/>\n");
    }
    file += "</Collection>\n</VTKFile>\n";
    writer.write_all(file.as_bytes())
}
