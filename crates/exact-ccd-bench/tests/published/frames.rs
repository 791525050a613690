//! The meshes of the scenes.

use crate::scenes;

#[test]
#[cfg_attr(no_data, ignore = "the published data sets are missing: set EXACT_CCD_DATA")]
fn frames_have_the_published_size_and_move() {
    let counts = scenes().into_iter().map(|scene| {
        let motion = scene.motion().unwrap();
        assert_ne!(motion.x0, motion.x1, "{}", scene.name());
        let mesh = &motion.mesh;
        (scene.name(), mesh.vertex_count(), mesh.faces().len())
    });
    let expected = [
        ("cloth-ball", 46_598, 92_230),
        ("cloth-funnel", 9_450, 18_484),
        ("rod-twist", 39_940, 79_864),
    ];
    let expected = expected.map(|(name, vertices, faces)| (name.to_owned(), vertices, faces));
    assert_eq!(counts.collect::<Vec<_>>(), expected);
}
