//! Drawings of which the camera sees a part: eyes amid a scene, on its vertices and in the planes of its faces. What is drawn has
//! to be exact, and what is not has to lie outside of the picture.

use crate::exact::drawing::{compare_edge, creases_and_mesh, drawn, pieces, without_flat_faces};
use crate::exact::moved::{Scene, Steps};
use crate::exact::rational::exact;
use crate::exact::visible::{Stretch, drawing};
use glam::DVec3;
use num_rational::BigRational;
use silhouette_core::{Camera, Projection, Topology, TriangleMesh};
use silhouette_testing::Random;
use silhouette_testing::lattice_scenes::{FAMILIES, camera, scene, seeds};
use silhouette_visibility::Chains;

/// Pixels from the border of the picture, and depth before the eye, within which a line may end.
const BORDER_PX: f64 = 0.5;
const LEAST_DEPTH: f64 = 1e-6;

/// Where a stretch may be drawn or not, as a share of its edge: next to where the picture ends.
const IN_DOUBT: f64 = 1e-7;

#[derive(Debug, Default, Clone, Copy)]
struct Tally {
    scenes: usize,
    edges: usize,
    stretches: usize,
    cut_off: usize,
    outside: usize,
}

/// Whether a point appears inside of the picture, by this margin; negative for one that must only not be far outside.
fn is_inside(camera: &Camera, point: DVec3, margin_px: f64) -> bool {
    let view = camera.view_matrix().transform_point3(point);
    if matches!(camera.projection(), Projection::Perspective { .. }) && -view.z < LEAST_DEPTH {
        return margin_px < 0.0 && -view.z > -LEAST_DEPTH;
    }
    let pixel = camera.view_to_pixel(view).pixel;
    let [width, height] = camera.size().map(f64::from);
    [pixel.x, pixel.y, width - pixel.x, height - pixel.y].into_iter().all(|inside| inside > margin_px)
}

/// The stretches as far as they lie between two parameters.
fn between(stretches: &[Stretch], [from, to]: [f64; 2]) -> Vec<Stretch> {
    let (from, to, least) = (exact(from), exact(to), exact(IN_DOUBT));
    let trimmed = stretches.iter().map(|stretch| {
        let [begin, end] = stretch.range.clone();
        // What begins with the edge begins where it is drawn from.
        let range: [BigRational; 2] = [begin.max(from.clone()), end.min(to.clone())];
        Stretch { range, invisibility: stretch.invisibility }
    });
    trimmed.filter(|stretch| &stretch.range[1] - &stretch.range[0] > least).collect()
}

fn compare(mesh: &TriangleMesh, camera: &Camera, chains: &Chains) -> Result<Tally, String> {
    let expected = drawing(&Scene::new(mesh, &camera.viewpoint(), Steps::WHOLE), creases_and_mesh());
    let pieces = pieces(mesh, &Topology::new(mesh), chains)?;
    if let Some(edge) = pieces.keys().find(|edge| !expected.contains_key(*edge)) {
        return Err(format!("edge {edge:?} is drawn"));
    }
    let mut tally = Tally { scenes: 1, ..Tally::default() };
    for (edge, (kind, stretches)) in &expected {
        let [a, b] = edge.map(|vertex| mesh.positions()[vertex as usize].as_dvec3());
        let is_outside = |[from, to]: [f64; 2]| {
            let at = |step: u32| a.lerp(b, from + (to - from) * f64::from(step) / 32.0);
            !(1..32).any(|step| is_inside(camera, at(step), BORDER_PX))
        };
        let Some(found) = pieces.get(edge) else {
            if !is_outside([0.0, 1.0]) {
                return Err(format!("edge {edge:?} is not drawn"));
            }
            tally.outside += 1;
            continue;
        };
        let range = [found[0].range[0], found[found.len() - 1].range[1]];
        for end in [[0.0, range[0]], [range[1], 1.0]] {
            if end[1] - end[0] > IN_DOUBT {
                tally.cut_off += 1;
                if !is_outside(end) {
                    return Err(format!("of edge {edge:?}, {end:?} is not drawn"));
                }
            }
        }
        if range.iter().any(|&t| !is_inside(camera, a.lerp(b, t), -BORDER_PX)) {
            return Err(format!("edge {edge:?} is drawn beyond the picture"));
        }
        let seen: Vec<_> = found.iter().filter(|piece| piece.range[1] - piece.range[0] > IN_DOUBT).copied().collect();
        let wanted = between(stretches, range);
        compare_edge(*kind, &wanted, &seen).map_err(|difference| format!("edge {edge:?}: {difference}"))?;
        tally.edges += 1;
        tally.stretches += wanted.len();
    }
    Ok(tally)
}

#[test]
fn drawings_from_amid_a_scene_are_the_exact_ones() {
    let mut sum = Tally::default();
    for family in FAMILIES {
        for seed in 0..seeds(150) {
            let mut random = Random::new(seed);
            let mesh = without_flat_faces(&scene(family, &mut random));
            let Some(camera) = camera(&mesh, &mut random) else { continue };
            let found = compare(&mesh, &camera, &drawn(&mesh, &camera, creases_and_mesh()));
            let tally = found.unwrap_or_else(|difference| {
                panic!(
                    "{family:?}, seed {seed}: {difference}\n{camera:?}\n{:?}\n{:?}",
                    mesh.positions(),
                    mesh.triangles()
                )
            });
            sum.scenes += tally.scenes;
            sum.edges += tally.edges;
            sum.stretches += tally.stretches;
            sum.cut_off += tally.cut_off;
            sum.outside += tally.outside;
        }
    }
    eprintln!("amid scenes: {sum:?}");
    assert!(sum.cut_off * 20 > sum.edges && sum.outside * 20 > sum.edges, "{sum:?}");
}

/// The comparison can fail: at another view, and where a chain is missing.
#[test]
fn wrong_drawings_from_amid_a_scene_are_told() {
    let (mut scenes, mut caught) = (0, [0; 2]);
    for seed in 0..60 {
        let mut random = Random::new(seed);
        let mesh = without_flat_faces(&scene(FAMILIES[random.below(FAMILIES.len())], &mut random));
        let (Some(one), Some(other)) = (camera(&mesh, &mut random), camera(&mesh, &mut random)) else { continue };
        let chains = drawn(&mesh, &one, creases_and_mesh());
        let mut rest = Chains::default();
        chains.iter().skip(1).for_each(|chain| rest.push(chain));
        for (caught, wrong) in caught.iter_mut().zip([drawn(&mesh, &other, creases_and_mesh()), rest]) {
            *caught += usize::from(compare(&mesh, &one, &wrong).is_err());
        }
        scenes += 1;
    }
    eprintln!("wrong drawings caught in {scenes} scenes: {caught:?}");
    assert!(caught.iter().all(|caught| *caught * 2 > scenes), "{caught:?} of {scenes}");
}
