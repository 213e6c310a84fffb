//! Meshes that the application has loaded with `tobj` 4.

use super::concave::Polygons;
use super::polygon::fan;
use crate::mesh::{MAX_VERTICES, MeshError, TriangleMesh};
use glam::Vec3;

/// Why models of `tobj` are not a mesh. Faces are counted within their model, points and lines included, from 0.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum FromTobjError {
    /// Coordinates are left over.
    #[error("model {model:?} has {coordinates} coordinates, not a multiple of 3; give x, y and z of each position")]
    Coordinates {
        /// The model's name.
        model: String,
        /// How many coordinates it has.
        coordinates: usize,
    },
    /// Indices are left over or missing.
    #[error("model {model:?} has {indices} indices, but its faces have {corners} corners; give one per corner")]
    Corners {
        /// The model's name.
        model: String,
        /// How many indices it has.
        indices: usize,
        /// How many corners its faces have; without arities, the next multiple of 3.
        corners: usize,
    },
    /// A face names a vertex that its model does not have.
    #[error("face {face} of model {model:?} names vertex {index}, but there are only {vertices} (0 is the first)")]
    IndexOutOfRange {
        /// The model's name.
        model: String,
        /// The first such face.
        face: usize,
        /// The index it names.
        index: u32,
        /// How many vertices the model has.
        vertices: usize,
    },
    /// Together the models are not a mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

impl TriangleMesh {
    /// The mesh of models that the application has loaded with [`tobj`]: one after another, with the vertex ids of each
    /// offset by the vertices of those before it. Cargo feature `tobj`. O(V + F).
    ///
    /// Faces of four or more corners are cut into triangles as [`load`](crate::load) does; points and lines are passed over.
    /// With `tobj`'s feature `use_f64`, coordinates are rounded to 32 bits.
    ///
    /// `tobj` starts a model at each object, group and material, with its own copy of the vertices, and with `single_index`
    /// also splits vertices along seams of texture coordinates and normals. Silhouettes need the surface in one piece: leave
    /// `single_index` off, and join the copies with [`weld_exact`](crate::weld::weld_exact). Set `ignore_points` and
    /// `ignore_lines` where `triangulate` is on, or points and lines become faces without area.
    ///
    /// # Errors
    /// [`FromTobjError`] names the first model and face at fault.
    ///
    /// ```
    /// use silhouette_core::{TriangleMesh, weld::weld_exact};
    ///
    /// let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\no square\nf 1 2 3 4\no triangle\nf 2 5 3\n";
    /// let no_materials = |_: &std::path::Path| tobj::load_mtl_buf(&mut std::io::empty());
    /// let (models, _) = tobj::load_obj_buf(&mut text.as_bytes(), &tobj::LoadOptions::default(), no_materials)?;
    ///
    /// let mesh = TriangleMesh::from_tobj(&models)?;
    /// assert_eq!(mesh.triangles(), [[0, 1, 2], [0, 2, 3], [4, 5, 6]]);
    /// assert_eq!(weld_exact(&mesh).mesh.vertex_count(), 5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn from_tobj(models: &[tobj::Model]) -> Result<Self, FromTobjError> {
        let (mut positions, mut triangles, mut polygons) = (Vec::new(), Vec::new(), Polygons::default());
        for model in models {
            append(model, &mut positions, &mut triangles, &mut polygons)?;
        }
        // Otherwise ids ran out, and the mesh is refused.
        if positions.len() <= MAX_VERTICES {
            polygons.triangulate(&positions, &mut triangles);
        }
        Ok(Self::new(positions, triangles)?)
    }
}

fn append(
    tobj::Model { mesh, name }: &tobj::Model,
    positions: &mut Vec<Vec3>,
    triangles: &mut Vec<[u32; 3]>,
    polygons: &mut Polygons,
) -> Result<(), FromTobjError> {
    let model = || name.clone();
    let (points, rest) = mesh.positions.as_chunks::<3>();
    if !rest.is_empty() {
        return Err(FromTobjError::Coordinates { model: model(), coordinates: mesh.positions.len() });
    }
    let indices = mesh.indices.len();
    let arities = mesh.face_arities.iter().map(|&arity| arity as usize);
    let corners = if mesh.face_arities.is_empty() { indices.next_multiple_of(3) } else { arities.clone().sum() };
    if corners != indices {
        return Err(FromTobjError::Corners { model: model(), indices, corners });
    }
    let first = positions.len();
    // By way of 64 bits, since `tobj` may have either; exact for 32.
    positions.extend(points.iter().map(|point| Vec3::from(point.map(|x| f64::from(x) as f32))));
    // More vertices than ids are refused as soon as all models are here.
    let first = u32::try_from(first).unwrap_or(u32::MAX);
    let mut rest = mesh.indices.as_slice();
    let triangular = std::iter::repeat_n(3, if mesh.face_arities.is_empty() { indices / 3 } else { 0 });
    let mut polygon = Vec::new();
    for (face, arity) in arities.chain(triangular).enumerate() {
        let (corners, after) = rest.split_at(arity);
        rest = after;
        if let Some(&index) = corners.iter().find(|&&index| index as usize >= points.len()) {
            return Err(FromTobjError::IndexOutOfRange { model: model(), face, index, vertices: points.len() });
        }
        polygon.clear();
        polygon.extend(corners.iter().map(|index| first.saturating_add(*index)));
        polygons.begin(triangles.len(), polygon.len());
        fan(&polygon, triangles);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn model(name: &str, positions: &[f32], indices: &[u32], face_arities: &[u32]) -> tobj::Model {
        let mesh = tobj::Mesh {
            positions: positions.to_vec(),
            indices: indices.to_vec(),
            face_arities: face_arities.to_vec(),
            ..tobj::Mesh::default()
        };
        tobj::Model::new(mesh, name.to_owned())
    }

    const SQUARE: [f32; 12] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0];

    #[test]
    fn models_become_one_mesh_with_ids_offset() {
        let models = [
            model("triangles", &SQUARE, &[0, 1, 2, 2, 3, 0], &[]),
            model("nothing", &[], &[], &[]),
            model("mixed", &SQUARE, &[0, 0, 1, 0, 1, 2, 3, 1, 2, 3], &[1, 2, 4, 3]),
        ];
        let mesh = TriangleMesh::from_tobj(&models).unwrap();
        assert_eq!(mesh.triangles(), [[0, 1, 2], [2, 3, 0], [4, 5, 6], [4, 6, 7], [5, 6, 7]]);
        assert_eq!((mesh.vertex_count(), mesh.positions()[6]), (8, Vec3::new(1.0, 1.0, 0.0)));
        assert_eq!(TriangleMesh::from_tobj(&[]).unwrap().face_count(), 0);
    }

    #[test]
    fn bad_models_are_refused_in_one_line() {
        let line = |positions: &[f32], indices: &[u32], face_arities: &[u32]| {
            let good = model("good", &SQUARE, &[0, 1, 2], &[]);
            let error = TriangleMesh::from_tobj(&[good, model("bad\n", positions, indices, face_arities)]).unwrap_err();
            let line = error.to_string();
            assert!(!line.contains('\n'), "{line}");
            line
        };
        let coordinates = line(&SQUARE[..11], &[0, 1, 2], &[]);
        assert_eq!(
            coordinates,
            r#"model "bad\n" has 11 coordinates, not a multiple of 3; give x, y and z of each position"#
        );
        let corners = line(&SQUARE, &[0, 1, 2, 3], &[]);
        assert_eq!(corners, r#"model "bad\n" has 4 indices, but its faces have 6 corners; give one per corner"#);
        assert!(line(&SQUARE, &[0, 1, 2], &[4]).contains("3 indices, but its faces have 4 corners"));
        let range = line(&SQUARE, &[0, 1, 2, 3, 0, 1, 4], &[3, 4]);
        assert_eq!(range, r#"face 1 of model "bad\n" names vertex 4, but there are only 4 (0 is the first)"#);
        let not_finite = line(&[f32::NAN, 0.0, 0.0], &[0, 0, 0], &[]);
        assert_eq!(not_finite, "vertex 4 has a coordinate that is not a finite 32-bit float");
    }
}
