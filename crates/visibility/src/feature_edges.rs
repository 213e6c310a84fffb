//! Edges that are drawn whatever the view: those of sections, boundary edges, creases, borders of labels, or all.

use crate::inward::InwardSolids;
use crate::kind::LineKind;
use crate::options::LineOptions;
use crate::scene::LineScene;
use crate::surface::{Wing, for_each_wing, longest_side};
use crate::unpaired::{UnpairedEdges, runs_forward};
use rayon::prelude::*;
use silhouette_core::glam::DVec3;
use silhouette_core::orientation::orientation;
use silhouette_core::{EdgeId, Topology, TriangleMesh};

/// The edges of a scene that are drawn whatever the view.
#[derive(Debug, Clone, Default)]
pub struct FeatureEdges {
    /// Ascending by edge.
    edges: Vec<(EdgeId, LineKind)>,
}

/// Two wings whose angle is below this lie on each other: a face that is listed twice.
const SAME_WING_RAD: f64 = 1e-6;

impl FeatureEdges {
    /// The feature edges of a scene. O(E), parallel; O(unpaired edges) where boundary edges are all that is asked for.
    pub fn new(scene: &LineScene, topology: &Topology, unpaired: &UnpairedEdges, options: &LineOptions) -> Self {
        let mut section: Vec<EdgeId> = Vec::new();
        if options.section {
            section.extend(scene.section_edges().iter().filter_map(|&[a, b]| topology.find_edge(a, b)));
            section.sort_unstable();
        }
        let looks_at_all = options.mesh
            || options.ridge_deg.is_some()
            || options.valley_deg.is_some()
            || scene.labels().is_some()
            || !section.is_empty();
        let mesh = scene.mesh().mesh();
        let wants_creases = options.ridge_deg.is_some() || options.valley_deg.is_some();
        let inward = wants_creases.then(|| InwardSolids::new(mesh, topology, unpaired));
        let judge = Judge { scene, mesh, topology, unpaired, section, inward, options };
        let kind_of = |edge: EdgeId| judge.kind(edge).map(|kind| (edge, kind));
        let edges = if looks_at_all {
            (0..topology.edge_count()).into_par_iter().map(EdgeId::from_usize).filter_map(kind_of).collect()
        } else {
            unpaired.as_slice().iter().copied().filter_map(kind_of).collect()
        };
        Self { edges }
    }

    /// Ascending by edge, each with the first of its kinds.
    pub fn as_slice(&self) -> &[(EdgeId, LineKind)] {
        &self.edges
    }
}

struct Judge<'a> {
    scene: &'a LineScene,
    mesh: &'a TriangleMesh,
    topology: &'a Topology,
    unpaired: &'a UnpairedEdges,
    /// Edges of sections, ascending.
    section: Vec<EdgeId>,
    /// Where creases are wanted.
    inward: Option<InwardSolids>,
    options: &'a LineOptions,
}

impl Judge<'_> {
    /// The first kind of an edge, if it is drawn whatever the view.
    fn kind(&self, edge: EdgeId) -> Option<LineKind> {
        if self.section.binary_search(&edge).is_ok() {
            return Some(LineKind::Section);
        }
        let other = self.options.mesh.then_some(LineKind::Mesh);
        let half_edges = self.topology.half_edges(edge);
        let is_flat = |face| self.unpaired.is_flat(face);
        let is_longest_of = |face| self.topology.edge_of(longest_side(self.mesh, face)) == edge;
        if half_edges.iter().any(|at| is_flat(at.face()) && is_longest_of(at.face())) {
            // A face without area on it: the other sides of that face cover it.
            return other;
        }
        // One more than the ordinary edge has is room for most.
        let mut wings: Vec<Wing> = Vec::with_capacity(3);
        for_each_wing(self.mesh, self.topology, &is_flat, edge, &mut |wing| wings.push(wing));
        if wings.len() == 1 && self.options.boundary {
            return Some(LineKind::Boundary);
        }
        if wings.len() > 1
            && let Some(kind) = self.crease(edge, &wings)
        {
            return Some(kind);
        }
        let labels_differ =
            |labels: &[u32]| wings.iter().any(|wing| labels[wing.face.index()] != labels[wings[0].face.index()]);
        if self.options.material && self.scene.labels().is_some_and(labels_differ) {
            return Some(LineKind::Material);
        }
        other
    }

    /// Whether an edge of several wings is a crease, and which: one of its wings bends by the threshold from every other.
    ///
    /// By how much two wings bend is the angle by which they differ from one plane, whatever their winding. Where two wings
    /// are wound consistently, winding tells a ridge from a valley; where they are not, or there are more, the edge is both.
    fn crease(&self, edge: EdgeId, wings: &[Wing]) -> Option<LineKind> {
        let thresholds = [self.options.ridge_deg, self.options.valley_deg];
        let least_threshold = thresholds.into_iter().flatten().reduce(f64::min)?;
        let [a, b] = self.topology.edges()[edge].map(|vertex| self.mesh.positions()[vertex as usize]);
        let along = b.as_dvec3() - a.as_dvec3();
        // Perpendicular to the wing: wings of one plane on both sides of the edge have opposite ones.
        let across = |wing: &Wing| along.cross(wing.apex.as_dvec3() - a.as_dvec3());
        let angle = |one: DVec3, other: DVec3| one.cross(other).length().atan2(one.dot(other));
        if let [one, other] = wings
            && angle(across(one), -across(other)).to_degrees() < least_threshold
        {
            // Most edges end here.
            return None;
        }
        let mut distinct: Vec<(DVec3, Vec<&Wing>)> = Vec::with_capacity(wings.len());
        for wing in wings {
            let normal = across(wing);
            match distinct.iter_mut().find(|(other, _)| angle(normal, *other) < SAME_WING_RAD) {
                Some((_, same)) => same.push(wing),
                None => distinct.push((normal, vec![wing])),
            }
        }
        let all_like = |group: &[&Wing]| group.iter().all(|wing| self.is_like(edge, wing, group[0]));
        let least_bend = |index: usize| {
            let bends = distinct.iter().enumerate().filter(|(other, _)| *other != index);
            bends.map(|(_, (normal, _))| angle(distinct[index].0, -*normal)).fold(f64::INFINITY, f64::min)
        };
        let bend = if distinct.len() == 1 {
            // A sheet folded onto itself, unless it is one face listed twice.
            if all_like(&distinct[0].1) { 0.0 } else { std::f64::consts::PI }
        } else {
            (0..distinct.len()).map(least_bend).fold(0.0, f64::max)
        };
        let reaches = |threshold: Option<f64>| threshold.is_some_and(|least| bend.to_degrees() >= least);
        let [is_ridge, is_valley] = match &distinct[..] {
            [(_, one), (_, other)] if all_like(one) && all_like(other) && !self.is_like(edge, one[0], other[0]) => {
                let is_ridge = self.is_ridge(one[0], other[0]);
                [is_ridge, !is_ridge]
            }
            _ => [true, true],
        };
        if is_ridge && reaches(self.options.ridge_deg) {
            Some(LineKind::Ridge)
        } else {
            (is_valley && reaches(self.options.valley_deg)).then_some(LineKind::Valley)
        }
    }

    /// Whether two wings run the same way along the edge: they are not wound consistently, or one face twice.
    fn is_like(&self, edge: EdgeId, one: &Wing, other: &Wing) -> bool {
        // A wing that was found across a face without area lies on another edge.
        let along = |edge: EdgeId| {
            let [from, to] =
                self.topology.edges()[edge].map(|vertex| self.mesh.positions()[vertex as usize].as_dvec3());
            to - from
        };
        let forward = |wing: &Wing| {
            let at = self.topology.edge_of(wing.half_edge);
            let runs_along = at == edge || along(at).dot(along(edge)) > 0.0;
            runs_forward(self.mesh, self.topology, at, wing.half_edge) == runs_along
        };
        forward(one) == forward(other)
    }

    /// Whether the surface of two consistently wound wings is convex: seen from the outer side of one, the other lies below
    /// its plane or in it. The outer side of a solid that is wound inward is the other one.
    fn is_ridge(&self, one: &Wing, other: &Wing) -> bool {
        let [u, v, w] = self.mesh.corners(one.face);
        let is_inward = self.inward.as_ref().is_some_and(|inward| inward.contains(one.face));
        orientation(u, v, w, other.apex) * if is_inward { -1.0 } else { 1.0 } <= 0.0
    }
}
