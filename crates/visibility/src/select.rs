//! Step 2: which edges are drawn, and why.
//!
//! A silhouette edge is drawn by where its faces lie in the picture, not by their winding: all on one side of it, so that
//! beyond it the surface ends. For consistently wound faces that is Hall's definition. So a solid wound inward, or in part,
//! has the silhouette that its mended twin has.
//!
//! # Walls seen edge-on
//!
//! The displaced viewer sees a wall that the camera has edge-on either from behind, and its near rim is a silhouette edge, or
//! from the front, as a strip without width, and its near rim is not. In the camera's picture the surface ends there all the
//! same: the floor of a pit has another depth than its rim. So that rim is drawn as well: an edge of which all faces that the
//! camera does not see edge-on lie on one side, while all that it does recede from the viewer.

use crate::chains::SegmentSource;
use crate::contours::{Contour, EDGES_PER_TASK};
use crate::feature_edges::FeatureEdges;
use crate::intersections::{FaceIntersections, Intersection};
use crate::kind::LineKind;
use crate::options::LineOptions;
use crate::scene::LineScene;
use crate::stroke::{Stroke, Strokes};
use crate::surface::Wing;
use crate::viewed_mesh::ViewedMesh;
use rayon::prelude::*;
use silhouette_core::method::PrepareError;
use silhouette_core::orientation::orientation;
use silhouette_core::{
    DisplacedViewer, EdgeId, FaceFacings, FaceId, Facing, HalfEdgeId, Method, NoOptions, Progress, SilhouetteEdges,
    Topology, TriangleMesh,
};
use silhouette_extraction::ClusterCones;
use std::sync::OnceLock;

/// Selects the edges of one view after another; what does not depend on the view is found once for each choice of kinds.
#[derive(Default)]
pub struct Selector {
    facings: FaceFacings,
    silhouette: SilhouetteEdges,
    /// Faces that the filter of facings left to exact arithmetic; those seen edge-on are among them.
    doubtful: Vec<FaceId>,
    features: Option<(LineOptions, FeatureEdges)>,
    /// Finds the silhouette without looking at all faces, where many views are wanted.
    cones: Option<ClusterCones>,
}

impl Selector {
    /// For many views: with a search tree over planes. O(F log F).
    pub fn for_many_views(scene: &LineScene, progress: &dyn Progress) -> Result<Self, PrepareError> {
        let cones = ClusterCones::prepare(scene.mesh(), &NoOptions, progress)?;
        Ok(Self { cones: Some(cones), ..Self::default() })
    }

    /// Finds the edges at which facings differ. O(F), or less with a search tree.
    pub fn find_silhouette(&mut self, mesh: &TriangleMesh, topology: &Topology, viewer: &DisplacedViewer) {
        self.doubtful.clear();
        if let Some(cones) = &mut self.cones {
            cones.extract_edges_by(viewer, &mut self.silhouette);
            self.doubtful.extend(cones.doubtful_faces());
        } else {
            self.facings.classify(mesh, viewer);
            self.silhouette = SilhouetteEdges::of(topology, &self.facings);
            self.doubtful.extend(self.facings.doubtful_faces());
        }
    }

    /// The strokes of the view whose silhouette was last found. `contours` are those of the view, ascending by edge: what is
    /// known of them is not looked up again. O(S); O(E) for a choice of kinds that is new.
    pub fn strokes(
        &mut self,
        scene: &LineScene,
        view: &ViewedMesh<'_>,
        contours: &[Contour],
        options: &LineOptions,
    ) -> Strokes {
        let kept = self.features.take().filter(|(of, _)| of == options);
        let (_, features) = self.features.insert(
            kept.unwrap_or_else(|| (options.clone(), FeatureEdges::new(scene, view.topology, view.unpaired, options))),
        );
        let silhouette =
            if options.silhouette { silhouette_edges(view, &self.silhouette, &self.doubtful) } else { Vec::new() };
        let drawn = drawn_edges(view, &silhouette, features, options);
        mesh_strokes(scene, view, contours, &drawn)
    }

    /// The edges at which facings differ in the view last looked for.
    pub fn silhouette(&self) -> &SilhouetteEdges {
        &self.silhouette
    }
}

/// The silhouette edges that are drawn, of those at which facings differ, the unpaired ones, and those of faces that may be
/// seen edge-on. Ascending. O(S + unpaired edges).
fn silhouette_edges(view: &ViewedMesh<'_>, differing: &SilhouetteEdges, doubtful: &[FaceId]) -> Vec<EdgeId> {
    let mut drawn: Vec<EdgeId> = differing.iter().filter(|&edge| !view.unpaired.contains(edge)).collect();
    let candidates = view.unpaired.as_slice().par_iter().copied().with_min_len(EDGES_PER_TASK);
    let touches_flat = |edge| view.topology.faces(edge).any(|face| view.unpaired.is_flat(face));
    let is_drawn = |&edge: &EdgeId| is_one_sided(view, edge) || touches_flat(edge) && is_rim_of_wall(view, edge);
    drawn.extend(candidates.filter(is_drawn).collect::<Vec<EdgeId>>());
    let edge_on = doubtful.iter().filter(|&&face| view.turn(face).is_tie() && !view.unpaired.is_flat(face));
    for slot_of in edge_on.flat_map(|&face| (0..3).map(move |slot| HalfEdgeId::of(face, slot))) {
        let edge = view.topology.edge_of(slot_of);
        if is_rim_of_wall(view, edge) {
            drawn.push(edge);
        }
    }
    drawn.sort_unstable();
    drawn.dedup();
    drawn
}

/// Whether an edge has two wings or more, all on one side of it.
fn is_one_sided(view: &ViewedMesh<'_>, edge: EdgeId) -> bool {
    let half_edges = view.topology.half_edges(edge);
    let may_have_two = half_edges.len() > 1 || view.unpaired.is_flat(half_edges[0].face());
    may_have_two && {
        let [left, right] = view.wings_beside(edge);
        left.min(right) == 0 && left.max(right) >= 2
    }
}

/// Whether an edge is the near rim of a wall that is seen edge-on. See the [module](self).
fn is_rim_of_wall(view: &ViewedMesh<'_>, edge: EdgeId) -> bool {
    let (_, [a, b]) = view.ends(edge);
    let mut seen: Vec<(Wing, i32)> = Vec::new();
    let mut walls: Vec<Wing> = Vec::new();
    view.for_each_wing(edge, |wing| {
        let turn = view.viewer.turn(a, b, wing.apex);
        if turn.is_tie() { walls.push(wing) } else { seen.push((wing, turn.sign())) }
    });
    // A wall recedes where it lies behind the plane of the face beside it.
    let recedes = |wall: &Wing| {
        let (beside, side) = &seen[0];
        orientation(a, b, beside.apex, wall.apex) * f64::from(*side) < 0.0
    };
    !walls.is_empty()
        && seen.first().is_some_and(|(_, first)| seen.iter().all(|(_, side)| side == first))
        && walls.iter().all(recedes)
}

/// The mesh edges drawn in a view, each once and ascending: sections and silhouette edges before other features.
/// O(S + features).
fn drawn_edges(
    view: &ViewedMesh<'_>,
    silhouette: &[EdgeId],
    features: &FeatureEdges,
    options: &LineOptions,
) -> Vec<(EdgeId, LineKind)> {
    let sections = features.as_slice().iter().copied().filter(|&(_, kind)| kind == LineKind::Section);
    let silhouettes = silhouette.iter().map(|&edge| (edge, LineKind::Silhouette));
    let mut drawn: Vec<(EdgeId, LineKind)> = sections.chain(silhouettes).collect();
    let kind_in_view = |&(edge, kind): &(EdgeId, LineKind)| {
        let is_front = || view.topology.faces(edge).any(|face| view.facing(face) == Facing::Front);
        if kind != LineKind::Boundary || options.back_boundary || is_front() {
            Some((edge, kind))
        } else {
            options.mesh.then_some((edge, LineKind::Mesh))
        }
    };
    drawn.extend(features.as_slice().iter().filter_map(kind_in_view));
    // Stable, so that sections and then the silhouette keep an edge that is a feature as well.
    drawn.sort_by_key(|&(edge, _)| edge);
    drawn.dedup_by_key(|&mut (edge, _)| edge);
    drawn
}

/// Strokes of drawn edges, those of no length left out. O(drawn + contours), parallel.
fn mesh_strokes(
    scene: &LineScene,
    view: &ViewedMesh<'_>,
    contours: &[Contour],
    drawn: &[(EdgeId, LineKind)],
) -> Strokes {
    let mut rest = contours.iter().peekable();
    let known = drawn.iter().map(|&(edge, kind)| {
        while rest.next_if(|contour| contour.edge < edge).is_some() {}
        (edge, kind, rest.peek().filter(|contour| contour.edge == edge).copied())
    });
    let known: Vec<(EdgeId, LineKind, Option<&Contour>)> = known.collect();
    let stroke = |&(edge, kind, contour): &(EdgeId, LineKind, Option<&Contour>)| {
        let (vertices, ends) = contour.map_or_else(|| view.ends(edge), |contour| (contour.vertices, contour.ends));
        // The object of the first face that is no mask.
        let face = view.topology.faces(edge).find(|&face| scene.is_drawn([face]));
        face.filter(|_| ends[0] != ends[1]).map(|face| Stroke {
            ends,
            vertices,
            source: SegmentSource::Edge(edge),
            kind,
            object: scene.object_of(face),
            own: 0..0,
            surface: OnceLock::new(),
        })
    };
    let found: Vec<Option<Stroke>> = known.par_iter().with_min_len(EDGES_PER_TASK).map(stroke).collect();
    let mut strokes = Strokes::default();
    for (stroke, (edge, _)) in found.into_iter().zip(drawn) {
        if let Some(stroke) = stroke {
            strokes.push(stroke, view.topology.faces(*edge));
        }
    }
    strokes
}

/// Appends the lines in which faces intersect; yields a number above those of all ends. O(intersections).
pub fn push_intersections(scene: &LineScene, found: &FaceIntersections, strokes: &mut Strokes) -> u32 {
    let mut first_free = scene.mesh().mesh().vertex_count() as u32;
    for (index, Intersection { ends, faces }) in found.as_slice().iter().enumerate() {
        first_free = first_free.max(ends[0].id + 1).max(ends[1].id + 1);
        if !scene.is_drawn(*faces) {
            continue;
        }
        let stroke = Stroke {
            ends: ends.map(|end| end.place),
            vertices: ends.map(|end| end.id),
            source: SegmentSource::Intersection(index as u32),
            kind: LineKind::Intersection,
            object: scene.object_of(faces[0]),
            own: 0..0,
            surface: OnceLock::new(),
        };
        strokes.push(stroke, *faces);
    }
    first_free
}
