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
    /// Whether its rows are about options that few methods have.
    pub is_about_options: bool,
    /// Makes its rows.
    pub rows: fn() -> Vec<Row>,
}

/// Every family, in the order of the page.
pub static ALL: [Family; 8] = [
    Family { title: "Scale and offset", is_about_options: false, rows: scale_and_offset::rows },
    Family { title: "Places of the eye", is_about_options: false, rows: eye_places::rows },
    Family { title: "Bad triangles", is_about_options: false, rows: bad_triangles::rows },
    Family { title: "Topology", is_about_options: false, rows: topology::rows },
    Family { title: "Projection and model matrices", is_about_options: false, rows: projection::rows },
    Family { title: "Depth", is_about_options: false, rows: depth::rows },
    Family { title: "Viewport and widths", is_about_options: false, rows: viewport_and_widths::rows },
    Family { title: "Parameters of methods", is_about_options: true, rows: parameters::rows },
];
