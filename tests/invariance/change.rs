//! Changes of a mesh and of its views that change nothing but numbers.

use glam::Vec3;
use silhouette_core::{Camera, Projection, TriangleMesh, Viewpoint};
use silhouette_testing::Random;
use silhouette_testing::edits::{inside_out, mapped, permuted};

/// A changed mesh, and how what belongs to it changes.
pub struct Change {
    pub name: &'static str,
    pub mesh: TriangleMesh,
    /// Where points go.
    place: fn(Vec3) -> Vec3,
    /// The factor by which lengths grow.
    pub scale: f32,
    pub is_mirrored: bool,
    /// The original number of each vertex; empty where it has not changed.
    original: Vec<u32>,
}

/// Far from the origin, where coordinates on the grid are as exact.
const OFFSET: Vec3 = Vec3::new(100.0, -300.0, 57.0);

/// The next point whose coordinates are multiples of `2^-12`.
pub fn on_grid(p: Vec3) -> Vec3 {
    (p * 4096.0).round() / 4096.0
}

/// Every change of a mesh on the grid.
pub fn changes(mesh: &TriangleMesh) -> impl Iterator<Item = Change> {
    let (shuffled, order) = permuted(mesh, &mut Random::new(9));
    let mut original = vec![0; order.len()];
    (0..).zip(&order).for_each(|(from, &to)| original[to as usize] = from);
    let placed =
        |name, place: fn(Vec3) -> Vec3, scale| Change { name, scale, place, ..Change::of(&mapped(mesh, place)) };
    let mirror: fn(Vec3) -> Vec3 = |p| Vec3::new(-p.x, p.y, p.z);
    let mirrored = Change { is_mirrored: true, ..placed("mirror", mirror, 1.0) };
    let all = [
        Change { name: "order", original, ..Change::of(&shuffled) },
        placed("smaller", |p| p * f32::exp2(-40.0), f32::exp2(-40.0)),
        placed("larger", |p| p * f32::exp2(40.0), f32::exp2(40.0)),
        placed("elsewhere", |p| p + OFFSET, 1.0),
        placed("quarter turn", |p| Vec3::new(-p.y, p.x, p.z), 1.0),
        Change { mesh: inside_out(&mirrored.mesh), ..mirrored },
    ];
    all.into_iter()
}

impl Change {
    /// None.
    pub fn none(mesh: &TriangleMesh) -> Self {
        Self::of(mesh)
    }

    /// Another mesh, seen as before.
    pub fn of(mesh: &TriangleMesh) -> Self {
        let mesh = mesh.clone();
        Self { name: "none", mesh, place: |p| p, scale: 1.0, is_mirrored: false, original: Vec::new() }
    }

    /// The number that a vertex had.
    pub fn original(&self, vertex: u32) -> u32 {
        self.original.get(vertex as usize).copied().unwrap_or(vertex)
    }

    /// Where a point goes.
    pub fn place(&self, p: Vec3) -> Vec3 {
        (self.place)(p)
    }

    /// Where a direction goes.
    pub fn direction(&self, d: Vec3) -> Vec3 {
        // Offsets are exact on the grid.
        (self.place(d) - self.place(Vec3::ZERO)) / self.scale
    }

    pub fn viewpoint(&self, viewpoint: &Viewpoint) -> Viewpoint {
        match *viewpoint {
            Viewpoint::Perspective { eye } => Viewpoint::Perspective { eye: self.place(eye) },
            Viewpoint::Orthographic { toward_viewer } => {
                Viewpoint::Orthographic { toward_viewer: self.direction(toward_viewer) }
            }
        }
    }

    pub fn camera(&self, camera: &Camera) -> Camera {
        let projection = match camera.projection() {
            Projection::Orthographic { height } => Projection::Orthographic { height: height * f64::from(self.scale) },
            perspective => perspective,
        };
        let [eye, target] = [camera.eye(), camera.target()].map(|p| self.place(p));
        Camera::new(eye, target, self.direction(camera.up()), projection, camera.size()).unwrap()
    }
}
