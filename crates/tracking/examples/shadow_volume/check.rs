//! Whether a volume is closed, and whether it holds exactly what the light does not reach. Naive on purpose: every edge
//! is counted, every ray asks every triangle.

use crate::volume::Caps;
use silhouette_core::glam::{DVec3, Vec4, Vec4Swizzles};
use silhouette_core::{TriangleMesh, Viewpoint};

/// Triangles over homogeneous positions.
#[derive(Clone, Copy)]
pub struct Surface<'a> {
    /// Positions; `w` is 1, or 0 for points at infinity.
    pub positions: &'a [Vec4],
    /// Counter-clockwise seen from outside.
    pub triangles: &'a [[u32; 3]],
}

/// The edges of a surface, counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct EdgeCount {
    /// Pairs of vertices that are joined.
    pub edges: usize,
    /// Those that are used more than once in each direction: where loops touch, or faces are doubled.
    pub multiple: usize,
    /// Uses in one direction beyond those in the other. The surface is closed and consistently oriented iff this is 0.
    pub unmatched: usize,
}

impl EdgeCount {
    /// Adds what another surface said.
    pub fn add(&mut self, other: Self) {
        self.edges += other.edges;
        self.multiple += other.multiple;
        self.unmatched += other.unmatched;
    }
}

/// Counts directed edges against their opposites. O(T log T) for T triangles.
pub fn count_edges(triangles: &[[u32; 3]]) -> EdgeCount {
    let sides = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let mut uses: Vec<([u32; 2], i32)> =
        sides.filter(|[a, b]| a != b).map(|[a, b]| ([a.min(b), a.max(b)], if a < b { 1 } else { -1 })).collect();
    uses.sort_unstable();
    let mut count = EdgeCount::default();
    for uses in uses.chunk_by(|one, other| one.0 == other.0) {
        count.edges += 1;
        count.multiple += usize::from(uses.len() > 2);
        count.unmatched += uses.iter().map(|&(_, direction)| direction).sum::<i32>().unsigned_abs() as usize;
    }
    count
}

/// A mesh in the light.
#[derive(Clone, Copy)]
pub struct LitScene<'a> {
    /// What casts the shadow.
    pub mesh: &'a TriangleMesh,
    /// The light, as the viewpoint that sees what it lights.
    pub light: &'a Viewpoint,
    /// Which faces cast.
    pub caps: Caps,
}

/// What samples of the space around a mesh said.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ShadowCount {
    /// Points looked at, skipped ones included.
    pub samples: u32,
    /// Points whose ray to the light is blocked.
    pub shadowed: u32,
    /// Points that say nothing: their ray passes a side of a face, or ends at a face, within [`MARGIN`].
    pub skipped: u32,
    /// Points at which volume and ray casts disagree.
    pub wrong: u32,
}

impl ShadowCount {
    /// Adds what other points said.
    pub fn add(&mut self, other: Self) {
        self.samples += other.samples;
        self.shadowed += other.shadowed;
        self.skipped += other.skipped;
        self.wrong += other.wrong;
    }
}

/// How near a ray to the light may pass a side of a face, in radii of the mesh (to which the distance from the origin
/// adds). Far ends are rounded to 32 bits, which turns sides by up to 1e-7: at a few radii less than a tenth of the
/// margin.
pub const MARGIN: f64 = 1e-5;

/// How far beyond the box around the mesh points are taken, in radii of the mesh.
const SURROUNDINGS: f64 = 0.75;

/// Counts `volume` at `samples` points in and around the mesh against ray casts; none where the mesh has no face.
///
/// At each point, along the rays that come from two eyes and go on to infinity (as z-fail counts), back-facing less
/// front-facing crossings must be the number of casting faces between point and light, and not 0 iff any face is there.
/// O(samples * (F + T)).
pub fn count_shadows(volume: Surface, scene: LitScene, samples: u32) -> ShadowCount {
    let mut count = ShadowCount::default();
    let Some(bounds) = scene.mesh.bounds() else { return count };
    let margin = MARGIN * (bounds.radius + bounds.center.length());
    let reach = SURROUNDINGS * bounds.radius;
    let (low, high) = (bounds.min - reach, bounds.max + reach);
    // Directions without a relation to any mesh.
    let eyes =
        [DVec3::new(1.734, 2.291, 3.117), DVec3::new(-2.913, -1.379, 2.071)].map(|d| bounds.center + d * bounds.radius);
    for index in 0..samples {
        let point = low + (high - low) * evenly_spread(index);
        count.samples += 1;
        let Some(layers) = cast(scene.mesh, scene.light, point, margin) else {
            count.skipped += 1;
            continue;
        };
        let casting = if scene.caps == Caps::Doubled { layers.front + layers.back } else { layers.front };
        // A face that does not cast lets light through, if the rule means it to.
        let is_blocked = if scene.caps == Caps::FrontTwice { layers.front > 0 } else { layers.front + layers.back > 0 };
        let around = eyes.map(|eye| crossings(volume, point, point - eye));
        count.shadowed += u32::from(is_blocked);
        count.wrong += u32::from(around != [casting; 2] || (casting != 0) != is_blocked);
    }
    count
}

/// The `index`th point of a sequence that fills the unit cube evenly (Roberts' additive recurrence on the root of
/// `x^4 = x + 1`).
fn evenly_spread(index: u32) -> DVec3 {
    const ROOT: f64 = 1.220_744_084_605_759_5;
    let step = DVec3::new(1.0 / ROOT, 1.0 / (ROOT * ROOT), 1.0 / (ROOT * ROOT * ROOT));
    (DVec3::splat(0.5) + step * f64::from(index)).fract()
}

/// Crossings of a ray with a closed surface on its way to infinity, infinity included: outward less inward.
///
/// With the ray's origin as the origin of space, a triangle of homogeneous points is met iff the ray's direction lies
/// in the cone over its corners `p - w * origin`: the same test for near, far and mixed triangles. A side's sign is the
/// same for both triangles at it, so no crossing is lost or counted twice between them.
fn crossings(surface: Surface, origin: DVec3, direction: DVec3) -> i32 {
    let corner = |vertex: u32| {
        let position = surface.positions[vertex as usize].as_dvec4();
        position.xyz() - origin * position.w
    };
    let crossing = |triangle: &[u32; 3]| {
        let corners = triangle.map(corner);
        let is_left = |from: usize, to: usize| {
            let side = direction.dot(corners[from].cross(corners[to]));
            if side == 0.0 { triangle[from] < triangle[to] } else { side > 0.0 }
        };
        let left = is_left(0, 1);
        if is_left(1, 2) != left || is_left(2, 0) != left {
            return 0;
        }
        // The sign of the origin's side, without which the opposite ray would count.
        let is_inside = corners[0].dot(corners[1].cross(corners[2])) > 0.0;
        if is_inside != left {
            0
        } else if left {
            1
        } else {
            -1
        }
    };
    surface.triangles.iter().map(crossing).sum()
}

/// Faces between a point and the light.
struct Layers {
    /// Those that face the light.
    front: i32,
    /// Those that do not.
    back: i32,
}

/// Counts the faces between a point and the light; `None` if the ray comes nearer than `margin` to a side of a face
/// that it might meet, or begins or ends that near to a face.
fn cast(mesh: &TriangleMesh, light: &Viewpoint, point: DVec3, margin: f64) -> Option<Layers> {
    let (toward, length) = match *light {
        Viewpoint::Perspective { eye } => {
            let toward = eye.as_dvec3() - point;
            (toward.normalize_or_zero(), toward.length())
        }
        Viewpoint::Orthographic { toward_viewer } => (toward_viewer.as_dvec3().normalize_or_zero(), f64::INFINITY),
    };
    let mut layers = Layers { front: 0, back: 0 };
    for triangle in mesh.triangles() {
        let corners = triangle.map(|vertex| mesh.positions()[vertex as usize].as_dvec3() - point);
        let along = corners.map(|corner| corner.dot(toward));
        if along.iter().all(|&t| t < -margin) || along.iter().all(|&t| t > length + margin) {
            continue;
        }
        // Distance from the ray's line to a side's, times the sine of their angle and the side's length.
        let sides = [[0, 1], [1, 2], [2, 0]].map(|[from, to]| {
            let (from, to): (DVec3, DVec3) = (corners[from], corners[to]);
            (toward.dot(from.cross(to)), margin * from.distance(to))
        });
        let (left, right) = (
            sides.iter().filter(|(side, near)| side > near).count(),
            sides.iter().filter(|(side, near)| -side > *near).count(),
        );
        if left > 0 && right > 0 {
            continue;
        }
        if left < 3 && right < 3 {
            return None;
        }
        let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        let distance = corners[0].dot(normal) / toward.dot(normal);
        if distance.abs() <= margin || (distance - length).abs() <= margin {
            return None;
        }
        if 0.0 < distance && distance < length {
            layers.front += i32::from(left == 3);
            layers.back += i32::from(right == 3);
        }
    }
    Some(layers)
}
