//! The region that an outline encloses against a raster of all faces, zoomed in and out.

use crate::rays::is_thorough;
use crate::scenes::{finder, framing};
use silhouette_core::glam::DVec2;
use silhouette_core::view::Projection;
use silhouette_core::{Camera, NoProgress, TriangleMesh};
use silhouette_testing::directions::spread;
use silhouette_testing::prepare::prepared;
use silhouette_testing::{builtin, real_mesh};
use silhouette_visibility::{LineFinder, LineScene};

/// Which pixels' centres are covered, one bit per pixel.
struct Raster {
    side: usize,
    words: Vec<u64>,
}

impl Raster {
    fn new(side: usize) -> Self {
        Self { side, words: vec![0; side * side.div_ceil(64)] }
    }

    /// Marks the pixels of a row whose centres lie between two places.
    fn fill(&mut self, row: usize, [from, to]: [f64; 2]) {
        let first = |place: f64| (place - 0.5).ceil().clamp(0.0, self.side as f64) as usize;
        let (begin, end) = (first(from), first(to));
        let words_per_row = self.side.div_ceil(64);
        let below = |count: usize| if count == 64 { u64::MAX } else { (1_u64 << count) - 1 };
        let words = &mut self.words[row * words_per_row..][..words_per_row];
        for (index, word) in words.iter_mut().enumerate().take(end.div_ceil(64)).skip(begin / 64) {
            let [low, high] = [begin, end].map(|at| at.saturating_sub(index * 64).min(64));
            *word |= below(high) & !below(low);
        }
    }

    /// Calls with each row whose centre an edge crosses, and where.
    fn for_each_crossing(&self, [a, b]: [DVec2; 2], mut visit: impl FnMut(usize, f64)) {
        // The same place whichever way it runs, so that no crack opens between two faces.
        let (a, b) = if a.y < b.y { (a, b) } else { (b, a) };
        let first = |place: f64| (place - 0.5).ceil().clamp(0.0, self.side as f64) as usize;
        for row in first(a.y)..first(b.y) {
            visit(row, a.x + (row as f64 + 0.5 - a.y) / (b.y - a.y) * (b.x - a.x));
        }
    }

    fn of_faces(side: usize, faces: impl Iterator<Item = [DVec2; 3]>) -> Self {
        let mut raster = Self::new(side);
        let mut spans: Vec<(usize, f64)> = Vec::new();
        for corners in faces {
            spans.clear();
            for slot in 0..3 {
                let edge = [corners[slot], corners[(slot + 1) % 3]];
                raster.for_each_crossing(edge, |row, place| spans.push((row, place)));
            }
            spans.sort_unstable_by_key(|(row, _)| *row);
            for pair in spans.chunk_by(|one, other| one.0 == other.0) {
                let places = pair.iter().map(|(_, place)| *place);
                raster.fill(pair[0].0, [places.clone().fold(f64::MAX, f64::min), places.fold(f64::MIN, f64::max)]);
            }
        }
        raster
    }

    fn of_rings(side: usize, rings: &[Vec<DVec2>]) -> Self {
        let mut raster = Self::new(side);
        let mut crossings: Vec<(usize, f64)> = Vec::new();
        for ring in rings {
            for (at, &from) in ring.iter().enumerate() {
                let to = ring[(at + 1) % ring.len()];
                raster.for_each_crossing([from, to], |row, place| crossings.push((row, place)));
            }
        }
        crossings.sort_unstable_by(|one, other| one.0.cmp(&other.0).then(one.1.total_cmp(&other.1)));
        for of_row in crossings.chunk_by(|one, other| one.0 == other.0) {
            for span in of_row.chunks_exact(2) {
                raster.fill(span[0].0, [span[0].1, span[1].1]);
            }
        }
        raster
    }

    /// Pixels covered, and those that are covered in one alone.
    fn compare(&self, other: &Self) -> [u64; 2] {
        let differ = self.words.iter().zip(&other.words).map(|(one, other)| u64::from((one ^ other).count_ones()));
        [self.words.iter().map(|word| u64::from(word.count_ones())).sum(), differ.sum()]
    }
}

/// The camera with a picture so many times as wide, and as many pixels along each side.
fn zoomed_out(camera: &Camera, times: f64, side: u32) -> Camera {
    let projection = match camera.projection() {
        Projection::Perspective { fov_y_rad } => {
            Projection::Perspective { fov_y_rad: 2.0 * ((fov_y_rad * 0.5).tan() * times).atan() }
        }
        Projection::Orthographic { height } => Projection::Orthographic { height: height * times },
    };
    Camera::new(camera.eye(), camera.target(), camera.up(), projection, [side; 2]).unwrap()
}

fn rasters(mesh: &TriangleMesh, camera: &Camera, rings: &[Vec<DVec2>]) -> [Raster; 2] {
    let side = camera.size()[0] as usize;
    let pixels: Vec<DVec2> =
        mesh.positions().iter().map(|position| camera.project(position.as_dvec3()).unwrap().pixel).collect();
    let faces = mesh.triangles().iter().map(|corners| corners.map(|corner| pixels[corner as usize]));
    [Raster::of_faces(side, faces), Raster::of_rings(side, rings)]
}

const MODELS: [&str; 10] = [
    "armadillo.obj",
    "bear.off",
    "cow.obj",
    "dragon.ply",
    "fandisk.obj",
    "homer.obj",
    "rocker-arm.obj",
    "spot.obj",
    "stanford-bunny.obj",
    "teapot.obj",
];

/// Picture widths relative to one that frames the mesh. In the smallest, most of the mesh lies beyond the window in which the
/// outline is followed.
const ZOOMS: [f64; 4] = [5.0, 1.0, 0.2, 0.02];

#[test]
fn outlines_enclose_what_a_raster_covers() {
    let (views, side) = if is_thorough() { (30, 8192) } else { (1, 512) };
    let built_in = ["torus:48,24", "gear", "knot"].map(|name| (name, Some(builtin(name))));
    for (name, mesh) in
        built_in.into_iter().chain(MODELS.map(|name| (name, real_mesh("outlines_enclose_what_a_raster_covers", name))))
    {
        let Some(mesh) = mesh else { continue };
        let scene = LineScene::new(prepared(mesh.clone()));
        let mut finder = LineFinder::for_many_views(scene, &NoProgress).unwrap();
        let mut worst = 0.0_f64;
        for (index, direction) in spread(views).enumerate() {
            for (zoom, times) in ZOOMS.into_iter().enumerate() {
                let camera = zoomed_out(&framing(&mesh, direction, (index + zoom) % 2 == 0), times, side);
                let outline = finder.outline(&camera, &NoProgress).unwrap();
                let [of_faces, of_rings] = rasters(&mesh, &camera, &outline.rings);
                let [covered, differ] = of_faces.compare(&of_rings);
                worst = worst.max(differ as f64 / covered.max(1) as f64);
                assert!(differ * 1000 <= covered, "{name}, {direction}, {times}: {differ} of {covered}");
            }
        }
        eprintln!("{name}: at most {worst:.2e} of the covered pixels differ");
    }
}

/// The comparison can fail: the raster of a view from beside differs.
#[test]
fn the_raster_of_another_view_is_seen_to_differ() {
    let mesh = builtin("gear");
    let at = |direction| zoomed_out(&framing(&mesh, direction, true), 1.0, 512);
    let (one, other) = (at(DVec2::ONE.extend(0.3)), at(DVec2::ONE.extend(0.35)));
    let outline = finder(mesh.clone()).outline(&one, &NoProgress).unwrap();
    let [of_faces, of_rings] = rasters(&mesh, &other, &outline.rings);
    let [covered, differ] = of_faces.compare(&of_rings);
    assert!(covered > 10_000 && differ * 1000 > covered, "{differ} of {covered}");
}
