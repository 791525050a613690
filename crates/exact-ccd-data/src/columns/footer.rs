//! A check of the metadata at the end of a file, before the library reads them.
//!
//! The library builds the tree of columns by recursion, and reserves memory for as many children as a group
//! announces. Metadata pass this check only if their elements are the nodes of one tree of small depth, and
//! all that they name lies in the file.
//!
//! Apache Parquet, *File Format* and `parquet.thrift`.

use bytes::Bytes;
use parquet::errors::{ParquetError, Result};
use parquet::file::reader::{ChunkReader, Length};

use super::counted_file::CountedFile;
use super::format::FILE_METADATA;
use super::thrift::{STRUCT, Thrift};

/// The most levels of groups within groups.
const DEPTH: usize = 32;
/// The length of the metadata and the mark `PAR1` at the end.
const END: u64 = 8;

/// The metadata of a file, checked.
///
/// # Errors
/// If the file cannot be read, or its metadata are not as stated above.
pub(super) fn metadata(file: &CountedFile) -> Result<Bytes> {
    let wrong = |problem: &str| Err(ParquetError::General(problem.to_owned()));
    let Some(start) = file.len().checked_sub(END) else {
        return wrong("the file is too short for metadata");
    };
    let end = file.get_bytes(start, END as usize)?;
    let Some((&length, b"PAR1")) = end.split_first_chunk::<4>() else {
        return wrong("the file does not end in PAR1");
    };
    let length = u32::from_le_bytes(length);
    let Some(start) = start.checked_sub(length.into()) else {
        return wrong("the metadata are longer than the file");
    };
    let metadata = file.get_bytes(start, length as usize)?;
    match schema(&metadata) {
        Some(children) if is_tree(&children) => Ok(metadata),
        Some(_) => wrong("the columns are not one tree of few levels"),
        None => wrong("the metadata are damaged"),
    }
}

/// The number of children of each element of the schema. `None` if the metadata are not valid.
fn schema(metadata: &[u8]) -> Option<Vec<usize>> {
    let mut thrift = Thrift { rest: metadata };
    thrift.clone().known(&FILE_METADATA, STRUCT)?;
    let mut schema = None;
    thrift.fields(&mut |thrift, field, stated| {
        if field != 2 {
            return thrift.skip(stated);
        }
        let (count, _) = thrift.list()?;
        schema = (0..count).map(|_| children(thrift)).collect();
        schema.as_ref().map(|_: &Vec<_>| ())
    })?;
    schema
}

/// The number of children of an element of the schema.
fn children(thrift: &mut Thrift<'_>) -> Option<usize> {
    let (mut children, mut has_type) = (0, false);
    thrift.fields(&mut |thrift, field, stated| {
        has_type |= field == 1;
        if field != 5 {
            return thrift.skip(stated);
        }
        children = usize::try_from(thrift.i32()?).ok()?;
        Some(())
    })?;
    // A column has a type, and a group has children.
    (has_type != (children > 0)).then_some(children)
}

/// Returns true if these are the numbers of children of the nodes of a tree, each before its children,
/// without many levels.
fn is_tree(children: &[usize]) -> bool {
    // The numbers of children that are still to come, of the nodes above.
    let mut open = vec![1_usize];
    for &count in children {
        while open.last() == Some(&0) {
            open.pop();
        }
        let Some(left) = open.last_mut() else {
            return false;
        };
        *left -= 1;
        if open.len() > DEPTH {
            return false;
        }
        open.push(count);
    }
    children.first().is_some_and(|&count| count > 0) && open.iter().all(|&left| left == 0)
}
