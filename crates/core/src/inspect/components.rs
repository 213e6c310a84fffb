//! Components with their Euler characteristic, genus, area and volume.

use super::Sides;
use super::boundary::BoundaryLoop;
use super::defects::Defects;
use super::fans::Fans;
use super::patches::Patches;
use crate::id::FaceId;
use glam::{DVec3, Vec3};

/// A surface: faces connected through shared edges.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Component {
    /// Its lowest face.
    pub first_face: FaceId,
    /// Its vertices. One in which two components touch counts for both.
    pub vertices: usize,
    /// Its edges.
    pub edges: usize,
    /// Its faces.
    pub faces: usize,
    /// Its boundaries.
    pub boundary_loops: usize,
    /// Whether each of its edges has at least two faces.
    pub is_closed: bool,
    /// Whether its faces can be wound consistently.
    pub is_orientable: bool,
    /// Whether it has no non-manifold edge, touches itself in no vertex and has no face that names a vertex twice.
    pub is_manifold: bool,
    /// Vertices - edges + faces.
    pub euler_characteristic: i64,
    /// Number of handles: `1 - (euler_characteristic + boundary_loops) / 2`. `None` unless the component is an orientable
    /// manifold.
    pub genus: Option<u64>,
    /// Total area of its faces, in object units squared.
    pub area: f64,
    /// Enclosed volume in object units cubed, negative if the faces are clockwise from outside (a cavity, or a surface
    /// turned inside out). `None` unless closed, consistently wound and free of non-manifold edges.
    pub volume: Option<f64>,
}

/// Describes each component, in the order of their lowest faces. O(V + E + F), in one thread, so sums have one order.
pub(super) fn describe(
    sides: Sides,
    patches: &Patches,
    fans: &Fans,
    boundary_loops: &[BoundaryLoop],
    defects: &Defects,
) -> Vec<Component> {
    let component_of = |face: FaceId| patches.component_of[face] as usize;
    let mut components: Vec<Component> =
        patches.is_orientable.iter().map(|&is_orientable| empty(is_orientable)).collect();
    add_faces(sides, patches, &mut components);
    for edge in sides.topology.edges().ids().filter(|&edge| !sides.is_collapsed(edge)) {
        components[component_of(sides.topology.half_edges(edge)[0].face())].edges += 1;
    }
    for face in fans.some_face.as_slice().iter().flatten() {
        components[component_of(*face)].vertices += 1;
    }
    for pinch in &fans.pinches {
        // Counted once above, for the component of some face at the vertex: the lowest one's.
        let mut touching: Vec<usize> = pinch.fans.iter().map(|&fan| component_of(fan)).collect();
        let counted = touching[0];
        touching.sort_unstable();
        for group in touching.chunk_by(|one, other| one == other) {
            components[group[0]].is_manifold &= group.len() == 1;
            components[group[0]].vertices += usize::from(group[0] != counted);
        }
    }
    for boundary in boundary_loops {
        let component = &mut components[component_of(boundary.first_half_edge.face())];
        component.boundary_loops += 1;
        component.is_closed = false;
    }
    for defect in &defects.non_manifold_edges {
        let component = &mut components[component_of(defect.faces[0])];
        component.is_manifold = false;
        component.volume = None;
    }
    for &face in &defects.repeated_vertex_faces {
        components[component_of(face)].is_manifold = false;
    }
    for defect in &defects.inconsistent_edges {
        components[component_of(defect.faces[0])].volume = None;
    }
    for component in &mut components {
        component.finish();
    }
    components
}

fn empty(is_orientable: bool) -> Component {
    Component {
        first_face: FaceId::new(u32::MAX),
        vertices: 0,
        edges: 0,
        faces: 0,
        boundary_loops: 0,
        is_closed: true,
        is_orientable,
        is_manifold: true,
        euler_characteristic: 0,
        genus: None,
        area: 0.0,
        volume: Some(0.0),
    }
}

/// Adds faces and areas, and six times the volume: [`Component::finish`] divides once, which keeps small integers exact.
fn add_faces(sides: Sides, patches: &Patches, components: &mut [Component]) {
    // Volumes are summed about a corner of each component, not about the origin, which may be far away.
    let mut origins = vec![DVec3::ZERO; components.len()];
    for (face, &index) in patches.component_of.iter() {
        let (component, origin) = (&mut components[index as usize], &mut origins[index as usize]);
        let [a, b, c] = sides.mesh.corners(face).map(Vec3::as_dvec3);
        if component.faces == 0 {
            component.first_face = face;
            *origin = a;
        }
        let normal = (b - a).cross(c - a);
        component.faces += 1;
        component.area += 0.5 * normal.length();
        component.volume = component.volume.map(|sixfold| sixfold + normal.dot(a - *origin));
    }
}

impl Component {
    fn finish(&mut self) {
        self.euler_characteristic = self.vertices as i64 - self.edges as i64 + self.faces as i64;
        self.volume = self.volume.filter(|_| self.is_closed).map(|sixfold| sixfold / 6.0);
        let handles = 2 - self.euler_characteristic - self.boundary_loops as i64;
        let has_genus = self.is_manifold && self.is_orientable;
        self.genus = u64::try_from(handles).ok().filter(|_| has_genus).map(|handles| handles / 2);
    }
}
