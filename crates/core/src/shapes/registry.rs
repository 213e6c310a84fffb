//! The table of built-in shapes, and the mesh that `NAME[:ARG[,ARG…]]` describes.

use super::builtin::{Builtin, ShapeError};
use super::contour::AnalyticContour;
use super::{
    blob, cone, cuboid, cylinder, ellipsoid, gear, grid, machine_room, moebius, ring, sphere, torus, torus_knot,
};
use crate::mesh::TriangleMesh;

/// Every built-in shape, in the order a list should show them.
pub const BUILTINS: &[&Builtin] = &[
    &cuboid::CUBE,
    &sphere::ICOSPHERE,
    &sphere::UV_SPHERE,
    &ellipsoid::ELLIPSOID,
    &cylinder::CYLINDER,
    &cone::CONE,
    &torus::TORUS,
    &torus_knot::TORUS_KNOT,
    &gear::GEAR,
    &ring::RING,
    &blob::BLOB,
    &machine_room::MACHINE_ROOM,
    &grid::GRID,
    &moebius::MOEBIUS,
];

/// The mesh that `NAME[:ARG[,ARG…]]` describes, such as `cube`, `icosphere:4` or `torus:64,32`. [`BUILTINS`] lists names
/// and arguments.
///
/// # Errors
/// [`ShapeError`] names the argument that does not fit and its range.
pub fn by_name(text: &str) -> Result<TriangleMesh, ShapeError> {
    let (builtin, values) = resolve(text)?;
    (builtin.build)(&values)
}

/// The smooth surface behind the mesh of the same name, for its contour in closed form; `None` for a shape that has none
/// (see [`BUILTINS`]). The mesh's vertices lie on this surface.
///
/// # Errors
/// [`ShapeError`], as [`by_name`], but for the number of faces.
pub fn contour_by_name(text: &str) -> Result<Option<Box<dyn AnalyticContour>>, ShapeError> {
    let (builtin, values) = resolve(text)?;
    builtin.check(&values, 0)?;
    builtin.contour.map(|contour| contour(&values)).transpose()
}

fn resolve(text: &str) -> Result<(&'static Builtin, Vec<f64>), ShapeError> {
    let (name, arguments) = text.split_once(':').map_or((text, None), |(name, arguments)| (name, Some(arguments)));
    let builtin = BUILTINS.iter().find(|builtin| builtin.name == name).ok_or_else(|| {
        let names: Vec<&str> = BUILTINS.iter().map(|builtin| builtin.name).collect();
        ShapeError::UnknownName { name: name.to_owned(), known: names.join(", ") }
    })?;
    Ok((builtin, builtin.parse(arguments)?))
}
