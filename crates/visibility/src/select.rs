//! Step 2: which edges are drawn, and why.

use crate::chains::SegmentSource;
use crate::contours::{Contour, ContourFinder, EDGES_PER_TASK, UnpairedEdges};
use crate::intersections::{FaceIntersections, Intersection};
use crate::kind::LineKind;
use crate::options::LineOptions;
use crate::scene::LineScene;
use crate::stroke::{Stroke, Strokes};
use rayon::prelude::*;
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::method::{OptionValues, PrepareError};
use silhouette_core::{EdgeId, ExtractsEdges, FaceFacings, Facing, Method, Progress, SilhouetteEdges};
use silhouette_core::{Topology, TriangleMesh, Viewpoint};
use silhouette_extraction::ClusterCones;

/// Edges that are drawn whatever the view: boundary edges, creases, borders of labels, or all.
#[derive(Debug, Clone, Default)]
struct FeatureEdges {
    /// Ascending by edge. Boundary edges, ridges and the rest by the view-independent kinds.
    edges: Vec<(EdgeId, LineKind)>,
}

impl FeatureEdges {
    /// The feature edges of a scene. O(E), parallel; O(unpaired edges) where boundary edges are all that is asked for.
    fn new(scene: &LineScene, topology: &Topology, unpaired: &UnpairedEdges, options: &LineOptions) -> Self {
        let looks_at_all =
            options.mesh || options.ridge_deg.is_some() || options.valley_deg.is_some() || scene.labels().is_some();
        let mesh = scene.mesh().mesh();
        let kind_of = |edge: EdgeId| kind(scene, mesh, topology, options, edge).map(|kind| (edge, kind));
        let edges = if looks_at_all {
            (0..topology.edge_count()).into_par_iter().map(EdgeId::from_usize).filter_map(kind_of).collect()
        } else {
            unpaired.as_slice().iter().copied().filter_map(kind_of).collect()
        };
        Self { edges }
    }
}

fn kind(
    scene: &LineScene,
    mesh: &TriangleMesh,
    topology: &Topology,
    options: &LineOptions,
    edge: EdgeId,
) -> Option<LineKind> {
    let half_edges = topology.half_edges(edge);
    let other = options.mesh.then_some(LineKind::Mesh);
    let [one, another] = half_edges else {
        return if half_edges.len() == 1 && options.boundary { Some(LineKind::Boundary) } else { other };
    };
    let faces = [one.face(), another.face()];
    let wanted = [(LineKind::Ridge, options.ridge_deg), (LineKind::Valley, options.valley_deg)];
    if wanted.iter().any(|(_, threshold)| threshold.is_some()) {
        let [normal, across] = faces.map(|face| {
            let [a, b, c] = mesh.corners(face).map(Vec3::as_dvec3);
            (b - a).cross(c - a)
        });
        let bend_deg = normal.cross(across).length().atan2(normal.dot(across)).to_degrees();
        // Concave where the neighbour's third corner rises above the face.
        let [a, ..] = mesh.corners(faces[0]).map(Vec3::as_dvec3);
        let apex = mesh.corners(faces[1])[(another.slot() as usize + 2) % 3].as_dvec3();
        let is_ridge = normal.dot(apex - a) <= 0.0;
        let threshold = if is_ridge { options.ridge_deg } else { options.valley_deg };
        if normal != DVec3::ZERO && across != DVec3::ZERO && threshold.is_some_and(|least| bend_deg >= least) {
            return Some(if is_ridge { LineKind::Ridge } else { LineKind::Valley });
        }
    }
    let labels_differ = |labels: &[u32]| labels[faces[0].index()] != labels[faces[1].index()];
    if options.material && scene.labels().is_some_and(labels_differ) { Some(LineKind::Material) } else { other }
}

/// Selects the edges of one view after another; what does not depend on the view is found once for each choice of kinds.
#[derive(Default)]
pub struct Selector {
    facings: FaceFacings,
    silhouette: SilhouetteEdges,
    features: Option<(LineOptions, FeatureEdges)>,
    /// Finds the silhouette without looking at all faces, where many views are wanted.
    cones: Option<ClusterCones>,
}

impl Selector {
    /// For many views: with a search tree over planes. O(F log F).
    pub fn for_many_views(scene: &LineScene, progress: &dyn Progress) -> Result<Self, PrepareError> {
        let options = OptionValues::defaults(ClusterCones::INFO.options);
        let cones = ClusterCones::prepare(scene.mesh(), &options, progress)?;
        Ok(Self { cones: Some(cones), ..Self::default() })
    }

    /// Finds the silhouette of a view. O(F), or less with a search tree.
    pub fn find_silhouette(&mut self, mesh: &TriangleMesh, topology: &Topology, viewpoint: &Viewpoint) {
        if let Some(cones) = &mut self.cones {
            cones.extract_edges(viewpoint, &mut self.silhouette);
        } else {
            self.facings.classify(mesh, viewpoint);
            self.silhouette = SilhouetteEdges::of(topology, &self.facings);
        }
    }

    /// The strokes of the view whose silhouette was last found. `contours` are those of the view, ascending by edge: what is
    /// known of them is not looked up again. O(S); O(E) for a choice of kinds that is new.
    pub fn strokes(
        &mut self,
        scene: &LineScene,
        finder: &ContourFinder<'_>,
        contours: &[Contour],
        options: &LineOptions,
    ) -> Strokes {
        let kept = self.features.take().filter(|(of, _)| of == options);
        let (_, features) =
            self.features.insert(kept.unwrap_or_else(|| {
                (options.clone(), FeatureEdges::new(scene, finder.topology, finder.unpaired, options))
            }));
        let drawn = drawn_edges(finder, &self.silhouette, features, options);
        mesh_strokes(scene, finder, contours, &drawn)
    }

    /// All silhouette edges of the view last looked for.
    pub fn silhouette(&self) -> &SilhouetteEdges {
        &self.silhouette
    }
}

/// The mesh edges drawn in a view, each once and ascending: silhouette edges before features. O(S + features).
fn drawn_edges(
    finder: &ContourFinder<'_>,
    silhouette: &SilhouetteEdges,
    features: &FeatureEdges,
    options: &LineOptions,
) -> Vec<(EdgeId, LineKind)> {
    let is_interior = |edge: &EdgeId| finder.topology.half_edges(*edge).len() > 1;
    let silhouette = silhouette.iter().filter(|edge| options.silhouette && is_interior(edge));
    let mut drawn: Vec<(EdgeId, LineKind)> = silhouette.map(|edge| (edge, LineKind::Silhouette)).collect();
    let is_wanted = |&&(edge, kind): &&(EdgeId, LineKind)| {
        let bounds_front_face = || finder.topology.faces(edge).any(|face| finder.facing(face) == Facing::Front);
        options.back_boundary || kind != LineKind::Boundary || bounds_front_face()
    };
    drawn.extend(features.edges.iter().filter(is_wanted));
    // Stable, so that the silhouette keeps an edge that is a feature as well.
    drawn.sort_by_key(|&(edge, _)| edge);
    drawn.dedup_by_key(|&mut (edge, _)| edge);
    drawn
}

/// Strokes of drawn edges, those of no length left out. O(drawn + contours), parallel.
fn mesh_strokes(
    scene: &LineScene,
    finder: &ContourFinder<'_>,
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
        let (vertices, ends) = contour.map_or_else(|| finder.ends(edge), |contour| (contour.vertices, contour.ends));
        let first_face = finder.topology.half_edges(edge)[0].face();
        (ends[0] != ends[1]).then(|| Stroke {
            ends,
            vertices,
            source: SegmentSource::Edge(edge),
            kind,
            object: scene.object_of(first_face),
            side: contour.map_or_else(|| finder.surface_side(edge), Contour::surface_side),
            own: 0..0,
        })
    };
    let found: Vec<Option<Stroke>> = known.par_iter().with_min_len(EDGES_PER_TASK).map(stroke).collect();
    let mut strokes = Strokes::default();
    for (stroke, (edge, _)) in found.into_iter().zip(drawn) {
        if let Some(stroke) = stroke {
            strokes.push(stroke, finder.topology.faces(*edge));
        }
    }
    strokes
}

/// Appends the lines in which faces intersect; yields a number above those of all ends. O(intersections).
pub fn push_intersections(scene: &LineScene, found: &FaceIntersections, strokes: &mut Strokes) -> u32 {
    let mut first_free = scene.mesh().mesh().vertex_count() as u32;
    for (index, Intersection { ends, faces }) in found.as_slice().iter().enumerate() {
        first_free = first_free.max(ends[0].id + 1).max(ends[1].id + 1);
        let stroke = Stroke {
            ends: ends.map(|end| end.place),
            vertices: ends.map(|end| end.id),
            source: SegmentSource::Intersection(index as u32),
            kind: LineKind::Intersection,
            object: scene.object_of(faces[0]),
            side: 1,
            own: 0..0,
        };
        strokes.push(stroke, *faces);
    }
    first_free
}
