//! Adaptive refinement: faces near the silhouette are curved and split, the others stay as they are.
//!
//! C. Dyken, M. Reimers and J. Seland, "Real-time GPU silhouette refinement using adaptively blended Bézier patches", Computer
//! Graphics Forum 27(1), 2008:
//!
//! 1. each edge has a *silhouetteness* from 0 to 1: 1 for silhouette edges, falling smoothly to 0 as its faces turn away from
//!    grazing view,
//! 2. the curve over an edge is a blend of the straight edge and a cubic made of the normals at its ends ([`crate::side_curves`]), by
//!    its silhouetteness,
//! 3. a face with an edge above 0 is a cubic patch over the three curves, split evenly; the others are drawn as they are.
//!
//! Departures:
//!
//! 1. All patches are split alike, into a power of two per side; the paper chooses the power by the largest silhouetteness.
//! 2. The thresholds of the silhouetteness are angles of the view to the plane of a face; between them it is the cubic 3 t² - 2 t³.
//! 3. A flat face next to a patch has the patch's vertices on its side, so that the surface is watertight bit for bit, where
//!    the paper relies on points of a straight side being on it.
//! 4. Boundary edges count as silhouette edges: the outline always runs along them.
//! 5. Normals are interpolated linearly, so that a face does not change its light when it is split.

use crate::eye::{Eye, SmoothingView};
use crate::face_splitter::{FaceSplitter, Patch, Splitting};
use crate::hermite::Hermite;
use crate::pn_triangles::PnPatch;
use crate::shading_mesh::ShadingMesh;
use crate::shading_normals::NormalWeights;
use crate::side_curves::side_curves;
use crate::tessellation::check_size;
use crate::view_mesh::{MakesTriangles, Remesher, ViewMesh};
use silhouette_core::face_normal::face_normal;
use silhouette_core::glam::DVec3;
use silhouette_core::id::PerEdge;
use silhouette_core::method::{Method, MethodGuide, MethodInfo, MethodOptions, PrepareError, Source};
use silhouette_core::prepared::{Artefact, PreparedMesh};
use silhouette_core::progress::Progress;
use silhouette_core::{EdgeId, FaceId, HalfEdgeId, Topology};
use std::sync::Arc;

silhouette_core::method_options! {
    /// Options of [`AdaptiveRefinement`].
    pub struct AdaptiveRefinementOptions {
        /// How often the sides of patches are halved: each patch becomes 4 to this power triangles.
        pub halvings: u32 = whole("halvings", 0..=4, default 2, sweep linear 0..=4),
        /// Angle between the view and the plane of a face up to which its edges are wholly curved.
        pub full_deg: f64 = number("full", 0.0..=90.0 "degrees", default 10.0),
        /// Angle between the view and the planes of its faces from which an edge is straight; edges are wholly curved or straight
        /// if this is not above full.
        pub none_deg: f64 = number("none", 0.0..=90.0 "degrees", default 25.0),
        /// Dihedral angle from which an edge is a feature, across which the surface is not smooth.
        pub crease_deg: f64 = number("crease", 0.0..=180.0 "degrees", default 75.0),
        /// How much each face counts in the normal of a vertex.
        pub normals: NormalWeights = choice("normals"),
    }
}

/// Patches near the silhouette, flat faces elsewhere. See the [module](self).
///
/// O(F) per view on the CPU, and 4^halvings triangles per patch to upload.
#[derive(Debug, Clone)]
pub struct AdaptiveRefinement {
    options: AdaptiveRefinementOptions,
    remesher: AdaptiveRemesher,
}

impl Method for AdaptiveRefinement {
    type Options = AdaptiveRefinementOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "adaptive-refinement",
        summary: "Curves and splits the faces near the silhouette, blending into flat faces away from it.",
        source: Source {
            authors: "Christopher Dyken, Martin Reimers, Johan Seland",
            title: "Real-time GPU silhouette refinement using adaptively blended Bézier patches",
            venue: "Computer Graphics Forum 27(1)",
            year: 2008,
        },
        exact: false,
        needs: &[Topology::NAME],
        options: AdaptiveRefinementOptions::SPECS,
        guide: MethodGuide {
            origin: "Dyken et al. 2008",
            yields: "a filled image, split near the silhouette alone",
            accuracy: "no: a sphere of 80 faces is off by 0.010 to 0.011 radii, with 760 to 940 triangles",
            cost: "O(F + E), one thread; O(F + split triangles) to upload",
            memory: "350 bytes per face, plus the triangles it makes",
            choose_when: "the outline of `pn-triangles` is wanted with fewer triangles, made anew for each view",
            limits: "the processor works and uploads in every view; trusts normals, as `pn-triangles` does",
        },
        published: &[],
    };

    fn prepare(
        mesh: &Arc<PreparedMesh>,
        options: &AdaptiveRefinementOptions,
        progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        options.validate()?;
        let segments = 1 << options.halvings;
        check_size(mesh.mesh().face_count(), segments)?;
        let mesh = Arc::new(ShadingMesh::new(mesh, options.crease_deg, options.normals, Self::INFO.name, progress)?);
        progress.check()?;
        let faces = (0..mesh.triangles().len()).map(FaceId::from_usize);
        let normals = faces.map(|face| face_normal(mesh.mesh().corners(face)).unwrap_or(DVec3::ZERO)).collect();
        progress.check()?;
        let curves = side_curves(&mesh);
        progress.check()?;
        let remesher = AdaptiveRemesher {
            law: Law { full_deg: options.full_deg, none_deg: options.none_deg },
            segments,
            blended: curves.clone(),
            curves: Arc::new(curves),
            is_curved: vec![false; mesh.topology().edge_count()],
            is_split: vec![false; mesh.topology().edge_count()],
            normals,
            mesh,
            splitter: FaceSplitter::default(),
            made: None,
        };
        Ok(Self { options: *options, remesher })
    }

    fn bytes(&self) -> usize {
        self.remesher.bytes()
    }
}

impl AdaptiveRefinement {
    /// Its options.
    pub fn options(&self) -> &AdaptiveRefinementOptions {
        &self.options
    }

    /// The mesh with its shading normals.
    pub fn shading_mesh(&self) -> &ShadingMesh {
        &self.remesher.mesh
    }
}

impl MakesTriangles for AdaptiveRefinement {
    type Remesher = AdaptiveRemesher;

    fn remesher(&self) -> Self::Remesher {
        self.remesher.clone()
    }
}

/// Angles of the view to the plane of a face.
#[derive(Debug, Clone, Copy)]
struct Law {
    full_deg: f64,
    none_deg: f64,
}

impl Law {
    /// Step 1, from the cosines of the angles between the view and the normals of an edge's faces.
    fn silhouetteness(self, cosines: impl Iterator<Item = f64>) -> f64 {
        let (least, most) =
            cosines.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), c| (low.min(c), high.max(c)));
        if least <= 0.0 && most >= 0.0 {
            return 1.0;
        }
        let grazing_deg = least.abs().min(most.abs()).min(1.0).asin().to_degrees();
        if grazing_deg <= self.full_deg {
            1.0
        } else if grazing_deg >= self.none_deg {
            0.0
        } else {
            let t = (self.none_deg - grazing_deg) / (self.none_deg - self.full_deg);
            t * t * (3.0 - 2.0 * t)
        }
    }
}

/// Makes the triangles of [`AdaptiveRefinement`].
#[derive(Debug, Clone)]
pub struct AdaptiveRemesher {
    law: Law,
    segments: u32,
    mesh: Arc<ShadingMesh>,
    /// Unit normals of faces; 0 without an area.
    normals: Arc<[DVec3]>,
    curves: Arc<PerEdge<Hermite>>,
    /// The curves of this view, of edges that are split.
    blended: PerEdge<Hermite>,
    /// Per edge, whether its silhouetteness is above 0.
    is_curved: Vec<bool>,
    /// Per edge, whether a face at it is a patch.
    is_split: Vec<bool>,
    splitter: FaceSplitter,
    /// The view that was made last, and its vertices.
    made: Option<(SmoothingView, usize)>,
}

impl AdaptiveRemesher {
    /// Bytes held beside the mesh and its topology.
    pub fn bytes(&self) -> usize {
        self.mesh.bytes()
            + size_of_val(&*self.normals)
            + size_of_val(self.curves.as_slice())
            + size_of_val(self.blended.as_slice())
            + self.is_curved.len()
            + self.is_split.len()
            + self.splitter.bytes()
    }

    /// The silhouetteness of an edge, from 0 to 1.
    pub fn silhouetteness(&self, edge: EdgeId, eye: Eye) -> f64 {
        let topology = self.mesh.topology();
        if topology.half_edges(edge).len() == 1 {
            return 1.0;
        }
        let [from, to] =
            topology.end_points(edge).map(|vertex| self.mesh.mesh().positions()[vertex.index()].as_dvec3());
        let toward = eye.toward(0.5 * (from + to)).normalize_or_zero();
        let normals =
            topology.faces(edge).map(|face| self.normals[face.index()]).filter(|normal| *normal != DVec3::ZERO);
        let cosines = normals.map(|normal| normal.dot(toward));
        self.law.silhouetteness(cosines)
    }

    /// Steps 1 and 2.
    fn blend(&mut self, eye: Eye) {
        let straight = |[from, to]: [DVec3; 2]| Hermite { ends: [from, to], tangents: [to - from; 2] };
        self.is_split.fill(false);
        for edge in (0..self.curves.len()).map(EdgeId::from_usize) {
            let silhouetteness = self.silhouetteness(edge, eye);
            self.is_curved[edge.index()] = silhouetteness > 0.0;
            let (curve, line) = (self.curves[edge], straight(self.curves[edge].ends));
            let tangent = |end: usize| line.tangents[end].lerp(curve.tangents[end], silhouetteness);
            self.blended[edge] = Hermite { tangents: [tangent(0), tangent(1)], ..curve };
        }
        for face in (0..self.mesh.triangles().len()).map(FaceId::from_usize) {
            let edges = edges(self.mesh.topology(), face);
            if edges.iter().any(|edge| self.is_curved[edge.index()]) {
                edges.iter().for_each(|edge| self.is_split[edge.index()] = true);
            }
        }
    }
}

fn edges(topology: &Topology, face: FaceId) -> [EdgeId; 3] {
    [0, 1, 2].map(|slot| topology.edge_of(HalfEdgeId::of(face, slot)))
}

/// Step 3. The same view twice in a row is made once. O(F + triangles).
impl Remesher for AdaptiveRemesher {
    fn remesh(&mut self, view: &SmoothingView, out: &mut ViewMesh) -> bool {
        if self.made == Some((*view, out.positions.len())) {
            return false;
        }
        self.blend(view.eye());
        let Self { mesh, blended, segments, is_curved, is_split, splitter, .. } = self;
        let from = Splitting { mesh, curves: blended, patch: &BlendedPatch, segments: *segments };
        splitter.begin(mesh, out);
        for face in (0..mesh.triangles().len()).map(FaceId::from_usize) {
            let edges = edges(mesh.topology(), face);
            if edges.iter().any(|edge| is_curved[edge.index()]) {
                splitter.push_split(&from, face, out);
            } else {
                splitter.push_flat(&from, face, edges.map(|edge| is_split[edge.index()]), out);
            }
        }
        self.made = Some((*view, out.positions.len()));
        true
    }
}

/// The patch of PN triangles with linear normals.
#[derive(Debug, Clone, Copy)]
struct BlendedPatch;

impl Patch for BlendedPatch {
    fn side_point(&self, side: &Hermite, u: f64) -> DVec3 {
        PnPatch.side_point(side, u)
    }

    fn inner_point(&self, sides: &[Hermite; 3], weights: [f64; 3]) -> DVec3 {
        PnPatch.inner_point(sides, weights)
    }

    fn normal(&self, _positions: [DVec3; 3], normals: [DVec3; 3], weights: [f64; 3]) -> DVec3 {
        weights[0] * normals[0] + weights[1] * normals[1] + weights[2] * normals[2]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::glam::Vec3;
    use silhouette_core::view::Viewpoint;
    use silhouette_core::{FaceFacings, SilhouetteEdges};
    use silhouette_testing::{builtin, directions, prepare, zoo};

    fn method(name: &str, words: &[&str]) -> AdaptiveRefinement {
        let options = AdaptiveRefinementOptions::parse(words.iter().copied()).unwrap();
        AdaptiveRefinement::new(&prepare::prepared(builtin(name)), options).unwrap()
    }

    fn view(eye: Eye) -> SmoothingView {
        SmoothingView::new(eye, silhouette_core::glam::DMat4::IDENTITY, [400, 400])
    }

    #[test]
    fn the_silhouetteness_is_one_at_the_silhouette_and_falls_smoothly() {
        let law = Law { full_deg: 10.0, none_deg: 40.0 };
        let at = |degrees: [f64; 2]| law.silhouetteness(degrees.into_iter().map(|degree| degree.to_radians().sin()));
        assert!([[-30.0, 5.0], [80.0, 9.9], [0.0, 50.0]].into_iter().all(|degrees| at(degrees) >= 1.0));
        assert!(at([-41.0, -60.0]) <= 0.0);
        assert!((at([25.0, 70.0]) - 0.5).abs() < 1e-12);
        let values: Vec<f64> = (0..=500).map(|step| at([f64::from(step) * 0.1, 80.0])).collect();
        assert!(values.is_sorted_by(|a, b| a >= b) && values.windows(2).all(|pair| pair[0] - pair[1] < 0.01));
        let step = Law { full_deg: 20.0, none_deg: 10.0 };
        let [below, above] =
            [19.9_f64, 20.1].map(|degrees| step.silhouetteness([degrees.to_radians().sin(); 2].into_iter()));
        assert!(below >= 1.0 && above <= 0.0);
    }

    #[test]
    fn silhouette_edges_are_wholly_curved() {
        for (name, mesh) in zoo::edge_manifold() {
            let method: AdaptiveRefinement = prepare::method(&prepare::prepared(mesh.clone()));
            let topology = Topology::new(&mesh);
            for direction in directions::spread(5) {
                let viewpoint = Viewpoint::Orthographic { toward_viewer: direction.as_vec3() };
                let edges = SilhouetteEdges::of(&topology, &FaceFacings::new(&mesh, &viewpoint));
                let remesher = method.remesher();
                assert!(edges.iter().all(|edge| remesher.silhouetteness(edge, viewpoint.into()) >= 1.0), "{name}");
            }
        }
    }

    #[test]
    fn few_faces_of_a_fine_mesh_become_patches_and_all_do_if_the_thresholds_say_so() {
        let eye = Eye::from(Viewpoint::Orthographic { toward_viewer: Vec3::new(0.2, 0.3, 1.0) });
        let mut out = ViewMesh::default();
        method("icosphere:4", &["none=10", "full=5"]).remesher().remesh(&view(eye), &mut out);
        assert!((5120 * 2..5120 * 6).contains(&out.triangles.len()), "{}", out.triangles.len());
        method("icosphere:4", &["none=90", "full=90"]).remesher().remesh(&view(eye), &mut out);
        assert_eq!(out.triangles.len(), 5120 * 16);
        // Only silhouette edges, which a plane seen from above has at its boundary alone.
        let plane = method("grid:20,14", &["full=0", "none=0"]);
        let eye = Eye::from(Viewpoint::Orthographic { toward_viewer: builtin_normal("grid:20,14") });
        plane.remesher().remesh(&view(eye), &mut out);
        assert!(out.triangles.len() < 560 * 6, "{}", out.triangles.len());
    }

    fn builtin_normal(name: &str) -> Vec3 {
        face_normal(builtin(name).corners(FaceId::new(0))).unwrap().as_vec3()
    }

    #[test]
    fn the_same_view_is_made_once() {
        let mut remesher = method("torus", &[]).remesher();
        let mut out = ViewMesh::default();
        let views = [Vec3::X, Vec3::Y].map(|toward_viewer| view(Viewpoint::Orthographic { toward_viewer }.into()));
        let answers = [0, 0, 1, 1, 0].map(|index: usize| remesher.remesh(&views[index], &mut out));
        assert_eq!(answers, [true, false, true, false, true]);
    }
}
