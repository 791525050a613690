//! Tetrahedral meshes. Some of the files also list the surface.

use std::fs;
use std::path::{Path, PathBuf};

use exact_ccd_files::read_tet_mesh;
use exact_ccd_mesh::{Bvh, IntersectionOptions, Point, intersections};

use crate::data;

fn meshes() -> Vec<PathBuf> {
    let mut files = data().meshes().unwrap();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "msh"));
    assert!(!files.is_empty());
    files
}

/// The same triangle in the same orientation, with its least vertex first.
fn turned(mut triangle: [u32; 3]) -> [u32; 3] {
    let least = (0..3).min_by_key(|&k| triangle[k]).unwrap();
    triangle.rotate_left(least);
    triangle
}

/// The triangles of the section `$Surface`, which only some of the files have: a count, then three
/// node tags, from 1, for each triangle.
fn listed_surface(file: &Path) -> Option<Vec<[u32; 3]>> {
    let text = fs::read_to_string(file).unwrap();
    let (_, section) = text.split_once("$Surface\n")?;
    let mut numbers = section
        .split_ascii_whitespace()
        .map_while(|word| word.parse::<u32>().ok());
    let count = numbers.next().unwrap() as usize;
    let numbers: Vec<u32> = numbers.map(|tag| tag - 1).collect();
    let (triangles, rest) = numbers.as_chunks::<3>();
    assert_eq!((triangles.len(), rest), (count, [].as_slice()));
    Some(triangles.iter().copied().map(turned).collect())
}

/// Six times the signed volume of the tetrahedron with these corners and the origin.
fn six_volumes([a, b, c]: [Point; 3]) -> f64 {
    let minor = |i: usize, j: usize| b[i] * c[j] - b[j] * c[i];
    a[0] * minor(1, 2) + a[1] * minor(2, 0) + a[2] * minor(0, 1)
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn the_surface_is_the_one_in_the_file() {
    let mut with_surface = 0;
    for file in meshes() {
        let Some(mut expected) = listed_surface(&file) else {
            continue;
        };
        let (mesh, _) = read_tet_mesh(&file).unwrap();
        let mut surface: Vec<_> = mesh.surface().iter().copied().map(turned).collect();
        surface.sort_unstable();
        expected.sort_unstable();
        assert_eq!(surface, expected, "{}", file.display());
        with_surface += 1;
    }
    assert_eq!(with_surface, 6);
}

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn the_surface_encloses_the_tetrahedra_and_does_not_intersect_itself() {
    for file in meshes() {
        let (mesh, _) = read_tet_mesh(&file).unwrap();
        let at = |vertex: u32| mesh.positions()[vertex as usize];
        let from = |origin: u32| move |vertex: u32| [0, 1, 2].map(|k| at(vertex)[k] - at(origin)[k]);
        let tetrahedra = mesh
            .tetrahedra()
            .iter()
            .map(|&[a, b, c, d]| six_volumes([b, c, d].map(from(a))).abs());
        let inside: f64 = tetrahedra.sum();
        let around: f64 = mesh.surface().iter().map(|face| six_volumes(face.map(at))).sum();
        assert!(
            (inside - around).abs() < 1e-9 * inside,
            "{}: {inside} {around}",
            file.display()
        );

        let (frame, _) = mesh.surface_frame();
        assert_eq!(
            intersections(
                &frame.mesh,
                &frame.positions,
                &Bvh,
                &IntersectionOptions::default()
            ),
            Ok(vec![]),
            "{}",
            file.display()
        );
    }
}
