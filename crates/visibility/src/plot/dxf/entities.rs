//! Paths as entities.

use super::super::decimal::printed;
use super::super::fill::Fill;
use super::super::paths::Path;
use super::frame::MODEL_SPACE;
use super::groups::Groups;
use std::io;

/// Where degree 3 ends and begins again.
const DEGREE: usize = 3;

/// A path on a layer: a polyline, or a spline where it has handles.
pub fn path(groups: &mut Groups<'_>, layer: &str, path: Path<'_>) -> io::Result<()> {
    if path.handles.is_empty() { polyline(groups, layer, path) } else { spline(groups, layer, path) }
}

fn polyline(groups: &mut Groups<'_>, layer: &str, path: Path<'_>) -> io::Result<()> {
    begin(groups, "LWPOLYLINE", layer, "AcDbPolyline")?;
    groups.put(90, path.points.len())?;
    groups.put(70, u8::from(path.closed))?;
    path.points.iter().try_for_each(|&point| groups.put_place(10, point))
}

/// Bezier pieces one after another are a B-spline with knots three times where they meet.
fn spline(groups: &mut Groups<'_>, layer: &str, path: Path<'_>) -> io::Result<()> {
    const PLANAR: &str = "8";
    let pieces = path.segment_count();
    begin(groups, "SPLINE", layer, "AcDbSpline")?;
    groups.put_all(&[(210, "0"), (220, "0"), (230, "1"), (70, PLANAR)])?;
    groups.put(71, DEGREE)?;
    groups.put(72, DEGREE * (pieces + 1) + 2)?;
    groups.put(73, DEGREE * pieces + 1)?;
    groups.put(74, 0)?;
    groups.put(40, 0)?;
    for knot in 0..=pieces {
        (0..DEGREE).try_for_each(|_| groups.put(40, knot))?;
    }
    groups.put(40, pieces)?;
    let mut control = |point| {
        groups.put_place(10, point)?;
        groups.put(30, 0)
    };
    control(path.start())?;
    for segment in path.segments() {
        let handles = segment.handles.unwrap_or([segment.from, segment.to]);
        handles.into_iter().chain([segment.to]).try_for_each(&mut control)?;
    }
    Ok(())
}

/// Whether a fill is more than points and lines in the file.
pub fn fills_something(fill: &Fill) -> bool {
    fill.paths.iter().any(encloses_something)
}

/// What is filled, as one solid hatch with a boundary for each ring.
pub fn hatch(groups: &mut Groups<'_>, layer: &str, fill: &Fill) -> io::Result<()> {
    const POLYLINE: &str = "2";
    const OUTERMOST: &str = "19";
    begin(groups, "HATCH", layer, "AcDbHatch")?;
    let fixed = [(10, "0"), (20, "0"), (30, "0"), (210, "0"), (220, "0"), (230, "1")];
    groups.put_all(&fixed)?;
    groups.put_all(&[(2, "SOLID"), (70, "1"), (71, "0")])?;
    let rings = || fill.paths.iter().filter(|ring| encloses_something(*ring));
    groups.put(91, rings().count())?;
    for (index, ring) in rings().enumerate() {
        groups.put(92, if index == 0 { OUTERMOST } else { POLYLINE })?;
        groups.put_all(&[(72, "0"), (73, "1")])?;
        groups.put(93, ring.points.len())?;
        ring.points.iter().try_for_each(|&point| groups.put_place(10, point))?;
        groups.put(97, 0)?;
    }
    // Every other ring is a hole; associated with nothing, no seed.
    groups.put_all(&[(75, "0"), (76, "1"), (98, "0")])
}

/// Whether a ring has three places in the file.
fn encloses_something(ring: Path<'_>) -> bool {
    let mut places: Vec<[i64; 2]> = ring.points.iter().map(|&point| printed(point)).collect();
    places.sort_unstable();
    places.dedup();
    places.len() > 2
}

fn begin(groups: &mut Groups<'_>, kind: &str, layer: &str, class: &str) -> io::Result<()> {
    groups.put(0, kind)?;
    groups.put_handle()?;
    groups.put_all(&[(330, MODEL_SPACE), (100, "AcDbEntity"), (8, layer), (100, class)])
}
