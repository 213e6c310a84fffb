//! The smallest offset whose surface, simplified, encloses the object.

use crate::hull::caps::capped;
use crate::hull::coarsen::coarsened;
use crate::hull::collapse::collapsed;
use crate::hull::enclosure::{Enclosed, Enclosure};
use crate::hull::offset_surface::{OffsetError, offset_surface};
use crate::hull::{Failure, Hull, HullError};
use silhouette_core::mesh::Bounds;
use silhouette_core::origin::largest_rounding;
use silhouette_core::{Cancelled, Progress, TriangleMesh};
use silhouette_rays::MeshHierarchy;
use std::sync::Arc;

/// Smallest offset tried, as a share of the radius of the object's bounding sphere.
pub const LEAST_OFFSET: f64 = 1.0 / 1024.0;

/// Largest offset tried, as a share of the radius. At twice the radius, a tetrahedron with its corners that far away encloses
/// any object.
pub const MOST_OFFSET: f64 = 4.0;

/// The offset found is at most this many times one that fails.
pub const PRECISION: f64 = 1.05;

/// How far from the object's box a hull and distances to it have to fit 32-bit floats, in radii of the bounding sphere.
const REACH: f64 = 8.0;

/// First offset tried, as a share of the radius.
const FIRST_OFFSET: f64 = 1.0 / 16.0;

/// What the estimate of the smallest offset is multiplied by, so that its surface stays below the limit.
const FEWER_FACES: f64 = 1.05;

/// With how many times the wanted vertices, or [`COARSE`] if that is more, unchecked collapses leave a surface, in turn.
const TIMES: [usize; 3] = [16, 4, 2];

/// Checked collapses of so few vertices take no time that matters.
const COARSE: usize = 200;

/// Most faces of an offset surface, whatever the wanted vertices: more take minutes.
pub const MOST_FACES: usize = 1 << 21;

/// What [`Hull::enclosing`] is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HullOptions {
    /// Most vertices, at least 4.
    pub vertices: usize,
    /// Holes of the object whose boxes have no longer side than this share of the radius of its bounding sphere are closed, as
    /// far as the shape of the hull is concerned: otherwise it leads through them and covers the object's inside, too. 0
    /// closes none.
    pub closed_holes: f64,
    /// Faces of the finest offset surface per wanted vertex, of which at least 100 count, up to [`MOST_FACES`] in all: no smaller
    /// offset is tried. The hull comes closer with the inverse square root, and time is proportional.
    pub faces_per_vertex: usize,
}

impl Default for HullOptions {
    /// 500 vertices: what the paper uses for objects of some ten thousand. Holes up to the radius are closed.
    fn default() -> Self {
        Self { vertices: 500, closed_holes: 1.0, faces_per_vertex: 512 }
    }
}

impl Hull {
    /// The hull of at most so many vertices that is closest to an object: a simplified offset surface, of the smallest offset
    /// for which it encloses the object.
    ///
    /// From a sixteenth of the radius on, the offset is halved while the hull holds, or doubled until it does, between [`LEAST_OFFSET`]
    /// and [`MOST_OFFSET`] times the radius of the object's bounding sphere, and then bisected in logarithmic scale to within
    /// [`PRECISION`]. It is also left where a smaller one would take a surface of more faces than the options allow. A smaller
    /// offset can hold by chance where a larger one fails; so it is the border that bisection meets. The same bits for any number
    /// of threads. Some three to ten offset surfaces, simplifications and proofs.
    ///
    /// # Errors
    /// [`HullError`].
    pub fn enclosing(object: &TriangleMesh, options: &HullOptions, progress: &dyn Progress) -> Result<Self, HullError> {
        let vertices = options.vertices;
        let most_faces = vertices.max(100).saturating_mul(options.faces_per_vertex).min(MOST_FACES);
        if vertices < 4 {
            return Err(HullError::TooFewVertices(vertices));
        }
        let bounds = object.bounds().filter(|bounds| bounds.radius > 0.0).ok_or(HullError::NoExtent)?;
        let (step, radius) = (2.0 * largest_rounding(object), bounds.radius);
        // Wherever positions count from, no two are closer than the smallest number.
        if f64::from(f32::from_bits(1)) > LEAST_OFFSET * radius {
            return Err(HullError::TooSmall { radius });
        }
        if step > LEAST_OFFSET * radius {
            return Err(HullError::TooFar { step, radius });
        }
        // Distances through the hull are kept in 32 bits, and offsets tried until one holds.
        let farthest = bounds.min.abs().max(bounds.max.abs()).max_element();
        if farthest + REACH * radius > f64::from(f32::MAX) {
            return Err(HullError::TooLarge { radius });
        }
        progress.stage("hull", 0);
        progress.check()?;
        let capped = capped(object, options.closed_holes * bounds.radius, progress)?;
        let shaping = capped.map(|capped| MeshHierarchy::with_progress(&capped, progress)).transpose()?;
        let object = Enclosed::with_progress(object, progress)?;
        let search = Search { object, bounds, vertices, most_faces, shaping, progress };
        search.run()
    }
}

struct Search<'a> {
    object: Enclosed<'a>,
    bounds: Bounds,
    vertices: usize,
    /// Most faces of an offset surface.
    most_faces: usize,
    /// The object with its holes closed, where it has some.
    shaping: Option<MeshHierarchy>,
    progress: &'a dyn Progress,
}

struct Found {
    hull: TriangleMesh,
    enclosure: Enclosure,
    share: f64,
    /// Of the offset surface.
    faces: usize,
}

impl Search<'_> {
    fn run(&self) -> Result<Hull, HullError> {
        let (mut fails, mut holds) = (None, None);
        let mut failure = Failure::Unsupported;
        let (mut share, mut least) = (FIRST_OFFSET, LEAST_OFFSET);
        while (LEAST_OFFSET..=MOST_OFFSET).contains(&share) {
            match self.attempt(share)? {
                Ok(found) => {
                    // The number of faces is inversely proportional to the square of the offset.
                    least = least.max(share * (found.faces as f64 / self.most_faces as f64).sqrt() * FEWER_FACES);
                    holds = Some(found);
                }
                Err(why) => (fails, failure) = (Some(share), why),
            }
            share = match (fails, &holds) {
                (Some(fails), Some(holds)) if holds.share <= PRECISION * fails => break,
                (Some(fails), Some(holds)) => (fails * holds.share).sqrt(),
                (Some(fails), None) => fails * 2.0,
                (None, Some(holds)) if holds.share <= PRECISION * least => break,
                (None, Some(holds)) => least.max(holds.share / 2.0),
                (None, None) => break,
            };
        }
        let out_of_reach = HullError::OutOfReach { vertices: self.vertices, failure };
        let Found { hull, enclosure, share, .. } = holds.ok_or(out_of_reach)?;
        Ok(Hull { mesh: Arc::new(hull), offset: Some(share * self.bounds.radius), enclosure: Some(enclosure) })
    }

    /// What offset surfaces and collapses keep away from.
    fn shaping(&self) -> &MeshHierarchy {
        self.shaping.as_ref().unwrap_or(self.object.hierarchy())
    }

    fn attempt(&self, share: f64) -> Result<Result<Found, Failure>, HullError> {
        self.progress.check()?;
        let offset = share * self.bounds.radius;
        let surface = match offset_surface(self.shaping(), &self.bounds, offset, self.most_faces, self.progress) {
            Ok(surface) => surface,
            Err(OffsetError::Cancelled(cancelled)) => return Err(cancelled.into()),
            Err(OffsetError::TooFine(_) | OffsetError::TooFar(_)) => return Ok(Err(Failure::Unsupported)),
        };
        let result = self.hull_of(surface, share)?;
        self.progress.advance(1);
        Ok(result)
    }

    /// The hull that a surface becomes: by unchecked collapses as far as they leave a hull, then by checked ones.
    fn hull_of(&self, mut hull: TriangleMesh, share: f64) -> Result<Result<Found, Failure>, Cancelled> {
        let faces = hull.face_count();
        for times in TIMES {
            self.progress.check()?;
            let vertices = self.vertices.max(COARSE).saturating_mul(times);
            match coarsened(&hull, vertices, self.progress)? {
                Ok(coarse) if self.object.by_with_progress(&coarse, self.progress)?.is_proved() => hull = coarse,
                _ => break,
            }
        }
        let hull = collapsed(&hull, self.shaping(), self.vertices, self.progress)?;
        if hull.vertex_count() > self.vertices {
            return Ok(Err(Failure::Vertices(hull.vertex_count())));
        }
        let enclosure = self.object.by_with_progress(&hull, self.progress)?;
        Ok(match enclosure.first {
            None => Ok(Found { hull, enclosure, share, faces }),
            Some(offence) => Err(Failure::Offence(offence)),
        })
    }
}
