//! Files that are made to cost much: work and memory are at most proportional to the size.
//!
//! Both are counted by the reader. A file four times as large may cost four times as much.

use std::io::Write;

use flate2::Compression;
use flate2::write::{DeflateEncoder, GzEncoder};

use super::budget::Budget;
use super::compressed::gunzip;
use super::mesh_file::assemble;
use super::{series, vtk};
use crate::error::ParseError;
use crate::format::Format;

/// The most steps and the most bytes for each byte of a file and of the data that it may expand to, as the
/// documentation of the crate states.
const STEPS_A_BYTE: u64 = 8;
const BYTES_A_BYTE: u64 = 32;
/// The data that a file may expand to, for each byte, and in any case.
const RATIO: u64 = 200;
const ALLOWANCE: u64 = 1 << 20;

/// A file of a number of parts.
type Make = fn(usize) -> Vec<u8>;

fn read(bytes: &[u8], format: Format, budget: &Budget) -> Result<(), ParseError> {
    assemble(bytes, format, None, budget).map(drop)
}

/// The cost of a reading, whatever its result: steps and bytes.
fn spent(file: &[u8], read: impl FnOnce(&[u8], &Budget) -> Result<(), ParseError>) -> [u64; 2] {
    let budget = Budget::new(u64::MAX);
    budget.add_file(file.len() as u64).unwrap();
    let _either = read(file, &budget);
    budget.spent()
}

fn assert_linear(
    name: &str,
    make: Make,
    parts: usize,
    read: impl Fn(&[u8], &Budget) -> Result<(), ParseError>,
) {
    let [small, large] = [parts, 4 * parts].map(make);
    assert!(
        large.len() <= 4 * small.len() + 1000,
        "{name}: the size of the file"
    );
    let [first, second] = [&small, &large].map(|file| spent(file, &read));
    println!(
        "{name}: {} bytes {first:?}, {} bytes {second:?}",
        small.len(),
        large.len()
    );
    for (kind, a_byte) in [("steps", STEPS_A_BYTE), ("bytes", BYTES_A_BYTE)] {
        let k = usize::from(kind == "bytes");
        assert!(
            second[k] <= 4 * first[k] + 4096,
            "{name}: {kind} {first:?}, {second:?}"
        );
        let limit = a_byte * (RATIO * large.len() as u64 + ALLOWANCE);
        assert!(second[k] <= limit, "{name}: {kind} {second:?}");
    }
}

/// Files that do not expand, so that the size of the file alone bounds the cost.
const PLAIN: &[(&str, Format, Make)] = &[
    ("PLY, parts without vertices", Format::Ply, |count| {
        let parts = "comment part 0 0 a\n".repeat(count);
        ply(
            &parts,
            "element vertex 0\nproperty float x\nproperty float y\nproperty float z\n",
        )
    }),
    ("PLY, elements", Format::Ply, |count| {
        let elements: String = (0..count).map(|k| format!("element e{k:06} 0\n")).collect();
        ply("", &elements)
    }),
    ("PLY, properties", Format::Ply, |count| {
        let properties: String = (0..count).map(|k| format!("property char p{k:06}\n")).collect();
        ply("", &format!("element vertex 1\n{properties}"))
    }),
    ("OBJ, groups without elements", Format::Obj, |count| {
        format!("v 0 0 0\n{}", "g\n".repeat(count)).into()
    }),
    ("OBJ, groups without names", Format::Obj, |count| {
        format!("v 0 0 0\n{}", "g\np 1\n".repeat(count)).into()
    }),
    ("OBJ, groups with names", Format::Obj, |count| {
        let groups: String = (0..count).map(|k| format!("g {k:06}\np 1\n")).collect();
        format!("v 0 0 0\n{groups}").into()
    }),
    ("OBJ, points", Format::Obj, |count| {
        format!("v 0 0 0\n{}", "p\n".repeat(count)).into()
    }),
    ("OBJ, a polygon", Format::Obj, |count| {
        format!("v 0 0 0\nf{}", " 1".repeat(count)).into()
    }),
    ("OBJ, a line of many lines", Format::Obj, |count| {
        format!("v 0 0 0\nf 1{}", "\\\n".repeat(count)).into()
    }),
    ("OBJ, faces of two corners", Format::Obj, |count| {
        format!("v 0 0\n{}", "f 1 1\n".repeat(count)).into()
    }),
    ("OBJ, statements that are not read", Format::Obj, |count| {
        format!("v 0 0 0\n{}", "surf\n".repeat(count)).into()
    }),
    ("PLY, a strip of many pieces", Format::Ply, |count| {
        let vertex = "element vertex 1\nproperty int x\nproperty int y\nproperty int z\n";
        let strips = "element tristrips 1\nproperty list int int vertex_indices\n";
        let file = ply("", &format!("{vertex}{strips}"));
        let row = format!("0 0 0\n{count}{}\n", " -1".repeat(count));
        [file, row.into_bytes()].concat()
    }),
    ("PLY, rows longer than declared", Format::Ply, |count| {
        let file = ply(
            "",
            &format!("element vertex {count}\nproperty int x\nproperty int y\nproperty int z\n"),
        );
        [file, "0 0 0 0\n".repeat(count).into_bytes()].concat()
    }),
    ("OFF, a face of many lines", Format::Off, |count| {
        format!("OFF\n1 1 0\n0 0 0\n{count}{}", "\n0".repeat(count)).into()
    }),
    ("STL, solids", Format::Stl, |count| {
        "solid\nendsolid\n".repeat(count).into()
    }),
    ("STL, blanks", Format::Stl, |count| {
        format!("solid\nfacet{}normal", " ".repeat(count)).into()
    }),
    ("OFF, a polygon", Format::Off, |count| {
        format!("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n{count}{}", " 0".repeat(count)).into()
    }),
    ("Gmsh, names", Format::Msh, |count| {
        let names: String = (0..count).map(|k| format!("0 {k:06} \"\"\n")).collect();
        msh(
            "4.1 0",
            &format!("$PhysicalNames\n{count}\n{names}$EndPhysicalNames\n"),
        )
    }),
    ("Gmsh, entities", Format::Msh, |count| {
        let entities: String = (0..count).map(|k| format!("{k:06} 0 0 0 0\n")).collect();
        msh(
            "4.1 0",
            &format!("$Entities\n{count} 0 0 0\n{entities}$EndEntities\n"),
        )
    }),
    ("Gmsh 1, elements", Format::Msh, |count| {
        let elements: String = (0..count).map(|k| format!("{k:06} 15 1 1 1 1\n")).collect();
        format!("$NOD\n1\n1 0 0 0\n$ENDNOD\n$ELM\n{count}\n{elements}$ENDELM\n").into()
    }),
    ("Gmsh 4.0, blocks", Format::Msh, |count| {
        let blocks = "1 1 1 0\n".repeat(count);
        msh("4 0", &format!("$Nodes\n{count} 0\n{blocks}$EndNodes\n"))
    }),
    ("Gmsh, data of nodes", Format::Msh, |count| {
        let data = "$NodeData\n$EndNodeData\n".repeat(count);
        msh("2.2 0", &data)
    }),
    ("Gmsh, nodes", Format::Msh, |count| {
        let nodes: String = (0..count).map(|k| format!("{k:06} 0 0 0\n")).collect();
        msh("2.2 0", &format!("$Nodes\n{count}\n{nodes}$EndNodes\n"))
    }),
    ("Gmsh, the name of a section", Format::Msh, |count| {
        let name = "$End".repeat(count);
        let head = b"$MeshFormat\n4.1 1 8\n\x01\0\0\0\n$EndMeshFormat\n";
        [&head[..], name.as_bytes(), b"\n", name.repeat(3).as_bytes()].concat()
    }),
    ("VTK's XML, attributes", Format::Vtp, |count| {
        let attributes: String = (0..count).map(|k| format!(" a{k:06}=''")).collect();
        format!("<VTKFile type='PolyData'{attributes}/>").into()
    }),
    ("VTK's XML, namespaces", Format::Vtp, |count| {
        let begin: String = (0..count)
            .map(|k| format!("<a xmlns:a{k:06}='b{k:06}'>"))
            .collect();
        format!(
            "<VTKFile type='PolyData'>{begin}{}</VTKFile>",
            "</a>".repeat(count)
        )
        .into()
    }),
    ("VTK's XML, elements", Format::Vtp, |count| {
        let (begin, end) = ("<a>".repeat(count), "</a>".repeat(count));
        format!("<VTKFile type='PolyData' byte_order='LittleEndian'>{begin}{end}<PolyData/></VTKFile>").into()
    }),
    ("VTK's XML, numbers", Format::Vtp, |count| {
        let numbers = "0 ".repeat(3 * count);
        format!(
            "<VTKFile type='PolyData' byte_order='LittleEndian'><PolyData><Piece><Points><DataArray \
             type='Float32' format='ascii'>{numbers}</DataArray></Points></Piece></PolyData></VTKFile>"
        )
        .into()
    }),
    ("legacy VTK, lists", Format::Vtk, |count| {
        let lists = "LINES 0 0\n".repeat(count);
        format!("# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\n{lists}").into()
    }),
    ("legacy VTK, a strip", Format::Vtk, |count| {
        format!(
            "# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 1 float 0 0 0\nTRIANGLE_STRIPS 1 \
             {} {count}{}",
            count + 1,
            " 0".repeat(count)
        )
        .into()
    }),
    ("glTF, nodes", Format::Gltf, |count| {
        let nodes = vec!["{}"; count].join(",");
        gltf(&format!("\"nodes\":[{nodes}]"))
    }),
    ("glTF, nodes of the scene", Format::Gltf, |count| {
        let nodes = vec!["{}"; count].join(",");
        let roots: Vec<String> = (0..count).map(|k| format!("{k:6}")).collect();
        gltf(&format!(
            "\"scenes\":[{{\"nodes\":[{}]}}],\"nodes\":[{nodes}]",
            roots.join(",")
        ))
    }),
    ("glTF, channels", Format::Gltf, |count| {
        let channel = "{\"sampler\":0,\"target\":{\"node\":0,\"path\":\"\"}}";
        let channels = vec![channel; count].join(",");
        gltf(&format!(
            "\"animations\":[{{\"channels\":[{channels}],\"samplers\":[]}}]"
        ))
    }),
    ("glTF, a list within a list", Format::Gltf, |count| {
        gltf(&format!("\"extras\":{}{}", "[".repeat(count), "]".repeat(count)))
    }),
    ("numpy, dimensions", Format::Npy, |count| {
        npy(&format!("({}1)", "1, ".repeat(count)))
    }),
];

/// An array of numbers at the beginning of the appended data.
const ARRAY: &str = "<Piece><Points><DataArray type='Int8' format='appended' offset='0'/></Points></Piece>";

/// Files with data that expand, or that are named again and again, beyond the limits.
const EXPANDING: &[(&str, Format, Make)] = &[
    ("VTK's XML, arrays with one header", Format::Vtp, |count| {
        // The header takes as many bytes as all arrays. Its blocks are empty.
        const BLOCK: &[u8] = b"\x78\x9c\x03\0\0\0\0\x01";
        let blocks = count * ARRAY.len() / 12;
        let numbers = [[blocks as u32, 0, 0].to_vec(), vec![BLOCK.len() as u32; blocks]].concat();
        let header: Vec<u8> = numbers.into_iter().flat_map(u32::to_le_bytes).collect();
        vtp(&ARRAY.repeat(count), &[header, BLOCK.repeat(blocks)].concat())
    }),
    ("VTK's XML, arrays with one block", Format::Vtp, |count| {
        let mut block = flate2::write::ZlibEncoder::new(Vec::new(), Compression::best());
        block.write_all(&vec![0; 99 * count]).unwrap();
        let block = block.finish().unwrap();
        let header = [1, 99 * count as u32, 0, block.len() as u32].map(u32::to_le_bytes);
        vtp(&ARRAY.repeat(count), &[&header.concat()[..], &block].concat())
    }),
    ("glTF, nodes with one mesh", Format::Gltf, |count| {
        let nodes = vec!["{\"mesh\":0}"; count].join(",");
        let primitives = vec!["{\"attributes\":{}}"; count].join(",");
        let roots: Vec<String> = (0..count).map(|k| format!("{k:6}")).collect();
        gltf(&format!(
            "\"scenes\":[{{\"nodes\":[{}]}}],\"nodes\":[{nodes}],\"meshes\":[{{\"primitives\":[{primitives}]}}]",
            roots.join(",")
        ))
    }),
    ("glTF, instances of one mesh", Format::Gltf, |count| {
        // Each instance has its translation in the same place, and a primitive without positions.
        let instancing = "{\"EXT_mesh_gpu_instancing\":{\"attributes\":{\"TRANSLATION\":0}}}";
        let node = format!("{{\"mesh\":0,\"extensions\":{instancing}}}");
        let nodes = vec![&*node; count].join(",");
        let roots: Vec<String> = (0..count).map(|k| format!("{k:6}")).collect();
        let zeros = "A".repeat(48 * count);
        gltf(&format!(
            "\"scenes\":[{{\"nodes\":[{}]}}],\"nodes\":[{nodes}],\"meshes\":[{{\"primitives\":[{{\"attributes\":{{}}\
             }}]}}],\"accessors\":[{{\"bufferView\":0,\"componentType\":5126,\"count\":{},\"type\":\"VEC3\"}}],\
             \"bufferViews\":[{{\"buffer\":0,\"byteLength\":{}}}],\"buffers\":[{{\"byteLength\":{},\"uri\":\
             \"data:;base64,{zeros}\"}}]",
            roots.join(","),
            3 * count,
            36 * count,
            36 * count
        ))
    }),
    ("Gmsh, an element in many groups", Format::Msh, |count| {
        let tags = " 1".repeat(count);
        let element = "1 1 1 1\n".repeat(count);
        msh(
            "4.1 0",
            &format!(
                "$Entities\n0 0 1 0\n1 0 0 0 0 0 0 {count}{tags} 0\n$EndEntities\n$Nodes\n1 1 1 1\n0 1 0 1\n1\n\
                 0 0 0\n$EndNodes\n$Elements\n1 {count} 1 1\n2 1 2 {count}\n{element}$EndElements\n"
            ),
        )
    }),
    ("numpy, members in one place", Format::Npz, |count| {
        let member = npy("(1, 3)");
        let mut deflate = DeflateEncoder::new(Vec::new(), Compression::best());
        deflate.write_all(&[&member[..], &[0; 1 << 20]].concat()).unwrap();
        let data = deflate.finish().unwrap();
        npz(&data, 1 << 20, count)
    }),
];

#[test]
fn files_that_do_not_expand_cost_in_proportion_to_their_size() {
    for &(name, format, make) in PLAIN {
        assert_linear(name, make, 10_000, |file, budget| read(file, format, budget));
        let file = make(10_000);
        let [steps, bytes] = spent(&file, |file, budget| read(file, format, budget));
        let size = file.len() as u64;
        assert!(
            steps <= STEPS_A_BYTE * size + 4096,
            "{name}: {steps} steps for {size} bytes"
        );
        assert!(
            bytes <= BYTES_A_BYTE * size + 4096,
            "{name}: {bytes} bytes for {size} bytes"
        );
    }
}

#[test]
fn files_that_expand_cost_in_proportion_to_their_size() {
    for &(name, format, make) in EXPANDING {
        assert_linear(name, make, 1000, |file, budget| read(file, format, budget));
    }
}

/// A decompressor reads blocks of deflate that are empty, and returns nothing.
#[test]
fn compressed_data_that_many_members_have_in_common_are_work_for_each() {
    let blocks = b"\0\0\0\xff\xff".repeat(20_000);
    let last = b"\x01\0\0\xff\xff";
    let file = npz(&[&blocks[..], last].concat(), 1, 2_000);
    let budget = Budget::new(u64::MAX);
    budget.add_file(file.len() as u64).unwrap();
    let error = read(&file, Format::Npz, &budget).unwrap_err();
    assert!(error.to_string().contains("expand"), "{error}");
}

#[test]
fn lists_of_files_cost_in_proportion_to_their_size() {
    assert_linear(
        "a collection",
        |count| {
            let files: String = (0..count)
                .map(|k| format!("<DataSet timestep='{k:06}' file='a'/>"))
                .collect();
            format!("<VTKFile type='Collection'><Collection>{files}</Collection></VTKFile>").into()
        },
        10_000,
        |file, budget| vtk::read_collection(file, budget).map(drop),
    );
    assert_linear(
        "a series",
        |count| {
            let files = vec!["{\"name\":\"a\",\"time\":0}"; count].join(",");
            format!("{{\"files\":[{files}]}}").into()
        },
        10_000,
        |file, budget| series::parse_series(file, budget).map(drop),
    );
}

#[test]
fn members_of_gzip_cost_in_proportion_to_their_size() {
    assert_linear(
        "gzip",
        |count| {
            let mut member = GzEncoder::new(Vec::new(), Compression::best());
            member.write_all(&[0; 1000]).unwrap();
            member.finish().unwrap().repeat(count)
        },
        1000,
        |file, budget| gunzip(file, budget).map(drop),
    );
}

fn ply(comments: &str, elements: &str) -> Vec<u8> {
    format!("ply\nformat ascii 1.0\n{comments}{elements}end_header\n").into()
}

fn msh(version: &str, sections: &str) -> Vec<u8> {
    format!("$MeshFormat\n{version} 8\n$EndMeshFormat\n{sections}").into()
}

fn vtp(pieces: &str, data: &[u8]) -> Vec<u8> {
    let xml = format!(
        "<VTKFile type='PolyData' byte_order='LittleEndian' compressor='vtkZLibDataCompressor'><PolyData>\
         {pieces}</PolyData><AppendedData encoding='raw'>_"
    );
    [xml.as_bytes(), data].concat()
}

fn gltf(properties: &str) -> Vec<u8> {
    format!("{{\"asset\":{{\"version\":\"2.0\"}},{properties}}}").into()
}

fn npy(shape: &str) -> Vec<u8> {
    let header = format!("{{'descr': '<f8', 'fortran_order': True, 'shape': {shape}, }}\n");
    let length = (header.len() as u32).to_le_bytes();
    [b"\x93NUMPY\x02\x00", &length[..], header.as_bytes(), &[0; 8]].concat()
}

/// An archive of compressed members that have their data in common.
fn npz(data: &[u8], size: u32, count: usize) -> Vec<u8> {
    let sizes = [data.len() as u32, size].map(u32::to_le_bytes).concat();
    let local = [
        b"PK\x03\x04\0\0\0\0\x08\0\0\0\0\0\0\0\0\0",
        &sizes[..],
        b"\x05\0\0\0a.npy",
        data,
    ];
    let entry = |number: usize| {
        let name = format!("{number:06}.npy");
        [
            b"PK\x01\x02\0\0\0\0\0\0\x08\0\0\0\0\0\0\0\0\0",
            &sizes[..],
            b"\x0a\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0",
            name.as_bytes(),
        ]
        .concat()
    };
    let (local, list) = (local.concat(), (0..count).map(entry).collect::<Vec<_>>().concat());
    let numbers = [(count as u16).to_le_bytes(); 2].concat();
    let place = [list.len() as u32, local.len() as u32]
        .map(u32::to_le_bytes)
        .concat();
    [
        &local[..],
        &list,
        b"PK\x05\x06\0\0\0\0",
        &numbers,
        &place,
        b"\0\0",
    ]
    .concat()
}
