//! Several views on one page, placed as on a drafting sheet (ISO 5456-2, ASME Y14.3): all at one scale, each beside the one that it
//! is folded from, so that what lies above or beside each other is the same part of the thing.

use super::clip::Rectangle;
use super::layer::{Layer, LayerName};
use super::length::{Length, Unit};
use super::options::{PlotError, PlotOptions};
use super::page::{Fit, Sheet};
use super::place::{self, Placement};
use super::{Drawing, plot_placed};
use crate::lines::Lines;
use silhouette_core::glam::DVec2;
use silhouette_core::progress::Progress;
use silhouette_core::view::{Camera, Projection, ViewPreset};
use std::collections::BTreeMap;

/// How views are folded into the plane of the page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum ProjectionAngle {
    /// What is seen from the right stands on the left, what is seen from above below: ISO's.
    First,
    /// What is seen from the right stands on the right, what is seen from above above: ASME's.
    #[default]
    Third,
}

/// One of several views on a page.
#[derive(Debug, Clone, Copy)]
pub struct SheetView<'a> {
    /// From where; it decides the place on the page.
    pub preset: ViewPreset,
    /// What is seen. The camera is orthographic.
    pub lines: &'a Lines,
}

/// A column and a row of the sheet, from those of the front view on, to the right and downwards.
type Cell = [i32; 2];

/// Makes strokes of several views. Each layer holds all of them, one after another ([`Layer::views`]).
///
/// The front view stands in the middle, the others around it by `angle`, the view from behind outermost on the right. Views that are
/// not along an axis take the corner between the others. Views stand a margin apart, and all are as large as the page allows, or in
/// true scale ([`Fit::Scale`]).
///
/// # Errors
/// [`PlotError::Views`] without a page, or if the cameras are not orthographic, of one scale and of one target; otherwise as
/// [`plot`](super::plot()).
pub fn plot_views(
    views: &[SheetView<'_>],
    angle: ProjectionAngle,
    options: &PlotOptions,
    progress: &dyn Progress,
) -> Result<Drawing, PlotError> {
    let placements = placements(views, angle, options)?;
    let mut layers: BTreeMap<(u32, usize), Layer> = BTreeMap::new();
    let mut whole: Option<Drawing> = None;
    for (view, placement) in views.iter().zip(placements) {
        let mut drawing = plot_placed(view.lines, options, placement, progress)?;
        for mut layer in std::mem::take(&mut drawing.layers) {
            let paths = std::mem::take(&mut layer.paths);
            let all = layers.entry(layer.order).or_insert(layer);
            let first = all.paths.len();
            paths.iter().for_each(|path| all.paths.push(path));
            all.views.push((name(view.preset), first..all.paths.len()));
        }
        match &mut whole {
            Some(whole) => {
                whole.stats.add(&drawing.stats);
                match (&mut whole.fill, drawing.fill) {
                    (Some(all), Some(fill)) => fill.paths.iter().for_each(|path| all.paths.push(path)),
                    (all @ None, fill) => *all = fill,
                    (Some(_), None) => {}
                }
            }
            None => whole = Some(drawing),
        }
    }
    let mut whole = whole.ok_or(PlotError::Views)?;
    whole.layers = layers.into_values().collect();
    Ok(whole)
}

/// The preset's name on the command line.
fn name(preset: ViewPreset) -> &'static str {
    ViewPreset::NAMED.iter().find(|(_, other)| *other == preset).map_or("view", |(name, _)| name)
}

/// Where each view lies on the page.
fn placements(
    views: &[SheetView<'_>],
    angle: ProjectionAngle,
    options: &PlotOptions,
) -> Result<Vec<Placement>, PlotError> {
    let (Some(sheet), Some(first)) = (options.sheet, views.first()) else { return Err(PlotError::Views) };
    let per_unit = first.lines.camera.pixels_per_unit(1.0);
    for SheetView { lines: Lines { camera, .. }, .. } in views {
        options.check(camera)?;
        let like = |one: &Camera| (one.projection(), one.size(), one.target());
        let is_like = like(camera) == like(&first.lines.camera);
        if !is_like || !matches!(camera.projection(), Projection::Orthographic { .. }) {
            return Err(PlotError::Views);
        }
    }
    let presets: Vec<ViewPreset> = views.iter().map(|view| view.preset).collect();
    let cells = cells(&presets, angle);
    let reaches: Vec<Rectangle> = views.iter().map(|view| reach(view.lines, options)).collect();
    let axes = [0, 1].map(|axis| Axis::new(axis, &cells, &reaches));

    let unit = options.unit;
    let (size, gap) = (DVec2::from(sheet.page.size(unit)), sheet.margin.to(unit));
    let room = Rectangle { min: DVec2::splat(gap), max: size - gap };
    let gaps = DVec2::from(axes.each_ref().map(|axis| gap * (axis.tracks.len() as f64 - 1.0)));
    let sum = DVec2::from(axes.each_ref().map(Axis::sum));
    let scale = scale(&sheet, unit, per_unit, room.size() - gaps, sum)?;
    let begin = room.middle() - (sum * scale + gaps) * 0.5;
    let placement = |(view, cell): (&SheetView<'_>, &Cell)| {
        let middle = [0, 1].map(|axis| begin[axis] + axes[axis].middle(cell[axis], scale, gap));
        let window = place::viewport(&view.lines.camera);
        let offset = DVec2::from(middle) - window.middle() * scale;
        let window = if let Fit::Scale { .. } = sheet.fit {
            let [min, max] = [room.min, room.max].map(|corner| (corner - offset) / scale);
            window.common_with(&Rectangle { min, max })
        } else {
            window
        };
        Placement { unit, width: size.x, height: size.y, scale, offset, window }
    };
    Ok(views.iter().zip(&cells).map(placement).collect())
}

/// Page units per pixel.
fn scale(sheet: &Sheet, unit: Unit, per_unit: f64, room: DVec2, sum: DVec2) -> Result<f64, PlotError> {
    match sheet.fit {
        Fit::Scale { mm_per_unit } => Ok(Length::mm(mm_per_unit).to(unit) / per_unit),
        Fit::Lines | Fit::View if room.min_element() <= 0.0 => Err(PlotError::Margin { margin: sheet.margin }),
        Fit::Lines | Fit::View => Ok(place::fitting(sum, room)),
    }
}

/// What a view shows, from the middle of its picture on, in pixels.
fn reach(lines: &Lines, options: &PlotOptions) -> Rectangle {
    let view = place::viewport(&lines.camera);
    let drawn = lines.chains.iter().filter(|chain| LayerName::of(chain.style).pen(options).is_some());
    let seen = place::extent(view, drawn, &lines.outline.rings);
    let middle = view.middle();
    seen.map_or(Rectangle { min: DVec2::ZERO, max: DVec2::ZERO }, |seen| Rectangle {
        min: (seen.min - middle).min(DVec2::ZERO),
        max: (seen.max - middle).max(DVec2::ZERO),
    })
}

/// The columns or the rows that hold something, in order.
struct Axis {
    /// Number of each, and how far its views reach before and behind their middles, in pixels.
    tracks: Vec<(i32, [f64; 2])>,
}

impl Axis {
    fn new(axis: usize, cells: &[Cell], reaches: &[Rectangle]) -> Self {
        let mut tracks: BTreeMap<i32, [f64; 2]> = BTreeMap::new();
        for (cell, reach) in cells.iter().zip(reaches) {
            let track = tracks.entry(cell[axis]).or_default();
            *track = [track[0].max(-reach.min[axis]), track[1].max(reach.max[axis])];
        }
        Self { tracks: tracks.into_iter().collect() }
    }

    fn sum(&self) -> f64 {
        self.tracks.iter().map(|(_, [before, behind])| before + behind).sum()
    }

    /// The middle of the views of a track on the page, from the first one's edge on.
    fn middle(&self, number: i32, scale: f64, gap: f64) -> f64 {
        let before = self.tracks.iter().take_while(|(track, _)| *track < number);
        let begin: f64 = before.map(|(_, [before, behind])| (before + behind) * scale + gap).sum();
        begin + self.tracks.iter().find(|(track, _)| *track == number).map_or(0.0, |(_, reach)| reach[0] * scale)
    }
}

/// The cell of each view, no two alike.
fn cells(presets: &[ViewPreset], angle: ProjectionAngle) -> Vec<Cell> {
    let side = match angle {
        ProjectionAngle::First => -1,
        ProjectionAngle::Third => 1,
    };
    let folded = |preset: ViewPreset| match preset {
        ViewPreset::Front => Some([0, 0]),
        ViewPreset::Right => Some([side, 0]),
        ViewPreset::Left => Some([-side, 0]),
        ViewPreset::Top => Some([0, -side]),
        ViewPreset::Bottom => Some([0, side]),
        ViewPreset::Back => Some([2, 0]),
        _ => None,
    };
    let mut taken: Vec<Cell> = Vec::new();
    let mut cells: Vec<Option<Cell>> = Vec::new();
    for &preset in presets {
        let cell = folded(preset).filter(|cell| !taken.contains(cell));
        taken.extend(cell);
        cells.push(cell);
    }
    cells.into_iter().map(|cell| cell.unwrap_or_else(|| take_free(&mut taken, side))).collect()
}

/// Takes a corner whose column and row hold a view, if there is one, or a corner at all, or a new column.
fn take_free(taken: &mut Vec<Cell>, side: i32) -> Cell {
    let corners = [[side, -side], [side, side], [-side, -side], [-side, side]];
    let is_used = |axis: usize, at: i32| taken.iter().any(|cell| cell[axis] == at);
    let free = corners.into_iter().filter(|corner| !taken.contains(corner));
    let best = free.max_by_key(|&[column, row]| {
        let rank = corners.iter().position(|corner| *corner == [column, row]);
        (u8::from(is_used(0, column)) + u8::from(is_used(1, row)), std::cmp::Reverse(rank))
    });
    let beyond = taken.iter().map(|cell| cell[0]).max().unwrap_or(0) + 1;
    let cell = best.unwrap_or([beyond, 0]);
    taken.push(cell);
    cell
}
