//! A writer of Gmsh files, after the reference manual of Gmsh.

use exact_ccd_mesh::Point;

/// The contents of a file: nodes with their tags, and elements as tags of nodes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Contents {
    pub(crate) nodes: Vec<(u32, Point)>,
    pub(crate) triangles: Vec<[u32; 3]>,
    pub(crate) tetrahedra: Vec<[u32; 4]>,
    /// The physical tags of the entity of each dimension in version 4; if none, the file has no entities. All
    /// elements of version 2 have the physical tag 99.
    pub(crate) physical: [Vec<i32>; 4],
}

impl Contents {
    /// Contents with vertices tagged from 1.
    pub(crate) fn new(positions: &[Point], triangles: &[[u32; 3]], tetrahedra: &[[u32; 4]]) -> Self {
        Self::tagged(positions, triangles, tetrahedra, |vertex| vertex + 1)
    }

    pub(crate) fn tagged(
        positions: &[Point],
        triangles: &[[u32; 3]],
        tetrahedra: &[[u32; 4]],
        tag: impl Fn(u32) -> u32,
    ) -> Self {
        Self {
            nodes: (0..).map(&tag).zip(positions.iter().copied()).collect(),
            triangles: triangles.iter().map(|corners| corners.map(&tag)).collect(),
            tetrahedra: tetrahedra.iter().map(|corners| corners.map(&tag)).collect(),
            physical: Default::default(),
        }
    }

    /// The type and the nodes of each element, after a point and a line of the geometry.
    fn elements(&self) -> Vec<(i32, Vec<u32>)> {
        let first = self.nodes.first().map(|node| node.0);
        let extra = first.map(|tag| [(15, vec![tag]), (1, vec![tag, tag])]);
        let triangles = self.triangles.iter().map(|corners| (2, corners.to_vec()));
        let tetrahedra = self.tetrahedra.iter().map(|corners| (4, corners.to_vec()));
        extra
            .into_iter()
            .flatten()
            .chain(triangles)
            .chain(tetrahedra)
            .collect()
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Encoding {
    Text,
    Little,
    Big,
}

const ENCODINGS: [Encoding; 3] = [Encoding::Text, Encoding::Little, Encoding::Big];

/// The names of groups, as a section of text.
const NAMES: &str = "1\n3 99 \"$body\"";

/// The contents in every version and encoding, each with a name.
pub(crate) fn all(contents: &Contents) -> Vec<(String, Vec<u8>)> {
    let mut files = Vec::new();
    for encoding in ENCODINGS {
        files.push((format!("2.2 {encoding:?}"), v2(contents, encoding)));
        files.push((format!("4.1 {encoding:?}"), v4(contents, encoding)));
    }
    for version in [v2, v4] {
        let text = String::from_utf8(version(contents, Encoding::Text)).unwrap();
        files.push(("with CRLF".to_owned(), text.replace('\n', "\r\n").into_bytes()));
    }
    files
}

/// A writer of consecutive values, separated by spaces in text.
struct Writer {
    encoding: Encoding,
    bytes: Vec<u8>,
}

impl Writer {
    fn new(version: &str, encoding: Encoding) -> Self {
        let bytes = Vec::new();
        let mut writer = Self { encoding, bytes };
        let is_binary = u8::from(encoding != Encoding::Text);
        writer.line(&format!("$MeshFormat\n{version} {is_binary} 8"));
        if is_binary == 1 {
            writer.int(1);
            writer.line("");
        }
        writer.line("$EndMeshFormat");
        writer
    }

    fn line(&mut self, text: &str) {
        self.bytes.extend(text.bytes());
        self.bytes.push(b'\n');
    }

    fn value<const N: usize>(&mut self, text: String, little: [u8; N]) {
        match self.encoding {
            Encoding::Text => self.bytes.extend([text.as_bytes(), b" "].concat()),
            Encoding::Little => self.bytes.extend(little),
            Encoding::Big => self.bytes.extend(little.iter().rev()),
        }
    }

    fn int(&mut self, value: i32) {
        self.value(value.to_string(), value.to_le_bytes());
    }

    fn size(&mut self, value: usize) {
        self.value(value.to_string(), (value as u64).to_le_bytes());
    }

    fn real(&mut self, value: f64) {
        self.value(format!("{value:?}"), value.to_le_bytes());
    }

    fn tag(&mut self, tag: u32) {
        self.int(tag.try_into().unwrap());
    }

    /// The end of a record: a line break in text, nothing in binary.
    fn end(&mut self) {
        if self.encoding == Encoding::Text {
            self.line("");
        }
    }

    fn section(&mut self, name: &str, body: impl FnOnce(&mut Self)) {
        self.line(&format!("${name}"));
        body(self);
        if self.encoding != Encoding::Text {
            self.line("");
        }
        self.line(&format!("$End{name}"));
    }
}

pub(crate) fn v2(contents: &Contents, encoding: Encoding) -> Vec<u8> {
    let mut writer = Writer::new("2.2", encoding);
    writer.section("PhysicalNames", |writer| writer.line(NAMES));
    writer.section("Nodes", |writer| {
        writer.line(&contents.nodes.len().to_string());
        for &(tag, position) in &contents.nodes {
            writer.tag(tag);
            position.into_iter().for_each(|x| writer.real(x));
            writer.end();
        }
    });
    writer.section("Elements", |writer| {
        let elements = contents.elements();
        writer.line(&elements.len().to_string());
        let mut number = 0;
        for block in elements.chunk_by(|a, b| a.0 == b.0) {
            if encoding != Encoding::Text {
                writer.int(block[0].0);
                writer.size_as_int(block.len());
                writer.int(2);
            }
            for (kind, nodes) in block {
                number += 1;
                writer.int(number);
                if encoding == Encoding::Text {
                    writer.int(*kind);
                    writer.int(2);
                }
                writer.int(99);
                writer.int(2);
                nodes.iter().for_each(|&tag| writer.tag(tag));
                writer.end();
            }
        }
    });
    writer.bytes
}

pub(crate) fn v4(contents: &Contents, encoding: Encoding) -> Vec<u8> {
    let mut writer = Writer::new("4.1", encoding);
    if contents.physical != <[Vec<i32>; 4]>::default() {
        writer.section("PhysicalNames", |writer| writer.line(NAMES));
    }
    writer.section("Entities", |writer| {
        let counts = contents
            .physical
            .each_ref()
            .map(|tags| usize::from(!tags.is_empty()));
        counts.into_iter().for_each(|count| writer.size(count));
        writer.end();
        let all = contents.physical.iter().enumerate();
        for (dimension, tags) in all.filter(|(_, tags)| !tags.is_empty()) {
            writer.int(1);
            let coordinates = if dimension == 0 { 3 } else { 6 };
            (0..coordinates).for_each(|x| writer.real(f64::from(x)));
            writer.size(tags.len());
            tags.iter().for_each(|&tag| writer.int(tag));
            if dimension > 0 {
                writer.size(dimension);
                (0..dimension).for_each(|_| writer.int(-1));
            }
            writer.end();
        }
    });
    let tags = || contents.nodes.iter().map(|node| node.0 as usize);
    let range = (tags().min().unwrap_or(0), tags().max().unwrap_or(0));
    writer.section("Nodes", |writer| {
        // The first half of the nodes is on a surface, with parameters; an empty block follows.
        let (first, second) = contents.nodes.split_at(contents.nodes.len() / 2);
        [3, contents.nodes.len(), range.0, range.1]
            .into_iter()
            .for_each(|count| writer.size(count));
        writer.end();
        for (dimension, nodes) in [(2, first), (3, &[]), (3, second)] {
            let parameters = usize::from(dimension == 2) * 2;
            writer.int(dimension);
            writer.int(1);
            writer.int(i32::from(parameters > 0));
            writer.size(nodes.len());
            writer.end();
            for &(tag, _) in nodes {
                writer.size(tag as usize);
                writer.end();
            }
            for &(_, position) in nodes {
                position
                    .into_iter()
                    .chain(vec![0.5; parameters])
                    .for_each(|x| writer.real(x));
                writer.end();
            }
        }
    });
    writer.section("Elements", |writer| {
        let elements = contents.elements();
        let blocks: Vec<_> = elements.chunk_by(|a, b| a.0 == b.0).collect();
        [blocks.len(), elements.len(), 1, elements.len()]
            .into_iter()
            .for_each(|count| writer.size(count));
        writer.end();
        let mut number = 0;
        for block in blocks {
            let dimension = match block[0].0 {
                15 => 0,
                1 => 1,
                2 => 2,
                _ => 3,
            };
            writer.int(dimension);
            writer.int(1);
            writer.int(block[0].0);
            writer.size(block.len());
            writer.end();
            for (_, nodes) in block {
                number += 1;
                writer.size(number);
                nodes.iter().for_each(|&tag| writer.size(tag as usize));
                writer.end();
            }
        }
    });
    writer.section("Surface", |writer| writer.line("1\n1 2 3"));
    writer.bytes
}

impl Writer {
    fn size_as_int(&mut self, value: usize) {
        self.int(value.try_into().unwrap());
    }
}
