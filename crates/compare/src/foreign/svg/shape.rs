//! Step 4: shapes as lines.

use super::arcs::{self, MAX_ARC_RADIUS};
use super::page::in_user_units;
use super::{at, finite};
use crate::foreign::error::ForeignFault;
use crate::foreign::trace::{CHORD_PX, TooMany, Tracer};
use glam::{DAffine2, DVec2};
use roxmltree::Node;
use std::f64::consts::{PI, TAU};
use std::str::FromStr;
use svgtypes::{Length, NumberListParser, SimplePathSegment, SimplifyingPathParser, Transform};

/// Most chords of a circle.
const MAX_CHORDS: f64 = 4096.0;

/// The outline of a shape in its own coordinates.
pub enum Shape<'a> {
    /// Points in order, and whether the last is joined to the first; `points` names the attribute that they come from.
    Points { attribute: &'static str, points: Vec<DVec2>, closed: bool },
    /// Path data.
    Path(&'a str),
    /// A circle or an ellipse.
    Ellipse { center: DVec2, radii: DVec2 },
}

/// The shape that an element is; nothing for one that is none.
pub fn of<'a>(node: &Node<'a, '_>) -> Result<Option<Shape<'a>>, ForeignFault> {
    let number = |name: &'static str| length(node, name);
    let point = |x, y| -> Result<DVec2, ForeignFault> { Ok(DVec2::new(number(x)?, number(y)?)) };
    Ok(Some(match node.tag_name().name() {
        "line" => {
            Shape::Points { attribute: "x1", points: vec![point("x1", "y1")?, point("x2", "y2")?], closed: false }
        }
        "polyline" => Shape::Points { attribute: "points", points: points(node)?, closed: false },
        "polygon" => Shape::Points { attribute: "points", points: points(node)?, closed: true },
        "path" => Shape::Path(node.attribute("d").unwrap_or_default()),
        "rect" => {
            let (low, extent) = (point("x", "y")?, point("width", "height")?);
            let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y].map(|corner| low + corner * extent);
            Shape::Points { attribute: "width", points: corners.to_vec(), closed: true }
        }
        "circle" => Shape::Ellipse { center: point("cx", "cy")?, radii: DVec2::splat(number("r")?) },
        "ellipse" => Shape::Ellipse { center: point("cx", "cy")?, radii: point("rx", "ry")? },
        _ => return Ok(None),
    }))
}

impl Shape<'_> {
    /// Follows the outline under a transform to pixels.
    pub fn trace(&self, node: &Node<'_, '_>, to_pixels: DAffine2, tracer: &mut Tracer) -> Result<(), ForeignFault> {
        let too_many = |many: TooMany| many.at(format!("line {}", node.document().text_pos_at(node.range().start).row));
        match self {
            Self::Points { attribute, points, closed } => {
                let mut placed = Vec::with_capacity(points.len());
                for &point in points {
                    placed.push(finite(node, attribute, to_pixels.transform_point2(point))?);
                }
                polyline(&placed, *closed, tracer).map_err(too_many)
            }
            Self::Ellipse { center, radii } => {
                let extent = to_pixels.transform_vector2(DVec2::new(radii.x, 0.0)).length()
                    + to_pixels.transform_vector2(DVec2::new(0.0, radii.y)).length();
                finite(node, "r", DVec2::splat(extent))?;
                // A chord strays by the radius times 1 - cos(half its angle).
                let chords = (PI / (1.0 - (CHORD_PX / extent).min(1.0)).acos()).ceil().clamp(8.0, MAX_CHORDS);
                let on_rim = |at: u32| center + *radii * DVec2::from_angle(TAU * f64::from(at) / chords);
                let rim: Vec<DVec2> = (0..chords as u32).map(|at| to_pixels.transform_point2(on_rim(at))).collect();
                rim.iter().try_for_each(|&point| finite(node, "cx", point).map(drop))?;
                if radii.min_element() > 0.0 { polyline(&rim, true, tracer).map_err(too_many) } else { Ok(()) }
            }
            Self::Path(data) => {
                if !arcs::are_small(data) {
                    let message = format!("has an arc with a radius above {MAX_ARC_RADIUS:e}; write a line");
                    return Err(at(node, Some("d"), &message));
                }
                let place = |x: f64, y: f64| finite(node, "d", to_pixels.transform_point2(DVec2::new(x, y)));
                let mut from = DVec2::ZERO;
                for segment in SimplifyingPathParser::from(*data) {
                    let segment = segment.map_err(|error| at(node, Some("d"), &error))?;
                    match segment {
                        SimplePathSegment::MoveTo { x, y } => {
                            from = place(x, y)?;
                            tracer.move_to(from);
                        }
                        SimplePathSegment::LineTo { x, y } => {
                            from = place(x, y)?;
                            tracer.line_to(from).map_err(too_many)?;
                        }
                        SimplePathSegment::CurveTo { x1, y1, x2, y2, x, y } => {
                            let handles = [place(x1, y1)?, place(x2, y2)?];
                            from = place(x, y)?;
                            tracer.curve_to(handles, from).map_err(too_many)?;
                        }
                        SimplePathSegment::Quadratic { x1, y1, x, y } => {
                            // The same curve as a cubic.
                            let (handle, to) = (place(x1, y1)?, place(x, y)?);
                            let handles = [from, to].map(|end| end.lerp(handle, 2.0 / 3.0));
                            from = to;
                            tracer.curve_to(handles, to).map_err(too_many)?;
                        }
                        SimplePathSegment::ClosePath => tracer.close().map_err(too_many)?,
                    }
                }
                Ok(())
            }
        }
    }
}

fn polyline(points: &[DVec2], closed: bool, tracer: &mut Tracer) -> Result<(), TooMany> {
    let Some((first, rest)) = points.split_first() else { return Ok(()) };
    tracer.move_to(*first);
    rest.iter().try_for_each(|&point| tracer.line_to(point))?;
    if closed { tracer.close() } else { Ok(()) }
}

/// The transform that an element states, or none.
pub fn transform(node: &Node<'_, '_>) -> Result<DAffine2, ForeignFault> {
    let Some(text) = node.attribute("transform") else { return Ok(DAffine2::IDENTITY) };
    let Transform { a, b, c, d, e, f } =
        Transform::from_str(text).map_err(|error| at(node, Some("transform"), &error))?;
    Ok(DAffine2::from_cols_array(&[a, b, c, d, e, f]))
}

fn length(node: &Node<'_, '_>, name: &'static str) -> Result<f64, ForeignFault> {
    let Some(text) = node.attribute(name) else { return Ok(0.0) };
    let length = Length::from_str(text).map_err(|error| at(node, Some(name), &error))?;
    in_user_units(length)
        .ok_or_else(|| at(node, Some(name), &format!("{text} depends on something else; write a number")))
}

fn points(node: &Node<'_, '_>) -> Result<Vec<DVec2>, ForeignFault> {
    let text = node.attribute("points").unwrap_or_default();
    let numbers: Result<Vec<f64>, _> = NumberListParser::from(text).collect();
    let numbers = numbers.map_err(|error| at(node, Some("points"), &error))?;
    if numbers.len() % 2 == 1 {
        return Err(at(node, Some("points"), &format!("{} numbers; give an x and a y for each point", numbers.len())));
    }
    Ok(numbers.chunks_exact(2).map(DVec2::from_slice).collect())
}
