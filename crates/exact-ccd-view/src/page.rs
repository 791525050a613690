//! A page under construction.

use std::collections::BTreeMap;
use std::io::{self, Write};

use exact_ccd::{Kind, Query, Separation};
use exact_ccd_mesh::vector::unit;
use exact_ccd_mesh::{Aabb, Contact, Intersection, Point, Step, TriangleMesh, check_positions};

use crate::block;
use crate::body::Body;
use crate::contact::{Labels, ShownContact};
use crate::document::{self, Document, ShownFrame};
use crate::error::PageError;
use crate::half_space::ShownHalfSpace;
use crate::history::History;
use crate::query::{self, ShownQuery};
use crate::units::Units;

/// The number of contacts that a page lists: the first ones that are added. The others are counted.
pub const MOST_CONTACTS: usize = 10_000;

/// The size at which frames of a long motion are left out, in bytes of text.
const MOST_TEXT: usize = 256 << 20;

/// A mesh in motion and its contacts, for a browser.
///
/// Frames are added in the order of time; between them, vertices move in straight lines. A contact
/// is added after both frames of its step. The page opens at the first contact, with the camera on
/// it, or at the first frame if there is none. If a motion would take more than 256 MiB, every second frame
/// is left out, as often as necessary. The frames of contacts are kept.
#[derive(Clone, Debug)]
pub struct Page {
    mesh: TriangleMesh,
    units: Units,
    up: Point,
    title: String,
    verdict: String,
    summary: Vec<String>,
    bodies: Vec<Body>,
    half_spaces: Vec<ShownHalfSpace>,
    history: Option<History>,
    radii: Vec<f32>,
    frames: Vec<ShownFrame>,
    /// The number of all frames, including the frames that were left out.
    frame_count: usize,
    most_text: usize,
    /// The first frame in the units of the page, from which the others are displaced.
    first: Vec<[f32; 3]>,
    /// The positions in the last two frames.
    last: [Vec<Point>; 2],
    contacts: Vec<ShownContact>,
    contact_count: usize,
    query: Option<ShownQuery>,
    labels: Option<Labels>,
}

impl Page {
    /// A page without frames and contacts.
    ///
    /// `bounds` is the box around the mesh in all frames, or in the first one if the others are not
    /// known yet: the middle of the picture, and the unit of its positions.
    #[must_use]
    pub fn new(title: impl Into<String>, mesh: TriangleMesh, bounds: &Aabb) -> Self {
        Self {
            mesh,
            units: Units::of(bounds),
            up: [0.0, 0.0, 1.0],
            title: title.into(),
            verdict: String::new(),
            summary: Vec::new(),
            bodies: Vec::new(),
            half_spaces: Vec::new(),
            history: None,
            radii: Vec::new(),
            frames: Vec::new(),
            frame_count: 0,
            most_text: MOST_TEXT,
            first: Vec::new(),
            last: [Vec::new(), Vec::new()],
            contacts: Vec::new(),
            contact_count: 0,
            query: None,
            labels: None,
        }
    }

    /// The page of a step: the intersections at its start, and its contacts, the earliest first.
    ///
    /// # Errors
    /// [`PageError::NoSuchIntersection`] or [`PageError::NoSuchPair`], if one of them is not of this mesh.
    pub fn of_step(
        title: impl Into<String>,
        step: Step<'_>,
        start: &[Intersection],
        contacts: &[Contact],
    ) -> Result<Self, PageError> {
        let bounds = step.positions().into_iter().flatten().copied().collect();
        let mut page = Self::new(title, step.mesh().clone(), &bounds);
        let [x0, x1] = step.positions();
        page.add_frame("t = 0", x0)?;
        start
            .iter()
            .try_for_each(|&intersection| page.add_intersection(intersection))?;
        page.add_frame("t = 1", x1)?;
        contacts
            .iter()
            .try_for_each(|contact| page.add_contact(contact))?;
        Ok(page)
    }

    /// The page of a query: its primitives in motion, the coplanarity cubic and the distance over
    /// time, the stage that decided it, and the image of the domain under F.
    ///
    /// Primitives at most `separation` apart count as touching.
    #[must_use]
    pub fn of_query<K: Kind>(title: impl Into<String>, query: &Query<K>, separation: Separation) -> Self {
        let positions = &query::points_of(query);
        let bounds = positions.as_flattened().iter().copied().collect();
        let mut page = Self::new(title, query::mesh_of::<K>(), &bounds);
        for (label, positions) in ["t = 0", "t = 1"].into_iter().zip(positions) {
            page.push_frame(label.to_owned(), positions);
        }
        if let Some(collision) = query.collision(separation) {
            let ([x0, x1], distance) = (positions, collision.distance().lower);
            let primitives = query::primitives_of::<K>();
            let shown = ShownContact::new(primitives, 0, [x0, x1], &collision.impact(), distance);
            if let Some(shown) = shown {
                page.push(shown);
            }
        }
        let query = ShownQuery::new(query, separation);
        page.verdict = query.verdict();
        page.summary = vec![query.decided_by()];
        page.query = Some(query);
        page
    }

    /// The same page with the line of the answer as its headline, in place of the first line of the summary.
    #[must_use]
    pub fn with_verdict(self, verdict: impl Into<String>) -> Self {
        let verdict = verdict.into();
        Self { verdict, ..self }
    }

    /// The same page with lines about the answer under its headline.
    #[must_use]
    pub fn with_summary(self, lines: impl IntoIterator<Item = String>) -> Self {
        let summary = lines.into_iter().collect();
        Self { summary, ..self }
    }

    /// The same page with the ids that vertices and faces have in a file, in place of the ids in the mesh:
    /// one for each vertex, and one or none for each face.
    #[must_use]
    pub fn with_ids(mut self, vertices: Vec<u32>, faces: Vec<Option<u32>>) -> Self {
        let labels = Labels { vertices, faces };
        self.contacts
            .iter_mut()
            .for_each(|contact| contact.label(&labels));
        let labels = Some(labels);
        Self { labels, ..self }
    }

    /// The same page with bodies: each has a name and a colour of its own. Without bodies, these are the
    /// connected parts of the mesh, without names.
    #[must_use]
    pub fn with_bodies(self, bodies: impl IntoIterator<Item = Body>) -> Self {
        let bodies = bodies.into_iter().collect();
        Self { bodies, ..self }
    }

    /// The same page with the radii at which rods and loose vertices are drawn: one for each vertex, in the
    /// unit of the positions. Radii that are too small to be seen are drawn a few pixels wide.
    #[must_use]
    pub fn with_radii(self, radii: &[f64]) -> Self {
        let radii = radii.iter().map(|&radius| self.units.convert_length(radius));
        let radii = radii.collect();
        Self { radii, ..self }
    }

    /// The same page with charts over the time of the motion.
    #[must_use]
    pub fn with_history(self, history: History) -> Self {
        let history = Some(history);
        Self { history, ..self }
    }

    /// The same page with a further half space: all x with n · (x − p) ≤ 0, for a point p of its boundary and
    /// the normal n. Its number is the count of half spaces before it.
    ///
    /// A half space whose normal is zero, or with a coordinate that is not finite, is ignored.
    #[must_use]
    pub fn with_half_space(mut self, name: impl Into<String>, point: Point, normal: Point) -> Self {
        self.half_spaces
            .extend(ShownHalfSpace::new(name.into(), point, normal));
        self
    }

    /// The same page with another direction upwards, of any length; it is the z axis by default.
    ///
    /// A direction that is zero or not finite is ignored.
    #[must_use]
    pub fn with_up(self, up: Point) -> Self {
        let up = unit(up).unwrap_or(self.up);
        Self { up, ..self }
    }

    /// The same page with another size, in bytes, above which frames are left out.
    #[must_use]
    pub fn with_most_text(self, most_text: usize) -> Self {
        Self { most_text, ..self }
    }

    /// Adds the next frame.
    ///
    /// # Errors
    /// [`PageError::Positions`] if there is not one finite position for each vertex.
    pub fn add_frame(&mut self, label: impl Into<String>, positions: &[Point]) -> Result<(), PageError> {
        let frame = self.frame_count;
        check_positions(self.mesh.vertex_count(), positions)
            .map_err(|source| PageError::Positions { frame, source })?;
        self.push_frame(label.into(), positions);
        Ok(())
    }

    /// Adds finite positions, one for each vertex.
    fn push_frame(&mut self, label: String, positions: &[Point]) {
        let frame = self.frame_count;
        let here = positions.iter().map(|&position| self.units.convert(position));
        let block = if frame == 0 {
            self.first = here.collect();
            block::encode_floats(self.first.as_flattened().iter().copied())
        } else {
            // Vertices that stay where they are take no room: zeros are deflated to nothing.
            let displacement = |([a, b, c], [x, y, z]): (&[f32; 3], [f32; 3])| [x - a, y - b, z - c];
            block::encode_floats(self.first.iter().zip(here).flat_map(displacement))
        };
        self.frames.push(ShownFrame::new(frame, label, block));
        self.frame_count += 1;
        if self.frames.iter().map(ShownFrame::size).sum::<usize>() > self.most_text {
            self.leave_out();
        }
        self.last.swap(0, 1);
        self.last[1] = positions.to_vec();
    }

    /// Adds a contact of the step from the last frame but one to the last, or of the only frame at
    /// rest.
    ///
    /// # Errors
    /// [`PageError::NoFrame`] before the first frame, [`PageError::NoSuchPair`] if the contact is not
    /// of this mesh.
    pub fn add_contact(&mut self, contact: &Contact) -> Result<(), PageError> {
        let frame = self.frame_count.checked_sub(1).ok_or(PageError::NoFrame)?;
        let [before, last] = &self.last;
        let start = if frame == 0 { last } else { before };
        let shown = ShownContact::of_pair(&self.mesh, frame.saturating_sub(1), [start, last], contact);
        self.push(shown.ok_or(PageError::NoSuchPair { pair: contact.pair })?);
        Ok(())
    }

    /// Adds an intersection of an edge and a face in the last frame.
    ///
    /// # Errors
    /// [`PageError::NoFrame`] before the first frame, [`PageError::NoSuchIntersection`] if it is not
    /// of this mesh.
    pub fn add_intersection(&mut self, intersection: Intersection) -> Result<(), PageError> {
        let frame = self.frame_count.checked_sub(1).ok_or(PageError::NoFrame)?;
        let shown = ShownContact::at_rest(&self.mesh, frame, &self.last[1], intersection);
        self.push(shown.ok_or(PageError::NoSuchIntersection { intersection })?);
        Ok(())
    }

    /// Adds a vertex that touches the half space of this number at a time of the step that leads to the last
    /// frame; or without a time, one that is not apart from it in the last frame.
    ///
    /// # Errors
    /// [`PageError::NoFrame`] before the first frame, [`PageError::NoSuchHalfSpace`] if the vertex is not of
    /// this mesh, or the half space not of this page.
    pub fn add_half_space_contact(
        &mut self,
        vertex: u32,
        half_space: u32,
        time: Option<f64>,
    ) -> Result<(), PageError> {
        let frame = self.frame_count.checked_sub(1).ok_or(PageError::NoFrame)?;
        let [before, last] = &self.last;
        let (frame, start, time) = match time {
            Some(time) if frame > 0 => (frame - 1, before, time),
            _ => (frame, last, 0.0),
        };
        let known = self.half_spaces.get(half_space as usize);
        let shown = known.and_then(|known| {
            ShownContact::in_half_space((frame, time), [start, last], vertex, half_space, known)
        });
        self.push(shown.ok_or(PageError::NoSuchHalfSpace { vertex, half_space })?);
        Ok(())
    }

    /// Leaves out every second frame, but not the first, the last two, and the frames of contacts.
    fn leave_out(&mut self) {
        let count = self.frames.len();
        let mut index = 0;
        let contacts = &self.contacts;
        self.frames.retain(|frame| {
            let is_end = index == 0 || index + 2 >= count;
            let is_kept =
                |contact: &ShownContact| contact.frame == frame.number || contact.frame + 1 == frame.number;
            index += 1;
            is_end || index % 2 == 1 || contacts.iter().any(is_kept)
        });
    }

    fn push(&mut self, mut contact: ShownContact) {
        self.contact_count += 1;
        if let Some(labels) = &self.labels {
            contact.label(labels);
        }
        if self.contacts.len() < MOST_CONTACTS {
            self.contacts.push(contact);
        }
    }

    /// Writes the page as an HTML file.
    ///
    /// # Errors
    /// The errors of `writer`.
    pub fn write(&self, writer: &mut impl Write) -> io::Result<()> {
        self.document().write(&self.mesh, writer)
    }

    /// The data of the page without the program that draws it, for a viewer that is open already: texts
    /// by the ids of the elements that contain them in the HTML file.
    #[must_use]
    pub fn blocks(&self) -> BTreeMap<String, String> {
        let document = self.document();
        let blocks = document.blocks(&self.mesh);
        blocks
            .map(|(id, text)| (id.into_owned(), text.into_owned()))
            .collect()
    }

    fn document(&self) -> Document<'_> {
        Document {
            format: document::FORMAT,
            title: &self.title,
            verdict: &self.verdict,
            summary: &self.summary,
            bodies: &self.bodies,
            half_spaces: &self.half_spaces,
            history: self.history.as_ref(),
            radii: &self.radii,
            up: self.up,
            vertices: self.first.len(),
            faces: self.mesh.faces().len(),
            edges: self.mesh.loose_edges().len(),
            center: self.units.center,
            scale: self.units.scale,
            frames: &self.frames,
            contacts: &self.contacts,
            contact_count: self.contact_count,
            query: self.query.as_ref(),
        }
    }
}
