//! All extremes, a file per family.

mod bad_triangles;
mod depth;
mod eye_places;
mod parameters;
mod projection;
mod scale_and_offset;
mod topology;
mod viewport_and_widths;

use crate::row::Row;

/// Rows that belong together: a table of the page.
pub struct Family {
    /// Its heading.
    pub title: &'static str,
    /// Makes its rows.
    pub rows: fn() -> Vec<Row>,
}

/// Every family, in the order of the page.
pub static ALL: [Family; 8] = [
    Family { title: "Scale and offset", rows: scale_and_offset::rows },
    Family { title: "Places of the eye", rows: eye_places::rows },
    Family { title: "Bad triangles", rows: bad_triangles::rows },
    Family { title: "Topology", rows: topology::rows },
    Family { title: "Projection and model matrices", rows: projection::rows },
    Family { title: "Depth", rows: depth::rows },
    Family { title: "Viewport and widths", rows: viewport_and_widths::rows },
    Family { title: "Parameters of methods", rows: parameters::rows },
];
