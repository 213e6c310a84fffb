//! Scenes that break the usual assumptions: each yields what brute force yields, or a clear error, and never a panic.

use crate::rays::{Tally, compare};
use crate::scenes::{all_lines, finder, framing};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::view::MAX_VIEWPORT;
use silhouette_core::{Camera, EdgeId, NoProgress, Projection, Topology, TriangleMesh};
use silhouette_testing::directions::spread;
use silhouette_testing::edges::edge_ends;
use silhouette_testing::edits::{inside_out, joined, keeping, moved, turned_over, with_triangles};
use silhouette_testing::lattice_scenes::{FAMILIES, camera, scene};
use silhouette_testing::prepare::prepared;
use silhouette_testing::views::look;
use silhouette_testing::{Random, builtin, zoo};
use silhouette_visibility::{LineFinder, LineOptions, LineScene, Lines, SegmentSource};
use std::collections::BTreeSet;

/// Silhouette and boundary edges alone, and every mesh edge.
fn all_options() -> [LineOptions; 2] {
    [LineOptions::default(), LineOptions { mesh: true, ..LineOptions::default() }]
}

/// Holds lines against brute force in about `wanted` points, and their pixels against the border of the picture. Yields what
/// the comparison saw, or what is wrong.
fn hold(mesh: &TriangleMesh, lines: &Lines, wanted: usize, what: &str) -> Result<Tally, String> {
    let [width, height] = lines.camera.size().map(f64::from);
    for pixel in lines.chains.iter().flat_map(|chain| chain.pixels) {
        let margin = 1e-6 * width.max(height);
        let is_inside = (-margin..=width + margin).contains(&pixel.x) && (-margin..=height + margin).contains(&pixel.y);
        if !is_inside {
            return Err(format!("{what}: {pixel} in a picture of {width}x{height}"));
        }
    }
    let tally = compare(mesh, lines, wanted);
    if tally.wrong > 0 { Err(format!("{what}: {tally:?}")) } else { Ok(tally) }
}

/// The same, where nothing may be wrong.
fn check(mesh: &TriangleMesh, lines: &Lines, wanted: usize, what: &str) -> Tally {
    hold(mesh, lines, wanted, what).unwrap_or_else(|wrong| panic!("{wrong}"))
}

/// Checks a mesh from several sides, perspective and orthographic; yields what all comparisons saw together.
fn check_around(mesh: &TriangleMesh, views: usize, what: &str) -> Tally {
    let mut sum = Tally::default();
    for (index, direction) in spread(views).chain([DVec3::Z, DVec3::new(1.0, 0.0, 1.0)]).enumerate() {
        let camera = framing(mesh, direction, index % 2 == 0);
        for options in all_options() {
            let tally = check(mesh, &all_lines(mesh, &camera, &options), 400, &format!("{what} from {direction}"));
            sum.samples += tally.samples;
            sum.hidden += tally.hidden;
            sum.ties += tally.ties;
        }
    }
    eprintln!("{what}: {sum:?}");
    assert!(sum.samples > 400, "{what}: {sum:?}");
    sum
}

fn triangles(corners: &[[f32; 3]], triangles: &[[u32; 3]]) -> TriangleMesh {
    TriangleMesh::new(corners.iter().copied().map(Vec3::from).collect(), triangles.to_vec()).unwrap()
}

#[test]
fn coincident_faces() {
    for name in ["cube", "torus:16,12", "grid:4,4", "gear"] {
        let mesh = builtin(name);
        check_around(&joined(&[&mesh, &mesh]), 3, name);
        let reversed = inside_out(&mesh);
        check_around(&joined(&[&mesh, &reversed]), 3, &format!("{name} and its reverse"));
    }
    // The same faces over the same vertices: each edge has four faces.
    let cube = builtin("cube");
    let twice = [cube.triangles(), cube.triangles()].concat();
    check_around(&with_triangles(&cube, twice), 3, "each face twice");
    // Cubes that share a side, and one that stands on a larger one: faces in one plane, overlapping in part.
    check_around(&joined(&[&cube, &moved(&cube, Vec3::new(2.0, 0.0, 0.0))]), 4, "two cubes side by side");
    check_around(&joined(&[&cube, &moved(&cube, Vec3::new(1.0, 2.0, 0.5))]), 4, "a cube on a cube");
}

#[test]
fn meshes_that_pass_through_each_other() {
    let cube = builtin("cube");
    for by in [Vec3::new(0.7, 0.4, 0.9), Vec3::new(1.0, 1.0, 0.0), Vec3::new(0.0, 1.0, 0.0)] {
        let seen = check_around(&joined(&[&cube, &moved(&cube, by)]), 6, &format!("cubes {by} apart"));
        assert!(seen.hidden > 0);
    }
    let blob = builtin("blob:2000");
    let reach = blob.bounds().unwrap().radius as f32;
    let seen = check_around(&joined(&[&blob, &moved(&blob, Vec3::new(0.6, 0.3, -0.2) * reach)]), 3, "two blobs");
    assert!(seen.hidden > seen.samples / 10, "{seen:?}");
    check_around(&joined(&[&builtin("torus:24,16"), &builtin("grid:6,6"), &cube]), 3, "torus, sheet and cube");
}

#[test]
fn t_junctions() {
    // A vertex of the two small faces lies in the middle of the large one's edge, exactly and not quite.
    for middle in [0.0, 1e-6] {
        let corners = [
            [-1.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, -0.5],
            [0.0, middle, 0.0],
            [-0.7, -1.0, -0.6],
            [0.7, -1.0, 0.3],
        ];
        let mesh = triangles(&corners, &[[0, 1, 2], [0, 4, 3], [3, 5, 1]]);
        check_around(&mesh, 8, &format!("a T-junction, {middle} off"));
    }
}

#[test]
fn open_and_non_manifold_meshes() {
    for name in ["grid:6,5", "moebius", "cone"] {
        check_around(&builtin(name), 4, name);
    }
    let holes = keeping(&builtin("torus:24,16"), |face| face % 5 != 0 && face % 7 != 0);
    check_around(&holes, 4, "a torus with holes");
    // A book: seven pages around one spine, their winding alternating; the first one twice.
    let page = |index: u32| {
        let (sin, cos) = (index as f32 * 0.8).sin_cos();
        [[cos, 1.0, sin], [cos, -1.0, sin]]
    };
    let corners: Vec<[f32; 3]> = [[0.0, 1.0, 0.0], [0.0, -1.0, 0.0]].into_iter().chain((0..7).flat_map(page)).collect();
    let faces = |index: u32| {
        let [top, bottom] = [2 + 2 * index, 3 + 2 * index];
        if index.is_multiple_of(2) { [[0, 1, bottom], [0, bottom, top]] } else { [[0, bottom, 1], [0, top, bottom]] }
    };
    let pages: Vec<[u32; 3]> = (0..7).flat_map(faces).chain(faces(0)).collect();
    check_around(&triangles(&corners, &pages), 8, "a book");
}

#[test]
fn inconsistent_winding() {
    for name in ["cube", "torus:16,12", "knot", "gear"] {
        check_around(&turned_over(&builtin(name), |face| face % 3 == 0 || face % 7 == 2), 3, name);
        check_around(&inside_out(&builtin(name)), 2, name);
    }
}

#[test]
fn needles_and_faces_without_area() {
    let torus = builtin("torus:16,12");
    let faces = torus.triangles().iter().flat_map(|&[a, b, c]| {
        // A face along an edge and back, one that is a point, and the true one.
        [[a, b, a], [c, c, c], [a, b, c]]
    });
    check_around(&with_triangles(&torus, faces.collect()), 3, "faces of two corners");
    // Slivers: corners on a line, exactly or but for a last bit; needles a millionth as wide as long.
    let mut corners = Vec::new();
    for index in 0..24_u32 {
        let at = index as f32 / 24.0;
        let width = [0.0, 1e-6, 1e-3][index as usize % 3];
        corners.extend([[-1.0, at, -at], [1.0, at + width, 0.3 - at], [0.25, at + width * 0.6, 0.1875 - at]]);
    }
    let faces: Vec<[u32; 3]> = (0..24).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
    check_around(&joined(&[&triangles(&corners, &faces), &builtin("cube")]), 4, "needles");
}

#[test]
fn nothing_to_draw() {
    let points = triangles(&[[0.0; 3], [1.0; 3]], &[[0, 0, 0], [1, 1, 1], [0, 1, 0]]);
    let camera = look(Vec3::new(3.0, 2.0, 1.0), Vec3::ZERO, 40.0, [64, 64]);
    for options in all_options() {
        assert!(all_lines(&zoo::empty(), &camera, &options).chains.is_empty());
        check(&points, &all_lines(&points, &camera, &options), 50, "faces that are points");
    }
    let scene = LineScene::of_meshes(&[]).unwrap();
    let mut finder = LineFinder::new(scene, &NoProgress).unwrap();
    assert!(finder.find(&camera, &LineOptions::default(), &NoProgress).unwrap().chains.is_empty());
}

#[test]
fn a_mesh_behind_the_eye_shows_nothing() {
    for name in ["cube", "knot"] {
        let mesh = builtin(name);
        for direction in spread(6) {
            let camera = framing(&mesh, direction, true);
            let away = look(camera.eye(), camera.eye() * 2.0 - camera.target(), 100.0, [640, 480]);
            for options in all_options() {
                assert!(all_lines(&mesh, &away, &options).chains.is_empty(), "{name} from {direction}");
            }
        }
    }
}

/// Eyes in places where sight lines run along edges and through vertices, or start in a face. Where `in_a_face`, those that
/// a face contains, and otherwise the others.
fn eyes_close_by(in_a_face: bool) {
    let mut failures = Vec::new();
    for name in ["cube", "torus:16,12", "gear", "grid:6,6", "knot", "moebius"] {
        let mesh = builtin(name);
        let middle = |points: &[Vec3]| points.iter().sum::<Vec3>() / points.len() as f32;
        let mut eyes = Vec::new();
        for face in [0, mesh.face_count() / 2] {
            let corners = mesh.triangles()[face].map(|vertex| mesh.positions()[vertex as usize]);
            if in_a_face {
                eyes.push(("a vertex", corners[0]));
                eyes.push(("an edge", middle(&corners[..2])));
                eyes.push(("a face", middle(&corners)));
            } else {
                eyes.push(("the middle", Vec3::ZERO));
                eyes.push(("the tube", Vec3::new(1.0, 0.125, 0.0)));
                eyes.push(("the plane of a face", corners[0] + (corners[1] - corners[0]) * 4.0));
                eyes.push(("the line of an edge", corners[1] + (corners[1] - corners[2]) * 2.0));
            }
        }
        for (place, eye) in eyes {
            for toward in [Vec3::X, Vec3::NEG_Z, Vec3::new(0.3, -0.8, 0.5), Vec3::new(-1.0, 1.0, 0.0)] {
                let camera = look(eye, eye + toward, 110.0, [512, 384]);
                for options in all_options() {
                    let what = format!("{name} from {place}, {eye}, towards {toward}");
                    failures.extend(hold(&mesh, &all_lines(&mesh, &camera, &options), 150, &what).err());
                }
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn an_eye_inside_the_mesh_or_in_line_with_its_faces() {
    eyes_close_by(false);
}

/// A face that contains the eye is seen edge-on, all around the eye, and hides nothing.
#[test]
fn an_eye_on_the_mesh() {
    eyes_close_by(true);
}

#[test]
fn a_mesh_partly_behind_the_eye_is_clipped() {
    let mut samples = 0;
    for name in ["knot", "torus:24,16", "grid:6,6"] {
        let mesh = builtin(name);
        let reach = mesh.bounds().unwrap().radius as f32;
        for direction in spread(8) {
            let eye = direction.as_vec3() * (0.4 * reach);
            for fov_deg in [60.0, 150.0] {
                let camera = look(eye, Vec3::new(0.1, 0.2, -0.1) * reach, fov_deg, [640, 480]);
                for options in all_options() {
                    let what = format!("{name} from {eye}, {fov_deg} degrees");
                    samples += check(&mesh, &all_lines(&mesh, &camera, &options), 200, &what).samples;
                }
            }
        }
    }
    assert!(samples > 8000, "{samples}");
}

#[test]
fn extreme_fields_of_view_and_viewports() {
    let mesh = builtin("torus:24,16");
    let mut samples = 0;
    let mut view = |eye: Vec3, fov_deg: f64, size: [u32; 2]| {
        let camera = look(eye, Vec3::new(0.9, 0.1, 0.2), fov_deg, size);
        for options in all_options() {
            let what = format!("from {eye}, {fov_deg} degrees, {size:?}");
            samples += check(&mesh, &all_lines(&mesh, &camera, &options), 200, &what).samples;
        }
    };
    for size in [[1, 1], [1, MAX_VIEWPORT], [MAX_VIEWPORT, MAX_VIEWPORT], [512, 512]] {
        for fov_deg in [0.01, 1.0, 40.0, 179.0, 179.99] {
            view(Vec3::new(2.0, 3.0, 2.5), fov_deg, size);
        }
        view(Vec3::new(2e4, 3e4, 2.5e4), 0.01, size);
        view(Vec3::new(1.5, 0.4, 0.1), 179.0, size);
    }
    assert!(samples > 3000, "{samples}");
}

/// A flat sheet of which every face is seen edge-on and every edge lies over others: all of it is drawn, and nothing hides
/// anything.
fn check_edge_on(name: &str, least_edges: usize, options: &LineOptions) {
    let mesh = builtin(name);
    let topology = Topology::new(&mesh);
    let drawn = topology.edges().ids().filter(|&edge| options.mesh || topology.half_edges(edge).len() == 1);
    let ends: Vec<[DVec3; 2]> = drawn.map(|edge| edge_ends(&mesh, &topology, edge)).collect();
    assert!(topology.edge_count() > least_edges, "{}", topology.edge_count());
    let mut finder = finder(mesh);
    let projections = [Projection::Orthographic { height: 3.0 }, Projection::Perspective { fov_y_rad: 0.7 }];
    for (eye, projection) in [Vec3::new(0.0, 0.0, 4.0), Vec3::new(3.0, 0.0, 4.0)].into_iter().zip(projections) {
        let camera = Camera::new(eye, Vec3::ZERO, Vec3::Y, projection, [1024, 1024]).unwrap();
        let lines = finder.find(&camera, options, &NoProgress).unwrap();
        let pixel = |point: DVec3| camera.project(point).unwrap().pixel;
        let expected: f64 = ends.iter().map(|&[a, b]| pixel(a).distance(pixel(b))).sum();
        let found: f64 = lines.chains.iter().map(|chain| chain.length_px()).sum();
        assert!((found - expected).abs() < 1e-6 * expected, "{found} px of {expected} px from {eye}");
    }
}

#[test]
fn the_boundary_of_a_million_edges_seen_edge_on() {
    check_edge_on("grid:578,578", 1_000_000, &LineOptions::default());
}

#[test]
fn all_edges_of_a_sheet_seen_edge_on() {
    check_edge_on("grid:64,64", 12_000, &LineOptions { mesh: true, ..LineOptions::default() });
}

/// Many faces in one place, around one vertex, and around one edge: a result, and a true one.
#[test]
fn crowds_of_faces() {
    let pile = triangles(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], &[[0, 1, 2]; 3000]);
    let sectors = 1500_u32;
    let turn = |sector: u32| sector as f32 * std::f32::consts::TAU / sectors as f32;
    let rim = (0..sectors).map(|sector| [turn(sector).cos(), turn(sector).sin(), 0.0]);
    let cone: Vec<[f32; 3]> = [[0.0, 0.0, 1.0]].into_iter().chain(rim.clone()).collect();
    let next = |sector: u32| 1 + (sector + 1) % sectors;
    let cone = triangles(&cone, &(0..sectors).map(|sector| [0, 1 + sector, next(sector)]).collect::<Vec<_>>());
    let spine = [[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]];
    let book: Vec<[f32; 3]> = spine.into_iter().chain(rim.take(400)).collect();
    let book = triangles(&book, &(0..400).map(|leaf| [0, 1, 2 + leaf]).collect::<Vec<_>>());
    let all_edges = LineOptions { mesh: true, max_invisibility: u32::MAX, ..LineOptions::default() };
    for (name, mesh, least) in [("pile", pile, 3), ("cone", cone, 3000), ("book", book, 801)] {
        let scene = LineScene::new(prepared(mesh.clone()));
        let mut finder = LineFinder::for_many_views(scene, &NoProgress).unwrap();
        let camera = framing(&mesh, DVec3::new(0.3, 0.2, 1.0), true);
        let lines = finder.find(&camera, &all_edges, &NoProgress).unwrap();
        assert!(lines.stats.edges >= least && !lines.chains.is_empty(), "{name}: {:?}", lines.stats);
        check(&mesh, &lines, 300, name);
    }
}

/// With every mesh edge wanted, excluding other kinds of lines removes no edge.
#[test]
fn every_edge_is_drawn_whatever_else_is_wanted() {
    let (mut scenes, mut fewer) = (0, 0);
    for seed in 0..200 {
        let mut random = Random::new(seed);
        let mesh = scene(FAMILIES[random.below(FAMILIES.len())], &mut random);
        let Some(camera) = camera(&mesh, &mut random) else { continue };
        let drawn = |options: &LineOptions| -> BTreeSet<EdgeId> {
            let lines = all_lines(&mesh, &camera, options);
            let sources = lines.chains.iter().flat_map(|chain| chain.sources.to_vec());
            sources
                .filter_map(|source| if let SegmentSource::Edge(edge) = source { Some(edge) } else { None })
                .collect()
        };
        let every = LineOptions { mesh: true, ..LineOptions::default() };
        let expected = drawn(&every);
        for options in [
            LineOptions { back_boundary: false, ..every.clone() },
            LineOptions { boundary: false, silhouette: false, ..every.clone() },
            LineOptions { ridge_deg: Some(30.0), valley_deg: Some(30.0), ..every.clone() },
        ] {
            assert!(drawn(&options) == expected, "seed {seed}: {options:?}");
        }
        fewer += usize::from(drawn(&LineOptions { mesh: false, ..every }).len() < expected.len());
        scenes += 1;
    }
    assert!(scenes > 150 && fewer * 2 > scenes, "{fewer} of {scenes}");
}
