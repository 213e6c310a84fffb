//! A drawing as DXF: what CAD programs, laser cutters and routers open.
//!
//! The files are those of AutoCAD 2004 (`AC1018`), the first whose layers have true colours. The crate `dxf` cannot give a
//! layer a true colour or a line weight, and writes the date and random identifiers; a drawing of strokes needs few groups.

mod colour;
mod entities;
mod frame;
mod groups;

use self::groups::Groups;
use super::Drawing;
use super::length::Unit;
use std::io::{self, Write};

/// The name of the layer of what is filled.
const FILL: &str = "fill";

/// What the file says of a layer.
struct LayerRecord {
    name: String,
    colour: super::pen::Colour,
    width_mm: f64,
}

impl Drawing {
    /// Writes the drawing as ASCII DXF of AutoCAD 2004, in millimetres (`$INSUNITS` 4), origin at the page's bottom left, y up.
    ///
    /// Each layer is one of that name, as `silhouette-visible`, with the pen's colour and width, which its paths take from it.
    /// Widths are rounded to the line weights that the format knows, of 0 to 2.11 mm. Black is colour 7, which programs show as
    /// what stands out from their ground; other colours are true ones, with the nearest of the nine named ones for old readers.
    /// Straight paths are `LWPOLYLINE`s, smooth ones `SPLINE`s of the same cubics; a fill is a solid `HATCH` beneath all others.
    /// Coordinates have three decimals, and no date is written, so that equal drawings are equal bytes.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_dxf(&self, out: &mut dyn Write) -> io::Result<()> {
        let mm = self.placement.mm();
        let filled = self.fill.as_ref().filter(|fill| entities::fills_something(fill));
        let fill = filled.iter().map(|fill| LayerRecord { name: FILL.to_owned(), colour: fill.colour, width_mm: 0.0 });
        let strokes = self.layers.iter().map(|layer| LayerRecord {
            name: layer.entry_id(),
            colour: layer.pen.colour,
            width_mm: layer.width(Unit::Mm),
        });
        let records: Vec<LayerRecord> = fill.chain(strokes).collect();
        let entities = self.layers.iter().map(|layer| layer.paths.len()).sum::<usize>() + usize::from(filled.is_some());
        let height = self.placement.height;

        let mut groups = Groups::new(mm, height, out);
        frame::head(&mut groups, [self.placement.width, height], &records, entities)?;
        groups.section("ENTITIES")?;
        if let Some(fill) = filled {
            entities::hatch(&mut groups, FILL, fill)?;
        }
        for layer in &self.layers {
            let name = layer.entry_id();
            layer.paths.iter().try_for_each(|path| entities::path(&mut groups, &name, path))?;
        }
        groups.end_section()?;
        frame::tail(&mut groups)
    }
}
