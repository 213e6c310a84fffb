//! Contours of a smooth surface on its coarse triangles: the zero set of N . (E - V), interpolated.
//!
//! A. Hertzmann and D. Zorin, "Illustrating smooth surfaces", SIGGRAPH 2000:
//!
//! 1. g = N . (E - V) at each vertex V with normal N, E being the eye; for parallel projection the direction towards the viewer
//!    takes the place of E - V,
//! 2. on an edge whose ends have g of opposite signs, the point at which g interpolated linearly is 0,
//! 3. in each triangle with two such edges, the segment between their points; segments are chained over the edges.
//!
//! The contour moves continuously with the view, but remains a polyline on the faces: its image is off by the height of the
//! faces' chords.
//!
//! Departures:
//!
//! 1. g of 0 counts as positive, as everywhere in this crate.
//! 2. A chain ends at feature edges too, where g differs on both sides.
//!
//! Chains have the visible side on their left, seen from outside. They are ordered by the lowest face, at which a closed one
//! begins; an open one begins at a feature edge or where the surface ends.

use crate::eye::Eye;
use crate::shading_mesh::ShadingMesh;
use crate::shading_normals::NormalWeights;
use crate::vertex_visibility::visible;
use silhouette_core::curves::{CurveKind, CurveSource, SilhouetteCurves, SmoothPiece};
use silhouette_core::glam::Vec3;
use silhouette_core::method::{
    ExtractionStats, ExtractsCurves, Method, MethodGuide, MethodInfo, MethodOptions, PrepareError, Source,
};
use silhouette_core::prepared::{Artefact, PreparedMesh};
use silhouette_core::progress::Progress;
use silhouette_core::view::Viewpoint;
use silhouette_core::{FaceId, HalfEdgeId, Topology};
use std::sync::Arc;

silhouette_core::method_options! {
    /// Options of [`InterpolatedContours`].
    pub struct InterpolatedContoursOptions {
        /// Dihedral angle from which an edge is a feature, across which the surface is not smooth and no contour runs.
        pub crease_deg: f64 = number("crease", 0.0..=180.0 "degrees", default 75.0),
        /// How much each face counts in the normal of a vertex.
        pub normals: NormalWeights = choice("normals"),
    }
}

/// Contours as straight pieces, one per face that they cross. See the [module](self).
///
/// O(V + F) per view; a byte per face and shading vertex of scratch.
#[derive(Debug, Clone)]
pub struct InterpolatedContours {
    mesh: ShadingMesh,
    is_visible: Vec<bool>,
    is_done: Vec<bool>,
}

impl Method for InterpolatedContours {
    type Options = InterpolatedContoursOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "interpolated-contours",
        summary: "Draws the zero set of the interpolated vertex normals' facing: continuous in the view, straight on each face.",
        source: Source {
            authors: "Aaron Hertzmann, Denis Zorin",
            title: "Illustrating smooth surfaces",
            venue: "SIGGRAPH",
            year: 2000,
        },
        exact: false,
        needs: &[Topology::NAME],
        options: InterpolatedContoursOptions::SPECS,
        guide: MethodGuide {
            origin: "Hertzmann and Zorin 2000",
            yields: "curves, straight on each face",
            accuracy: "no: chords cut off the curve; a sphere of 80 faces is off by 0.066 radii",
            cost: "O(V + F), one thread",
            memory: "38 bytes per face",
            choose_when: "contours must move continuously with the view, and the chords of a coarse mesh may be seen",
            limits: "near the eye its error is above that of the mesh's own edges; curves that lie on faces which face away \
                     are hidden by the mesh itself",
        },
        published: &[],
    };

    fn prepare(
        mesh: &Arc<PreparedMesh>,
        options: &InterpolatedContoursOptions,
        progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        options.validate()?;
        let mesh = ShadingMesh::new(mesh, options.crease_deg, options.normals, Self::INFO.name, progress)?;
        let (is_visible, is_done) = (vec![true; mesh.positions().len()], vec![false; mesh.triangles().len()]);
        Ok(Self { mesh, is_visible, is_done })
    }

    fn bytes(&self) -> usize {
        self.mesh.bytes() + self.is_visible.len() + self.is_done.len()
    }
}

impl InterpolatedContours {
    /// Shading vertices where a half-edge begins and ends.
    fn ends(&self, half_edge: HalfEdgeId) -> [u32; 2] {
        let corners = self.mesh.triangles()[half_edge.face().index()];
        let slot = half_edge.slot() as usize;
        [corners[slot], corners[(slot + 1) % 3]]
    }

    /// The half-edge of a face that begins at a visible vertex, or an invisible one, and does not end at another such.
    fn side(&self, face: FaceId, begins_visible: bool) -> Option<HalfEdgeId> {
        let is_side = |half_edge: &HalfEdgeId| {
            let [start, end] = self.ends(*half_edge).map(|vertex| self.is_visible[vertex as usize]);
            start == begins_visible && end != begins_visible
        };
        (0..3).map(|slot| HalfEdgeId::of(face, slot)).find(is_side)
    }

    /// The face that shares an edge and the shading vertices at its ends.
    fn across(&self, half_edge: HalfEdgeId) -> Option<FaceId> {
        let edge = self.mesh.topology().edge_of(half_edge);
        if self.mesh.features()[edge] {
            return None;
        }
        let sides = self.mesh.topology().half_edges(edge);
        sides.iter().find(|other| **other != half_edge).map(|other| other.face())
    }

    /// Step 2: the point of an edge with both signs, bitwise the same from both faces.
    fn point(&self, half_edge: HalfEdgeId, eye: Eye) -> Vec3 {
        let [a, b] = self.ends(half_edge);
        let [(p, g), (q, h)] = [a.min(b), a.max(b)].map(|vertex| {
            let position = self.mesh.positions()[vertex as usize].as_dvec3();
            (position, self.mesh.normals()[vertex as usize].as_dvec3().dot(eye.toward(position)))
        });
        p.lerp(q, g / (g - h)).as_vec3()
    }

    /// Step 3: the chain through a face with both signs. Chains have their visible side on the left, so that they enter a face
    /// over the side from its visible vertices to its invisible ones.
    fn chain(&mut self, face: FaceId, eye: Eye, out: &mut SilhouetteCurves) {
        let before = |of: &Self, face| of.side(face, true).and_then(|side| of.across(side));
        let mut first = face;
        let mut is_closed = false;
        while let Some(previous) = before(self, first) {
            is_closed = previous == face;
            if is_closed {
                first = face;
                break;
            }
            first = previous;
        }
        let (mut at, mut is_empty) = (first, true);
        while let (Some(enter), Some(leave)) = (self.side(at, true), self.side(at, false)) {
            self.is_done[at.index()] = true;
            let (from, to) = (self.point(enter, eye), self.point(leave, eye));
            // The contour touches faces in a vertex where g is 0.
            if from != to {
                out.push(SmoothPiece::line(from, to, CurveKind::Silhouette, CurveSource::Face(at)));
                is_empty = false;
            }
            match self.across(leave) {
                Some(next) if next != first => at = next,
                _ => break,
            }
        }
        if !is_empty {
            out.end_chain(is_closed);
        }
    }
}

/// Counts every face as tested.
impl ExtractsCurves for InterpolatedContours {
    fn extract_curves(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteCurves) -> ExtractionStats {
        out.clear();
        let eye = Eye::from(*viewpoint);
        for (is_visible, (&position, &normal)) in
            self.is_visible.iter_mut().zip(self.mesh.positions().iter().zip(self.mesh.normals()))
        {
            *is_visible = visible(position, normal, eye);
        }
        self.is_done.fill(false);
        for face in (0..self.mesh.triangles().len()).map(FaceId::from_usize) {
            if !self.is_done[face.index()] && self.side(face, true).is_some() {
                self.chain(face, eye, out);
            }
        }
        ExtractionStats { faces_tested: self.mesh.triangles().len() as u64, ..ExtractionStats::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use silhouette_core::TriangleMesh;
    use silhouette_testing::{builtin, directions, prepare, strategies, views, zoo};

    fn extracted(mesh: &TriangleMesh, viewpoint: Viewpoint) -> (InterpolatedContours, SilhouetteCurves) {
        let mut method = prepare::method::<InterpolatedContours>(&prepare::prepared(mesh.clone()));
        let mut curves = SilhouetteCurves::default();
        method.extract_curves(&viewpoint, &mut curves);
        (method, curves)
    }

    fn parallel(direction: Vec3) -> Viewpoint {
        Viewpoint::Orthographic { toward_viewer: direction }
    }

    #[test]
    fn without_features_chains_of_closed_meshes_are_closed_and_cross_each_mixed_face_once() {
        for name in ["icosphere:3", "torus:40,24", "knot", "blob:3000"] {
            let mesh = builtin(name);
            let has_features = prepare::method::<InterpolatedContours>(&prepare::prepared(mesh.clone()))
                .mesh
                .features()
                .as_slice()
                .contains(&true);
            for direction in directions::spread(5) {
                for viewpoint in [parallel(direction.as_vec3()), views::seen_from_radii(&mesh, direction, 2.0)] {
                    let (method, curves) = extracted(&mesh, viewpoint);
                    assert!(has_features || curves.iter().all(|chain| chain.closed), "{name}");
                    let faces = (0..mesh.face_count()).map(FaceId::from_usize);
                    let mixed = faces.filter(|face| method.side(*face, false).is_some()).count();
                    assert_eq!(curves.pieces().len(), mixed, "{name}");
                }
            }
        }
    }

    #[test]
    fn open_chains_end_at_features_and_where_the_surface_ends() {
        for (name, mesh) in [("cylinder", builtin("cylinder"))].into_iter().chain(zoo::with_boundary()) {
            let (mut open, mut sides) = (0, 0);
            for direction in directions::spread(20) {
                let (method, curves) = extracted(&mesh, parallel(direction.as_vec3()));
                for chain in curves.iter().filter(|chain| !chain.closed) {
                    open += 1;
                    for piece in [chain.pieces[0], chain.pieces[chain.pieces.len() - 1]] {
                        let CurveSource::Face(face) = piece.source else { panic!("pieces run through faces") };
                        let has_no_neighbour = |begins_visible| {
                            method.side(face, begins_visible).is_some_and(|side| method.across(side).is_none())
                        };
                        sides += usize::from(has_no_neighbour(true) || has_no_neighbour(false));
                    }
                }
            }
            assert!(name.starts_with("grid") || open > 0, "{name}");
            assert_eq!(sides, 2 * open, "{name}");
        }
    }

    #[test]
    fn the_visible_side_is_on_the_left_and_pieces_are_tangential_to_the_view() {
        let mesh = builtin("icosphere:2");
        let toward = Vec3::new(0.3, -0.5, 0.8).normalize();
        let (_, curves) = extracted(&mesh, parallel(toward));
        for piece in curves.pieces() {
            let (from, to) = (piece.control[0], piece.control[3]);
            // Seen from outside, left is the normal times the way, and the visible side is the viewer's.
            assert!(from.normalize().cross(to - from).dot(toward) > 0.0);
            assert!(from.normalize().dot(toward).abs() < 0.02);
        }
    }

    #[test]
    fn once_grown_nothing_is_allocated() {
        let mesh = builtin("knot");
        let mut method = prepare::method::<InterpolatedContours>(&prepare::prepared(mesh.clone()));
        let mut curves = SilhouetteCurves::default();
        views::orbit(&mesh, 3.0, 120).for_each(|view| _ = method.extract_curves(&view, &mut curves));
        let extract = || views::orbit(&mesh, 3.0, 120).for_each(|view| _ = method.extract_curves(&view, &mut curves));
        assert_eq!(allocation_counter::measure(extract).count_total, 0);
    }

    proptest! {
        #[test]
        fn any_mesh_yields_finite_chains(mesh in strategies::soup(30), viewpoint in strategies::viewpoint()) {
            let (_, curves) = extracted(&mesh, viewpoint);
            prop_assert!(curves.pieces().iter().flat_map(|piece| piece.control).all(Vec3::is_finite));
        }
    }
}
