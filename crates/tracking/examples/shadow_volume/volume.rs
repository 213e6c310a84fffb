//! [`ShadowVolume`]: silhouette loops extruded away from a light, with caps at both ends, ready for the z-fail test.
//!
//! F. C. Crow, "Shadow Algorithms for Computer Graphics", SIGGRAPH 1977; for open meshes P. Bergeron, "A General
//! Version of Crow's Shadow Volumes", IEEE CG&A 6(9), 1986; for points at infinity and z-fail C. Everitt and M. J.
//! Kilgard, "Practical and Robust Stenciled Shadow Volumes for Hardware-Accelerated Rendering", 2002.
//!
//! # What is built, and why it is closed
//!
//! A face that casts a shadow has a prism: the face, wound so that it faces the light; its copy at the far end, wound
//! the other way; three sides between. Each prism is closed and its surface oriented outward. The volume is their sum,
//! in which a side between two neighbours occurs once in each direction and is left out. What remains is a side for
//! each silhouette half-edge, from the boundary of the casting faces; so the volume is closed for every mesh, and how
//! often its surface goes around a point is the number of casting faces between the point and the light. [`Caps`] says
//! which faces cast. Closed means: of each directed edge there are as many as of its opposite. Most have one; where
//! loops touch in a vertex, the edge from there to the far end has several.
//!
//! # To draw it
//!
//! Wind back faces into the stencil with increment-wrap where the depth test fails, front faces with decrement-wrap;
//! what is not zero lies in shadow. Nothing may be clipped at the far plane: with [`Reach::Infinite`] use an infinite
//! projection, under which `w = 0` lands on the far plane, or depth clamping. A stencil of `n` bits misreads `2^n`
//! layers as none.

use crate::facings::FollowedFacings;
use silhouette_core::facing::Facing;
use silhouette_core::glam::{DVec3, Vec3, Vec4};
use silhouette_core::{HalfEdgeId, SilhouetteLoops, TriangleMesh, Viewpoint};
use silhouette_tracking::ConnectivityTable;
use std::sync::Arc;

/// Which faces cast a shadow, and what closes the volume at its ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Caps {
    /// Faces that face the light cast. Front cap: these faces. Back cap: the *other* faces, extruded; that is the sum
    /// of prisms plus a far copy of the whole mesh, which is closed and far away. F triangles in both caps. For closed
    /// meshes with the light outside: then every shadow has a casting face.
    FrontAndBack,
    /// Faces that face the light cast. Front cap: these faces. Back cap: the same, extruded and reversed. For any mesh;
    /// as with culled back faces, one that turns its back to the light lets it through. On a closed mesh with the light
    /// outside that changes nothing, and the caps are smaller where fewer faces are front than back.
    FrontTwice,
    /// Every face casts, as if each had a reversed double: of the two, the one that faces the light. Front cap: the
    /// front faces, and the back faces reversed. Back cap: both extruded, reversed. A silhouette half-edge with a face
    /// across has two sides, one from each; one at the boundary a single side, and so has each boundary edge of a back
    /// face, which is in no loop. 2 F triangles in both caps. For any mesh and any light, also inside a closed mesh.
    Doubled,
}

impl Caps {
    /// What fits a mesh if nothing is known but its table: doubled faces where there is any boundary edge. A mesh that is
    /// cut has boundary edges at the cuts, whatever it was before: faces on both sides may cast from there, so the same
    /// rule holds.
    pub fn fitting(table: &ConnectivityTable, mesh: &TriangleMesh) -> Self {
        if boundary(table, mesh).next().is_none() { Self::FrontAndBack } else { Self::Doubled }
    }
}

/// How far the volume reaches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Reach {
    /// To infinity, in homogeneous coordinates with `w = 0`. Under a directional light all far vertices are one point,
    /// the direction itself; each side is a triangle and there is no back cap.
    Infinite,
    /// Every vertex moves by `distance` (object units, above 0) along the light's direction, or by at least that away
    /// from a point light. There the far end is the mesh scaled about the light, by `1 + distance / nearest vertex`, so
    /// that no face bends; a point of a large face, nearer to the light than any vertex, moves less in proportion.
    Finite {
        /// How far the vertices move at least.
        distance: f32,
    },
}

/// Largest scale about a point light. A light in a vertex would have none; 2^20 keeps coordinates finite for meshes up
/// to 10^32 units and is beyond any scene.
const MAX_SCALE: f64 = 1_048_576.0;

/// Why a mesh has no volume.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum VolumeError {
    /// [`Caps::FrontAndBack`] on a mesh with boundary edges.
    #[error(
        "{boundary_edges} half-edges have nothing across; front and back faces close the volume of closed meshes only"
    )]
    NotClosed {
        /// How many, cut ones included.
        boundary_edges: usize,
    },
    /// Near and far vertices together are more than 32-bit indices can name.
    #[error("{vertices} vertices cannot be doubled; at most {} can", u32::MAX / 2)]
    TooLarge {
        /// How many the mesh has.
        vertices: usize,
    },
}

/// The shadow volume of a mesh; keeps its memory from frame to frame.
#[derive(Debug, Clone)]
pub struct ShadowVolume {
    mesh: Arc<TriangleMesh>,
    table: Arc<ConnectivityTable>,
    caps: Caps,
    reach: Reach,
    /// Half-edges that have nothing across.
    boundary: Vec<HalfEdgeId>,
    facings: FollowedFacings,
    positions: Vec<Vec4>,
    triangles: Vec<[u32; 3]>,
    /// Where the sides begin in `triangles`, and the back cap.
    ends: [usize; 2],
    /// Whether all far vertices are one.
    has_apex: bool,
}

impl ShadowVolume {
    /// An empty volume for a mesh that `table` is of. O(F).
    ///
    /// # Errors
    /// [`VolumeError`] if the mesh has boundary edges that `caps` does not allow, or too many vertices.
    ///
    /// # Panics
    /// If the table is of another mesh.
    pub fn new(
        mesh: Arc<TriangleMesh>,
        table: Arc<ConnectivityTable>,
        caps: Caps,
        reach: Reach,
    ) -> Result<Self, VolumeError> {
        assert_eq!(table.face_count(), mesh.face_count(), "table of another mesh");
        let vertices = mesh.vertex_count();
        if vertices > (u32::MAX / 2) as usize {
            return Err(VolumeError::TooLarge { vertices });
        }
        let boundary: Vec<_> = boundary(&table, &mesh).collect();
        if caps == Caps::FrontAndBack && !boundary.is_empty() {
            return Err(VolumeError::NotClosed { boundary_edges: boundary.len() });
        }
        let mut positions = Vec::with_capacity(2 * vertices);
        positions.extend(mesh.positions().iter().map(|position| position.extend(1.0)));
        let (facings, triangles) = (FollowedFacings::default(), Vec::new());
        Ok(Self { mesh, table, caps, reach, boundary, facings, positions, triangles, ends: [0; 2], has_apex: false })
    }

    /// Replaces the volume by that of `light`, of which `loops` are all the silhouette loops: half-edges of front
    /// faces, in any order.
    ///
    /// The light is the viewpoint that sees what it lights: a perspective eye is a point light, an orthographic
    /// `toward_viewer` points to a directional one. If a loop is missing the volume may be open there. A light in the
    /// plane of a face is behind it (facing is exact, and ties are back); one in a vertex leaves that vertex no way to
    /// go.
    ///
    /// O(V + F) to write far vertices and caps, O(S) for the sides; facing is evaluated between the old loops and the
    /// new ones only ([`facings`](crate::facings)). One thread. Allocates nothing once memory has grown.
    ///
    /// # Panics
    /// If a half-edge is of another mesh.
    pub fn extrude(&mut self, light: &Viewpoint, loops: &SilhouetteLoops) {
        self.place_far_vertices(light);
        self.facings.follow(&self.mesh, &self.table, light, loops);
        self.triangles.clear();
        self.push_front_cap();
        self.ends[0] = self.triangles.len();
        self.push_sides(loops);
        self.ends[1] = self.triangles.len();
        // At a single point at infinity a cap would be nothing but faces without area.
        if !self.has_apex {
            self.push_back_cap();
        }
    }

    fn place_far_vertices(&mut self, light: &Viewpoint) {
        let near = self.mesh.positions();
        self.positions.truncate(near.len());
        self.has_apex = false;
        match (*light, self.reach) {
            (Viewpoint::Perspective { eye }, Reach::Infinite) => {
                self.positions.extend(near.iter().map(|&position| (position - eye).extend(0.0)));
            }
            (Viewpoint::Perspective { eye }, Reach::Finite { distance }) => {
                let eye = eye.as_dvec3();
                let from_light = |position: &Vec3| position.as_dvec3() - eye;
                let nearest = near.iter().map(|position| from_light(position).length()).fold(f64::INFINITY, f64::min);
                let scale = (1.0 + f64::from(distance) / nearest).min(MAX_SCALE);
                let far = |position: &Vec3| (eye + from_light(position) * scale).as_vec3().extend(1.0);
                self.positions.extend(near.iter().map(far));
            }
            (Viewpoint::Orthographic { toward_viewer }, Reach::Infinite) => {
                self.positions.push((-toward_viewer).extend(0.0));
                self.has_apex = true;
            }
            (Viewpoint::Orthographic { toward_viewer }, Reach::Finite { distance }) => {
                let step: DVec3 = -toward_viewer.as_dvec3().normalize_or_zero() * f64::from(distance);
                self.positions.extend(near.iter().map(|p| (p.as_dvec3() + step).as_vec3().extend(1.0)));
            }
        }
    }

    fn push_front_cap(&mut self) {
        let faces = self.mesh.triangles().iter().zip(self.facings.as_slice());
        let doubled = self.caps == Caps::Doubled;
        self.triangles.extend(faces.filter_map(|(&[a, b, c], facing)| match facing {
            Facing::Front => Some([a, b, c]),
            Facing::Back => doubled.then_some([c, b, a]),
        }));
    }

    fn push_sides(&mut self, loops: &SilhouetteLoops) {
        for &half_edge in loops.half_edges() {
            let [a, b] = ends(&self.mesh, half_edge);
            self.push_side(a, b);
            // The face across is a back face; its double runs along the edge in the same direction.
            if self.caps == Caps::Doubled && self.table.twin(half_edge).is_some() {
                self.push_side(a, b);
            }
        }
        if self.caps == Caps::Doubled {
            for index in 0..self.boundary.len() {
                let half_edge = self.boundary[index];
                if self.facings.as_slice()[half_edge.face().index()] == Facing::Back {
                    let [a, b] = ends(&self.mesh, half_edge);
                    self.push_side(b, a);
                }
            }
        }
    }

    /// The side below an edge of the front cap that runs from `a` to `b`.
    fn push_side(&mut self, a: u32, b: u32) {
        let [far_a, far_b] = [a, b].map(|vertex| self.far(vertex));
        self.triangles.push([b, a, far_a]);
        if !self.has_apex {
            self.triangles.push([b, far_a, far_b]);
        }
    }

    fn push_back_cap(&mut self) {
        let near = self.mesh.vertex_count() as u32;
        let far = |triangle: [u32; 3]| triangle.map(|vertex| near + vertex);
        if self.caps == Caps::FrontAndBack {
            let faces = self.mesh.triangles().iter().zip(self.facings.as_slice());
            let back = faces.filter(|&(_, &facing)| facing == Facing::Back);
            self.triangles.extend(back.map(|(&triangle, _)| far(triangle)));
        } else {
            for index in 0..self.ends[0] {
                let [a, b, c] = far(self.triangles[index]);
                self.triangles.push([c, b, a]);
            }
        }
    }

    /// The far end of a vertex.
    fn far(&self, vertex: u32) -> u32 {
        let near = self.mesh.vertex_count() as u32;
        if self.has_apex { near } else { near + vertex }
    }

    /// Homogeneous positions in object space: first the vertices of the mesh, which never change, then the far ends: as
    /// many in the same order, or a single one under [`Reach::Infinite`] and a directional light.
    pub fn positions(&self) -> &[Vec4] {
        &self.positions
    }

    /// All triangles, counter-clockwise seen from outside the volume: front cap, sides, back cap.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The end that faces the light.
    pub fn front_cap(&self) -> &[[u32; 3]] {
        &self.triangles[..self.ends[0]]
    }

    /// What lies between the caps: all that the z-pass test needs. Two triangles a side, one where far ends are one
    /// point.
    pub fn sides(&self) -> &[[u32; 3]] {
        &self.triangles[self.ends[0]..self.ends[1]]
    }

    /// The far end.
    pub fn back_cap(&self) -> &[[u32; 3]] {
        &self.triangles[self.ends[1]..]
    }
}

/// The vertices that a half-edge leaves and reaches.
fn ends(mesh: &TriangleMesh, half_edge: HalfEdgeId) -> [u32; 2] {
    let triangle = mesh.triangles()[half_edge.face().index()];
    [half_edge, half_edge.next_in_face()].map(|corner| triangle[corner.slot() as usize])
}

/// Half-edges that have nothing across, but for sides from a vertex to itself, which bound nothing.
fn boundary<'a>(table: &'a ConnectivityTable, mesh: &'a TriangleMesh) -> impl Iterator<Item = HalfEdgeId> + 'a {
    (0..3 * mesh.face_count()).map(HalfEdgeId::from_usize).filter(|&half_edge| {
        let [a, b] = ends(mesh, half_edge);
        a != b && table.twin(half_edge).is_none()
    })
}
