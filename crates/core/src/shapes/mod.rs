//! Generated meshes, and for smooth shapes the contour generator in closed form: scenes whose true silhouette is known.
//!
//! Every mesh is in a right-handed space with y up, centred on the origin and about one unit in radius, counter-clockwise
//! seen from outside, watertight by shared vertices wherever the shape is closed, free of zero-area faces, and the same
//! bits for any number of threads. A shape is a struct of its dimensions ([`Torus`]), a mesh of it is asked for with a
//! density ([`Torus::mesh`]); the command line's `builtin:torus:64,32` goes through [`by_name`].
//!
//! | shape | closed | genus | contour in closed form |
//! |---|---|---|---|
//! | [`Cuboid`] | yes | 0 | |
//! | [`Sphere`] (geodesic or by latitude), [`Ellipsoid`] | yes | 0 | yes |
//! | [`Cylinder`] | yes | 0 | yes |
//! | [`Cone`] | yes | 0 | |
//! | [`Torus`] | yes | 1 | yes |
//! | [`TorusKnot`], [`Gear`], [`Ring`] | yes | 1 | |
//! | [`Blob`]: any even number of faces up to [`MAX_FACES`] | yes | 0 | |
//! | [`MachineRoom`]: hundreds of objects | yes | 0 and 1 | |
//! | [`Grid`], [`MoebiusStrip`] | no | | |
//!
//! Cost: O(V + F), in parallel for all but the smallest shapes.

mod blob;
mod builtin;
mod cone;
pub mod contour;
mod cuboid;
mod cylinder;
mod ellipsoid;
mod gear;
mod grid;
mod lattice;
mod machine_room;
mod moebius;
mod registry;
mod revolution;
mod ring;
mod sphere;
mod torus;
mod torus_knot;

pub use blob::Blob;
pub use builtin::{ArgumentKind, ArgumentSpec, Builtin, MAX_FACES, ShapeError};
pub use cone::Cone;
pub use contour::{AnalyticContour, ContourCurve, ContourKind};
pub use cuboid::Cuboid;
pub use cylinder::Cylinder;
pub use ellipsoid::Ellipsoid;
pub use gear::Gear;
pub use grid::Grid;
pub use machine_room::MachineRoom;
pub use moebius::MoebiusStrip;
pub use registry::{BUILTINS, by_name, contour_by_name};
pub use ring::Ring;
pub use sphere::Sphere;
pub use torus::Torus;
pub use torus_knot::TorusKnot;

use crate::mesh::TriangleMesh;
use glam::{DVec3, Vec3};

/// Wraps arrays that a generator made. The ranges of [`Builtin`] keep every coordinate finite and every count far below
/// the limits of a mesh, so a refusal here is a bug of the generator.
fn finish(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> TriangleMesh {
    TriangleMesh::new(positions, triangles).expect("generators yield finite positions and indices in range")
}

/// The unit vector in the xz plane at `angle_rad`, counter-clockwise seen from +y, from +x on.
fn around_y(angle_rad: f64) -> DVec3 {
    let (sin, cos) = angle_rad.sin_cos();
    DVec3::new(cos, 0.0, -sin)
}

/// `2 pi * step / steps`, in radians.
fn turn(step: u32, steps: u32) -> f64 {
    std::f64::consts::TAU * f64::from(step) / f64::from(steps)
}

#[cfg(test)]
mod tests;
