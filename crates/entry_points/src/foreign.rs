//! [`foreign`].

use crate::check_message;
use silhouette_compare::foreign::{Drawing, Frame, Polyline, crowding, edge_list, picture, svg};

const FRAME: Frame = Frame { size: [64, 48], pen_width_px: 2.0 };

/// Reads a drawing by another program: the first byte says whether the rest is SVG, JSON or PNG.
///
/// Lines lie within the picture and the pen's width around it; an error says something.
pub fn foreign(bytes: &[u8]) -> bool {
    let Some((kind, file)) = bytes.split_first() else { return false };
    let read = match kind {
        b's' => svg::read(file, FRAME).map(|(lines, notes)| {
            check_lines(&lines);
            notes.iter().for_each(|note| check_message(note));
        }),
        b'j' => edge_list::read(file, FRAME).map(|list| {
            if let Drawing::Lines(lines) = &list.drawing {
                check_lines(lines);
            }
            list.notes.iter().for_each(|note| check_message(note));
        }),
        b'p' => picture::read(file, FRAME.size).map(|picture| {
            assert_eq!([picture.width, picture.height], FRAME.size);
            picture::note(&picture);
        }),
        _ => return false,
    };
    match read {
        Ok(()) => true,
        Err(fault) => {
            check_message(&fault.to_string());
            false
        }
    }
}

fn check_lines(lines: &[Polyline]) {
    let [width, height] = FRAME.size.map(f64::from);
    let margin = 2.0 * FRAME.pen_width_px + 1.0;
    for point in lines.iter().flat_map(|line| &line.points) {
        let is_near = (-margin..=width + margin).contains(&point.x) && (-margin..=height + margin).contains(&point.y);
        assert!(is_near, "{point} lies outside of the picture");
    }
    if let Err(fault) = crowding::check(lines, FRAME) {
        check_message(&fault.to_string());
    }
}
