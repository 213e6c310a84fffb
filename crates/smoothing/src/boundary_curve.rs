//! Boundary curve interpolation: a smooth curve through the vertices of the silhouette edges, and the area between both.
//!
//! B. Wang, W. Wang, J. Wu and J. Sun, "Silhouette smoothing by boundary curve interpolation", CAD/Graphics 2003. Read from what
//! Wang, Tu, Wang, Meng, Chan and Yan (2008) say of it, as the paper itself was not at hand: it works on the projected boundary
//! of the mesh in the plane of the view, with curves that interpolate the vertices of silhouette edges. Neither smooth in time
//! nor right where the silhouette is concave, by the same source. The reading:
//!
//! 1. silhouette edges, by the exact facing of faces, form loops ([`silhouette_core::loops`]),
//! 2. at each vertex, the tangent in the image is that of the circle through three consecutive vertices of the loop; where the
//!    loop turns by `corner` or more in the image, each side leaves along its own edge,
//! 3. over each edge, a cubic with these tangents, as long as arcs ask for; its depth is that of the edge ([`LoopCurves`]),
//! 4. the faces are drawn as they are, and between each edge and its cubic a fan of triangles ([`BoundaryRemesher`]).
//!
//! The plane of the image at a vertex is the plane across its sight line: in parallel projection curves and tangents are exactly
//! those of the image; in a perspective the foreshortening over one edge is neglected.
//!
//! Where a curve runs inside of the mesh's image, its fan lies within it and smooths nothing: the mesh covers more than the curve
//! encloses.

use crate::eye::{Eye, SmoothingView};
use crate::face_splitter::FaceSplitter;
use crate::hermite::Hermite;
use crate::sampling::{Sampling, segments};
use crate::shading_mesh::ShadingMesh;
use crate::shading_normals::NormalWeights;
use crate::side_curves::Side;
use crate::view_mesh::{MakesTriangles, Origin, Remesher, ViewMesh};
use silhouette_core::curves::{CurveKind, CurveSource, SilhouetteCurves};
use silhouette_core::glam::DVec3;
use silhouette_core::loops::LoopWalker;
use silhouette_core::method::{
    ExtractionStats, ExtractsCurves, Method, MethodGuide, MethodInfo, MethodOptions, PrepareError, Source,
};
use silhouette_core::prepared::{Artefact, PreparedMesh};
use silhouette_core::progress::Progress;
use silhouette_core::silhouette::is_silhouette_edge;
use silhouette_core::view::Viewpoint;
use silhouette_core::{EdgeId, FaceFacings, FaceId, HalfEdgeId, SilhouetteEdges, SilhouetteLoops, Topology};
use std::sync::Arc;

silhouette_core::method_options! {
    /// Options of [`BoundaryCurve`].
    pub struct BoundaryCurveOptions {
        /// Turn of the silhouette in the image from which a vertex is a corner, which stays sharp.
        pub corner_deg: f64 = number("corner", 0.0..=90.0 "degrees", default 75.0),
        /// Distance to which a curve is drawn by straight segments.
        pub tolerance_px: f64 = number("tolerance", 0.01..=64.0 "px", default 1.0, sweep log 0.1..=16.0),
        /// Dihedral angle from which an edge is a feature, across which normals are not interpolated.
        pub crease_deg: f64 = number("crease", 0.0..=180.0 "degrees", default 75.0),
        /// How much each face counts in the normal of a vertex.
        pub normals: NormalWeights = choice("normals"),
    }
}

/// Curves through the vertices of silhouette edges. See the [module](self).
///
/// O(F + E) per view on the CPU; of the surface, O(F) bytes are uploaded per view.
#[derive(Debug, Clone)]
pub struct BoundaryCurve {
    options: BoundaryCurveOptions,
    loops: LoopCurves,
}

impl Method for BoundaryCurve {
    type Options = BoundaryCurveOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "boundary-curve",
        summary: "Draws curves through the vertices of the silhouette edges, and fills the area between edges and curves.",
        source: Source {
            authors: "B. Wang, W. Wang, J. Wu, J. Sun",
            title: "Silhouette smoothing by boundary curve interpolation",
            venue: "CAD/Graphics",
            year: 2003,
        },
        exact: false,
        needs: &[Topology::NAME],
        options: BoundaryCurveOptions::SPECS,
        guide: MethodGuide {
            origin: "B. Wang et al. 2003, read from its description",
            yields: "curves; a filled image",
            accuracy: "no: a sphere of 80 faces is off by 0.062 radii, hardly less than the mesh",
            cost: "O(F + E), one thread; O(F) bytes to upload",
            memory: "38 to 49 bytes per face",
            choose_when: "you compare smoothing with what came before it",
            limits: "gains little, and on some simplified scans has a worse outline than the mesh",
        },
        published: &[],
    };

    fn prepare(
        mesh: &Arc<PreparedMesh>,
        options: &BoundaryCurveOptions,
        progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        options.validate()?;
        let mesh = ShadingMesh::new(mesh, options.crease_deg, options.normals, Self::INFO.name, progress)?;
        Ok(Self { options: *options, loops: LoopCurves::new(Arc::new(mesh), options.corner_deg) })
    }

    fn bytes(&self) -> usize {
        self.loops.bytes()
    }
}

impl BoundaryCurve {
    /// Its options.
    pub fn options(&self) -> &BoundaryCurveOptions {
        &self.options
    }

    /// The mesh with its shading normals.
    pub fn shading_mesh(&self) -> &ShadingMesh {
        &self.loops.mesh
    }
}

impl MakesTriangles for BoundaryCurve {
    type Remesher = BoundaryRemesher;

    fn remesher(&self) -> Self::Remesher {
        let loops = self.loops.clone();
        let (mut splitter, mut faces) = (FaceSplitter::default(), ViewMesh::default());
        splitter.begin(&loops.mesh, &mut faces);
        for face in (0..loops.mesh.triangles().len()).map(FaceId::from_usize) {
            splitter.push_whole(&loops.mesh, face, &mut faces);
        }
        BoundaryRemesher { loops, splitter, faces, tolerance_px: self.options.tolerance_px, made: None }
    }
}

/// Steps 1 to 3: the loops of a view with a curve over each half-edge.
#[derive(Debug, Clone)]
pub struct LoopCurves {
    mesh: Arc<ShadingMesh>,
    least_cosine: f64,
    facings: FaceFacings,
    edges: SilhouetteEdges,
    walker: LoopWalker,
    loops: SilhouetteLoops,
    /// In the order of the loops' half-edges.
    curves: Vec<Hermite>,
}

impl LoopCurves {
    /// Curves of a mesh, with corners where a loop turns by `corner_deg`, 0 to 90, or more in the image.
    pub fn new(mesh: Arc<ShadingMesh>, corner_deg: f64) -> Self {
        Self {
            mesh,
            least_cosine: corner_deg.to_radians().cos(),
            facings: FaceFacings::default(),
            edges: SilhouetteEdges::default(),
            walker: LoopWalker::default(),
            loops: SilhouetteLoops::default(),
            curves: Vec::new(),
        }
    }

    /// Finds loops and curves of a view. O(F + E), allocates nothing once it has grown.
    pub fn find(&mut self, viewpoint: &Viewpoint) -> ExtractionStats {
        let topology = self.mesh.topology();
        let exact_fallbacks = self.facings.classify(self.mesh.mesh(), viewpoint);
        let edges = (0..topology.edge_count()).map(EdgeId::from_usize);
        self.edges.refill_ascending(edges.filter(|edge| is_silhouette_edge(topology, &self.facings, *edge)));
        self.walker.walk(topology, &self.facings, &self.edges, &mut self.loops);
        let eye = Eye::from(*viewpoint);
        self.curves.clear();
        for half_edges in self.loops.iter() {
            let count = half_edges.len();
            for index in 0..count {
                let around = [index + count - 1, index, index + 1].map(|index| half_edges[index % count]);
                let curve = curve(&self.mesh, self.least_cosine, eye, around);
                self.curves.push(curve);
            }
        }
        ExtractionStats {
            faces_tested: self.mesh.mesh().face_count() as u64,
            edges_tested: topology.edge_count() as u64,
            exact_fallbacks,
            ..ExtractionStats::default()
        }
    }

    /// The half-edges of the view last looked at, loop after loop.
    pub fn loops(&self) -> &SilhouetteLoops {
        &self.loops
    }

    /// The curve over each of them, from its begin to its end.
    pub fn curves(&self) -> &[Hermite] {
        &self.curves
    }

    /// Bytes held beside the mesh and its topology.
    pub fn bytes(&self) -> usize {
        self.mesh.bytes()
            + self.facings.bytes()
            + size_of_val(self.edges.as_slice())
            + self.walker.bytes()
            + self.loops.bytes()
            + size_of_val(self.curves.as_slice())
    }
}

/// Vertices of the mesh where a half-edge begins and ends.
fn ends(mesh: &ShadingMesh, half_edge: HalfEdgeId) -> [u32; 2] {
    let corners = mesh.mesh().triangles()[half_edge.face().index()];
    let slot = half_edge.slot() as usize;
    [corners[slot], corners[(slot + 1) % 3]]
}

/// Step 3, for the second of three half-edges of a loop.
fn curve(mesh: &ShadingMesh, least_cosine: f64, eye: Eye, around: [HalfEdgeId; 3]) -> Hermite {
    let position = |vertex: u32| mesh.mesh().positions()[vertex as usize].as_dvec3();
    let vertices = around.map(|half_edge| ends(mesh, half_edge));
    let chords = vertices.map(|[from, to]| position(to) - position(from));
    let points = vertices[1].map(position);
    let tangent = |end: usize| {
        let sight = eye.toward(points[end]).normalize_or_zero();
        let in_image = |vector: DVec3| vector - vector.dot(sight) * sight;
        let [before, after] = [end, end + 1].map(|index| in_image(chords[index]));
        // Where windings disagree, a loop jumps.
        let is_joined = vertices[end][1] == vertices[end + 1][0];
        match turn(before, after, least_cosine).filter(|_| is_joined) {
            Some(direction) => {
                let chord = chords[1];
                let across = in_image(chord);
                Hermite::along([DVec3::ZERO, across], [direction; 2]).tangents[end] + (chord - across)
            }
            None => chords[1],
        }
    };
    Hermite { ends: points, tangents: [tangent(0), tangent(1)] }
}

/// Step 2: the direction of the circle through three points, given the ways between them; `None` at a corner.
fn turn(before: DVec3, after: DVec3, least_cosine: f64) -> Option<DVec3> {
    let lengths = [before.length(), after.length()];
    if before.dot(after) <= least_cosine * lengths[0] * lengths[1] {
        return None;
    }
    (before / (lengths[0] * lengths[0]) + after / (lengths[1] * lengths[1])).try_normalize()
}

impl ExtractsCurves for BoundaryCurve {
    /// One closed chain per loop, with a piece per silhouette edge. Where windings disagree, a loop may fall apart into open
    /// chains.
    fn extract_curves(&mut self, viewpoint: &Viewpoint, out: &mut SilhouetteCurves) -> ExtractionStats {
        out.clear();
        let stats = self.loops.find(viewpoint);
        let LoopCurves { mesh, loops, curves, .. } = &self.loops;
        for (index, half_edges) in loops.iter().enumerate() {
            let curves = &curves[loops.range(index)];
            let joins = |at: usize| curves[at].ends[1] == curves[(at + 1) % curves.len()].ends[0];
            let is_closed = (0..curves.len()).all(joins);
            let mut is_empty = true;
            for (at, (half_edge, curve)) in half_edges.iter().zip(curves).enumerate() {
                if curve.ends[0] != curve.ends[1] {
                    let edge = mesh.topology().edge_of(*half_edge);
                    let is_boundary = mesh.topology().half_edges(edge).len() == 1;
                    let kind = if is_boundary { CurveKind::Boundary } else { CurveKind::Silhouette };
                    out.push(curve.piece(kind, CurveSource::Edge(edge)));
                    is_empty = false;
                }
                if !is_empty && (at + 1 == curves.len() || !joins(at)) {
                    out.end_chain(is_closed);
                    is_empty = true;
                }
            }
        }
        stats
    }
}

/// Step 4: makes the triangles of [`BoundaryCurve`].
#[derive(Debug, Clone)]
pub struct BoundaryRemesher {
    loops: LoopCurves,
    /// Knows the vertices of `faces`.
    splitter: FaceSplitter,
    /// The mesh as it is, which every view begins with.
    faces: ViewMesh,
    tolerance_px: f64,
    /// The view that was made last, and its vertices.
    made: Option<(SmoothingView, usize)>,
}

/// The same view twice in a row is made once. O(F + samples).
impl Remesher for BoundaryRemesher {
    fn remesh(&mut self, view: &SmoothingView, out: &mut ViewMesh) -> bool {
        if self.made == Some((*view, out.positions.len())) {
            return false;
        }
        self.loops.find(&view.eye().viewpoint());
        out.clear();
        out.positions.extend_from_slice(&self.faces.positions);
        out.normals.extend_from_slice(&self.faces.normals);
        out.origins.extend_from_slice(&self.faces.origins);
        out.triangles.extend_from_slice(&self.faces.triangles);
        let LoopCurves { mesh, loops, curves, .. } = &self.loops;
        for (half_edge, curve) in loops.half_edges().iter().zip(curves) {
            let side = Side::of(mesh, *half_edge);
            let normals = side.corners.map(|corner| mesh.normals()[corner as usize].as_dvec3());
            let count = segments(curve, normals, view, self.tolerance_px, Sampling::Guaranteed);
            let [start, end] = side.corners.map(|corner| self.splitter.vertex_of(corner));
            let mut last = None;
            for step in 1..=count {
                let next = if step == count {
                    end
                } else {
                    let u = f64::from(step) / f64::from(count);
                    let mut weights = [0.0; 3];
                    (weights[side.slots[0]], weights[side.slots[1]]) = ((1.0 - u) as f32, u as f32);
                    let origin = Origin { face: half_edge.face(), weights };
                    out.push_vertex(curve.point(u), normals[0].lerp(normals[1], u), origin)
                };
                if let Some(last) = last {
                    out.push_triangle([start, last, next]);
                }
                last = Some(next);
            }
        }
        self.made = Some((*view, out.positions.len()));
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use silhouette_core::TriangleMesh;
    use silhouette_core::glam::Vec3;
    use silhouette_core::view::Framing;
    use silhouette_testing::{builtin, prepare, strategies, views, zoo};

    fn extracted(mesh: &TriangleMesh, viewpoint: &Viewpoint) -> SilhouetteCurves {
        let mut method: BoundaryCurve = prepare::method(&prepare::prepared(mesh.clone()));
        let mut curves = SilhouetteCurves::default();
        method.extract_curves(viewpoint, &mut curves);
        curves
    }

    #[test]
    fn loops_become_closed_chains_through_their_vertices() {
        for (name, mesh) in zoo::edge_manifold() {
            let topology = Topology::new(&mesh);
            for viewpoint in views::orbit(&mesh, 70.0, 5) {
                let curves = extracted(&mesh, &viewpoint);
                let edges = SilhouetteEdges::of(&topology, &FaceFacings::new(&mesh, &viewpoint));
                assert_eq!(curves.pieces().len(), edges.len(), "{name}");
                assert!(curves.iter().all(|chain| chain.closed), "{name}");
                for piece in curves.pieces() {
                    let CurveSource::Edge(edge) = piece.source else { panic!("pieces replace edges") };
                    let ends = topology.end_points(edge).map(|vertex| mesh.positions()[vertex.index()]);
                    let of_piece = [piece.control[0], piece.control[3]];
                    assert!(of_piece == ends || of_piece == [ends[1], ends[0]], "{name}");
                    assert_eq!(piece.kind == CurveKind::Boundary, topology.half_edges(edge).len() == 1);
                }
            }
        }
    }

    #[test]
    fn in_the_image_tangents_turn_at_corners_alone() {
        let toward = DVec3::new(0.3, 0.2, 0.9).normalize();
        for (name, has_corners) in [("icosphere:3", false), ("cube", true)] {
            let curves = extracted(&builtin(name), &Viewpoint::Orthographic { toward_viewer: toward.as_vec3() });
            let mut corners = 0;
            for chain in curves.iter() {
                let next = chain.pieces.iter().cycle().skip(1);
                for (piece, next) in chain.pieces.iter().zip(next) {
                    let [arriving, leaving] = [piece.derivative(1.0), next.derivative(0.0)]
                        .map(|tangent| (tangent - tangent.dot(toward) * toward).normalize());
                    corners += usize::from(arriving.dot(leaving) < 0.999);
                }
            }
            assert_eq!(corners > 0, has_corners, "{name}: {corners}");
        }
    }

    /// The equator of a sphere, which is seen as it is from above the pole.
    #[test]
    fn vertices_on_a_circle_make_a_circle_and_its_area_is_filled() {
        let mesh = builtin("uv-sphere:12,6");
        let radius = mesh.positions()[0].length();
        let equator = |axis: Vec3| extracted(&mesh, &Viewpoint::Orthographic { toward_viewer: axis });
        let axis = [Vec3::X, Vec3::Y, Vec3::Z].into_iter().find(|axis| equator(*axis).pieces().len() == 12).unwrap();
        for piece in equator(axis).pieces() {
            for step in 0..=10 {
                let point = piece.point(f64::from(step) / 10.0);
                assert!((point.length() - f64::from(radius)).abs() < 1e-5, "{}", point.length());
            }
        }
        let method: BoundaryCurve = prepare::method(&prepare::prepared(mesh.clone()));
        let camera = views::framed(&mesh, axis.as_dvec3(), Framing::Orthographic, [2000; 2]);
        let view = SmoothingView::from_camera(&camera);
        let mut out = ViewMesh::default();
        method.remesher().remesh(&view, &mut out);
        let area = |triangles: &[[u32; 3]]| {
            let double = |corners: &[u32; 3]| {
                let [a, b, c] = corners.map(|corner| out.positions[corner as usize]);
                f64::from((b - a).cross(c - a).dot(axis))
            };
            triangles.iter().map(|corners| 0.5 * double(corners)).collect::<Vec<_>>()
        };
        let added = area(&out.triangles[mesh.face_count()..]);
        assert!(added.len() > 24 && added.iter().all(|area| *area > 0.0), "fans face the viewer");
        let circle = std::f64::consts::PI * f64::from(radius * radius);
        let polygon = 12.0 * 0.5 * (std::f64::consts::TAU / 12.0).sin() * f64::from(radius * radius);
        let missing = circle - polygon - added.iter().sum::<f64>();
        assert!((0.0..0.03 * (circle - polygon)).contains(&missing), "{missing} of {}", circle - polygon);
    }

    #[test]
    fn once_grown_nothing_is_allocated() {
        let mesh = builtin("knot");
        let mut method: BoundaryCurve = prepare::method(&prepare::prepared(mesh.clone()));
        let mut curves = SilhouetteCurves::default();
        views::orbit(&mesh, 3.0, 120).for_each(|view| _ = method.extract_curves(&view, &mut curves));
        let extract = || views::orbit(&mesh, 3.0, 120).for_each(|view| _ = method.extract_curves(&view, &mut curves));
        assert_eq!(allocation_counter::measure(extract).count_total, 0);
    }

    proptest! {
        #[test]
        fn any_mesh_yields_finite_chains(mesh in strategies::soup(30), viewpoint in strategies::viewpoint()) {
            let curves = extracted(&mesh, &viewpoint);
            prop_assert!(curves.pieces().iter().flat_map(|piece| piece.control).all(Vec3::is_finite));
        }
    }

    #[test]
    fn a_turn_is_a_corner_from_its_angle_on() {
        let at = |degrees: f64| DVec3::new(degrees.to_radians().cos(), degrees.to_radians().sin(), 0.0);
        let least = 75.0_f64.to_radians().cos();
        assert!(turn(at(0.0), at(75.1), least).is_none() && turn(at(0.0), at(180.0), least).is_none());
        assert!(turn(at(0.0), at(74.0), least).unwrap().distance(at(37.0)) < 1e-12);
        assert_eq!(turn(DVec3::ZERO, at(3.0), least), None);
    }
}
