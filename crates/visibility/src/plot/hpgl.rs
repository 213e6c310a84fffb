//! A drawing as HP-GL: what pen plotters of old and many cutters draw.

use super::Drawing;
use super::flatten::flatten;
use silhouette_core::glam::DVec2;
use std::io::{self, Write};

/// Plotter units a millimetre.
const UNITS_PER_MM: f64 = 40.0;
/// How far chords may lie off their curve in millimetres: half a plotter unit, as much as rounding moves a point.
const TOLERANCE_MM: f64 = 0.5 / UNITS_PER_MM;

impl Drawing {
    /// Writes the drawing as HP-GL: `IN`, then for each layer `SP` with its number, from 1, and for each path `PU` to its start and
    /// `PD` along it.
    ///
    /// Coordinates are plotter units of 1/40 mm from the page's bottom left corner, y up. Curves are drawn as chords within
    /// half a unit. The format knows no colours and no widths: those are the pens'. Points that are one in plotter units are
    /// written once, and what is a single one is a dot. A fill is left out.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_hpgl(&self, out: &mut dyn Write) -> io::Result<()> {
        let mm = self.placement.mm();
        let height = self.placement.height;
        let units = |point: DVec2| {
            (DVec2::new(point.x, height - point.y) * (mm * UNITS_PER_MM)).to_array().map(|side| side.round() as i64)
        };
        let mut text = String::from("IN;\n");
        for (number, layer) in (1..).zip(&self.layers) {
            text.push_str(&format!("SP{number};\n"));
            for path in layer.paths.iter() {
                let [x, y] = units(path.start());
                text.push_str(&format!("PU{x},{y};PD"));
                let (mut last, mut separator) = ([x, y], "");
                flatten(path, TOLERANCE_MM / mm, |point| {
                    let at = units(point);
                    if at != last {
                        text.push_str(&format!("{separator}{},{}", at[0], at[1]));
                        (last, separator) = (at, ",");
                    }
                });
                text.push_str(";\n");
            }
            out.write_all(text.as_bytes())?;
            text.clear();
        }
        text.push_str("PU;SP0;\n");
        out.write_all(text.as_bytes())
    }
}
