//! Step 1, place: chains in pixels become paths on the page, cut off at the viewport and at the margins.

use super::clip::{Rectangle, clip, clip_polygon};
use super::length::{Length, Unit};
use super::options::PlotOptions;
use super::page::Fit;
use super::paths::{Path, Paths, Segment};
use crate::chains::Chain;
use silhouette_core::glam::DVec2;
use silhouette_core::view::Camera;

/// How pixels map to the page: `page = pixel * scale + offset`. The page's origin is at its top left, its y points down.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct Placement {
    /// What page coordinates are measured in.
    pub unit: Unit,
    /// The page's width in that unit.
    pub width: f64,
    /// The page's height in that unit.
    pub height: f64,
    /// Page units a pixel.
    pub scale: f64,
    /// Where the viewport's top left corner lies on the page.
    pub offset: DVec2,
    /// What of the viewport is drawn, in pixels.
    #[serde(skip)]
    pub(super) window: Rectangle,
}

impl Placement {
    /// Where a pixel lies on the page.
    pub fn page(&self, pixel: DVec2) -> DVec2 {
        pixel * self.scale + self.offset
    }

    /// Millimetres a page unit.
    pub(super) fn mm(&self) -> f64 {
        Length::new(1.0, self.unit).to(Unit::Mm)
    }

    /// The placement of a view in which `chains` are drawn. O(points).
    pub(super) fn new<'a>(
        camera: &Camera,
        options: &PlotOptions,
        chains: impl Iterator<Item = Chain<'a>>,
        outline: &[Vec<DVec2>],
    ) -> Self {
        let unit = options.unit;
        let view = viewport(camera);
        let Some(sheet) = options.sheet else {
            let scale = Length::px(1.0).to(unit);
            let [width, height] = (view.max * scale).to_array();
            return Self { unit, width, height, scale, offset: DVec2::ZERO, window: view };
        };
        let [width, height] = sheet.page.size(unit);
        let margin = sheet.margin.to(unit);
        let room = Rectangle { min: DVec2::splat(margin), max: DVec2::new(width, height) - margin };
        let framed = match sheet.fit {
            Fit::View => view,
            Fit::Lines | Fit::Scale { .. } => extent(view, chains, outline).unwrap_or(view),
        };
        let scale = match sheet.fit {
            Fit::Lines | Fit::View => fitting(framed.size(), room.size()),
            Fit::Scale { mm_per_unit } => Length::mm(mm_per_unit).to(unit) / camera.pixels_per_unit(1.0),
        };
        let offset = room.middle() - framed.middle() * scale;
        let window = match sheet.fit {
            // All that the viewport shows fits, but for rounding, which shall cut nothing off.
            Fit::Lines | Fit::View => view,
            Fit::Scale { .. } => {
                let [min, max] = [room.min, room.max].map(|corner| (corner - offset) / scale);
                view.common_with(&Rectangle { min, max })
            }
        };
        Self { unit, width, height, scale, offset, window }
    }
}

/// The largest factor by which a picture fits into the room; 1 for a point.
pub(super) fn fitting(picture: DVec2, room: DVec2) -> f64 {
    let factors = (room / picture).to_array().into_iter().filter(|factor| factor.is_finite());
    factors.reduce(f64::min).unwrap_or(1.0)
}

/// The smallest rectangle around what the viewport shows of the lines (of curves: around their handles, too).
pub(super) fn extent<'a>(
    view: Rectangle,
    chains: impl Iterator<Item = Chain<'a>>,
    outline: &[Vec<DVec2>],
) -> Option<Rectangle> {
    let mut seen: Option<Rectangle> = None;
    let mut see = |point: DVec2| match &mut seen {
        Some(seen) => {
            seen.min = seen.min.min(point);
            seen.max = seen.max.max(point);
        }
        None => seen = Some(Rectangle { min: point, max: point }),
    };
    for chain in chains {
        for segment in as_path(&chain).segments() {
            clip(&segment, &view, |part| {
                let handles = part.handles.into_iter().flatten().map(|handle| handle.clamp(view.min, view.max));
                [part.from, part.to].into_iter().chain(handles).for_each(&mut see);
            });
        }
    }
    for &corner in outline.iter().flatten().filter(|corner| corner.is_finite()) {
        see(corner.clamp(view.min, view.max));
    }
    seen
}

/// Places chains of one layer. A chain that is cut off somewhere becomes several open paths. Yields the length, in
/// page units, of what the viewport shows but the page cannot hold. O(points).
pub fn place<'a>(
    chains: impl Iterator<Item = Chain<'a>>,
    camera: &Camera,
    placement: &Placement,
    out: &mut Paths,
) -> f64 {
    let view = viewport(camera);
    let mut cut_off = 0.0;
    for chain in chains {
        let path = as_path(&chain);
        if path.closed
            && path.points.iter().chain(path.handles.iter().flatten()).all(|&point| placement.window.holds(point))
        {
            out.begin();
            path.segments().for_each(|segment| out.extend(&placed(&segment, placement)));
            out.drop_repeated_point();
            out.finish(true);
            continue;
        }
        let mut last: Option<DVec2> = None;
        for segment in path.segments() {
            let mut inside = 0.0;
            clip(&segment, &placement.window, |part| {
                inside += part.length();
                if last != Some(part.from) {
                    if last.is_some() {
                        out.finish(false);
                    }
                    out.begin();
                }
                last = Some(part.to);
                out.extend(&placed(&part, placement));
            });
            if placement.window != view {
                clip(&segment, &view, |part| cut_off += part.length());
                cut_off -= inside;
            }
        }
        if last.is_some() {
            out.finish(false);
        }
    }
    cut_off.max(0.0) * placement.scale
}

/// Places the outline: polygons stay closed, and run along the sides where they are cut off. Yields the length of what is
/// cut off, as [`place()`] does. O(points).
pub fn place_outline(outline: &[Vec<DVec2>], camera: &Camera, placement: &Placement, out: &mut Paths) -> f64 {
    let view = viewport(camera);
    let mut cut_off = 0.0;
    for polygon in outline {
        for (index, &to) in polygon.iter().enumerate() {
            let from = polygon[(index + polygon.len() - 1) % polygon.len()];
            let within = |room: &Rectangle| {
                let mut length = 0.0;
                clip(&Segment { from, to, handles: None }, room, |part| length += part.length());
                length
            };
            cut_off += within(&view) - within(&placement.window);
        }
        let corners = clip_polygon(polygon, &placement.window);
        if corners.len() >= 3 {
            out.begin();
            corners.iter().for_each(|&corner| out.extend_to(placement.page(corner)));
            out.finish(true);
        }
    }
    cut_off.max(0.0) * placement.scale
}

pub(super) fn viewport(camera: &Camera) -> Rectangle {
    Rectangle { min: DVec2::ZERO, max: DVec2::from_array(camera.size().map(f64::from)) }
}

fn as_path<'a>(chain: &Chain<'a>) -> Path<'a> {
    Path { closed: chain.closed, points: chain.pixels, handles: chain.handles }
}

fn placed(segment: &Segment, placement: &Placement) -> Segment {
    Segment {
        from: placement.page(segment.from),
        to: placement.page(segment.to),
        handles: segment.handles.map(|handles| handles.map(|handle| placement.page(handle))),
    }
}
