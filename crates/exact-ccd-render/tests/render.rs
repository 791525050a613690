//! Contents of pictures and of their files.

#![expect(clippy::unwrap_used, reason = "a failure is a failed test")]

use std::collections::HashSet;
use std::io::{Cursor, ErrorKind};

use exact_ccd_mesh::{Aabb, Frame, Pair, Point};
use exact_ccd_render::{Animation, Camera, Gif, Marks, Picture, View, render, render_thick, write_apng};
use proptest::prelude::*;

const ABOVE: Point = [0.0, 0.0, 1.0];
const WHITE: [u8; 3] = [255; 3];

fn square(low: f64, high: f64, z: f64) -> [Point; 4] {
    [[low, low, z], [high, low, z], [high, high, z], [low, high, z]]
}

fn squares(squares: &[[Point; 4]]) -> Frame {
    let corners = (0..squares.len() as u32).map(|index| 4 * index);
    let faces = corners
        .flat_map(|a| [[a, a + 1, a + 2], [a, a + 2, a + 3]])
        .collect();
    Frame::new(squares.concat(), faces).unwrap()
}

/// The box for which 100 pixels are ten units.
fn ten_units() -> Aabb {
    [[0.5, 0.5, 0.0], [9.5, 9.5, 1.0]].into_iter().collect()
}

fn pixel(picture: &Picture, x: usize, y: usize) -> [u8; 3] {
    picture.pixels()[y * usize::from(picture.size()[0]) + x]
}

#[test]
fn a_square_covers_its_area() {
    let view = View::of(&ten_units(), ABOVE, [100, 100]);
    let picture = render(&squares(&[square(2.0, 7.0, 0.0)]), &view, &Marks::default());
    for y in 0..100 {
        for x in 0..100 {
            // y points upwards in the plane, and rows are counted from the top. Edges may extend by
            // one pixel.
            let inside =
                |low: usize, high: usize| (low..high).contains(&x) && (low..high).contains(&(99 - y));
            if inside(21, 69) {
                assert_ne!(pixel(&picture, x, y), WHITE, "{x}, {y}");
            } else if !inside(19, 71) {
                assert_eq!(pixel(&picture, x, y), WHITE, "{x}, {y}");
            }
        }
    }
}

#[test]
fn connected_parts_have_distinct_colours() {
    let view = View::of(&ten_units(), ABOVE, [100, 100]);
    let two = squares(&[square(1.0, 4.0, 0.0), square(6.0, 9.0, 0.0)]);
    let picture = render(&two, &view, &Marks::default());
    // Pixels off the diagonals, which are edges.
    let [a, b] = [pixel(&picture, 20, 70), pixel(&picture, 70, 20)];
    assert!(a != WHITE && b != WHITE && a != b);
    let mut faces = two.mesh.faces().to_vec();
    faces.push([2, 4, 4]);
    let joined = Frame::new(two.positions.clone(), faces).unwrap();
    let picture = render(&joined, &view, &Marks::default());
    assert_eq!([pixel(&picture, 20, 70), pixel(&picture, 70, 20)], [a, a]);
}

#[test]
fn short_edges_are_not_drawn() {
    let cells = |count: u32| {
        let places = (0..count * count).map(|cell| [cell % count, cell / count].map(f64::from));
        let size = 9.0 / f64::from(count);
        let cell = |[x, y]: [f64; 2]| {
            square(0.0, size, 0.0).map(|[u, v, z]| [0.5 + size * x + u, 0.5 + size * y + v, z])
        };
        let view = View::of(&ten_units(), ABOVE, [100, 100]);
        let mut joined = squares(&places.map(cell).collect::<Vec<_>>());
        // Faces without area connect all cells to one part.
        let mut faces = joined.mesh.faces().to_vec();
        faces.extend((1..count * count).map(|cell| [4 * (cell - 1), 4 * cell, 4 * cell]));
        joined = Frame::new(joined.positions, faces).unwrap();
        render(&joined, &view, &Marks::default())
    };
    let colours = |picture: &Picture| {
        picture.pixels()[50 * 100 + 20..50 * 100 + 80]
            .iter()
            .collect::<HashSet<_>>()
            .len()
    };
    assert!(colours(&cells(4)) > 1);
    assert_eq!(colours(&cells(45)), 1);
}

#[test]
fn nearer_faces_hide_farther_ones() {
    let (low, high) = (square(2.0, 7.0, 0.0), square(3.0, 6.0, 1.0));
    let marks = Marks {
        faces: vec![0, 1],
        ..Marks::default()
    };
    let is_red = |picture: &Picture| {
        let [red, green, _] = pixel(picture, 55, 50);
        red / 2 > green
    };
    for (towards, low_is_hidden) in [(ABOVE, true), ([0.0, 0.0, -1.0], false)] {
        let view = View::of(&ten_units(), towards, [100, 100]);
        // From below, left and right are exchanged, and the middle is the same.
        assert_eq!(
            is_red(&render(&squares(&[low, high]), &view, &marks)),
            !low_is_hidden
        );
        assert_eq!(
            is_red(&render(&squares(&[high, low]), &view, &marks)),
            low_is_hidden
        );
    }
}

#[test]
fn the_vertical_axis_points_upwards() {
    let (y, z) = ([5.0, 6.0, 0.0], [5.0, 5.0, 1.0]);
    let pole = Frame::new(vec![[5.0, 5.0, 0.0], y, z], vec![[0, 1, 2]]).unwrap();
    let row = |view: &View, vertex: u32| {
        let marks = Marks {
            vertices: vec![vertex],
            ..Marks::default()
        };
        let picture = render(&pole, view, &marks);
        let red = (0..10_000).filter(|&i| picture.pixels()[i][0] > 200 && picture.pixels()[i][1] < 60);
        let rows: Vec<usize> = red.map(|i| i / 100).collect();
        rows.iter().sum::<usize>() / rows.len()
    };
    let upright = |up| View::upright(&ten_units(), up, [0.3, 0.4, 1.0], [100, 100]);
    for (view, upper) in [
        (View::of(&ten_units(), [0.3, -1.0, 0.2], [100, 100]), 2),
        (upright([0.0, 9.8, 0.0]), 1),
        (upright([0.0; 3]), 1),
    ] {
        assert!(row(&view, upper) < row(&view, 0), "{view:?}");
    }
    let view = upright([0.0, -1.0, 0.0]);
    assert!(row(&view, 1) > row(&view, 0));
}

#[test]
fn marks_of_a_pair_are_its_primitives() {
    let mesh = squares(&[square(0.0, 1.0, 0.0)]).mesh;
    let edges = Marks::pair(&mesh, Pair::EdgeEdge { a: 0, b: 99 });
    assert_eq!((edges.edges, edges.faces), (vec![mesh.edges()[0]], vec![]));
    let face = Marks::pair(&mesh, Pair::VertexFace { vertex: 3, face: 1 });
    assert_eq!(
        (face.vertices, face.faces, face.edges),
        (vec![3], vec![1], vec![])
    );
}

/// The pictures in a file: one, or all pictures of an animation.
fn decode(file: Vec<u8>) -> Vec<Vec<u8>> {
    let mut reader = png::Decoder::new(Cursor::new(file)).read_info().unwrap();
    let count = reader
        .info()
        .animation_control()
        .map_or(1, |control| control.num_frames);
    let mut buffer = vec![0; reader.output_buffer_size().unwrap()];
    let next = |_| {
        let info = reader.next_frame(&mut buffer).unwrap();
        buffer[..info.buffer_size()].to_vec()
    };
    (0..count).map(next).collect()
}

#[test]
fn files_hold_every_pixel() {
    let view = View::of(&ten_units(), [1.0, 2.0, 3.0], [40, 30]);
    let picture = |high| render(&squares(&[square(2.0, high, 0.0)]), &view, &Marks::default());
    let pictures = [picture(5.0), picture(6.0), picture(7.0)];
    assert_ne!(pictures[0], pictures[1]);
    let bytes = |picture: &Picture| picture.pixels().as_flattened().to_vec();

    let mut file = Vec::new();
    pictures[1].write_png(&mut file).unwrap();
    assert_eq!(decode(file), [bytes(&pictures[1])]);

    let mut file = Vec::new();
    write_apng(&mut file, &pictures, 0.04).unwrap();
    assert_eq!(decode(file), pictures.each_ref().map(bytes));
}

#[test]
fn invalid_pictures_are_errors() {
    let of = |size| {
        render(
            &squares(&[]),
            &View::of(&ten_units(), ABOVE, size),
            &Marks::default(),
        )
    };
    let error = |pictures: &[Picture]| write_apng(Vec::new(), pictures, 1.0).unwrap_err().kind();
    assert_eq!(error(&[]), ErrorKind::InvalidInput);
    assert_eq!(error(&[of([0, 5])]), ErrorKind::InvalidInput);
    assert_eq!(error(&[of([5, 5]), of([5, 6])]), ErrorKind::InvalidInput);

    let mut animation = Animation::new(Vec::new(), [5, 5], 2).unwrap();
    animation.add(&of([5, 5]), 1.0).unwrap();
    assert_eq!(animation.finish().unwrap_err().kind(), ErrorKind::InvalidInput);
    let mut animation = Animation::new(Vec::new(), [5, 5], 1).unwrap();
    animation.add(&of([5, 5]), 1.0).unwrap();
    assert_eq!(
        animation.add(&of([5, 5]), 1.0).unwrap_err().kind(),
        ErrorKind::InvalidInput
    );

    let kind = |result: std::io::Result<()>| result.unwrap_err().kind();
    assert!(Gif::new(Vec::new(), [0, 5]).is_err());
    let mut gif = Gif::new(Vec::new(), [5, 5]).unwrap();
    assert_eq!(kind(gif.add(&of([5, 6]), 1.0)), ErrorKind::InvalidInput);
    assert_eq!(kind(gif.finish()), ErrorKind::InvalidInput);
}

/// The times at which pictures begin are rounded, not their durations. Pictures that begin too soon after
/// another one are left out of GIF files.
#[test]
fn durations_do_not_drift() {
    let view = View::of(&ten_units(), ABOVE, [20, 20]);
    let picture = |high| render(&squares(&[square(1.0, high, 0.0)]), &view, &Marks::default());
    let pictures: Vec<Picture> = (0..30)
        .map(|index| picture(2.0 + 0.2 * f64::from(index)))
        .collect();
    let seconds = 1.0 / 150.0;

    let mut file = Vec::new();
    write_apng(&mut file, &pictures, seconds).unwrap();
    let controls = file.windows(4).enumerate().filter(|(_, name)| name == b"fcTL");
    let delays: Vec<u16> = controls
        .map(|(at, _)| u16::from_be_bytes([file[at + 24], file[at + 25]]))
        .collect();
    assert_eq!((delays.len(), delays.iter().sum()), (30, 200));
    assert!(delays.iter().all(|delay| [6, 7].contains(delay)), "{delays:?}");

    let mut file = Vec::new();
    let mut animation = Gif::new(&mut file, [20, 20]).unwrap();
    for picture in &pictures {
        animation.add(picture, seconds).unwrap();
    }
    animation.finish().unwrap();
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(file.as_slice()).unwrap();
    let mut delays = Vec::new();
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        // Few colours are kept exactly.
        let drawn = &pictures[3 * delays.len()];
        let colours = frame.buffer.chunks_exact(4).map(|pixel| &pixel[..3]);
        assert!(colours.eq(drawn.pixels().iter().map(|pixel| &pixel[..])));
        delays.push(frame.delay);
    }
    assert_eq!(delays, [2; 10]);
}

/// A picture of thousands of colours differs little from its 256 colours.
#[test]
fn colours_of_gif_files_are_near() {
    let positions = vec![[2.0, 2.0, 0.0], [5.0, 5.0, 0.0], [8.0, 3.0, 0.0], [3.0, 7.0, 0.0]];
    let frame = Frame::with_edges(positions, vec![[0, 1, 2]], &[[1, 3]]).unwrap();
    let view = View::of(&ten_units(), [0.3, 0.2, 1.0], [300, 300]);
    let picture = render_thick(&frame, &view, &Marks::default(), &[1.5; 4]);
    let colours: HashSet<_> = picture.pixels().iter().collect();
    assert!(colours.len() > 256, "{}", colours.len());

    let mut file = Vec::new();
    let mut animation = Gif::new(&mut file, [300, 300]).unwrap();
    animation.add(&picture, 1.0).unwrap();
    animation.finish().unwrap();
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(file.as_slice()).unwrap();
    let decoded = decoder.read_next_frame().unwrap().unwrap();
    let differences = decoded
        .buffer
        .chunks_exact(4)
        .zip(picture.pixels())
        .map(|(read, drawn)| (0..3).map(|k| read[k].abs_diff(drawn[k])).max().unwrap());
    let differences: Vec<u8> = differences.collect();
    let mean = differences.iter().map(|&x| f64::from(x)).sum::<f64>() / differences.len() as f64;
    assert!(
        mean < 1.0 && differences.iter().max() < Some(&24),
        "{mean} {:?}",
        differences.iter().max()
    );
}

/// Text covers the corner, in letters of twice the size in large pictures, and nothing else.
#[test]
fn text_is_in_the_corner() {
    let plain = |size| {
        render(
            &squares(&[]),
            &View::of(&ten_units(), ABOVE, size),
            &Marks::default(),
        )
    };
    let written = |size, text: &str| {
        let mut picture = plain(size);
        picture.write(text);
        picture
    };
    let dark = |picture: &Picture| {
        let width = usize::from(picture.size()[0]);
        let pixels = picture.pixels().iter().enumerate();
        let dark = pixels.filter(|(_, pixel)| **pixel != WHITE);
        dark.map(|(index, _)| [index % width, index / width])
            .collect::<Vec<_>>()
    };
    let small = dark(&written([400, 300], "t = 1.5 s"));
    assert!(small.len() > 100);
    assert!(
        small
            .iter()
            .all(|&[x, y]| (8..98).contains(&x) && (5..25).contains(&y))
    );
    assert_eq!(dark(&written([1600, 1000], "t = 1.5 s")).len(), 4 * small.len());
    assert_ne!(written([400, 300], "t = 1.5 s"), written([400, 300], "t = 1.6 s"));
    for size in [[1, 1], [20, 3], [0, 0]] {
        let _ = written(size, "longer than the picture, and é∞");
    }
}

/// A camera shows the silhouette of balls, so that they fill the picture.
#[test]
fn extents_of_balls_fill_pictures() {
    let camera = Camera::new([0.0, 0.0, 1.0], [1.0, 1.0, 0.5]);
    let positions = vec![[-3.0, 1.0, 2.0], [4.0, 0.0, -1.0], [0.0, 2.0, 5.0]];
    let frame = Frame::new(positions.clone(), Vec::new()).unwrap();
    let radii = [0.5, 1.0, 0.25];
    let extent = camera.extent(positions.into_iter().zip(radii));
    let picture = render_thick(
        &frame,
        &camera.view(&extent, [200, 100]),
        &Marks::default(),
        &radii,
    );
    let is_drawn = |x: usize, y: usize| pixel(&picture, x, y) != WHITE;
    let rows = (0..100).filter(|&y| (0..200).any(|x| is_drawn(x, y)));
    let rows: Vec<usize> = rows.collect();
    assert!(
        (4..=6).contains(&rows[0]) && (93..=95).contains(rows.last().unwrap()),
        "{rows:?}"
    );
    assert_eq!(View::upright(&ten_units(), [0.0, 1.0, 0.0], ABOVE, [9, 9]), {
        let camera = Camera::new([0.0, 1.0, 0.0], ABOVE);
        camera.view(
            &camera.extent([([0.5, 0.5, 0.0], 0.0), ([9.5, 9.5, 1.0], 0.0)]),
            [9, 9],
        )
    });
}

proptest! {
    /// Meshes far away, out of range, flat, or without extent.
    #[test]
    fn anything_has_a_picture(
        positions in prop::collection::vec(prop::array::uniform3(prop_oneof![
            any::<f64>().prop_filter("finite", |x| x.is_finite()),
            (-2..=2i8).prop_map(f64::from),
            -1e6..1e6,
        ]), 1..9),
        faces in prop::collection::vec(prop::array::uniform3(any::<u32>()), 0..9),
        towards in prop::array::uniform3(any::<f64>()),
        size in prop::array::uniform2(0..40_u16),
        marked in any::<u32>(),
        own_view in any::<bool>(),
    ) {
        let count = positions.len() as u32;
        let faces = faces.into_iter().map(|face| face.map(|k| k % count)).collect();
        let frame = Frame::new(positions, faces).unwrap();
        let bounds = if own_view { frame.bounds() } else { ten_units() };
        let marks = Marks {
            vertices: vec![marked, 0],
            edges: vec![[0, marked], [0, count - 1]],
            faces: vec![marked],
        };
        let picture = render(&frame, &View::of(&bounds, towards, size), &marks);
        prop_assert_eq!(picture.pixels().len(), usize::from(size[0]) * usize::from(size[1]));
    }
}

/// A rod and a point with a radius cover their silhouettes; the nearer ball hides the farther one.
#[test]
fn rods_are_tubes_and_points_are_balls() {
    let positions = vec![[2.0, 3.0, 0.0], [8.0, 3.0, 0.0], [5.0, 7.0, 0.0], [5.0, 7.5, 2.0]];
    let frame = Frame::with_edges(positions, Vec::new(), &[[0, 1]]).unwrap();
    let view = View::of(&ten_units(), ABOVE, [100, 100]);
    let radii = [1.0, 1.0, 1.0, 0.5];
    let picture = render_thick(&frame, &view, &Marks::default(), &radii);
    let is_drawn = |x: usize, y: usize| pixel(&picture, x, 99 - y) != WHITE;
    for (x, y, inside) in [
        (50, 38, true),
        (50, 42, false),
        (12, 30, true),
        (8, 30, false),
        // The ends are round.
        (12, 38, false),
        (50, 62, true),
        (50, 58, false),
        (42, 78, false),
    ] {
        assert_eq!(is_drawn(x, y), inside, "{x}, {y}");
    }
    // The small ball is nearer and covers the upper part of the large one, up to its own silhouette.
    let alone = render_thick(&frame, &view, &Marks::default(), &radii[..3]);
    let differs = |x: usize, y: usize| pixel(&picture, x, 99 - y) != pixel(&alone, x, 99 - y);
    assert!(differs(48, 77) && !differs(43, 70) && !differs(50, 65));
    // Without radii, rods are lines and points are dots.
    let thin = render(&frame, &view, &Marks::default());
    assert_eq!(thin, render_thick(&frame, &view, &Marks::default(), &[0.0; 4]));
    assert_eq!(pixel(&thin, 50, 99 - 34), WHITE);
}

/// No radius and no position causes a panic or an endless loop.
#[test]
fn strange_radii_are_harmless() {
    let far = [[1e300, 0.0, 0.0], [-1e300, 1e300, 0.0], [f64::MAX; 3], [0.0; 3]];
    let frame = Frame::with_edges(far.to_vec(), Vec::new(), &[[0, 1], [1, 2]]).unwrap();
    let view = View::of(&ten_units(), ABOVE, [20, 20]);
    for radius in [f64::NAN, f64::INFINITY, -1.0, 1e-300, 1e300, f64::MAX] {
        let _ = render_thick(&frame, &view, &Marks::default(), &[radius; 4]);
    }
}
