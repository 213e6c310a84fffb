//! The outline: the boundary of the union of all projected faces, as a planar map.
//!
//! 1. `chain.rs`: contours as directed edges of the picture, with the scene on their left, as many times as there are layers
//!    more on that side. They close: together they are the boundary of all projected faces. `window.rs`: what is far beyond the
//!    picture or behind the eye is cut off, and the chain closed along the border. Points are snapped to a lattice far below
//!    any pixel.
//! 2. `lattice.rs`, `chain_map.rs`, `resolve.rs`, `arrangement.rs`: cell by cell of a grid, only what may bound the covered
//!    area is kept, which on a scan is little.
//! 3. `cycles.rs`, `union.rs`: what remains is united by `i_overlay`, with the rule that a point is inside where its winding
//!    number is above 0.
//! 4. `seal.rs`: slivers as wide as rounding are closed.
//! 5. `nesting.rs`: the rings are sorted into regions.
//!
//! The winding number of a point is the number of layers there, which is why closed and open meshes, meshes that are wound
//! against each other and meshes that overlap need no case of their own. A face seen edge-on has no area and adds nothing.

mod arrangement;
mod chain;
mod chain_map;
mod cycles;
mod lattice;
mod nesting;
mod resolve;
mod seal;
mod union;
mod window;

use self::lattice::{Point, pixel};
use crate::contours::Contour;
use crate::frame::PictureFrame;
use crate::line_error::LineError;
use crate::scene::Extent;
use crate::viewed_mesh::ViewedMesh;
use silhouette_core::Progress;
use silhouette_core::glam::DVec2;
use std::ops::Range;

/// The boundary of the union of all projected faces: disjoint simple rings.
#[derive(Debug, Clone, PartialEq, Default, serde::Serialize)]
pub struct Outline {
    /// All rings, in pixels (origin at the top left, y down), each closed by its first point. Seen in the picture, an outer
    /// ring runs counter-clockwise and a hole clockwise, so that the scene is on the left of all.
    pub rings: Vec<Vec<DVec2>>,
    /// The rings of each connected region: its outer ring, then its holes.
    regions: Vec<Range<usize>>,
}

impl Outline {
    /// An outline of regions, each its outer ring followed by its holes.
    pub fn of_regions(regions: impl IntoIterator<Item = Vec<Vec<DVec2>>>) -> Self {
        let mut outline = Self::default();
        for region in regions {
            let begin = outline.rings.len();
            outline.rings.extend(region);
            outline.regions.push(begin..outline.rings.len());
        }
        outline
    }

    /// The connected regions of the picture that the scene covers: of each the outer ring, then its holes. As it is, a region
    /// can be filled by either rule.
    pub fn regions(&self) -> impl ExactSizeIterator<Item = &[Vec<DVec2>]> {
        self.regions.iter().map(|rings| &self.rings[rings.clone()])
    }

    /// The area that the scene covers, in square pixels. O(points).
    pub fn area_px(&self) -> f64 {
        let of_ring = |ring: &Vec<DVec2>| {
            let next = ring.iter().cycle().skip(1);
            // Clockwise with y down is counter-clockwise as seen.
            ring.iter().zip(next).map(|(a, b)| b.perp_dot(*a)).sum::<f64>() * 0.5
        };
        self.rings.iter().map(of_ring).sum()
    }

    /// Whether nothing is covered.
    pub fn is_empty(&self) -> bool {
        self.rings.is_empty()
    }
}

/// The outline of a view, of which these are the contours, of a scene that spans so much.
///
/// # Errors
/// [`LineError`].
pub fn outline(
    view: &ViewedMesh<'_>,
    contours: &[Contour],
    frame: &PictureFrame,
    extent: &Extent,
    progress: &dyn Progress,
) -> Result<Outline, LineError> {
    progress.check()?;
    let chain = chain::chain(view, contours, frame, extent);
    progress.check()?;
    // Only a crowd is worth looking for edges that lie on each other.
    let bounds = resolve::resolve(&chain).or_else(|_| resolve::resolve(&chain::without_repeats(chain)))?;
    progress.check()?;
    let regions = nesting::regions(seal::sealed(union::union(&cycles::cycles(bounds))));
    let in_pixels = |ring: Vec<Point>| ring.into_iter().map(pixel).collect();
    Ok(Outline::of_regions(regions.into_iter().map(|region| region.into_iter().map(in_pixels).collect())))
}
