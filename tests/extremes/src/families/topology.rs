//! Meshes that are no closed, consistently wound manifolds.

use crate::cell::Aspect::{Curves, Edges, Fill, Lines};
use crate::cell::Outcome::{Differs, Empty, Refused};
use crate::meshes::{torus, triangle};
use crate::row::{Row, Who};
use crate::scene::{Scene, looking};
use silhouette_core::glam::Vec3;
use silhouette_testing::builtin;
use silhouette_testing::edits::{inside_out, joined, moved};
use silhouette_testing::zoo::{book, empty, finned_blob};

fn sheet(eye: Vec3) -> Scene {
    Scene::seen(builtin("grid:20,14"), looking(eye, Vec3::ZERO, 45.0))
}

fn of_triangle(z: f32) -> Scene {
    Scene::seen(triangle(), looking(Vec3::new(0.5, 0.4, z), Vec3::new(0.3, 0.3, 0.0), 45.0))
}

fn two_tori() -> Scene {
    Scene::of(joined(&[&torus(), &moved(&torus(), Vec3::new(0.5, 2.0, 0.25))]))
}

const NO_BACK: &str = "an open mesh has no back face behind its rim: boundary edges take the option `extra-edges`";
const NO_HULL_RIM: &str = "what is behind the front of an open mesh is nothing, so that nothing shows beside it";
const ANY_SIDE: &str = "it draws what is seen of either side, and the truth is that of the outer side alone";
const NO_BORDER: &str = "interpolated contours have no boundary lines";
const OPEN_HULL: &str = "the texture shows a sheet from both sides, and its rim where the texture's samples put it";
const NONE: &str = "the mesh is seen from its inner side alone: no face is front, and there is no line";
const BLUNT: &str = "a hull closes around a mesh that is open or thin";
const WINDING: &str = "along an edge at which faces are wound against each other one is front and one back, wherever the eye is, so that it is a \
                       silhouette edge and drawn; the truth goes by the surface, and has no line there";

/// What is expected of meshes with edges that cannot be tracked across.
fn without_tracking(row: Row) -> Row {
    row.expect_of(Edges, &["tracking", "tracking-exact"], Refused, "")
}

/// What is expected where no face is front.
fn from_inside(row: Row) -> Row {
    row.expect(Who::Every(Edges), Empty, NONE)
        .expect_of(Edges, &["randomized"], Empty, NONE)
        .expect(Who::Every(Curves), Empty, NONE)
        .expect_of(Lines, &["brute-force", "edge-mesh"], Empty, NONE)
}

/// The rows.
pub fn rows() -> Vec<Row> {
    vec![
        without_tracking(Row::new(
            "three faces per edge",
            "a book of three pages, of which all run the same way along its back",
            || Scene::of(book(3)),
        ))
        .expect_of(Lines, &["edge-mesh"], Differs, WINDING)
        .expect_of(
            Lines,
            &["image-precision", "inverted-hull", "gbuffer-filter", "jump-flood", "texture-lines"],
            Differs,
            ANY_SIDE,
        )
        .expect_of(Curves, &["smoothing", "boundary-curve"], Differs, WINDING)
        .expect_of(Curves, &["interpolated-contours"], Empty, NO_BORDER)
        .expect_of(Fill, &["normal-map-hull"], Differs, BLUNT)
        .expect_all_of_randomized(),
        without_tracking(Row::new(
            "fin",
            "a closed blob with a third face on one edge, and one face turned over",
            || Scene::of(finned_blob()),
        ))
        .expect_of(Lines, &["image-precision", "gbuffer-filter"], Differs, ANY_SIDE)
        .expect_of(
            Curves,
            &["smoothing", "interpolated-contours"],
            Differs,
            "the blob is coarse, and its smooth outline lies farther from its edges than that of the torus",
        )
        .expect_of(Fill, &["normal-map-hull"], Differs, BLUNT),
        without_tracking(Row::new("Moebius strip", "a strip that no winding makes consistent", || {
            Scene::of(builtin("moebius:24,2"))
        }))
        .expect_of(Lines, &["brute-force", "edge-mesh"], Differs, WINDING)
        .expect_of(
            Lines,
            &["image-precision", "inverted-hull", "gbuffer-filter", "jump-flood", "texture-lines"],
            Differs,
            ANY_SIDE,
        )
        .expect_of(Curves, &["smoothing", "boundary-curve"], Differs, WINDING)
        .expect_of(Curves, &["interpolated-contours"], Differs, NO_BORDER)
        .expect_of(Fill, &["normal-map-hull"], Differs, BLUNT),
        Row::new("inverted part", "two tori, one of them inside out", || {
            Scene::of(joined(&[&torus(), &inside_out(&moved(&torus(), Vec3::new(0.5, 2.0, 0.25)))]))
        })
        .beside("two tori", two_tori)
        .expect_of(
            Lines,
            &["image-precision", "inverted-hull"],
            Differs,
            "of the inverted torus the faces that are seen are back; `--orient` turns it",
        ),
        Row::new("open, from the front", "a curved sheet from its outer side", || sheet(Vec3::new(0.8, 3.0, 1.3)))
            .expect_of(Lines, &["image-precision"], Empty, NO_BACK)
            .expect_of(Lines, &["inverted-hull"], Empty, NO_HULL_RIM)
            .expect_of(Lines, &["texture-lines"], Differs, OPEN_HULL)
            .expect_of(Curves, &["interpolated-contours"], Empty, NO_BORDER)
            .expect_all_of_randomized(),
        from_inside(Row::new("open, from behind", "the same sheet from its inner side", || {
            sheet(Vec3::new(0.8, -3.0, 1.3))
        }))
        .expect_of(
            Lines,
            &["image-precision", "inverted-hull", "gbuffer-filter", "jump-flood", "texture-lines"],
            Differs,
            ANY_SIDE,
        )
        .expect_of(Fill, &["texture"], Differs, OPEN_HULL),
        Row::new("one triangle", "a triangle from its outer side", || of_triangle(3.0))
            .beside("triangle", || of_triangle(3.01))
            .expect_of(Lines, &["image-precision"], Empty, NO_BACK)
            .expect_of(Lines, &["inverted-hull"], Empty, NO_HULL_RIM)
            .expect_of(Lines, &["texture-lines"], Differs, OPEN_HULL)
            .expect_of(Curves, &["interpolated-contours"], Empty, NO_BORDER)
            .expect_all_of_randomized(),
        from_inside(Row::new("from behind", "the same triangle from its inner side", || of_triangle(-3.0)))
            .beside("triangle from behind", || of_triangle(-3.01)),
        Row::new("no face", "a mesh of no vertex and no face", || {
            Scene::seen(empty(), looking(Vec3::new(1.0, 2.0, 3.0), Vec3::ZERO, 45.0))
        })
        .expect(Who::All, Empty, "there is nothing to find and nothing to draw"),
    ]
}
