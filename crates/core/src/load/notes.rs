//! [`Note`]: what a file's user should know although the file was read.

use super::error::Place;
use crate::id::FaceId;
use std::fmt;

/// Something about a file that is read all the same. Displays as one line without the file's name.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Note {
    /// Faces of fewer than three corners were left out.
    FewCorners {
        /// How many.
        count: u64,
        /// Where the first one stands.
        first: Place,
    },
    /// Polygons that cross themselves, so that no triangles cover them, were fanned from their first corner, as if they
    /// were convex. Some of their triangles fold over others. A simple polygon of thousands of corners may be among them if
    /// to cut it would take too long.
    CrossingPolygons {
        /// How many.
        count: u64,
        /// The first triangle of the first one.
        first: FaceId,
    },
    /// 32-bit positions hold too little of a mesh this large and fine: rounding may have changed the directions of many short sides of
    /// faces.
    Rounded {
        /// The most that a position was moved by along an axis, in units of the file.
        distance: f64,
        /// How many sides of faces are short: no longer than 64 times that.
        sides: usize,
        /// How many there are.
        of: usize,
    },
    /// A text STL ends behind a whole facet, but without `endsolid`.
    NoEnd,
}

impl fmt::Display for Note {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::FewCorners { count: 1, first } => {
                write!(f, "1 face of fewer than three corners was left out ({first})")
            }
            Self::FewCorners { count, first } => {
                write!(f, "{count} faces of fewer than three corners were left out (the first: {first})")
            }
            Self::CrossingPolygons { count: 1, first } => {
                write!(
                    f,
                    "1 polygon crosses itself and is fanned from its first corner (face {first} and those after it)"
                )
            }
            Self::CrossingPolygons { count, first } => write!(
                f,
                "{count} polygons cross themselves and are fanned from their first corners (the first: face {first} and \
                 those after it)"
            ),
            Self::Rounded { distance, sides, of } => write!(
                f,
                "positions are rounded by up to {distance:.1e} (32-bit numbers), which is much for {sides} of {of} sides of faces; \
                 split the mesh into parts of smaller extent"
            ),
            Self::NoEnd => f.write_str("the file ends without endsolid; if it was cut short, faces are missing"),
        }
    }
}
