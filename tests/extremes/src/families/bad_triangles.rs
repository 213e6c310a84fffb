//! Needles, slivers, faces without area, and vertices that are there twice, never used, or no numbers.

use crate::cell::Aspect::{Curves, Edges, Fill, Lines};
use crate::cell::Found;
use crate::cell::Outcome::{Differs, Empty, Refused, Same};
use crate::meshes::{listed_twice, rod, slivers, torus, unwelded, with_flat_faces, with_loose_vertices};
use crate::row::{Row, Who};
use crate::scene::Scene;
use silhouette_core::TriangleMesh;
use silhouette_core::glam::Vec3;
use silhouette_testing::builtin;
use silhouette_testing::edits::mapped;

/// The torus with a coordinate of its vertex 7 replaced.
fn with_coordinate(value: f32) -> Result<Scene, Found> {
    let mut positions = torus().positions().to_vec();
    positions[7].y = value;
    let mesh = TriangleMesh::new(positions, torus().triangles().to_vec());
    mesh.map(Scene::of).map_err(|error| Found::refused(&error))
}

/// The rod, thick enough to be seen.
fn thick_rod() -> Scene {
    Scene::of(mapped(&builtin("cylinder"), |p| Vec3::new(p.x * 0.2, p.y, p.z * 0.2)))
}

const THIN: &str = "the rod is thinner than the samples of a pixel are apart";
const FLAT: &str = "faces without area are back, and their edges among front faces silhouette edges; healing removes them, and `edge-mesh` \
                    leaves them out";
const OPENED: &str = "the vertices of a sliver are pushed apart, each along its own normal; where it opens towards the eye it is a back face, \
                      and drawn";
const BORDERS: &str = "without welding each face is a part of its own, and all sides of front faces are boundary edges: it draws the \
                       silhouette of the surface and not the lines of the faces, which are the truth here";

/// What tracking says of edges with more than two faces.
fn without_tracking(row: Row) -> Row {
    row.expect_of(Edges, &["tracking", "tracking-exact"], Refused, "")
}

/// The rows.
pub fn rows() -> Vec<Row> {
    vec![
        Row::new("needles", "a cylinder 2 long and 2e-8 thick: faces of aspect 1e8", || Scene::of(rod()))
            .beside("rod", thick_rod)
            .expect(Who::Every(Fill), Empty, THIN)
            .expect_of(Lines, &["gbuffer-filter", "jump-flood", "texture-lines"], Empty, THIN)
            .expect_of(Fill, &["normal-map-hull"], Differs, "it fills what a hull encloses, which has a thickness")
            .expect_of(
                Fill,
                &["boundary-curve"],
                Same,
                "its curve bulges between the ends of any cylinder, thick or thin, by about half of its height",
            )
            .expect_of(
                Curves,
                &["smoothing", "interpolated-contours"],
                Differs,
                "it rounds the ends, whose edges are no features to it",
            )
            .expect_all_of_randomized(),
        Row::new(
            "slivers",
            "each face split at a point as close to an edge as 32 bits allow, 1e-8 of its length",
            || Scene::of(slivers(1e8)),
        )
        .expect_of(Lines, &["brute-force"], Differs, FLAT)
        .expect_of(Lines, &["inverted-hull"], Differs, OPENED)
        .expect_of(Curves, &["boundary-curve"], Differs, FLAT),
        without_tracking(Row::new(
            "zero-area faces",
            "a face along an edge and back, and one that is a point, to each face",
            || Scene::of(with_flat_faces()),
        ))
        .expect_of(Lines, &["brute-force"], Differs, FLAT)
        .expect(
            Who::Every(Curves),
            Differs,
            "edges with a face without area have more than two faces, and are features",
        ),
        without_tracking(Row::new("duplicate faces", "every face listed twice", || Scene::of(listed_twice())))
            .expect_of(
                Lines,
                &["image-precision"],
                Empty,
                "where four faces share an edge it takes both sides for covered; healing removes the second faces",
            )
            .expect_of(
                Curves,
                &["interpolated-contours"],
                Empty,
                "every edge has four faces and is a feature, and no normal is interpolated across features",
            ),
        Row::new("duplicate vertices", "three vertices of its own for each face", || Scene::of(unwelded()))
            .expect_of(
                Lines,
                &["image-precision", "inverted-hull", "gbuffer-filter", "jump-flood", "texture-lines"],
                Differs,
                BORDERS,
            )
            .expect_of(
                Curves,
                &["interpolated-contours"],
                Empty,
                "every edge is a boundary, and a face alone has one normal",
            ),
        Row::new("loose vertices", "vertices that no face names, two of them 1e30 away", || {
            Scene::of(with_loose_vertices())
        }),
        Row::fallible("NaN vertex", "a coordinate of vertex 7 is NaN", || with_coordinate(f32::NAN)).expect(
            Who::All,
            Refused,
            "",
        ),
        Row::fallible("infinite vertex", "a coordinate of vertex 7 is infinite", || with_coordinate(f32::INFINITY))
            .expect(Who::All, Refused, ""),
    ]
}
