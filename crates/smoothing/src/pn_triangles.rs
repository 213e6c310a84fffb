//! Curved PN triangles: a cubic patch over each face, from the positions and normals of its corners alone.
//!
//! A. Vlachos, J. Peters, C. Boyd and J. L. Mitchell, "Curved PN triangles", Symposium on Interactive 3D Graphics (I3D) 2001:
//!
//! 1. a cubic over each edge, whose tangents at the ends are the edge less its part along the normal ([`crate::side_curves`]),
//! 2. the control point in the middle, b111: the average E of the six on the sides, moved on by half its way from the average of
//!    the corners,
//! 3. normals that vary as a quadratic, whose coefficient at an edge is the sum of the end normals, reflected in the plane
//!    across the edge,
//! 4. `level` points inserted per side: (level + 1)² triangles ([`crate::tessellation`]).
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
    /// Options of [`PnTriangles`].
    pub struct PnTrianglesOptions {
        /// Points inserted per side: each face becomes (level + 1)² triangles.
        pub level: u32 = whole("level", 0..=15, default 3, sweep linear 0..=7),
        /// Dihedral angle from which an edge is a feature, across which the surface is not smooth.
        pub crease_deg: f64 = number("crease", 0.0..=180.0 "degrees", default 75.0),
        /// How much each face counts in the normal of a vertex.
        pub normals: NormalWeights = choice("normals"),
    }
}

/// A cubic patch over each face. See the [module](self).
///
/// O(F (level + 1)²) once; nothing per view but drawing that many triangles.
#[derive(Debug, Clone)]
pub struct PnTriangles {
    options: PnTrianglesOptions,
    tessellation: Tessellation<PnPatch>,
}

impl Method for PnTriangles {
    type Options = PnTrianglesOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "pn-triangles",
        summary: "Replaces every face by a cubic patch made of its corners' normals, split evenly whatever the view.",
        source: Source {
            authors: "Alex Vlachos, Jörg Peters, Chas Boyd, Jason L. Mitchell",
            title: "Curved PN triangles",
            venue: "Symposium on Interactive 3D Graphics (I3D)",
            year: 2001,
        },
        exact: false,
        needs: &[Topology::NAME],
        options: PnTrianglesOptions::SPECS,
        guide: MethodGuide {
            origin: "Vlachos et al. 2001",
            yields: "a filled image, the same surface in every view",
            accuracy: "no: a sphere of 80 faces is off by 0.010 radii, with 1280 triangles",
            cost: "nothing on the CPU; O(F (level + 1)²) on the GPU",
            memory: "180 bytes per face, plus the triangles it makes",
            choose_when: "a curved surface is wanted everywhere and (level + 1)² triangles per face can be drawn",
            limits: "draws as many triangles away from the silhouette as along it; trusts normals, so that it gains \
                     little on simplified scans",
        },
        published: &[],
    };

    fn prepare(
        mesh: &Arc<PreparedMesh>,
        options: &PnTrianglesOptions,
        progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        options.validate()?;
        let PnTrianglesOptions { level, crease_deg, normals } = *options;
        let tessellation = Tessellation::new(mesh, PnPatch, level, crease_deg, normals, Self::INFO.name, progress)?;
        Ok(Self { options: *options, tessellation })
    }

    fn bytes(&self) -> usize {
        self.tessellation.bytes()
    }
}

impl PnTriangles {
    /// Its options.
    pub fn options(&self) -> &PnTrianglesOptions {
        &self.options
    }

    /// The mesh with its shading normals.
    pub fn shading_mesh(&self) -> &ShadingMesh {
        self.tessellation.mesh()
    }
}

impl MakesTriangles for PnTriangles {
    type Remesher = Tessellation<PnPatch>;

    fn remesher(&self) -> Self::Remesher {
        self.tessellation.clone()
    }
}

/// Steps 2 and 3.
#[derive(Debug, Clone, Copy)]
pub struct PnPatch;

impl Patch for PnPatch {
    fn side_point(&self, side: &Hermite, u: f64) -> DVec3 {
        side.point(u)
    }

    fn inner_point(&self, sides: &[Hermite; 3], weights: [f64; 3]) -> DVec3 {
        let [w, u, v] = weights;
        let [[p0, p01, p10, p1], [_, p12, p21, p2], [_, p20, p02, _]] = sides.map(|side| side.control());
        let edges = (p01 + p10 + p12 + p21 + p20 + p02) / 6.0;
        let middle = edges + 0.5 * (edges - (p0 + p1 + p2) / 3.0);
        w * w * w * p0
            + u * u * u * p1
            + v * v * v * p2
            + 3.0 * (w * u * (w * p01 + u * p10) + u * v * (u * p12 + v * p21) + v * w * (v * p20 + w * p02))
            + 6.0 * w * u * v * middle
    }

    fn normal(&self, positions: [DVec3; 3], normals: [DVec3; 3], weights: [f64; 3]) -> DVec3 {
        let mut sum = DVec3::ZERO;
        for (slot, next) in [(0, 1), (1, 2), (2, 0)] {
            sum += weights[slot] * weights[slot] * normals[slot];
            if weights[slot] * weights[next] != 0.0 {
                let across = positions[next] - positions[slot];
                let both = normals[slot] + normals[next];
                let reflected = across.try_normalize().map_or(both, |axis| both - 2.0 * both.dot(axis) * axis);
                sum += weights[slot] * weights[next] * reflected.normalize_or_zero();
            }
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::side_curves::side_curves;
    use silhouette_core::NoProgress;
    use silhouette_core::glam::Vec3;
    use silhouette_testing::builtin;

    #[test]
    fn the_patch_has_its_sides_as_sides() {
        let mesh = ShadingMesh::new(
            &PreparedMesh::new(builtin("icosphere:0")),
            75.0,
            NormalWeights::Area,
            "test",
            &NoProgress,
        )
        .unwrap();
        let curves = side_curves(&mesh);
        let curve = |from: DVec3, to: DVec3| {
            let is_it = |curve: &&Hermite| curve.ends == [from, to] || curve.ends == [to, from];
            let found = *curves.as_slice().iter().find(is_it).unwrap();
            if found.ends[0] == from { found } else { found.reversed() }
        };
        let [a, b, c] = mesh.mesh().corners(silhouette_core::FaceId::new(3)).map(Vec3::as_dvec3);
        let sides = [curve(a, b), curve(b, c), curve(c, a)];
        for u in [0.0, 0.2, 0.5, 0.9, 1.0] {
            for (slot, side) in sides.iter().enumerate() {
                let mut weights = [0.0; 3];
                (weights[slot], weights[(slot + 1) % 3]) = (1.0 - u, u);
                assert!(PnPatch.inner_point(&sides, weights).distance(side.point(u)) < 1e-12);
            }
        }
        // The face's own middle is at 0.795.
        let middle = PnPatch.inner_point(&sides, [1.0 / 3.0; 3]).length();
        assert!((0.9..1.0).contains(&middle), "{middle}");
    }

    #[test]
    fn normals_are_those_of_a_sphere_and_turn_over_an_inflection() {
        let positions = [DVec3::X, DVec3::Y, DVec3::Z];
        for weights in [[0.5, 0.5, 0.0], [1.0 / 3.0; 3], [0.0, 0.0, 1.0]] {
            let expected = DVec3::from_array(weights).normalize();
            assert!(PnPatch.normal(positions, positions, weights).normalize().distance(expected) < 1e-12);
        }
        // Both ends rise alike along x, so that the surface between them sinks; the average of the normals would not turn.
        let tilted = DVec3::new(-0.6, 0.0, 0.8);
        let middle = PnPatch.normal([DVec3::ZERO, DVec3::X, DVec3::Y], [tilted; 3], [0.5, 0.5, 0.0]);
        assert!(middle.x.abs() < 0.5 * tilted.x.abs() * middle.length(), "{middle}");
    }
}
