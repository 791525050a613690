//! Certificates of one step, made and verified.

use exact_ccd::{Point, Separation};
use exact_ccd_certify::{Maker, Uncertified};
use exact_ccd_check::check::Proved;
use exact_ccd_check::ply::Frame;
use exact_ccd_check::{Failure, Mesh, check};
use exact_ccd_mesh::{
    Bvh, Contact, Detector, IntersectionOptions, Meeting, Options, TriangleMesh, intersections,
};

/// A mesh in motion, for the maker and for the checker.
pub(crate) struct Scene {
    pub(crate) mesh: TriangleMesh,
    pub(crate) frames: [Frame; 2],
}

impl Scene {
    pub(crate) fn of(frames: [Frame; 2]) -> Self {
        let Mesh { faces, edges, .. } = &frames[0].mesh;
        let mesh = TriangleMesh::with_edges(frames[0].positions.len(), faces.clone(), edges).unwrap();
        Self { mesh, frames }
    }

    pub(crate) fn new(faces: &[[u32; 3]], edges: &[[u32; 2]], x: [Vec<Point>; 2]) -> Self {
        let mesh = Mesh::new(x[0].len(), faces.to_vec(), edges).unwrap();
        Self::of(x.map(|positions| Frame {
            mesh: mesh.clone(),
            positions,
        }))
    }

    pub(crate) fn positions(&self) -> [&[Point]; 2] {
        [&self.frames[0].positions, &self.frames[1].positions]
    }

    pub(crate) fn earliest(&self, d: f64) -> Option<Contact> {
        let d = Separation::new(d).unwrap();
        let [x0, x1] = self.positions();
        Detector::new(self.mesh.clone())
            .collision(x0, x1, Options::within(d))
            .unwrap()
    }

    /// True if an edge passes through a face at the start.
    pub(crate) fn is_pierced(&self) -> bool {
        let options = IntersectionOptions::default().with_meeting(Meeting::Crossing);
        let found = intersections(&self.mesh, self.positions()[0], &Bvh, &options);
        !found.unwrap().is_empty()
    }
}

/// The certificate of a step, with the statement about its start if nothing crosses there.
pub(crate) fn certify(scene: &Scene, d: f64) -> Result<Vec<u8>, Uncertified> {
    let rest = !scene.is_pierced();
    let mut maker = Maker::new(Separation::new(d).unwrap());
    maker
        .add_step(&scene.mesh, scene.positions(), rest, scene.earliest(d).as_ref())
        .unwrap();
    maker.finish()
}

pub(crate) fn verify(scene: &Scene, certificate: &[u8]) -> Result<Proved, Failure> {
    check(certificate, scene.frames.clone().map(Ok))
}
