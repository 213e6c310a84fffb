//! Outlines of small scenes against the union of all projected faces, in rational coordinates of the picture.
//!
//! Every corner of an outline has to lie where a vertex or a crossing of two projected sides does. Once it is put there
//! exactly, the rings have to enclose exactly what the faces cover: between neighbouring abscissas of such places all sides
//! are straight and do not cross, so that both are compared along two lines in each such strip.

use crate::exact::drawing::{camera, without_flat_faces};
use crate::exact::rational::exact;
use crate::exact::situations::{all, crossing_triangles, stacked, two_cubes_in_line};
use glam::{DVec2, Vec3};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};
use silhouette_core::{Camera, NoProgress, Projection, TriangleMesh};
use silhouette_testing::Random;
use silhouette_testing::lattice_scenes::{FAMILIES, scene, seeds};
use silhouette_testing::prepare::prepared;
use silhouette_visibility::{LineFinder, LineScene};
use std::collections::BTreeSet;

type Place = [BigRational; 2];

/// Farthest in pixels that a corner may lie from its exact place.
const MOST_OFF_PX: f64 = 1e-5;

/// Most faces of a scene: a strip for each crossing of two sides is slow.
const MOST_FACES: usize = 20;

/// A camera at whole coordinates as a map to rational coordinates of the picture: to the right and upwards.
struct Picture {
    eye: [BigRational; 3],
    /// To the right, upwards, and towards the viewer; at right angles, of any length.
    axes: [[BigRational; 3]; 3],
    is_perspective: bool,
    /// Pixels per unit of both coordinates.
    scale: DVec2,
    middle: DVec2,
}

fn dot(one: &[BigRational; 3], other: &[BigRational; 3]) -> BigRational {
    one.iter().zip(other).map(|(x, y)| x * y).sum()
}

impl Picture {
    /// Of a camera whose up is perpendicular to its direction.
    fn new(camera: &Camera) -> Self {
        let (back, up) = (camera.eye() - camera.target(), camera.up());
        let right = up.cross(back);
        assert!(up.dot(back) == 0.0 && [right, up, back].iter().all(|axis| axis.fract() == Vec3::ZERO), "{camera:?}");
        let rational = |p: Vec3| p.to_array().map(|c| exact(f64::from(c)));
        let is_perspective = matches!(camera.projection(), Projection::Perspective { .. });
        let unit = if is_perspective { back.as_dvec3().length() } else { 1.0 };
        let per_unit = camera.pixels_per_unit(1.0) * unit;
        Self {
            eye: rational(camera.eye()),
            axes: [right, up, back].map(rational),
            is_perspective,
            scale: DVec2::new(per_unit / right.as_dvec3().length(), per_unit / up.as_dvec3().length()),
            middle: DVec2::from(camera.size().map(f64::from)) * 0.5,
        }
    }

    fn place(&self, p: Vec3) -> Place {
        let from_eye: [BigRational; 3] = std::array::from_fn(|axis| exact(f64::from(p[axis])) - &self.eye[axis]);
        let [x, y, depth] = self.axes.each_ref().map(|axis| dot(axis, &from_eye));
        if self.is_perspective { [-x / &depth, -y / depth] } else { [x, y] }
    }

    fn pixel(&self, [x, y]: &Place) -> DVec2 {
        let at = DVec2::new(x.to_f64().unwrap(), -y.to_f64().unwrap());
        self.middle + at * self.scale
    }
}

/// The place where two segments cross, unless they are parallel.
fn crossing([a, b]: [&Place; 2], [p, q]: [&Place; 2]) -> Option<Place> {
    let minus = |one: &Place, other: &Place| [&one[0] - &other[0], &one[1] - &other[1]];
    let cross = |one: &Place, other: &Place| &one[0] * &other[1] - &one[1] * &other[0];
    let (along, other, between) = (minus(b, a), minus(q, p), minus(p, a));
    let denominator = cross(&along, &other);
    if denominator.is_zero() {
        return None;
    }
    let (t, s) = (cross(&between, &other) / &denominator, cross(&between, &along) / denominator);
    let unit = BigRational::zero()..=BigRational::from(BigInt::from(1));
    (unit.contains(&t) && unit.contains(&s)).then(|| [&a[0] + &along[0] * &t, &a[1] + &along[1] * &t])
}

/// Where a segment passes over an abscissa, unless it does so at an end.
fn over([a, b]: [&Place; 2], x: &BigRational) -> Option<BigRational> {
    let (left, right) = if a[0] < b[0] { (a, b) } else { (b, a) };
    let is_over = left[0] < *x && *x < right[0];
    is_over.then(|| &left[1] + (&right[1] - &left[1]) * ((x - &left[0]) / (&right[0] - &left[0])))
}

fn sides(ring: &[Place]) -> impl Iterator<Item = [&Place; 2]> {
    (0..ring.len()).map(|at| [&ring[at], &ring[(at + 1) % ring.len()]])
}

/// Ordinates between which a line is covered, those that touch united.
fn united(mut spans: Vec<[BigRational; 2]>) -> Vec<[BigRational; 2]> {
    spans.sort();
    let mut all: Vec<[BigRational; 2]> = Vec::new();
    for [from, to] in spans {
        match all.last_mut() {
            Some(last) if last[1] >= from => last[1] = last[1].clone().max(to),
            _ => all.push([from, to]),
        }
    }
    all
}

/// The pairs of places at which rings pass over a line.
fn between(rings: &[Vec<Place>], x: &BigRational) -> Vec<[BigRational; 2]> {
    let mut places: Vec<BigRational> =
        rings.iter().flat_map(|ring| sides(ring)).filter_map(|side| over(side, x)).collect();
    places.sort();
    places.chunks_exact(2).map(|pair| [pair[0].clone(), pair[1].clone()]).collect()
}

/// Twice the area that a ring runs around counter-clockwise.
fn area(ring: &[Place]) -> BigRational {
    sides(ring).map(|[a, b]| &a[0] * &b[1] - &a[1] * &b[0]).sum()
}

/// Whether a ring goes back the way it came.
fn turns_back(ring: &[Place]) -> bool {
    let next = |at: usize| &ring[at % ring.len()];
    (0..ring.len()).any(|at| {
        let [one, other] = [1, 2].map(|step| {
            let (from, to) = (next(at + step - 1), next(at + step));
            [&to[0] - &from[0], &to[1] - &from[1]]
        });
        (&one[0] * &other[1] - &one[1] * &other[0]).is_zero()
            && &one[0] * &other[0] + &one[1] * &other[1] < BigRational::zero()
    })
}

#[derive(Debug, Default, Clone, Copy)]
struct Tally {
    scenes: usize,
    rings: usize,
    holes: usize,
    corners: usize,
    /// Points of rings that are no corners.
    within_sides: usize,
    strips: usize,
}

/// Whether a ring goes straight on at a point.
fn is_within_side(ring: &[DVec2], at: usize) -> bool {
    let [before, after] = [at + ring.len() - 1, at + 1].map(|index| ring[index % ring.len()]);
    let along = (after - before).normalize_or_zero();
    let (share, beside) = (along.dot(ring[at] - before), along.perp_dot(ring[at] - before));
    // Two points may stand for one place, in either order.
    let sides = -MOST_OFF_PX..=before.distance(after) + MOST_OFF_PX;
    beside.abs() <= MOST_OFF_PX && sides.contains(&share)
}

/// In what regions of rings, in pixels, differ from what a mesh covers.
fn compare(mesh: &TriangleMesh, camera: &Camera, regions: &[Vec<Vec<DVec2>>]) -> Result<Tally, String> {
    let picture = Picture::new(camera);
    let at: Vec<Place> = mesh.positions().iter().map(|&p| picture.place(p)).collect();
    let faces: Vec<Vec<Place>> =
        mesh.triangles().iter().map(|face| face.map(|vertex| at[vertex as usize].clone()).to_vec()).collect();
    let edges: BTreeSet<[&Place; 2]> =
        faces.iter().flat_map(|face| sides(face)).map(|[a, b]| if a < b { [a, b] } else { [b, a] }).collect();
    let edges: Vec<[&Place; 2]> = edges.into_iter().collect();
    let crossings = edges
        .iter()
        .enumerate()
        .flat_map(|(index, one)| edges[..index].iter().filter_map(|other| crossing(*one, *other)));
    let places: BTreeSet<Place> = crossings.chain(faces.iter().flatten().cloned()).collect();
    let pixels: Vec<(DVec2, &Place)> = places.iter().map(|place| (picture.pixel(place), place)).collect();
    let exact_place = |pixel: DVec2| {
        let nearest = pixels.iter().min_by(|one, other| one.0.distance(pixel).total_cmp(&other.0.distance(pixel)));
        nearest.filter(|(at, _)| at.distance(pixel) <= MOST_OFF_PX).map(|(_, place)| (*place).clone())
    };
    let exact_ring = |ring: &[DVec2]| {
        let corner = |(at, &pixel): (usize, &DVec2)| match exact_place(pixel) {
            Some(place) => Ok(Some(place)),
            // A ring may have points within its straight sides.
            None if is_within_side(ring, at) => Ok(None),
            None => Err(format!("a corner at {pixel} where no two sides meet")),
        };
        ring.iter().enumerate().map(corner).filter_map(Result::transpose).collect::<Result<Vec<Place>, String>>()
    };
    let mut rings: Vec<Vec<Place>> = Vec::new();
    let mut tally = Tally { scenes: 1, ..Tally::default() };
    for region in regions {
        for (index, ring) in region.iter().enumerate() {
            let points = ring.len();
            let ring = exact_ring(ring)?;
            tally.within_sides += points - ring.len();
            if turns_back(&ring) {
                return Err(format!("ring {index} of its region runs along itself"));
            }
            let is_hole = index > 0;
            if (area(&ring) < BigRational::zero()) != is_hole {
                return Err(format!("ring {index} of its region runs the wrong way"));
            }
            tally.holes += usize::from(is_hole);
            tally.corners += ring.len();
            rings.push(ring);
        }
    }
    tally.rings = rings.len();
    let abscissas: BTreeSet<&BigRational> = places.iter().map(|[x, _]| x).collect();
    let abscissas: Vec<&BigRational> = abscissas.into_iter().collect();
    for strip in abscissas.windows(2) {
        tally.strips += 1;
        for share in [1, 2] {
            let x = strip[0] + (strip[1] - strip[0]) * BigRational::new(BigInt::from(share), BigInt::from(3));
            let span = |face: &Vec<Place>| {
                let places: BTreeSet<BigRational> = sides(face).filter_map(|side| over(side, &x)).collect();
                Some([places.first()?.clone(), places.last()?.clone()]).filter(|[from, to]| from < to)
            };
            let (covered, enclosed) = (united(faces.iter().filter_map(span).collect()), between(&rings, &x));
            if covered != enclosed {
                let shown = |spans: &[[BigRational; 2]]| {
                    let shown = spans.iter().map(|span| span.each_ref().map(|y| y.to_f64().unwrap()));
                    format!("{:?}", shown.collect::<Vec<_>>())
                };
                let (x, covered, enclosed) = (x.to_f64().unwrap(), shown(&covered), shown(&enclosed));
                return Err(format!("at {x} faces cover {covered}, and rings enclose {enclosed}"));
            }
        }
    }
    Ok(tally)
}

/// The regions of a view's outline, each its rings.
fn outline(mesh: &TriangleMesh, camera: &Camera) -> Vec<Vec<Vec<DVec2>>> {
    let mut finder = LineFinder::new(LineScene::new(prepared(mesh.clone())), &NoProgress).unwrap();
    finder.outline(camera, &NoProgress).unwrap().regions().map(<[_]>::to_vec).collect()
}

/// The same camera with an upward direction at whole coordinates and at right angles.
fn upright(camera: &Camera) -> Camera {
    let back = camera.eye() - camera.target();
    let up = back.cross(if back.x == 0.0 && back.y == 0.0 { Vec3::X } else { Vec3::Z });
    Camera::new(camera.eye(), camera.target(), up, camera.projection(), camera.size()).unwrap()
}

fn check(what: &str, mesh: &TriangleMesh, camera: &Camera) -> Tally {
    compare(mesh, camera, &outline(mesh, camera)).unwrap_or_else(|difference| {
        panic!("{what}: {difference}\n{camera:?}\n{:?}\n{:?}", mesh.positions(), mesh.triangles())
    })
}

#[test]
fn outlines_of_random_scenes_are_the_exact_ones() {
    let mut sum = Tally::default();
    for family in FAMILIES {
        for seed in 0..seeds(40) {
            let mut random = Random::new(seed);
            let mesh = without_flat_faces(&scene(family, &mut random));
            let Some(camera) = camera(&mesh, &mut random) else { continue };
            if mesh.face_count() > MOST_FACES {
                continue;
            }
            let tally = check(&format!("{family:?}, seed {seed}"), &mesh, &upright(&camera));
            sum.scenes += tally.scenes;
            sum.rings += tally.rings;
            sum.holes += tally.holes;
            sum.corners += tally.corners;
            sum.within_sides += tally.within_sides;
            sum.strips += tally.strips;
        }
    }
    eprintln!("exact outlines: {sum:?}");
    assert!(sum.scenes > 100 && sum.holes > 10, "{sum:?}");
}

#[test]
fn outlines_of_situations_are_the_exact_ones() {
    for (name, mesh) in all() {
        let mut random = Random::new(5);
        let views = if mesh.face_count() > MOST_FACES { 1 } else { 6 };
        for _ in 0..views {
            check(name, &mesh, &upright(&camera(&mesh, &mut random).unwrap()));
        }
    }
}

#[test]
fn what_lies_in_line_is_one_ring_of_few_corners() {
    let look = |mesh: &TriangleMesh, toward: Vec3, projection| {
        let target = mesh.bounds().unwrap().center.round().as_vec3();
        upright(
            &Camera::new(target + toward * 8.0, target, toward.any_orthogonal_vector(), projection, [512; 2]).unwrap(),
        )
    };
    let orthographic = Projection::Orthographic { height: 16.0 };
    let cubes = two_cubes_in_line();
    let regions = outline(&cubes, &look(&cubes, Vec3::Z, orthographic));
    assert!(regions.len() == 1 && regions[0].len() == 1 && regions[0][0].len() == 4, "one square: {regions:?}");
    let boxes = stacked();
    let regions = outline(&boxes, &look(&boxes, Vec3::NEG_Y, orthographic));
    assert!(regions.len() == 1 && regions[0].len() == 1 && regions[0][0].len() == 6, "no diagonal: {regions:?}");
    // Another upward direction turns the picture, and nothing else.
    let crossing = crossing_triangles();
    let camera = look(&crossing, Vec3::Z, Projection::Perspective { fov_y_rad: 0.3 });
    for up in [Vec3::X, Vec3::Y, Vec3::new(3.0, 4.0, 0.0)] {
        let camera = Camera::new(camera.eye(), camera.target(), up, camera.projection(), camera.size()).unwrap();
        check("turned", &crossing, &camera);
    }
}

/// The comparison can fail: at the outline of another view, at one without a corner or a ring, and at one that runs the
/// other way.
#[test]
fn wrong_outlines_are_told_from_exact_ones() {
    let (mut scenes, mut caught) = (0, [0; 4]);
    for seed in 0..12 {
        let mut random = Random::new(seed);
        let mesh = without_flat_faces(&scene(FAMILIES[3 + random.below(2)], &mut random));
        let (Some(one), Some(other)) = (camera(&mesh, &mut random), camera(&mesh, &mut random)) else { continue };
        let (one, other) = (upright(&one), upright(&other));
        let regions = outline(&mesh, &one);
        if mesh.face_count() > MOST_FACES || regions.is_empty() {
            continue;
        }
        let (mut cut, mut reversed) = (regions.clone(), regions.clone());
        cut[0][0].pop();
        reversed[0][0].reverse();
        for (caught, wrong) in caught.iter_mut().zip([&outline(&mesh, &other), &cut, &regions[1..].to_vec(), &reversed])
        {
            *caught += usize::from(compare(&mesh, &one, wrong).is_err());
        }
        scenes += 1;
    }
    eprintln!("wrong drawings caught in {scenes} scenes: {caught:?}");
    assert!(
        scenes > 5 && caught[0] * 2 > scenes && caught[1..].iter().all(|caught| *caught == scenes),
        "{caught:?} of {scenes}"
    );
}
