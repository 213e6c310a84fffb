//! Facing, turns, orientations and heights of random, grid and nearly degenerate points: signs and zeros without exception,
//! values within the stated relative error, and the power of the infinitesimal that decides a tie.

use crate::exact::moved::{sign, viewers};
use crate::exact::rational::{exact, height, plane, point};
use glam::{DVec3, Vec3};
use num_bigint::BigInt;
use num_rational::BigRational;
use silhouette_core::displaced::Turn;
use silhouette_core::facing::judge;
use silhouette_core::orientation::{RELATIVE_ERROR, height_over_plane, orientation, turn};
use silhouette_core::{DisplacedViewer, Facing, Viewpoint};
use silhouette_testing::Random;
use silhouette_testing::lattice_scenes::seeds;

/// Coordinates are multiples of `2^-149`, as every 32-bit float is.
const EXPONENT: u32 = 149;

/// Bits of the step of a displaced viewer, more than determinants of any floats here differ by: those below `2^150` in
/// units of `2^-149` stay below `2^900`.
const STEP: u32 = 960;

/// Four points of a family, and a fifth towards which viewers are displaced.
type Points = [Vec3; 5];

/// A float of any size up to a power of two, subnormal ones included.
fn of_any_size(random: &mut Random) -> f32 {
    let exponent = random.whole(-149..64);
    (random.signed() * 2.0_f64.powi(exponent)) as f32
}

fn vector(mut of: impl FnMut() -> f32) -> Vec3 {
    Vec3::new(of(), of(), of())
}

/// Each coordinate moved by up to so many steps to the next float.
fn nudged(p: Vec3, by: i32, random: &mut Random) -> Vec3 {
    let nudge = |x: f32, random: &mut Random| {
        let steps = random.whole(-by..by + 1);
        (0..steps.abs()).fold(x, |x, _| if steps > 0 { x.next_up() } else { x.next_down() })
    };
    Vec3::from(p.to_array().map(|x| nudge(x, random)))
}

/// A point of the plane through three others, rounded.
fn in_plane([a, b, c]: [Vec3; 3], random: &mut Random) -> Vec3 {
    let [a, b, c]: [DVec3; 3] = [a, b, c].map(Vec3::as_dvec3);
    (a + (b - a) * (3.0 * random.signed()) + (c - a) * (3.0 * random.signed())).as_vec3()
}

/// What it is called in messages, and how its points are made.
type Family = (&'static str, fn(&mut Random) -> Points);

const FAMILIES: [Family; 7] = [
    ("any floats", |random| [0; 5].map(|_| vector(|| of_any_size(random)))),
    ("of one size", |random| [0; 5].map(|_| random.vector().as_vec3())),
    ("grid", |random| [0; 5].map(|_| Vec3::from(random.lattice_point(-3..4).map(|c| c as f32)))),
    ("within an ulp of the plane", |random| {
        let [a, b, c, toward] = [0; 4].map(|_| random.vector().as_vec3());
        let in_plane = in_plane([a, b, c], random);
        [a, b, c, nudged(in_plane, 1, random), toward]
    }),
    ("of 24 bits in one plane or a step beside", |random| {
        let [a, b, c, toward] = [0; 4].map(|_| random.lattice_point(-(1 << 21)..1 << 21));
        let [s, t] = [0; 2].map(|_| random.whole(-1..3));
        let beside = random.lattice_point(0..2).map(|step| if random.one_in(3) { step } else { 0 });
        let d = [0, 1, 2].map(|i| a[i] + s * (b[i] - a[i]) + t * (c[i] - a[i]) + beside[i]);
        [a, b, c, d, toward].map(|p| Vec3::from(p.map(|c| c as f32)))
    }),
    ("nearly coplanar neighbours", |random| {
        // A long edge, two points beside it that differ by some ulps, and an eye far off in their plane.
        let [a, b, c, toward] = [0; 4].map(|_| random.vector().as_vec3());
        let d = nudged(c, 3, random);
        let eye = a + (d - a) * 1000.0 + (b - a) * random.whole(-500..500) as f32;
        [a, b, if random.one_in(2) { c } else { d }, eye, toward]
    }),
    ("far from the origin", |random| {
        let at = random.vector().as_vec3() * 1e6;
        [0; 5].map(|_| at + random.vector().as_vec3())
    }),
];

/// The number that a determinant in units of `2^-149` stands for, of so many factors.
fn number(value: &BigInt, factors: u32) -> BigRational {
    BigRational::new(value.clone(), BigInt::from(1) << (EXPONENT * factors))
}

/// Whether a float has the sign of a number, is 0 where that is, and is relatively close.
fn is_faithful(found: f64, expected: &BigRational) -> bool {
    let difference = exact(found) - expected;
    let zero = BigRational::from(BigInt::ZERO);
    let size = |value: &BigRational| if *value < zero { -value.clone() } else { value.clone() };
    size(&difference) <= size(expected) * exact(RELATIVE_ERROR)
}

/// Whether each of the comparisons holds.
fn compared([a, b, c, d, toward]: Points) -> Vec<bool> {
    let rows = [a, b, c, d].map(|p| point(p, EXPONENT));
    let [of_a, of_b, of_c, of_d] = rows.each_ref();
    let own = plane([of_a, of_b, of_c]);
    let volume = number(&height(&own, of_d), 3);
    let mut all = vec![is_faithful(orientation(a, b, c, d), &volume)];
    // The height of d over a plane through a of which b is the normal.
    let along: BigInt = (0..3).map(|axis| &of_b[axis] * (&of_d[axis] - &of_a[axis])).sum();
    all.push(is_faithful(height_over_plane(a, b, d), &number(&along, 2)));
    for viewpoint in [Viewpoint::Perspective { eye: d }, Viewpoint::Orthographic { toward_viewer: d }] {
        let [camera, displaced] = viewers(&viewpoint, toward, EXPONENT, STEP);
        let of_camera = height(&own, &camera);
        all.push(is_faithful(turn(&viewpoint, a, b, c), &number(&of_camera, 3)));
        all.push((judge([a, b, c], &viewpoint).facing == Facing::Front) == (sign(&of_camera) > 0));
        let Turn { power, value } = DisplacedViewer::new(viewpoint, toward).turn(a, b, c);
        let found = i32::from(value > 0.0) - i32::from(value < 0.0);
        all.push(found == sign(&height(&own, &displaced)));
        all.push((power == 0) == (sign(&of_camera) != 0));
    }
    all
}

#[test]
fn predicates_are_those_of_rational_numbers() {
    for (name, family) in FAMILIES {
        let mut random = Random::new(11);
        let (mut count, mut ties) = (0, 0);
        for _ in 0..seeds(1500) {
            let points = family(&mut random);
            let all = compared(points);
            assert!(all.iter().all(|holds| *holds), "{name}: {points:?}: {all:?}");
            count += all.len();
            ties += usize::from(orientation(points[0], points[1], points[2], points[3]) == 0.0);
        }
        eprintln!("{name}: {count} comparisons, {ties} points in one plane");
    }
}

/// The points are hard: plain 32-bit arithmetic, and 64-bit arithmetic where points lie in one plane, have other signs for some.
#[test]
fn plain_arithmetic_fails_on_the_same_points() {
    let wrong = |name: &str, naive: fn([Vec3; 4]) -> f64| {
        let (_, family) = FAMILIES.into_iter().find(|(of, _)| *of == name).unwrap();
        let mut random = Random::new(11);
        let is_wrong = |_: &i32| {
            let [a, b, c, d, _] = family(&mut random);
            let own = plane([a, b, c].map(|p| point(p, EXPONENT)).each_ref());
            let value = naive([a, b, c, d]);
            i32::from(value > 0.0) - i32::from(value < 0.0) != sign(&height(&own, &point(d, EXPONENT)))
        };
        (0..1000).filter(is_wrong).count()
    };
    let narrow = |[a, b, c, d]: [Vec3; 4]| f64::from((b - a).cross(c - a).dot(d - a));
    let wide = |points: [Vec3; 4]| {
        let [a, b, c, d] = points.map(Vec3::as_dvec3);
        (b - a).cross(c - a).dot(d - a)
    };
    let names =
        ["within an ulp of the plane", "nearly coplanar neighbours", "of 24 bits in one plane or a step beside"];
    let counts = names.map(|name| [wrong(name, narrow), wrong(name, wide)]);
    eprintln!("wrong signs of 1000 in 32 bits and in 64: {counts:?}");
    assert!(counts.iter().all(|[narrow, _]| *narrow > 50) && counts[2][1] > 0, "{counts:?}");
}
