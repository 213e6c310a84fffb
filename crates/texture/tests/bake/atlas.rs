//! Every texel of every block lies on the hull, and filtering stays within blocks.

use proptest::prelude::*;
use silhouette_core::TriangleMesh;
use silhouette_core::glam::{DVec3, Vec2, Vec3};
use silhouette_core::shapes::Sphere;
use silhouette_testing::{edits, strategies, zoo};
use silhouette_texture::atlas::{Atlas, AtlasError, Block, Place};
use silhouette_texture::{Hull, VolumeSize};
use std::collections::HashSet;

const SIZE: VolumeSize = VolumeSize { width: 96, height: 80, azimuths: 4, pages: 2 };

fn position(mesh: &TriangleMesh, place: &Place) -> DVec3 {
    let corners = mesh.corners(place.face).map(Vec3::as_dvec3);
    (0..3).map(|at| f64::from(place.weights[at]) * corners[at]).sum()
}

fn texels(atlas: &Atlas) -> impl Iterator<Item = (&Block, u32, u32)> {
    let side = atlas.side();
    atlas.blocks().iter().flat_map(move |block| (0..side * side).map(move |at| (block, at % side, at / side)))
}

/// What must hold of any hull.
fn check(mesh: &TriangleMesh, gutter: u32) {
    let hull = Hull::trusted(mesh.clone());
    let atlas = Atlas::new(&hull, SIZE, gutter).unwrap();
    let (side, places) = (atlas.side(), atlas.places());

    // Each face lies in one block, and blocks do not overlap.
    let mut faces = HashSet::new();
    let mut taken = HashSet::new();
    for block in atlas.blocks() {
        for half_edge in [Some(block.first), block.second].into_iter().flatten() {
            assert!(faces.insert(half_edge.face()));
        }
        assert!(block.page < SIZE.pages && block.x + side <= SIZE.width && block.y + side <= SIZE.height);
        assert!(block.x % side == 0 && block.y % side == 0 && taken.insert((block.page, block.x, block.y)));
    }
    assert_eq!(faces.len(), mesh.face_count());

    for (block, x, y) in texels(&atlas) {
        let Place { face, weights } = atlas.point(block, f64::from(x), f64::from(y));
        assert!(weights.min_element() >= 0.0 && (weights.element_sum() - 1.0).abs() < 1e-5, "{weights}");
        // A texel within a face lies where the face's own texture coordinates say.
        let own = [Some(block.first), block.second].into_iter().flatten().any(|half_edge| half_edge.face() == face);
        let is_inner = (gutter..side - gutter).contains(&x) && (gutter..side - gutter).contains(&y);
        if own && is_inner && weights.min_element() > 1e-6 {
            let size = Vec2::new(SIZE.width as f32, SIZE.height as f32);
            let corners = places[face.index()].corners;
            let uv: Vec2 = (0..3).map(|corner| weights[corner] * corners[corner]).sum();
            let texel = Vec2::new((block.x + x) as f32 + 0.5, (block.y + y) as f32 + 0.5);
            assert!((uv * size - texel).length() < 1e-2, "{uv} {texel}");
        }
    }

    // Bilinear filtering at any point of a face gives weight to texels of its block only, inside the gutter.
    for block in atlas.blocks() {
        for half_edge in [Some(block.first), block.second].into_iter().flatten() {
            for corner in places[half_edge.face().index()].corners {
                let at = corner * Vec2::new(SIZE.width as f32, SIZE.height as f32) - 0.5;
                let (low, high) = (gutter as f32, (side - gutter - 1) as f32);
                let at = at - Vec2::new(block.x as f32, block.y as f32);
                assert!(at.min_element() > low - 1e-3 && at.max_element() < high + 1e-3, "{at}");
                assert_eq!(places[half_edge.face().index()].page, block.page);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn hulls_of_any_kind_are_laid_out(
        mesh in prop_oneof![strategies::closed_mesh(), strategies::open_mesh(), strategies::soup(40)],
        gutter in 0_u32..3,
    ) {
        prop_assume!(mesh.face_count() > 0);
        check(&mesh, gutter);
    }
}

/// Neighbouring texels, across the diagonal and into the gutter, are neighbours on the hull: no jump anywhere.
#[test]
fn texels_next_to_each_other_lie_next_to_each_other() {
    let mesh = edits::shaken(&Sphere::default().icosphere(2).unwrap(), 0.05, 3);
    let atlas = Atlas::new(&Hull::trusted(mesh.clone()), SIZE, 1).unwrap();
    let longest = silhouette_testing::edges::longest_edge(&mesh);
    for (block, x, y) in texels(&atlas) {
        let at = |x: u32, y: u32| position(&mesh, &atlas.point(block, f64::from(x), f64::from(y)));
        // The four corners of a block's gutter lie beyond a vertex, on one neighbour or the other.
        let is_corner = |x: u32, y: u32| [x, y].iter().all(|&at| at == 0 || at == atlas.side() - 1);
        for (dx, dy) in [(1, 0), (0, 1)] {
            if is_corner(x, y) || is_corner(x + dx, y + dy) {
                continue;
            }
            if x + dx < atlas.side() && y + dy < atlas.side() {
                let step = at(x, y).distance(at(x + dx, y + dy));
                assert!(step < 1.6 * longest / f64::from(atlas.side() - 3), "{step}");
            }
        }
    }
}

/// A gutter texel is as far from the edge as its mirror image within the face, but on the neighbour.
#[test]
fn gutter_texels_are_unfolded_onto_the_neighbour() {
    let mesh = zoo::builtin("icosphere:0");
    let atlas = Atlas::new(&Hull::trusted(mesh.clone()), SIZE, 2).unwrap();
    let edge =
        mesh.positions()[mesh.triangles()[0][0] as usize].distance(mesh.positions()[mesh.triangles()[0][1] as usize]);
    for block in atlas.blocks() {
        let middle = f64::from(atlas.side()) / 2.0;
        let outside = atlas.point(block, 1.0, middle - 1.0);
        assert_ne!(outside.face, block.first.face());
        let inside = atlas.point(block, 3.0, middle - 1.0);
        assert_eq!(inside.face, block.first.face());
        // All faces are alike: one texel off an edge is the same distance on either side.
        let away = |place: &Place| f64::from(place.weights.min_element());
        assert!((away(&outside) - away(&inside)).abs() < 1e-5, "{outside:?} {inside:?}");
        let apart = position(&mesh, &outside).distance(position(&mesh, &inside));
        assert!(apart > 0.0 && apart < f64::from(edge) * 0.5);
    }
}

#[test]
fn closed_hulls_are_nearly_all_paired() {
    for (name, mesh) in zoo::closed() {
        let size = VolumeSize { width: 1024, height: 1024, azimuths: 3, pages: 1 };
        let Ok(atlas) = Atlas::new(&Hull::trusted(mesh.clone()), size, 1) else { continue };
        let alone = atlas.blocks().iter().filter(|block| block.second.is_none()).count();
        assert!(alone * 50 <= mesh.face_count(), "{name}: {alone} of {}", mesh.face_count());
    }
}

#[test]
fn a_hull_that_does_not_fit_says_what_would() {
    let hull = Hull::trusted(Sphere::default().icosphere(4).unwrap());
    let size = VolumeSize { width: 64, height: 64, azimuths: 8, pages: 1 };
    let Err(AtlasError::TooSmall { faces, least_side, least_pages, .. }) = Atlas::new(&hull, size, 1) else {
        panic!("5120 faces on 4096 texels");
    };
    assert_eq!(faces, 5120);
    let side = least_side as u32;
    assert!(Atlas::new(&hull, VolumeSize { width: side, height: side, ..size }, 1).is_ok());
    assert!(Atlas::new(&hull, VolumeSize { pages: least_pages as u32, ..size }, 1).is_ok());
    assert!(Atlas::new(&hull, VolumeSize { pages: least_pages as u32 - 1, ..size }, 1).is_err());
    assert!(matches!(Atlas::new(&hull, VolumeSize { azimuths: 0, ..size }, 1), Err(AtlasError::Size(_))));
    assert!(matches!(Atlas::new(&Hull::trusted(zoo::empty()), size, 1), Err(AtlasError::NoFaces)));
    assert!(matches!(Atlas::new(&hull, size, 9), Err(AtlasError::Gutter(9))));
}
