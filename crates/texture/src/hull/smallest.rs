//! The smallest offset whose surface, simplified, encloses the object.

use crate::hull::coarsen::coarsened;
use crate::hull::collapse::collapsed;
use crate::hull::enclosure::{Enclosed, Enclosure};
use crate::hull::offset_surface::offset_surface;
use crate::hull::{Failure, Hull, HullError};
use silhouette_core::mesh::Bounds;
use silhouette_core::{Cancelled, Progress, TriangleMesh};
use std::sync::Arc;

/// Smallest offset tried, as a share of the radius of the object's bounding sphere.
pub const LEAST_OFFSET: f64 = 1.0 / 1024.0;

/// Largest offset tried, as a share of the radius. At twice the radius, a tetrahedron with its corners that far away encloses
/// any object.
pub const MOST_OFFSET: f64 = 4.0;

/// The offset found is at most this many times one that fails.
pub const PRECISION: f64 = 1.05;

/// First offset tried, as a share of the radius.
const FIRST_OFFSET: f64 = 1.0 / 16.0;

/// With how many times the wanted vertices a surface is left by unchecked collapses; tried in turn.
const TIMES: [usize; 3] = [2, 4, 16];

/// What [`Hull::enclosing`] is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct HullOptions {
    /// Most vertices, at least 4.
    pub vertices: usize,
}

impl Default for HullOptions {
    /// 500 vertices: what the paper uses for objects of some ten thousand.
    fn default() -> Self {
        Self { vertices: 500 }
    }
}

impl Hull {
    /// The hull of at most so many vertices that is closest to an object: a simplified offset surface, of the smallest offset
    /// for which it encloses the object.
    ///
    /// From [`FIRST_OFFSET`] on the offset is halved while the hull holds, or doubled until it does, between [`LEAST_OFFSET`]
    /// and [`MOST_OFFSET`] times the radius of the object's bounding sphere, and then bisected in logarithmic scale to within
    /// [`PRECISION`]. A smaller offset can hold by chance where a larger one fails; so it is the border that bisection meets.
    /// The same bits for any number of threads. Some ten offset surfaces, simplifications and proofs.
    ///
    /// # Errors
    /// [`HullError`].
    pub fn enclosing(object: &TriangleMesh, options: &HullOptions, progress: &dyn Progress) -> Result<Self, HullError> {
        let vertices = options.vertices;
        if vertices < 4 {
            return Err(HullError::TooFewVertices(vertices));
        }
        let bounds = object.bounds().filter(|bounds| bounds.radius > 0.0).ok_or(HullError::NoExtent)?;
        progress.stage("hull", 0);
        progress.check()?;
        let search = Search { object: Enclosed::new(object), bounds, vertices, progress };
        search.run()
    }
}

struct Search<'a> {
    object: Enclosed<'a>,
    bounds: Bounds,
    vertices: usize,
    progress: &'a dyn Progress,
}

struct Found {
    hull: TriangleMesh,
    enclosure: Enclosure,
    share: f64,
}

impl Search<'_> {
    fn run(&self) -> Result<Hull, HullError> {
        let (mut fails, mut holds) = (None, None);
        let mut failure = Failure::Unsupported;
        let mut share = FIRST_OFFSET;
        while (LEAST_OFFSET..=MOST_OFFSET).contains(&share) {
            match self.attempt(share)? {
                Ok(found) => holds = Some(found),
                Err(why) => (fails, failure) = (Some(share), why),
            }
            share = match (fails, &holds) {
                (Some(fails), Some(holds)) if holds.share <= PRECISION * fails => break,
                (Some(fails), Some(holds)) => (fails * holds.share).sqrt(),
                (Some(fails), None) => fails * 2.0,
                (None, Some(holds)) => holds.share / 2.0,
                (None, None) => break,
            };
        }
        let out_of_reach = HullError::OutOfReach { vertices: self.vertices, failure };
        let Found { hull, enclosure, share } = holds.ok_or(out_of_reach)?;
        Ok(Hull { mesh: Arc::new(hull), offset: Some(share * self.bounds.radius), enclosure: Some(enclosure) })
    }

    fn attempt(&self, share: f64) -> Result<Result<Found, Failure>, HullError> {
        self.progress.check()?;
        let offset = share * self.bounds.radius;
        let Ok(surface) = offset_surface(self.object.hierarchy(), &self.bounds, offset) else {
            return Ok(Err(Failure::Unsupported));
        };
        let mut result = Err(Failure::Unsupported);
        for times in TIMES {
            self.progress.check()?;
            result = self.hull_of(&surface, times, share)?;
            if result.is_ok() || surface.vertex_count() <= times * self.vertices {
                break;
            }
        }
        self.progress.advance(1);
        Ok(result)
    }

    /// The hull that a surface becomes: down to `times` the wanted vertices unchecked, then by checked collapses.
    fn hull_of(&self, surface: &TriangleMesh, times: usize, share: f64) -> Result<Result<Found, Failure>, Cancelled> {
        let coarse = match coarsened(surface, times * self.vertices) {
            Ok(coarse) => coarse,
            Err(vertices) => return Ok(Err(Failure::Vertices(vertices))),
        };
        if let Some(offence) = self.object.by(&coarse).first {
            return Ok(Err(Failure::Offence(offence)));
        }
        let hull = collapsed(&coarse, self.object.hierarchy(), self.vertices, self.progress)?;
        if hull.vertex_count() > self.vertices {
            return Ok(Err(Failure::Vertices(hull.vertex_count())));
        }
        let enclosure = self.object.by(&hull);
        Ok(match enclosure.first {
            None => Ok(Found { hull, enclosure, share }),
            Some(offence) => Err(Failure::Offence(offence)),
        })
    }
}
