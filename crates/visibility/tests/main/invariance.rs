//! What a drawing must not depend on: the winding of a solid, and the order of vertices and faces.

use crate::scenes::{all_lines, framing};
use silhouette_core::glam::{DVec3, Vec3};
use silhouette_core::{Camera, Topology, TriangleMesh, VertexId};
use silhouette_testing::directions::AXES;
use silhouette_testing::edits::{inside_out, permuted};
use silhouette_testing::lattice_scenes::{FAMILIES, camera, scene};
use silhouette_testing::{Random, builtin, zoo};
use silhouette_visibility::{LineKind, LineOptions, Lines, SegmentSource};
use std::collections::BTreeSet;

/// A stretch of a line: why it is drawn, how many layers hide it, the places of its edge's ends, and the parameters between
/// which it lies, in millionths.
type Stretch = (LineKind, u32, [[u32; 3]; 2], [i64; 2]);

/// All stretches of a drawing, without the id of any vertex or face. Those that continue each other are one.
fn stretches(mesh: &TriangleMesh, lines: &Lines) -> BTreeSet<Stretch> {
    let topology = Topology::new(mesh);
    let mut all = BTreeSet::new();
    for chain in lines.chains.iter() {
        for (segment, source) in chain.sources.iter().enumerate() {
            let SegmentSource::Edge(edge) = *source else { panic!("only mesh edges were asked for") };
            let mut ends = topology.end_points(edge).map(VertexId::get).map(|vertex| mesh.positions()[vertex as usize]);
            if ends[1].to_array() < ends[0].to_array() {
                ends.swap(0, 1);
            }
            let [a, b] = ends.map(Vec3::as_dvec3);
            let points = [segment, (segment + 1) % chain.points.len()].map(|index| chain.points[index]);
            let mut range = points.map(|point| (point.distance(a) / b.distance(a) * 1e6).round() as i64);
            range.sort_unstable();
            let places = ends.map(|end| (end + Vec3::ZERO).to_array().map(f32::to_bits));
            all.insert((chain.style.kind, chain.style.invisibility, places, range));
        }
    }
    all
}

fn creases() -> LineOptions {
    LineOptions { ridge_deg: Some(30.0), valley_deg: Some(30.0), ..LineOptions::default() }
}

#[test]
fn a_solid_and_its_inverse_have_one_drawing_along_axes() {
    for (name, mesh) in zoo::closed() {
        let turned = inside_out(&mesh);
        for direction in AXES {
            for perspective in [true, false] {
                let camera = framing(&mesh, direction, perspective);
                for options in [LineOptions::default(), creases()] {
                    let [one, other] =
                        [&mesh, &turned].map(|mesh| stretches(mesh, &all_lines(mesh, &camera, &options)));
                    assert!(one.len() > 3);
                    assert!(one == other, "{name} along {direction}, perspective {perspective}");
                }
            }
        }
    }
}

/// Open sheets, too, where boundary edges of both facings are drawn.
#[test]
fn a_scene_and_its_inverse_have_one_drawing() {
    for seed in 0..400 {
        let mut random = Random::new(seed);
        let mesh = scene(FAMILIES[random.below(FAMILIES.len())], &mut random);
        let Some(camera) = camera(&mesh, &mut random) else { continue };
        let draw = |mesh: &TriangleMesh| stretches(mesh, &all_lines(mesh, &camera, &LineOptions::default()));
        assert!(draw(&mesh) == draw(&inside_out(&mesh)), "seed {seed}");
    }
}

/// Faces without area have a longest side by their coordinates, but for two of equal length, of which order decides.
fn has_a_face_without_area(mesh: &TriangleMesh) -> bool {
    mesh.triangles().iter().any(|triangle| {
        let [a, b, c] = triangle.map(|vertex| mesh.positions()[vertex as usize].as_dvec3());
        (b - a).cross(c - a) == DVec3::ZERO
    })
}

#[test]
fn any_order_of_vertices_and_faces_yields_one_drawing() {
    let check = |mesh: &TriangleMesh, camera: &Camera, options: &LineOptions, random: &mut Random, what: &str| {
        let (other, _) = permuted(mesh, random);
        let draw = |mesh: &TriangleMesh| stretches(mesh, &all_lines(mesh, camera, options));
        let (expected, found) = (draw(mesh), draw(&other));
        assert!(expected == found, "{what}");
        expected.len()
    };
    let mut random = Random::new(7);
    let cube = builtin("cube");
    for direction in AXES {
        for perspective in [true, false] {
            for _ in 0..20 {
                let camera = framing(&cube, direction, perspective);
                let drawn = check(&cube, &camera, &creases(), &mut random, "cube");
                assert!(drawn >= 8, "{drawn}: four may be seen end on");
            }
        }
    }
    let mut compared = 0;
    for seed in 0..600 {
        let mut random = Random::new(seed);
        let mesh = scene(FAMILIES[random.below(FAMILIES.len())], &mut random);
        let Some(camera) = camera(&mesh, &mut random) else { continue };
        if has_a_face_without_area(&mesh) {
            continue;
        }
        for options in [LineOptions::default(), LineOptions { mesh: true, ..creases() }] {
            check(&mesh, &camera, &options, &mut random, &format!("seed {seed}"));
            compared += 1;
        }
    }
    assert!(compared > 600, "{compared}");
}
