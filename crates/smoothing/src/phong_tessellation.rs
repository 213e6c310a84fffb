//! Phong tessellation: each point of a face is drawn towards the planes through the corners.
//!
//! T. Boubekeur and M. Alexa, "Phong tessellation", ACM Transactions on Graphics 27(5), SIGGRAPH Asia 2008:
//!
//! 1. a point p of a face is projected onto the plane through each corner, across that corner's normal,
//! 2. the projections are averaged by the barycentric coordinates of p,
//! 3. the point drawn is (1 - α) p + α times that average; normals are interpolated.
//!
//! The averaged projections are a quadratic patch. Along a side its bend is u (1 - u) (T0 - T1), T0 and T1 being the edge
//! projected onto the planes at its ends: the tangents of [`crate::side_curves`]. Inside, the bends of the three sides add up.
//!
//! Departure: watertight at feature edges, as [`crate::side_curves`] says.

use crate::face_splitter::Patch;
use crate::hermite::Hermite;
use crate::shading_mesh::ShadingMesh;
use crate::shading_normals::NormalWeights;
use crate::tessellation::Tessellation;
use crate::view_mesh::MakesTriangles;
use silhouette_core::glam::DVec3;
use silhouette_core::method::{Method, MethodGuide, MethodInfo, MethodOptions, PrepareError, Source};
use silhouette_core::prepared::{Artefact, PreparedMesh};
use silhouette_core::progress::Progress;
use silhouette_core::topology::Topology;
use std::sync::Arc;

silhouette_core::method_options! {
    /// Options of [`PhongTessellation`].
    pub struct PhongTessellationOptions {
        /// Points inserted per side: each face becomes (level + 1)² triangles.
        pub level: u32 = whole("level", 0..=15, default 3, sweep linear 0..=7),
        /// How far points are drawn towards the projections: 0 leaves faces flat.
        pub alpha: f64 = number("alpha", 0.0..=1.0, default 0.75),
        /// Dihedral angle from which an edge is a feature, across which the surface is not smooth.
        pub crease_deg: f64 = number("crease", 0.0..=180.0 "degrees", default 75.0),
        /// How much each face counts in the normal of a vertex.
        pub normals: NormalWeights = choice("normals"),
    }
}

/// A quadratic patch over each face. See the [module](self).
///
/// O(F (level + 1)²) once; nothing per view but drawing that many triangles.
#[derive(Debug, Clone)]
pub struct PhongTessellation {
    options: PhongTessellationOptions,
    tessellation: Tessellation<PhongPatch>,
}

impl Method for PhongTessellation {
    type Options = PhongTessellationOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "phong-tessellation",
        summary: "Draws the points of every face towards the planes of its corners, split evenly whatever the view.",
        source: Source {
            authors: "Tamy Boubekeur, Marc Alexa",
            title: "Phong tessellation",
            venue: "ACM Transactions on Graphics 27(5) (SIGGRAPH Asia)",
            year: 2008,
        },
        exact: false,
        needs: &[Topology::NAME],
        options: PhongTessellationOptions::SPECS,
        guide: MethodGuide {
            origin: "Boubekeur and Alexa 2008",
            yields: "a filled image, the same surface in every view",
            accuracy: "no: a sphere of 80 faces is off by 0.022 radii, with 1280 triangles",
            cost: "as `pn-triangles`",
            memory: "as `pn-triangles`",
            choose_when: "as `pn-triangles`, where the simplest evaluation counts more than the shape",
            limits: "as `pn-triangles`, whose outline was closer on five of eight meshes",
        },
        published: &[],
    };

    fn prepare(
        mesh: &Arc<PreparedMesh>,
        options: &PhongTessellationOptions,
        progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        options.validate()?;
        let PhongTessellationOptions { level, alpha, crease_deg, normals } = *options;
        let patch = PhongPatch { alpha };
        let tessellation = Tessellation::new(mesh, patch, level, crease_deg, normals, Self::INFO.name, progress)?;
        Ok(Self { options: *options, tessellation })
    }

    fn bytes(&self) -> usize {
        self.tessellation.bytes()
    }
}

impl PhongTessellation {
    /// Its options.
    pub fn options(&self) -> &PhongTessellationOptions {
        &self.options
    }

    /// The mesh with its shading normals.
    pub fn shading_mesh(&self) -> &ShadingMesh {
        self.tessellation.mesh()
    }
}

impl MakesTriangles for PhongTessellation {
    type Remesher = Tessellation<PhongPatch>;

    fn remesher(&self) -> Self::Remesher {
        self.tessellation.clone()
    }
}

/// Steps 1 to 3.
#[derive(Debug, Clone, Copy)]
pub struct PhongPatch {
    alpha: f64,
}

/// The difference of a side's tangents: its bend, but for u (1 - u).
fn bend(side: &Hermite) -> DVec3 {
    side.tangents[0] - side.tangents[1]
}

impl Patch for PhongPatch {
    fn side_point(&self, side: &Hermite, u: f64) -> DVec3 {
        side.ends[0].lerp(side.ends[1], u) + self.alpha * u * (1.0 - u) * bend(side)
    }

    fn inner_point(&self, sides: &[Hermite; 3], weights: [f64; 3]) -> DVec3 {
        let part = |slot: usize| {
            let (here, next) = (weights[slot], weights[(slot + 1) % 3]);
            here * sides[slot].ends[0] + self.alpha * here * next * bend(&sides[slot])
        };
        part(0) + part(1) + part(2)
    }

    fn normal(&self, _positions: [DVec3; 3], normals: [DVec3; 3], weights: [f64; 3]) -> DVec3 {
        weights[0] * normals[0] + weights[1] * normals[1] + weights[2] * normals[2]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The paper's own formula, by projections.
    #[test]
    fn points_are_averages_of_their_projections_onto_the_planes_of_the_corners() {
        let corners = [DVec3::new(0.1, 0.0, 0.3), DVec3::new(1.2, 0.2, 0.0), DVec3::new(0.3, 0.9, -0.2)];
        let normals = [DVec3::new(-0.3, -0.2, 0.9), DVec3::new(0.4, 0.0, 0.8), DVec3::new(0.0, 0.5, 0.7)];
        let normals = normals.map(DVec3::normalize);
        let onto = |point: DVec3, slot: usize| point - (point - corners[slot]).dot(normals[slot]) * normals[slot];
        let sides = [(0, 1), (1, 2), (2, 0)].map(|(a, b)| {
            let tangent = |end: usize| onto(corners[end] + corners[b] - corners[a], end) - corners[end];
            Hermite { ends: [corners[a], corners[b]], tangents: [tangent(a), tangent(b)] }
        });
        for alpha in [0.0, 0.75, 1.0] {
            for weights in [[0.2, 0.3, 0.5], [1.0 / 3.0; 3], [0.6, 0.4, 0.0]] {
                let point: DVec3 = (0..3).map(|slot| weights[slot] * corners[slot]).sum();
                let average: DVec3 = (0..3).map(|slot| weights[slot] * onto(point, slot)).sum();
                let expected = point.lerp(average, alpha);
                assert!(PhongPatch { alpha }.inner_point(&sides, weights).distance(expected) < 1e-12);
            }
            let patch = PhongPatch { alpha };
            assert!(patch.side_point(&sides[0], 0.4).distance(patch.inner_point(&sides, [0.6, 0.4, 0.0])) < 1e-12);
        }
    }
}
