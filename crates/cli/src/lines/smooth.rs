//! `lines --smooth`: each mesh is re-meshed for the view around its smooth silhouette, and the smooth curves take the place of
//! silhouette, boundary and crease edges.
//!
//! Hidden lines are removed by the re-meshed surface. Around a saddle its flat triangles reach a little beyond the curve in the
//! picture, and would hide it there. Whether a contour is hidden by the surface close to it does not depend on triangles,
//! however, but on the sign of the radial curvature (Koenderink, "What does the occluding contour tell us about solid shape?",
//! Perception 13, 1984): where it is positive, the visible side of the contour lies nearer to the viewer, and the surface
//! around it does not hide it; where it is negative, the surface itself does. So a piece of silhouette through a face is either
//! not hidden by the faces that have a vertex in common with that face, or is no visible line.

use crate::failure::Failure;
use glam::{DVec3, Vec3};
use silhouette_core::curves::{CurveKind, CurveSource, SmoothPiece};
use silhouette_core::id::HalfEdgeId;
use silhouette_core::load::LabelledMesh;
use silhouette_core::weld::{Welded, weld_exact};
use silhouette_core::{
    Camera, EdgeId, ExtractsCurves, FaceId, Method, PreparedMesh, Progress, SilhouetteCurves, Topology, TriangleMesh,
    VertexId,
};
use silhouette_smoothing::{Eye, Remesher, Smoothing, SmoothingOptions, SmoothingView, ViewMesh};
use silhouette_visibility::{CurvePiece, LineKind, LineOptions, LineScene, VertexFaces};
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// How far the re-meshed surface may stray from a curve, in pixels: as far as the chords by which visibility is decided.
const TOLERANCE_PX: f64 = 0.05;

/// The scene of a view, and what of it is wanted: curves instead of edges. `wanted` says which kinds of line are.
pub fn scene(
    meshes: &[(String, LabelledMesh)],
    camera: &Camera,
    wanted: &LineOptions,
    progress: &dyn Progress,
) -> Result<(LineScene, LineOptions), Failure> {
    let mut surfaces = Vec::new();
    let mut curves: Vec<CurvePiece> = Vec::new();
    let mut first_face = 0;
    for (object, (name, loaded)) in meshes.iter().enumerate() {
        let view = SmoothView::new(name, loaded, camera, wanted, progress)?;
        for piece in view.wanted_pieces(wanted) {
            let visibility = view.local_visibility(&piece.curve);
            if visibility == LocalVisibility::Hidden && wanted.max_invisibility == 0 {
                continue;
            }
            let on_faces = view.faces_that_do_not_hide(&piece.curve, visibility);
            curves.push(CurvePiece {
                control: piece.curve.control,
                on_faces: on_faces.iter().map(|face| FaceId::from_usize(first_face + face.index())).collect(),
                kind: piece.kind,
                object: object as u32,
            });
        }
        first_face += view.surface.mesh.face_count();
        surfaces.push(view.surface.mesh);
    }
    let scene = LineScene::of_meshes(&surfaces.iter().collect::<Vec<_>>()).map_err(Failure::input)?;
    let scene = scene.with_curves(curves).map_err(Failure::input)?;
    let options = LineOptions {
        silhouette: false,
        boundary: false,
        ridge_deg: None,
        valley_deg: None,
        material: false,
        ..wanted.clone()
    };
    Ok((scene, options))
}

/// A curve with the kind of line that it is drawn as.
struct WantedPiece {
    curve: SmoothPiece,
    kind: LineKind,
}

/// What the surface close to a piece of curve does to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum LocalVisibility {
    /// It does not hide it.
    Visible,
    /// It hides it.
    Hidden,
    /// A sharp edge: what its faces do is seen from them.
    Sharp,
}

/// One mesh, smoothed for the view.
struct SmoothView {
    eye: Eye,
    /// The faces at each vertex of the mesh.
    faces: VertexFaces,
    smoothing: Smoothing,
    curves: SilhouetteCurves,
    surface: Welded,
    /// The triangles at each vertex of the surface.
    around: VertexFaces,
    /// Vertices of the surface strictly inside of each face and edge of the mesh.
    inside: HashMap<CurveSource, Vec<u32>>,
    /// Vertices of the surface by their places.
    at: HashMap<[u32; 3], u32>,
}

impl SmoothView {
    fn new(
        name: &str,
        loaded: &LabelledMesh,
        camera: &Camera,
        wanted: &LineOptions,
        progress: &dyn Progress,
    ) -> Result<Self, Failure> {
        let feature_edges = loaded.feature_edges.iter().map(|edge| edge.map(VertexId::new)).collect();
        let mesh = Arc::new(PreparedMesh::new(loaded.mesh.clone()).with_feature_edges(feature_edges));
        let defaults = SmoothingOptions::default();
        // What is to be drawn as a crease must not be smoothed away.
        let creases = wanted.ridge_deg.into_iter().chain(wanted.valley_deg);
        let crease_deg = creases.fold(defaults.crease_deg, f64::min);
        let options = SmoothingOptions { tolerance_px: TOLERANCE_PX, crease_deg, ..defaults };
        let failed = |error| Failure::of_preparation(name, Smoothing::INFO.name, error);
        let mut smoothing = Smoothing::prepare(&mesh, &options, progress).map_err(failed)?;
        let (mut view_mesh, mut curves) = (ViewMesh::default(), SilhouetteCurves::default());
        smoothing.remesh(&SmoothingView::from_camera(camera), &mut view_mesh);
        smoothing.extract_curves(&camera.viewpoint(), &mut curves);
        let unwelded = TriangleMesh::new(view_mesh.positions.clone(), view_mesh.triangles.clone());
        let surface = weld_exact(&unwelded.map_err(Failure::input)?.with_origin(loaded.mesh.origin()));

        let mut inside: HashMap<CurveSource, Vec<u32>> = HashMap::new();
        for (origin, &vertex) in view_mesh.origins.iter().zip(&surface.vertex_of) {
            let zeros: Vec<usize> = (0..3).filter(|&slot| origin.weights[slot] == 0.0).collect();
            let source = match zeros[..] {
                [] => CurveSource::Face(origin.face),
                [opposite] => {
                    CurveSource::Edge(edge_opposite(smoothing.shading_mesh().topology(), origin.face, opposite))
                }
                _ => continue,
            };
            inside.entry(source).or_default().push(vertex);
        }
        let places = surface.mesh.positions().iter().zip(0..);
        let at = places.map(|(&position, vertex)| (place(position), vertex)).collect();
        let faces = VertexFaces::new(&loaded.mesh);
        let around = VertexFaces::new(&surface.mesh);
        Ok(Self { eye: Eye::from(camera.viewpoint()), faces, smoothing, curves, around, surface, inside, at })
    }

    /// The curves that are drawn in place of edges.
    ///
    /// Extracted curves are those that show something: what a view sees of no front face is drawn too, as the surface has
    /// it, since boundaries of sheets seen from behind are visible and creases may be wanted hidden.
    fn wanted_pieces(&self, wanted: &LineOptions) -> Vec<WantedPiece> {
        let mut pieces = Vec::new();
        let mut is_drawn: HashSet<EdgeId> = HashSet::new();
        for &curve in self.curves.pieces() {
            if let CurveSource::Edge(edge) = curve.source {
                is_drawn.insert(edge);
            }
            let kind = match (curve.kind, curve.source) {
                (CurveKind::Silhouette, _) => wanted.silhouette.then_some(LineKind::Silhouette),
                // Whole, below.
                (CurveKind::Boundary, _) | (CurveKind::Crease, CurveSource::Face(_)) => None,
                (CurveKind::Crease, CurveSource::Edge(edge)) => self.crease(edge, wanted),
            };
            pieces.extend(kind.map(|kind| WantedPiece { curve, kind }));
        }
        let (mesh, features) = (self.smoothing.shading_mesh(), self.smoothing.features());
        for (&edge, segment) in features.edges().iter().zip(features.segments()) {
            let is_boundary = mesh.topology().half_edges(edge).len() == 1;
            let kind = if is_boundary {
                wanted.boundary.then_some(LineKind::Boundary)
            } else {
                self.crease(edge, wanted).filter(|_| !is_drawn.contains(&edge))
            };
            let Some(kind) = kind else { continue };
            let (source, curve_kind) =
                (CurveSource::Edge(edge), if is_boundary { CurveKind::Boundary } else { CurveKind::Crease });
            if is_drawn.contains(&edge) {
                let whole = segment.curves().map(|curve| curve.piece(curve_kind, source));
                pieces.extend(whole.map(|curve| WantedPiece { curve, kind }));
            } else {
                let [from, to] = mesh.topology().end_points(edge).map(|vertex| mesh.mesh().positions()[vertex.index()]);
                pieces.push(WantedPiece { curve: SmoothPiece::line(from, to, curve_kind, source), kind });
            }
        }
        pieces
    }

    /// As what a feature edge is drawn that is no silhouette.
    fn crease(&self, edge: EdgeId, wanted: &LineOptions) -> Option<LineKind> {
        let mesh = self.smoothing.shading_mesh();
        let &[one, other, ..] = mesh.topology().half_edges(edge) else { return None };
        let corners = |half_edge: HalfEdgeId| {
            let slot = half_edge.slot() as usize;
            let corners = mesh.mesh().corners(half_edge.face()).map(Vec3::as_dvec3);
            [corners[slot], corners[(slot + 1) % 3], corners[(slot + 2) % 3]]
        };
        let normal = |[a, b, c]: [DVec3; 3]| (b - a).cross(c - a);
        let [one, other] = [one, other].map(corners);
        let bend = normal(one).angle_between(normal(other)).to_degrees();
        let is_ridge = (other[2] - one[0]).dot(normal(one)) <= 0.0;
        let (kind, least) =
            if is_ridge { (LineKind::Ridge, wanted.ridge_deg) } else { (LineKind::Valley, wanted.valley_deg) };
        least.is_some_and(|least| bend >= least).then_some(kind)
    }

    /// What the surface close to a piece does to it. Curves have their visible side on the left, seen from outside.
    fn local_visibility(&self, curve: &SmoothPiece) -> LocalVisibility {
        let CurveSource::Face(face) = curve.source else { return LocalVisibility::Sharp };
        let mesh = self.smoothing.shading_mesh();
        let [a, b, c] = mesh.triangles()[face.index()].map(|vertex| mesh.positions()[vertex as usize].as_dvec3());
        let [from, to] = [curve.control[0], curve.control[3]].map(Vec3::as_dvec3);
        let visible_side = (b - a).cross(c - a).cross(to - from);
        let is_nearer = visible_side.dot(self.eye.toward(0.5 * (from + to))) >= 0.0;
        if is_nearer { LocalVisibility::Visible } else { LocalVisibility::Hidden }
    }

    /// Triangles of the surface that do not hide a curve, ascending: those along it, and where the surface does not hide it
    /// locally also those around its samples and in the faces around its own.
    fn faces_that_do_not_hide(&self, curve: &SmoothPiece, visibility: LocalVisibility) -> Vec<FaceId> {
        let inside = |source: CurveSource| self.inside.get(&source).into_iter().flatten().copied();
        let at = |position: &Vec3| self.at.get(&place(*position)).copied();
        let mut samples: Vec<u32> = [curve.control[0], curve.control[3]].iter().filter_map(at).collect();
        samples.extend(inside(curve.source));
        let least_in_common = match (curve.source, visibility) {
            (_, LocalVisibility::Hidden) => return Vec::new(),
            (CurveSource::Face(face), LocalVisibility::Visible) => {
                let mesh = self.smoothing.shading_mesh();
                samples.extend(mesh.mesh().corners(face).iter().filter_map(at));
                let corners = mesh.mesh().triangles()[face.index()];
                for around in corners.iter().flat_map(|&corner| self.faces.of(corner)) {
                    samples.extend(inside(CurveSource::Face(around.face)));
                    let edges = (0..3).map(|slot| mesh.topology().edge_of(HalfEdgeId::of(around.face, slot)));
                    samples.extend(edges.flat_map(|edge| inside(CurveSource::Edge(edge))));
                }
                1
            }
            // Other faces around an end of a sharp edge may well hide it.
            _ => 2,
        };
        samples.sort_unstable();
        samples.dedup();
        let mut faces: Vec<FaceId> =
            samples.iter().flat_map(|&vertex| self.around.of(vertex)).map(|around| around.face).collect();
        faces.sort_unstable();
        faces.chunk_by(PartialEq::eq).filter(|same| same.len() >= least_in_common).map(|same| same[0]).collect()
    }
}

/// The edge of a face that does not have the corner of a slot.
fn edge_opposite(topology: &Topology, face: FaceId, slot: usize) -> EdgeId {
    topology.edge_of(HalfEdgeId::of(face, (slot as u32 + 1) % 3))
}

/// The name of a place; both zeros have one.
fn place(position: Vec3) -> [u32; 3] {
    (position + Vec3::ZERO).to_array().map(f32::to_bits)
}
