//! Whole drawings of small scenes against the exact ones: every stretch of every edge, and how stretches are chained.

use crate::exact::moved::{Scene, Steps};
use crate::exact::visible::{Also, Drawing, Kind, Stretch, drawing};
use glam::Vec3;
use num_rational::BigRational;
use num_traits::ToPrimitive;
use silhouette_core::{Camera, NoProgress, Projection, Topology, TriangleMesh, VertexId};
use silhouette_testing::edits::{keeping, mapped, shaken};
use silhouette_testing::lattice_scenes::{FAMILIES, scene, seeds};
use silhouette_testing::prepare::prepared;
use silhouette_testing::{Random, builtin};
use silhouette_visibility::{Chain, ChainStyle, Chains, LineFinder, LineKind, LineOptions, LineScene, SegmentSource};
use std::collections::BTreeMap;

/// Most by which a drawn parameter may be off: the crate's own statement, with what rounding adds to a point.
const MOST_OFF: f64 = 2e-9;

/// An angle at which no two faces of small whole coordinates meet.
const CREASE_DEG: f64 = 37.0;

/// What was compared.
#[derive(Debug, Default, Clone, Copy)]
pub struct Tally {
    pub scenes: usize,
    pub edges: usize,
    /// Stretches of edges, hidden ones included.
    pub stretches: usize,
    /// Ends of stretches within their edges.
    pub places: usize,
    pub hidden: usize,
    pub chains: usize,
    pub worst: f64,
}

impl Tally {
    fn add(&mut self, other: Self) {
        self.scenes += other.scenes;
        self.edges += other.edges;
        self.stretches += other.stretches;
        self.places += other.places;
        self.hidden += other.hidden;
        self.chains += other.chains;
        self.worst = self.worst.max(other.worst);
    }
}

/// A mesh without the faces that have no area.
pub fn without_flat_faces(mesh: &TriangleMesh) -> TriangleMesh {
    keeping(mesh, |face| {
        let [a, b, c] = mesh.triangles()[face].map(|vertex| mesh.positions()[vertex as usize].as_dvec3());
        (b - a).cross(c - a) != glam::DVec3::ZERO
    })
}

/// The chains that the crate draws of a view, hidden ones included.
pub fn drawn(mesh: &TriangleMesh, camera: &Camera, also: Also) -> Chains {
    let crease = also.creases.map(|_| CREASE_DEG);
    let options = LineOptions {
        ridge_deg: crease,
        valley_deg: crease,
        mesh: also.mesh,
        max_invisibility: u32::MAX,
        ..LineOptions::default()
    };
    let mut finder = LineFinder::new(LineScene::new(prepared(mesh.clone())), &NoProgress).unwrap();
    finder.find(camera, &options, &NoProgress).unwrap().chains
}

pub fn creases_and_mesh() -> Also {
    Also { creases: Some(CREASE_DEG.to_radians().cos().powi(2)), mesh: true }
}

fn kind_of(kind: LineKind) -> Kind {
    match kind {
        LineKind::Silhouette => Kind::Silhouette,
        LineKind::Boundary => Kind::Boundary,
        LineKind::Ridge | LineKind::Valley => Kind::Crease,
        LineKind::Mesh => Kind::Mesh,
        other => panic!("{other:?} was not asked for"),
    }
}

/// A piece of an edge as drawn.
#[derive(Debug, Clone, Copy)]
pub struct Piece {
    pub style: ChainStyle,
    pub range: [f64; 2],
}

/// The pieces of each edge.
pub type Pieces = BTreeMap<[u32; 2], Vec<Piece>>;

/// The pieces of each edge in their order along it, or in what a chain is no chain.
pub fn pieces(mesh: &TriangleMesh, topology: &Topology, chains: &Chains) -> Result<Pieces, String> {
    let mut pieces = Pieces::new();
    for chain in chains.iter() {
        let count = chain.sources.len();
        let sides: Vec<[u32; 2]> = chain.sources.iter().map(|source| edge_of(topology, *source)).collect();
        for segment in 0..count {
            let ends = [segment, (segment + 1) % chain.points.len()].map(|at| chain.points[at]);
            let vertices = sides[segment];
            let [a, b] = vertices.map(|vertex| mesh.positions()[vertex as usize].as_dvec3());
            let along = b - a;
            let range = ends.map(|end| (end - a).dot(along) / along.length_squared());
            if ends.iter().zip(range).any(|(end, t)| end.distance(a.lerp(b, t)) > 1e-9 * along.length()) {
                return Err(format!("a segment is not on its edge {vertices:?}"));
            }
            let range = if range[0] < range[1] { range } else { [range[1], range[0]] };
            pieces.entry(vertices).or_default().push(Piece { style: chain.style, range });
            let next = if segment + 1 < count { segment + 1 } else { 0 };
            if next > 0 || chain.closed {
                // They meet in a vertex that both have, exactly.
                let place = chain.points[(segment + 1) % chain.points.len()];
                let is_there = |vertex: &&u32| mesh.positions()[**vertex as usize].as_dvec3() == place;
                if !sides[segment].iter().filter(is_there).any(|vertex| sides[next].contains(vertex)) {
                    return Err(format!("{:?} and {:?} follow each other apart", sides[segment], sides[next]));
                }
            }
        }
    }
    pieces.values_mut().for_each(|pieces| pieces.sort_by(|one, other| one.range[0].total_cmp(&other.range[0])));
    Ok(pieces)
}

fn edge_of(topology: &Topology, source: SegmentSource) -> [u32; 2] {
    let SegmentSource::Edge(edge) = source else { panic!("only mesh edges were asked for") };
    topology.end_points(edge).map(VertexId::get)
}

fn off(found: f64, expected: &BigRational) -> f64 {
    // The difference is exact, its size is not.
    let difference = BigRational::from_float(found).unwrap() - expected;
    difference.to_f64().unwrap().abs()
}

/// In what chains differ from a drawing.
pub fn compare(mesh: &TriangleMesh, expected: &Drawing, chains: &Chains) -> Result<Tally, String> {
    let topology = Topology::new(mesh);
    let pieces = pieces(mesh, &topology, chains)?;
    let mut tally = Tally { scenes: 1, edges: expected.len(), chains: chains.len(), ..Tally::default() };
    if let Some(edge) = pieces.keys().find(|edge| !expected.contains_key(*edge)) {
        return Err(format!("edge {edge:?} is drawn"));
    }
    for (edge, (kind, stretches)) in expected {
        let found = pieces.get(edge).ok_or_else(|| format!("edge {edge:?} is not drawn"))?;
        let worst =
            compare_edge(*kind, stretches, found).map_err(|difference| format!("edge {edge:?}: {difference}"))?;
        tally.worst = tally.worst.max(worst);
        tally.hidden += stretches.iter().filter(|stretch| stretch.invisibility > 0).count();
        tally.stretches += stretches.len();
        tally.places += stretches.len() - 1;
    }
    ends(mesh, &pieces, &topology, chains)?;
    Ok(tally)
}

/// By how much the ends of an edge's pieces are off, or in what else they differ from its stretches.
pub fn compare_edge(kind: Kind, stretches: &[Stretch], found: &[Piece]) -> Result<f64, String> {
    let is_like = |(piece, stretch): (&Piece, &Stretch)| {
        kind_of(piece.style.kind) == kind && piece.style.invisibility == stretch.invisibility
    };
    let pairs = || found.iter().zip(stretches);
    let ends = pairs().flat_map(|(piece, stretch)| (0..2).map(|end| off(piece.range[end], &stretch.range[end])));
    let worst = ends.fold(0.0, f64::max);
    if found.len() == stretches.len() && pairs().all(is_like) && worst <= MOST_OFF {
        return Ok(worst);
    }
    let wanted: Vec<_> = stretches.iter().map(|stretch| (shown(&stretch.range), stretch.invisibility)).collect();
    let got: Vec<_> = found.iter().map(|piece| (piece.style.kind, piece.range, piece.style.invisibility)).collect();
    Err(format!("{kind:?} {wanted:?}, but drawn are {got:?}"))
}

fn shown(range: &[BigRational; 2]) -> [f64; 2] {
    range.each_ref().map(|end| end.to_f64().unwrap())
}

/// Whether chains go on as far as they can: of the pieces of one style that end in a vertex, at most one is left over.
fn ends(mesh: &TriangleMesh, pieces: &Pieces, topology: &Topology, chains: &Chains) -> Result<(), String> {
    let mut left_over = BTreeMap::<(u32, ChainStyle), usize>::new();
    for (edge, pieces) in pieces {
        for (end, piece) in [pieces.first(), pieces.last()].into_iter().enumerate() {
            *left_over.entry((edge[end], piece.unwrap().style)).or_default() ^= 1;
        }
    }
    left_over.retain(|_, count| *count == 1);
    let mut loose = BTreeMap::<(u32, ChainStyle), usize>::new();
    for chain in chains.iter().filter(|chain| !chain.closed) {
        let (points, sources) = (chain.points, chain.sources);
        for (place, source) in [(points[0], sources[0]), (points[points.len() - 1], sources[sources.len() - 1])] {
            let is_there = |vertex: &u32| mesh.positions()[*vertex as usize].as_dvec3() == place;
            if let Some(vertex) = edge_of(topology, source).into_iter().find(is_there) {
                *loose.entry((vertex, chain.style)).or_default() += 1;
            }
        }
    }
    if loose == left_over { Ok(()) } else { Err(format!("chains end at {loose:?} instead of {left_over:?}")) }
}

/// A camera that shows all of a mesh, along an axis or a diagonal as often as not.
pub fn camera(mesh: &TriangleMesh, random: &mut Random) -> Option<Camera> {
    let bounds = mesh.bounds()?;
    let middle = bounds.center.round().as_vec3();
    let reach = bounds.radius.ceil() as f32 + 1.0;
    let far = if random.one_in(2) { 3 } else { 2 };
    let toward = loop {
        let toward = random.lattice_point(1 - far..far);
        if toward != [0; 3] {
            break Vec3::from(toward.map(|c| c as f32));
        }
    };
    let is_perspective = random.one_in(2);
    // Outside of the sphere around the mesh, at whole coordinates.
    let eye = middle + toward * (reach + random.whole(0..3) as f32);
    let projection = if is_perspective {
        Projection::Perspective { fov_y_rad: 2.9 }
    } else {
        Projection::Orthographic { height: f64::from(4.0 * reach) }
    };
    Camera::new(eye, middle, toward.any_orthogonal_vector(), projection, [512, 512]).ok()
}

/// Compares the drawing of a mesh with the exact one.
pub fn check(what: &str, mesh: &TriangleMesh, camera: &Camera, steps: Steps, also: Also) -> (Drawing, Tally) {
    let expected = drawing(&Scene::new(mesh, &camera.viewpoint(), steps), also);
    let tally = compare(mesh, &expected, &drawn(mesh, camera, also)).unwrap_or_else(|difference| {
        panic!("{what}: {difference}\n{camera:?}\n{:?}\n{:?}", mesh.positions(), mesh.triangles())
    });
    (expected, tally)
}

#[test]
fn drawings_of_random_scenes_are_the_exact_ones() {
    let mut sum = Tally::default();
    for family in FAMILIES {
        for seed in 0..seeds(200) {
            let mut random = Random::new(seed);
            let mesh = without_flat_faces(&scene(family, &mut random));
            let Some(camera) = camera(&mesh, &mut random) else { continue };
            let also = if random.one_in(2) { Also::default() } else { creases_and_mesh() };
            sum.add(check(&format!("{family:?}, seed {seed}"), &mesh, &camera, Steps::WHOLE, also).1);
        }
    }
    eprintln!("whole coordinates: {sum:?}");
    assert!(sum.hidden * 8 > sum.stretches && sum.places * 8 > sum.edges, "{sum:?}");
}

/// For coordinates from -8 to 8 in steps of `2^-20`.
const FINE: Steps = Steps { exponent: 21, bits: 26 };

fn on_fine_grid(p: Vec3) -> Vec3 {
    let step = f32::exp2(-20.0);
    (p / step).round() * step
}

/// Faces of random floats: a crumpled ball or ring, holes in it, or triangles that pass through each other.
fn float_scene(random: &mut Random) -> TriangleMesh {
    if random.one_in(3) {
        let corner = |random: &mut Random| on_fine_grid(random.vector().as_vec3() * 2.0);
        let positions: Vec<Vec3> = (0..3 * (2 + random.below(9))).map(|_| corner(random)).collect();
        let triangles = (0..positions.len() as u32 / 3).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
        return TriangleMesh::new(positions, triangles).unwrap();
    }
    let base = builtin(["icosphere:1", "torus:6,4", "cube", "moebius:9,1"][random.below(4)]);
    let shaken = shaken(&base, 0.5 * random.unit() as f32, random.bits());
    let holes = 2 + random.below(20);
    let kept: Vec<bool> = (0..base.face_count()).map(|_| holes > 15 || !random.one_in(holes)).collect();
    keeping(&mapped(&shaken, on_fine_grid), |face| kept[face])
}

#[test]
fn drawings_of_random_floats_are_the_exact_ones() {
    let mut sum = Tally::default();
    for seed in 0..seeds(150) {
        let mut random = Random::new(seed);
        let mesh = float_scene(&mut random);
        if mesh.face_count() == 0 {
            continue;
        }
        let direction = random.vector().normalize_or(glam::DVec3::X);
        let eye = on_fine_grid((direction * 6.0).as_vec3());
        let projection = if random.one_in(2) {
            Projection::Perspective { fov_y_rad: 2.0 }
        } else {
            Projection::Orthographic { height: 16.0 }
        };
        let camera = Camera::new(eye, Vec3::ZERO, eye.any_orthogonal_vector(), projection, [512; 2]).unwrap();
        sum.add(check(&format!("seed {seed}"), &mesh, &camera, FINE, creases_and_mesh()).1);
    }
    eprintln!("floats: {sum:?}");
    assert!(sum.hidden * 4 > sum.stretches && sum.places * 8 > sum.edges, "{sum:?}");
}

/// Sheets whose rims cross a long edge in the picture at parameters that differ by less than two millionths: as many
/// stretches, in their order.
#[test]
fn crossings_at_nearly_equal_parameters_keep_their_order() {
    let step = f32::exp2(-20.0);
    let mut sum = Tally::default();
    for seed in 0..seeds(100) {
        let mut random = Random::new(seed);
        let mut positions = vec![Vec3::new(0.0, 0.0, 0.0), Vec3::new(4.0, 0.0, 0.0), Vec3::new(2.0, 5.0, 0.0)];
        let count = 2 + random.below(6);
        for sheet in 1..=count {
            let [low, high] = [0; 2].map(|_| 2.0 + step * random.whole(0..8) as f32);
            let (far, z) = (if random.one_in(2) { -3.0 } else { 7.0 }, sheet as f32 * 0.5);
            positions.extend([Vec3::new(low, -1.0, z), Vec3::new(high, 3.0, z), Vec3::new(far, 1.0, z)]);
        }
        let triangles = (0..=count as u32).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
        let mesh = TriangleMesh::new(positions, triangles).unwrap();
        let (eye, target) = (Vec3::new(2.0, 1.0, 7.0), Vec3::new(2.0, 1.0, 0.0));
        let camera = Camera::new(eye, target, Vec3::Y, Projection::Orthographic { height: 16.0 }, [512; 2]).unwrap();
        let drawing = drawing(&Scene::new(&mesh, &camera.viewpoint(), FINE), Also::default());
        let pieces = pieces(&mesh, &Topology::new(&mesh), &drawn(&mesh, &camera, Also::default())).unwrap();
        let (kind, crossed) = &drawing[&[0, 1]];
        let worst = compare_edge(*kind, crossed, &pieces[&[0, 1]]).unwrap_or_else(|why| panic!("seed {seed}: {why}"));
        assert!(crossed.iter().skip(1).rev().skip(1).all(|stretch| length(stretch) < 2e-6), "seed {seed}");
        sum.add(Tally { scenes: 1, places: crossed.len() - 1, worst, ..Tally::default() });
    }
    eprintln!("nearly equal parameters: {sum:?}");
    assert!(sum.places > 2 * sum.scenes, "{sum:?}");
}

fn length(stretch: &Stretch) -> f64 {
    (&stretch.range[1] - &stretch.range[0]).to_f64().unwrap()
}

/// The chains of a drawing, changed one by one.
fn edited(chains: &Chains, mut edit: impl FnMut(Chain<'_>, &mut Chains)) -> Chains {
    let mut all = Chains::default();
    chains.iter().for_each(|chain| edit(chain, &mut all));
    all
}

/// The comparison can fail: at another view, at chains that are called visible, left out, repeated or cut in two, and at a
/// place that is off by more than rounding.
#[test]
fn wrong_drawings_are_told_from_exact_ones() {
    let (mut scenes, mut caught) = (0, [0; 6]);
    for seed in 0..60 {
        let mut random = Random::new(seed);
        let mesh = without_flat_faces(&scene(FAMILIES[random.below(FAMILIES.len())], &mut random));
        let (Some(one), Some(other)) = (camera(&mesh, &mut random), camera(&mesh, &mut random)) else { continue };
        let also = creases_and_mesh();
        let expected = drawing(&Scene::new(&mesh, &one.viewpoint(), Steps::WHOLE), also);
        let chains = drawn(&mesh, &one, also);
        let is_last = |all: &Chains| all.len() + 1 == chains.len();
        let visible = edited(&chains, |chain, all| {
            all.push(Chain { style: ChainStyle { invisibility: 0, ..chain.style }, ..chain });
        });
        let left_out = edited(&chains, |chain, all| {
            if !is_last(all) {
                all.push(chain);
            }
        });
        let repeated = edited(&chains, |chain, all| {
            all.push(chain);
            if all.len() == 1 {
                all.push(chain);
            }
        });
        let cut = edited(&chains, |chain, all| {
            let can_be_cut = !chain.closed && chain.sources.len() > 1;
            if can_be_cut {
                all.push(Chain {
                    points: &chain.points[..2],
                    pixels: &chain.pixels[..2],
                    sources: &chain.sources[..1],
                    ..chain
                });
                all.push(Chain {
                    points: &chain.points[1..],
                    pixels: &chain.pixels[1..],
                    sources: &chain.sources[1..],
                    ..chain
                });
            } else {
                all.push(chain);
            }
        });
        let moved = edited(&chains, |chain, all| {
            let mut points = chain.points.to_vec();
            points[0] = points[0].lerp(points[1], 1e-8);
            all.push(Chain { points: &points, ..chain });
        });
        for (caught, wrong) in
            caught.iter_mut().zip([drawn(&mesh, &other, also), visible, left_out, repeated, cut, moved])
        {
            *caught += usize::from(compare(&mesh, &expected, &wrong).is_err());
        }
        scenes += 1;
    }
    eprintln!("wrong drawings caught in {scenes} scenes: {caught:?}");
    // Some scenes look alike from two sides, hide nothing or hold no chain that could be cut.
    assert!(caught[0] * 2 > scenes && caught[1] * 2 > scenes && caught[4] * 2 > scenes, "{caught:?} of {scenes}");
    assert!([2, 3, 5].iter().all(|&index| caught[index] * 10 > scenes * 9), "{caught:?} of {scenes}");
}
