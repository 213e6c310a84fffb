//! [`plot`]: lines become strokes on a page, and the page a file that plotters and vector editors accept.
//!
//! 1. `place`(mod@place): pixels become page units, cut off at the viewport and the margins
//! 2. `dedupe`(mod@dedupe): what lies on another line is drawn once; visible before hidden, silhouettes first
//! 3. `bridge`(mod@bridge): a contour that is hidden for less than its pen's width goes on
//! 4. `join`(mod@join): paths of a layer that touch end to end become one
//! 5. `merge`(mod@merge): points that lie on the line between others are dropped
//! 6. `cover`(mod@cover): what lies in the ink of longer lines is left out
//! 7. `drop_short`(mod@drop_short): dots are left out
//! 8. `fit`(mod@fit): curves take the place of segments that turn little, on demand
//! 9. `dash`(mod@dash): hidden lines are cut into strokes and gaps, in phase (`phase`(mod@phase)) where they lie on each other
//! 10. `order`(mod@order): the lifted pen travels little
//!
//! Several views on one page are plotted each by itself, at one scale: `views`(mod@views).
//!
//! What comes out is a [`Drawing`], written by [`Drawing::write_svg`], [`Drawing::write_pdf`], [`Drawing::write_dxf`] or
//! [`Drawing::write_hpgl`]. [`write_json`] and [`write_gltf`] write the lines themselves, before any of these steps.

mod bridge;
mod clip;
mod cover;
mod dash;
mod decimal;
mod dedupe;
mod drawn;
mod drop_short;
mod dxf;
mod fill;
mod fit;
mod flatten;
mod gltf;
mod hpgl;
mod join;
mod json;
mod layer;
mod length;
mod merge;
mod options;
mod order;
mod page;
mod paths;
mod pdf;
mod pen;
mod phase;
mod place;
mod svg;
mod views;

pub use bridge::Bridged;
pub use drop_short::Dropped;
pub use fill::Fill;
pub use gltf::{GltfContainer, write_gltf};
pub use json::{EndPoints, write_json};
pub use layer::{Layer, LayerName, LayersBy};
pub use length::{Length, ParseLengthError, Unit};
pub use options::{Cap, Hidden, Join, PlotError, PlotOptions};
pub use order::Travel;
pub use page::{Fit, Page, ParsePageError, Sheet};
pub use paths::{Path, Paths, Segment};
pub use pen::{Colour, Dash, ParseColourError, Pen, Pens};
pub use place::Placement;
pub use views::{ProjectionAngle, SheetView, plot_views};

use crate::lines::Lines;
use rayon::prelude::*;
use silhouette_core::progress::Progress;
use std::collections::{BTreeMap, HashSet};
use std::time::{Duration, Instant};

/// Strokes on a page.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawing {
    /// The page, and where the view lies on it.
    pub placement: Placement,
    /// How strokes end.
    pub cap: Cap,
    /// How segments meet.
    pub join: Join,
    /// What is filled beneath all layers.
    pub fill: Option<Fill>,
    /// Layers that hold something, in the order of drawing.
    pub layers: Vec<Layer>,
    /// What was done.
    pub stats: PlotStats,
}

/// What plotting did. Lengths in page units, times are wall time.
#[derive(Debug, Clone, Copy, PartialEq, Default, serde::Serialize)]
pub struct PlotStats {
    /// Paths in the file.
    pub paths: u64,
    /// Points in the file.
    pub points: u64,
    /// Points of the lines as they were placed.
    pub points_placed: u64,
    /// Length of all strokes.
    pub drawn: f64,
    /// Length that the viewport shows and the page cannot hold at true scale.
    pub cut_off: f64,
    /// Segments removed, in whole or in part, because they lie on others.
    pub repeats: u64,
    /// Gaps across which a contour goes on.
    pub bridged: Bridged,
    /// Paths in the ink of longer ones that were left out.
    pub covered: Dropped,
    /// Short paths that were left out.
    pub dropped: Dropped,
    /// Way of the lifted pen within layers, before and after ordering.
    pub travel: Travel,
    /// Time of all steps but ordering.
    pub prepare: Duration,
    /// Time of ordering.
    pub order: Duration,
}

impl PlotStats {
    /// Adds what was done for another view of the same page.
    fn add(&mut self, other: &Self) {
        self.paths += other.paths;
        self.points += other.points;
        self.points_placed += other.points_placed;
        self.drawn += other.drawn;
        self.cut_off += other.cut_off;
        self.repeats += other.repeats;
        self.bridged.gaps += other.bridged.gaps;
        self.bridged.length += other.bridged.length;
        self.covered.add(other.covered);
        self.dropped.add(other.dropped);
        self.travel.before += other.travel.before;
        self.travel.after += other.travel.after;
        self.prepare += other.prepare;
        self.order += other.order;
    }
}

/// The placement of a view on the page that the options name; what [`plot`] uses. O(points).
///
/// # Errors
/// [`PlotError`] where the options cannot be honoured.
pub fn placement(lines: &Lines, options: &PlotOptions) -> Result<Placement, PlotError> {
    options.check(&lines.camera)?;
    let drawn = lines.chains.iter().filter(|chain| LayerName::of(chain.style).pen(options).is_some());
    Ok(Placement::new(&lines.camera, options, drawn, &lines.outline.rings))
}

/// Makes strokes of the lines. The same for any number of threads. About O(n log n) in points and paths.
///
/// # Errors
/// [`PlotError`] where the options cannot be honoured, or `progress` asks to stop.
pub fn plot(lines: &Lines, options: &PlotOptions, progress: &dyn Progress) -> Result<Drawing, PlotError> {
    let placement = placement(lines, options)?;
    plot_placed(lines, options, placement, progress)
}

/// The same at a given place on the page.
fn plot_placed(
    lines: &Lines,
    options: &PlotOptions,
    placement: Placement,
    progress: &dyn Progress,
) -> Result<Drawing, PlotError> {
    let start = Instant::now();
    let mut stats = PlotStats::default();
    let mut layers = place_layers(lines, options, &placement, &mut stats);
    progress.check()?;
    if options.dedupe {
        stats.repeats = dedupe_layers(&mut layers, options.merge_tolerance.to(options.unit));
    }
    bridge_layers(&mut layers, lines, options, &placement, &mut stats.bridged);
    let prepared: Vec<_> = layers.par_iter().map(|layer| prepare(layer, options)).collect();
    for (layer, Prepared { paths, covered, dropped }) in layers.iter_mut().zip(prepared) {
        layer.paths = paths;
        stats.covered.add(covered);
        stats.dropped.add(dropped);
    }
    dash::dash(&mut layers, options.unit, options.merge_tolerance.to(options.unit));
    layers.retain(|layer| !layer.paths.is_empty());
    stats.prepare = start.elapsed();

    let start = Instant::now();
    for layer in &mut layers {
        let travel = if options.order {
            let (ordered, travel) = order::order(&layer.paths, progress)?;
            layer.paths = ordered;
            travel
        } else {
            let travel = layer.paths.pen_up_travel();
            Travel { before: travel, after: travel }
        };
        stats.travel.before += travel.before;
        stats.travel.after += travel.after;
        stats.paths += layer.paths.len() as u64;
        stats.points += layer.paths.point_count() as u64;
        stats.drawn += layer.paths.length();
    }
    stats.order = start.elapsed();
    let fill = Fill::of(lines, options, &placement);
    Ok(Drawing { placement, cap: options.cap, join: options.join, fill, layers, stats })
}

/// One layer per name that has a pen and lines, and per object where layers are parted by objects.
fn place_layers(lines: &Lines, options: &PlotOptions, placement: &Placement, stats: &mut PlotStats) -> Vec<Layer> {
    let names: Vec<LayerName> = LayerName::all().collect();
    let mut chains_of: BTreeMap<(u32, usize), Vec<usize>> = BTreeMap::new();
    let mut rank_of_last: Option<(LayerName, usize)> = None;
    for (index, chain) in lines.chains.iter().enumerate() {
        let name = LayerName::of(chain.style);
        // Chains of one style follow each other.
        let rank = rank_of_last.filter(|(last, _)| *last == name).map(|(_, rank)| rank);
        let rank = rank.unwrap_or_else(|| names.iter().position(|other| *other == name).expect("all names are listed"));
        rank_of_last = Some((name, rank));
        let object = if options.layers == LayersBy::Kind { 0 } else { chain.style.object };
        chains_of.entry((object, rank)).or_default().push(index);
    }
    if !lines.outline.rings.is_empty() {
        // After all objects, in each of several views.
        chains_of.insert((u32::MAX, names.len() - 1), Vec::new());
    }
    let mut layers = Vec::new();
    for (order, chains) in chains_of {
        let name = names[order.1];
        let Some(pen) = name.pen(options) else { continue };
        let mut layer = Layer::new(order, name, pen, options);
        stats.cut_off += if name == LayerName::Outline {
            place::place_outline(&lines.outline.rings, &lines.camera, placement, &mut layer.paths)
        } else {
            let chains = chains.iter().map(|&index| lines.chains.get(index));
            place::place(chains, &lines.camera, placement, &mut layer.paths)
        };
        stats.points_placed += layer.paths.point_count() as u64;
        layers.push(layer);
    }
    layers
}

/// Removes repeats, visible lines before hidden ones and silhouettes before all others. The outline, which repeats
/// silhouettes by its nature, stays.
fn dedupe_layers(layers: &mut [Layer], tolerance: f64) -> u64 {
    let mut lines: Vec<&mut Layer> = layers.iter_mut().filter(|layer| layer.name != LayerName::Outline).collect();
    lines.sort_by_key(|layer| match layer.name {
        LayerName::Lines { kind, visible } => (!visible, Some(kind)),
        LayerName::Outline => (true, None),
    });
    let mut paths: Vec<&mut Paths> = lines.into_iter().map(|layer| &mut layer.paths).collect();
    dedupe::dedupe(&mut paths, tolerance)
}

/// Adds the gaps across which contours go on to the layers of their ends, if those are still there, as paths of their own, which
/// `join` then joins to both. A gap may lie along the line that hides it, so that repeats are removed before.
fn bridge_layers(
    layers: &mut [Layer],
    lines: &Lines,
    options: &PlotOptions,
    placement: &Placement,
    bridged: &mut Bridged,
) {
    let open = layers.iter().map(|layer| layer.paths.iter().filter(|path| !path.closed));
    let ends: Vec<HashSet<[i64; 2]>> =
        open.map(|paths| paths.flat_map(|path| [path.start(), path.end()]).map(decimal::printed).collect()).collect();
    let closed_by_ends = |kind| if options.cap == Cap::Butt { Length::mm(0.0) } else { options.pens.of(kind).width };
    let most = |kind| options.bridge.unwrap_or_else(|| closed_by_ends(kind)).to(options.unit) / placement.scale;
    for (name, object, gap) in bridge::gaps(lines, most) {
        let of_object = |layer: &Layer| options.layers == LayersBy::Kind || layer.order.0 == object;
        let Some(index) = layers.iter().position(|layer| layer.name == name && of_object(layer)) else { continue };
        let points = gap.map(|end| placement.page(end));
        if points.iter().all(|&end| ends[index].contains(&decimal::printed(end))) {
            layers[index].paths.push(Path { closed: false, points: &points, handles: &[] });
            bridged.gaps += 1;
            bridged.length += points[0].distance(points[1]);
        }
    }
}

/// The paths of a layer, ready to be dashed and ordered, and what was left out.
struct Prepared {
    paths: Paths,
    covered: Dropped,
    dropped: Dropped,
}

/// Joins, merges, drops and fits the paths of a layer.
fn prepare(layer: &Layer, options: &PlotOptions) -> Prepared {
    let unit = options.unit;
    let is_outline = layer.name == LayerName::Outline;
    let joined = if is_outline { layer.paths.clone() } else { join::join(&layer.paths) };
    let tolerance = options.merge_tolerance.to(unit) * if options.curves { 0.5 } else { 1.0 };
    let merged = merge::merge(&joined, tolerance);
    // Gaps of a pattern cover nothing, and neither does what lies past the end of a butt stroke.
    let is_solid = layer.pen.dash.is_none() && options.cap != Cap::Butt;
    let drops_covered = options.dedupe && is_solid && !is_outline && !layer.name.is_hidden();
    let (uncovered, covered) =
        if drops_covered { cover::drop_covered(&merged, layer.width(unit)) } else { (merged, Dropped::default()) };
    let (kept, dropped) = drop_short::drop_short(&uncovered, options.min_length.to(unit));
    let paths = if options.curves { fit::fit(&kept, tolerance) } else { kept };
    Prepared { paths, covered, dropped }
}
