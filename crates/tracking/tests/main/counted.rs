//! What a frame takes in faces, beside the speed-ups that Hall prints.

use crate::scenes::{Scene, options, real_mesh};
use silhouette_core::glam::DVec3;
use silhouette_tracking::TestedEdges;

/// A level of the paper's table.
struct Level {
    level_rad: f32,
    /// The paper's speed-up over brute force on the bunny: a ratio of frame rates.
    paper: f64,
    /// How far the paper's figure lies outside the range of ours over all circles, as a share of the nearer end: above 0 where
    /// it is greater than all of ours, 0 where it lies within. Measured.
    outside: f64,
}

/// Ours are ratios of faces, the paper's are ratios of time. Two of six lie outside the range:
///
/// - At level 0 a frame evaluates six faces in seven, whatever the path. The paper's figure is lower by 3 %, as it would be if
///   that share of a frame went into what takes time but evaluates no face, such as comparing the facings at all concave
///   edges. The paper does not state the share.
/// - At level 0.01 the paper's is higher by 1 %. Its rates, 5.68 over 4.42 frames per second, are rounded: their ratio may be
///   as low as 1.2825, 0.4 % above ours. The rest is within the 0.6 % of faces that this implementation evaluates beyond
///   the paper's (departure 7 of the crate).
const LEVELS: [Level; 6] = [
    Level { level_rad: 0.0, paper: 1.13, outside: -0.033 },
    Level { level_rad: 0.01, paper: 1.29, outside: 0.010 },
    Level { level_rad: 0.1, paper: 2.60, outside: 0.0 },
    Level { level_rad: 0.2, paper: 4.28, outside: 0.0 },
    Level { level_rad: 0.5, paper: 6.90, outside: 0.0 },
    Level { level_rad: 1.0, paper: 7.88, outside: 0.0 },
];

/// A level circle around a mesh.
#[derive(Debug, Clone, Copy)]
struct Circle {
    /// Of the eye from the middle of the mesh, in radii of its bounding sphere.
    distance_radii: f64,
    /// Of the eye above the horizon.
    elevation_deg: f64,
}

/// Twenty circles, near and far, from below and above. The paper does not state its camera's path.
fn circles() -> impl Iterator<Item = Circle> {
    let elevations =
        |distance_radii| [-40.0, 0.0, 40.0, 80.0].map(|elevation_deg| Circle { distance_radii, elevation_deg });
    [1.5, 2.0, 3.0, 6.0, 20.0].into_iter().flat_map(elevations)
}

/// Arcs of a circle whose frames are counted, and frames of each, in steps as small as an animation's.
const ARCS: u32 = 24;
const PER_ARC: u32 = 2;
const STEP_DEG: f64 = 0.1;

/// Steps from one arc to the next, of 5 degrees: tracked, not counted.
const BETWEEN: u32 = 3;

/// The azimuths of a turn in degrees, each with whether its frame counts. The first is found by brute force, as in the paper,
/// and does not count.
///
/// Over whole turns of 3600 frames on the bunny, all counted, the ranges over all circles are 1.169 to 1.177, 1.265 to 1.277,
/// 2.465 to 2.618, 4.161 to 4.820, 6.468 to 8.962 and 6.993 to 10.244 at the six levels. Over these 48 frames per circle no
/// end of them differs by more than 0.6 %.
fn azimuths_deg() -> impl Iterator<Item = (f64, bool)> {
    let arc_deg = 360.0 / f64::from(ARCS);
    (0..ARCS).flat_map(move |arc| {
        let begin_deg = arc_deg * f64::from(arc);
        let end_deg = begin_deg + STEP_DEG * f64::from(PER_ARC);
        let between_deg = (begin_deg + arc_deg - end_deg) / f64::from(BETWEEN);
        let frames = (0..=PER_ARC).map(move |frame| (begin_deg + STEP_DEG * f64::from(frame), frame > 0));
        frames.chain((1..BETWEEN).map(move |step| (end_deg + between_deg * f64::from(step), false)))
    })
}

/// Speed-up counted in faces: all of them over those that a frame evaluates, averaged over the counted frames of a turn.
fn counted(scene: &Scene, circle: Circle, level_rad: f32) -> f64 {
    let mut tracker = scene.tracker(options(level_rad, TestedEdges::All));
    let (sin_up, cos_up) = circle.elevation_deg.to_radians().sin_cos();
    let (mut evaluated, mut frames) = (0, 0);
    for (index, (azimuth_deg, counts)) in azimuths_deg().enumerate() {
        let (sin, cos) = azimuth_deg.to_radians().sin_cos();
        let view = scene.view(DVec3::new(cos * cos_up, sin_up, sin * cos_up), circle.distance_radii);
        tracker.update(&view);
        assert_eq!(tracker.stats().brute_force.is_some(), index == 0, "{circle:?}, frame {index}");
        if counts {
            evaluated += tracker.stats().faces_evaluated;
            frames += 1;
        }
    }
    (scene.mesh.face_count() as u64 * frames) as f64 / evaluated as f64
}

/// The counted speed-ups of a level on each circle.
fn on_all_circles(scene: &Scene, level_rad: f32) -> Vec<f64> {
    std::thread::scope(|scope| {
        let flights: Vec<_> = circles().map(|circle| scope.spawn(move || counted(scene, circle, level_rad))).collect();
        flights.into_iter().map(|flight| flight.join().unwrap()).collect()
    })
}

/// How far a figure lies outside of a range. See [`Level::outside`].
fn outside(figure: f64, of: &[f64]) -> f64 {
    let [least, most] = [of.iter().copied().reduce(f64::min), of.iter().copied().reduce(f64::max)].map(Option::unwrap);
    figure / figure.clamp(least, most) - 1.0
}

#[test]
fn counted_speed_ups_on_the_bunny_range_about_those_of_the_paper() {
    let test = "counted_speed_ups_on_the_bunny_range_about_those_of_the_paper";
    let Some(bunny) = real_mesh(test, "stanford-bunny.obj") else { return };
    assert_eq!(bunny.mesh.face_count(), 69_451, "the paper's bunny");
    for Level { level_rad, paper, outside: stated } in LEVELS {
        let ours = on_all_circles(&bunny, level_rad);
        let outside = outside(paper, &ours);
        assert!((outside - stated).abs() < 0.005, "level {level_rad}: {paper} lies {outside:.4} outside of {ours:.3?}");
        // The paper's figures of the other levels are the negative control: none lies in the range of this one.
        let others = LEVELS.iter().filter(|other| other.level_rad < level_rad.min(0.5));
        assert!(others.map(|other| other.paper).all(|other| self::outside(other, &ours) < -0.05), "{ours:.3?}");
    }
}

/// Each level evaluates fewer faces than the one below, and brute force all of them.
#[test]
fn higher_levels_evaluate_less() {
    let scene = Scene::builtin("blob:4000");
    let by_level: Vec<_> = LEVELS.iter().map(|level| on_all_circles(&scene, level.level_rad)).collect();
    for (index, circle) in circles().enumerate() {
        let counts: Vec<_> = by_level.iter().map(|level| level[index]).collect();
        assert!(counts.is_sorted(), "{circle:?}: {counts:?}");
        assert!(counts[0] > 1.05 && counts[5] > 1.5 * counts[0], "{circle:?}: {counts:?}");
    }
    let mut brute_force = scene.brute_force();
    brute_force.update(&scene.orbit(0.0, 1).next().unwrap());
    assert_eq!(brute_force.stats().faces_evaluated, 4000);
}
