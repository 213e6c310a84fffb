//! A whole drawing by brute force: which edges are drawn, and between which parameters so many layers hide each.

use crate::exact::moved::{Scene, sign};
use crate::exact::rational::{Row, height, plane};
use num_bigint::BigInt;
use num_rational::BigRational;
use std::collections::{BTreeMap, BTreeSet};

/// Why an edge is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    Silhouette,
    Boundary,
    Crease,
    Mesh,
}

/// A stretch of an edge with so many layers in front of it, from one parameter to another.
#[derive(Debug, Clone, PartialEq)]
pub struct Stretch {
    pub range: [BigRational; 2],
    pub invisibility: u32,
}

/// The edges that are drawn, each with its stretches from its lower vertex to its higher one.
pub type Drawing = BTreeMap<[u32; 2], (Kind, Vec<Stretch>)>;

/// Least length of a stretch: far above what moving viewer and strokes adds, and below what scenes hold.
fn least_length() -> BigRational {
    BigRational::new(BigInt::from(1), BigInt::from(1) << 27)
}

/// What else than silhouette and boundary edges is drawn.
#[derive(Debug, Clone, Copy, Default)]
pub struct Also {
    /// Creases that bend by at least an angle of which this is the squared cosine: 0 to below 90 degrees.
    pub creases: Option<f64>,
    /// Every other edge.
    pub mesh: bool,
}

/// The drawing of a scene, hidden lines included.
pub fn drawing(scene: &Scene, also: Also) -> Drawing {
    let sides = scene.faces.iter().flat_map(|face| {
        let [a, b, c] = face.corners;
        [[a, b], [b, c], [c, a]].map(|[p, q]| [p.min(q), p.max(q)])
    });
    let edges: BTreeSet<[u32; 2]> = sides.collect();
    let drawn = edges.into_iter().filter_map(|edge| {
        let kind = kind(scene, edge, also)?;
        (!scene.is_end_on(edge)).then(|| (edge, (kind, stretches(scene, edge))))
    });
    drawn.collect()
}

fn kind(scene: &Scene, edge: [u32; 2], also: Also) -> Option<Kind> {
    let wings = scene.wings(edge);
    let sides: BTreeSet<i32> = wings.iter().map(|&apex| scene.side(edge, apex)).collect();
    if sides.len() == 1 && wings.len() > 1 || is_rim_of_wall(scene, edge, &wings) {
        Some(Kind::Silhouette)
    } else if wings.len() == 1 {
        Some(Kind::Boundary)
    } else if also.creases.is_some_and(|squared_cosine| is_crease(scene, edge, &wings, squared_cosine)) {
        Some(Kind::Crease)
    } else {
        also.mesh.then_some(Kind::Mesh)
    }
}

/// Whether all wings that the camera sees edge-on recede from the plane of the others, which lie on one side.
fn is_rim_of_wall(scene: &Scene, [a, b]: [u32; 2], wings: &[u32]) -> bool {
    let (walls, seen): (Vec<u32>, Vec<u32>) = wings.iter().partition(|&&apex| scene.is_in_line([a, b, apex]));
    let Some(&beside) = seen.first() else { return false };
    let side = scene.side([a, b], beside);
    let floor = plane([scene.at(a), scene.at(b), scene.at(beside)]);
    !walls.is_empty()
        && seen.iter().all(|&apex| scene.side([a, b], apex) == side)
        && walls.iter().all(|&apex| sign(&height(&floor, scene.at(apex))) == -side)
}

/// Whether one wing bends from every other by an angle of which this is the squared cosine.
fn is_crease(scene: &Scene, [a, b]: [u32; 2], wings: &[u32], squared_cosine: f64) -> bool {
    let least = BigRational::from_float(squared_cosine).unwrap();
    // From one plane, two wings continue each other: their normals are opposite.
    let bends = |one: &[BigInt; 3], other: &[BigInt; 3]| {
        let cosine = -dot(one, other);
        let squared = BigRational::new(&cosine * &cosine, dot(one, one) * dot(other, other));
        cosine.sign() != num_bigint::Sign::Plus || squared <= least
    };
    let across = |&apex: &u32| normal([scene.at(a), scene.at(b), scene.at(apex)]);
    let normals: Vec<[BigInt; 3]> = wings.iter().map(across).collect();
    let is_same = |one: &[BigInt; 3], other: &[BigInt; 3]| {
        let product = dot(one, other);
        product.sign() == num_bigint::Sign::Plus && &product * &product == dot(one, one) * dot(other, other)
    };
    normals.iter().any(|one| {
        let others: Vec<_> = normals.iter().filter(|other| !is_same(one, other)).collect();
        !others.is_empty() && others.into_iter().all(|other| bends(one, other))
    })
}

fn dot(one: &[BigInt; 3], other: &[BigInt; 3]) -> BigInt {
    one.iter().zip(other).map(|(x, y)| x * y).sum()
}

fn normal(corners: [&Row; 3]) -> [BigInt; 3] {
    let [x, y, z, _] = plane(corners);
    [x, y, z]
}

/// The stretches of an edge, each as long as possible.
fn stretches(scene: &Scene, edge: [u32; 2]) -> Vec<Stretch> {
    let stroke = scene.stroke(edge);
    let others = scene.faces.iter().filter(|face| !edge.iter().all(|end| face.corners.contains(end)));
    let hidden: Vec<(bool, [BigRational; 2])> =
        others.filter_map(|face| Some((face.is_front, face.hides(&stroke)?))).collect();
    let [zero, one] = [0, 1].map(|end| BigRational::from(BigInt::from(end)));
    let mut places: Vec<BigRational> = hidden.iter().flat_map(|(_, range)| range.clone()).collect();
    places.extend([zero, one]);
    places.sort();
    places.dedup();
    let mut stretches: Vec<Stretch> = Vec::new();
    let least = least_length();
    for pair in places.windows(2).filter(|pair| &pair[1] - &pair[0] > least) {
        let layers = |is_front: bool| {
            let in_front = |(facing, [from, to]): &&(bool, [BigRational; 2])| {
                *facing == is_front && *from <= pair[0] && *to >= pair[1]
            };
            hidden.iter().filter(in_front).count() as u32
        };
        let invisibility = layers(true).max(layers(false));
        match stretches.last_mut() {
            Some(last) if last.invisibility == invisibility => last.range[1] = pair[1].clone(),
            Some(last) => {
                // What is too short to be seen belongs to either.
                last.range[1] = pair[0].clone();
                stretches.push(Stretch { range: [pair[0].clone(), pair[1].clone()], invisibility });
            }
            None => stretches.push(Stretch { range: [places[0].clone(), pair[1].clone()], invisibility }),
        }
    }
    if let (Some(last), Some(end)) = (stretches.last_mut(), places.last()) {
        last.range[1] = end.clone();
    }
    stretches
}
