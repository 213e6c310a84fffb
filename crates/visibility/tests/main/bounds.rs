//! Upper bounds of a view's memory and work.

use crate::determinism::options;
use crate::scenes::{finder, framing};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::{Camera, NoProgress, Projection, TriangleMesh};
use silhouette_testing::{Random, builtin, skipped, with_threads};
use silhouette_visibility::{LineError, LineOptions};

/// Peak of what a view allocates, in bytes, and the edges and contours that it looked at.
fn peak(name: &str, options: &LineOptions) -> (u64, u64) {
    with_threads(1, || {
        let mesh = builtin(name);
        let camera = framing(&mesh, DVec3::new(0.5, 0.4, 1.0), true);
        let mut finder = finder(mesh);
        let mut items = 0;
        let allocated = allocation_counter::measure(|| {
            let lines = finder.find(&camera, options, &NoProgress).unwrap();
            items = lines.stats.edges + lines.stats.contours + lines.stats.events;
        });
        (allocated.bytes_max, items)
    })
}

/// Bytes that an edge, contour or event may take at the peak: an edge as stroke (112), clipped (64), in a piece (80),
/// placed (150) and in two sets of chains (2 x 150), each array up to twice as long as it is full.
const BYTES_PER_ITEM: u64 = 1400;

/// Bytes per face, for the facings and the silhouette of any view.
const BYTES_PER_FACE: u64 = 8;

#[test]
fn memory_of_a_view_grows_with_what_is_drawn() {
    for name in ["icosphere:3", "icosphere:5", "torus:64,32", "knot", "grid:200,200"] {
        for options in [LineOptions::default(), options()] {
            let (bytes, items) = peak(name, &options);
            let faces = builtin(name).face_count() as u64;
            eprintln!("{name}: {bytes} bytes, {items} items, {faces} faces");
            let bound = items * BYTES_PER_ITEM + faces * BYTES_PER_FACE + (1 << 16);
            assert!(bytes < bound, "{name}: {bytes} bytes for {items} edges, contours and events");
        }
    }
}

/// Lines of sight that run along the sheet meet hundreds of faces each, more than a view may look at. Takes as long as a view
/// may take, and is therefore left to thorough runs.
#[test]
fn all_of_a_million_edges_seen_edge_on_are_refused() {
    if std::env::var_os("SILHOUETTES_ORACLE").is_none() {
        return skipped("all_of_a_million_edges_seen_edge_on_are_refused", "SILHOUETTES_ORACLE is not set");
    }
    let mut finder = finder(builtin("grid:578,578"));
    let projection = Projection::Orthographic { height: 3.0 };
    let camera = Camera::new(Vec3::new(0.0, 0.0, 4.0), Vec3::ZERO, Vec3::Y, projection, [1024, 1024]).unwrap();
    let options = LineOptions { mesh: true, ..LineOptions::default() };
    assert_eq!(finder.find(&camera, &options, &NoProgress).unwrap_err(), LineError::TooCrowded);
}

/// Meshes in which nearly all faces overlap, with the most expensive options: each is drawn or refused, and allocates less
/// than 1 GiB.
#[test]
fn tangles_are_drawn_or_refused_within_a_gibibyte() {
    let mut random = Random::new(7);
    let mut place = || random.unit() as f32;
    let mut needles = Vec::new();
    for _ in 0..6000 {
        needles.extend([-1.0, 1.0, 0.0].map(|x| [x, place(), place()]));
    }
    let across = |at: usize| at as f32 / 1500.0 - 1.0;
    let lattice = (0..3000).flat_map(|at| {
        let (from, to) = (across(at), across(at) + 1e-4);
        [
            [[-1.0, from, 0.0], [1.0, from, 0.0], [1.0, to, 1e-4]],
            [[from, -1.0, 1.0], [from, 1.0, 1.0], [to, 1.0, 1.0001]],
        ]
    });
    let lattice: Vec<[f32; 3]> = lattice.flatten().collect();
    let apart = |corners: &[[f32; 3]]| {
        let faces = (0..corners.len() as u32 / 3).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
        TriangleMesh::new(corners.iter().copied().map(Vec3::from).collect(), faces).unwrap()
    };
    let every = LineOptions { mesh: true, outline: true, max_invisibility: u32::MAX, ..LineOptions::default() };
    let all = [LineOptions::default(), LineOptions { intersection: true, ..LineOptions::default() }, every];
    let mut refused = 0;
    for (name, mesh) in [("needles", apart(&needles)), ("lattice", apart(&lattice)), ("cone", builtin("cone:65536"))] {
        let camera = framing(&mesh, DVec3::new(0.3, 0.2, 1.0), true);
        for options in &all {
            let mut result = None;
            // The counter sees one thread only.
            let allocated = with_threads(1, || {
                allocation_counter::measure(|| {
                    result = Some(finder(mesh.clone()).find(&camera, options, &NoProgress));
                })
            });
            let outcome = result.unwrap().map(|lines| lines.chains.len());
            eprintln!("{name}: {outcome:?}, {} MB", allocated.bytes_max >> 20);
            assert!(allocated.bytes_max < 1 << 30, "{name}: {} bytes", allocated.bytes_max);
            refused += usize::from(outcome.is_err());
        }
    }
    assert!(refused > 0, "no limit was reached");
}

/// The same face listed 3000 times, and chains of faces without area, each listed 3000 times.
#[test]
fn faces_listed_thousands_of_times_are_drawn() {
    let corners: Vec<Vec3> = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [4.0, 0.0], [8.0, 0.0], [0.0, 3.0]]
        .map(|[x, y]| Vec3::new(x, y, 0.0))
        .to_vec();
    let heap = |faces: &[[u32; 3]]| {
        let faces = faces.iter().flat_map(|&face| [face; 3000]).collect();
        TriangleMesh::new(corners.clone(), faces).unwrap()
    };
    for (mesh, drawn) in [(heap(&[[0, 1, 5]]), 3), (heap(&[[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]]), 3)] {
        let camera = framing(&mesh, DVec3::Z, true);
        let lines = finder(mesh).find(&camera, &LineOptions::default(), &NoProgress).unwrap();
        let edges: usize = lines.chains.iter().map(|chain| chain.sources.len()).sum();
        assert!(edges >= drawn, "{edges} edges");
    }
}
