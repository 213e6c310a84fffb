//! Meshes that are no closed, consistently wound manifolds.

use crate::meshes::{torus, triangle};
use crate::row::Row;
use crate::scene::{Scene, looking};
use silhouette_core::glam::Vec3;
use silhouette_testing::edits::{inside_out, joined, moved};
use silhouette_testing::zoo::{book, empty, finned_blob};
use silhouette_testing::builtin;

fn sheet(eye: Vec3) -> Scene {
    Scene::seen(builtin("grid:20,14"), looking(eye, Vec3::ZERO, 45.0))
}

fn of_triangle(z: f32) -> Scene {
    Scene::seen(triangle(), looking(Vec3::new(0.5, 0.4, z), Vec3::new(0.3, 0.3, 0.0), 45.0))
}

fn two_tori() -> Scene {
    Scene::of(joined(&[&torus(), &moved(&torus(), Vec3::new(0.5, 2.0, 0.25))]))
}

/// The rows.
pub fn rows() -> Vec<Row> {
    vec![
        Row::new("three faces per edge", "a book of three pages, of which all run the same way along its back", || {
            Scene::of(book(3))
        }),
        Row::new("fin", "a closed blob with a third face on one edge, and one face turned over", || {
            Scene::of(finned_blob())
        }),
        Row::new("Moebius strip", "a strip that no winding makes consistent", || Scene::of(builtin("moebius:24,2"))),
        Row::new("inverted part", "two tori, one of them inside out", || {
            Scene::of(joined(&[&torus(), &inside_out(&moved(&torus(), Vec3::new(0.5, 2.0, 0.25)))]))
        })
        .beside("two tori", two_tori),
        Row::new("open, from the front", "a curved sheet from its outer side", || sheet(Vec3::new(0.8, 3.0, 1.3))),
        Row::new("open, from behind", "the same sheet from its inner side", || sheet(Vec3::new(0.8, -3.0, 1.3))),
        Row::new("one triangle", "a triangle from its outer side", || of_triangle(3.0))
            .beside("triangle", || of_triangle(3.01)),
        Row::new("from behind", "the same triangle from its inner side", || of_triangle(-3.0))
            .beside("triangle from behind", || of_triangle(-3.01)),
        Row::new("no face", "a mesh of no vertex and no face", || {
            Scene::seen(empty(), looking(Vec3::new(1.0, 2.0, 3.0), Vec3::ZERO, 45.0))
        }),
    ]
}
