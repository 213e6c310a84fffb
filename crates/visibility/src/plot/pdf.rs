//! A drawing as PDF: one page, one optional content group a layer.

use super::Drawing;
use super::decimal::rounded;
use super::fill::Fill;
use super::layer::Layer;
use super::options::{Cap, Join};
use super::paths::Path;
use super::pen::Colour;
use pdf_writer::types::{LineCapStyle, LineJoinStyle};
use pdf_writer::{Content, Finish, Name, Pdf, Rect, Ref, TextStr};
use silhouette_core::glam::DVec2;
use std::io::{self, Write};

/// Points, the unit of PDF, a millimetre.
const POINTS_PER_MM: f64 = 72.0 / 25.4;
/// The longest side in user space units that readers have to accept; larger pages have larger units.
const MAX_SIDE: f64 = 14_400.0;
/// What SVG takes where nothing is said, so that both formats look alike.
const MITER_LIMIT: f32 = 4.0;

const CATALOG: Ref = Ref::new(1);
const PAGES: Ref = Ref::new(2);
const PAGE: Ref = Ref::new(3);
const CONTENT: Ref = Ref::new(4);
const INFO: Ref = Ref::new(5);
/// The first layer's group; the others follow.
const FIRST_GROUP: i32 = 6;

impl Drawing {
    /// Writes the drawing as PDF 1.7: a page of the drawing's size, strokes with the pens' widths and colours, curves as curves.
    /// `title` becomes the title of the document.
    ///
    /// Each layer is an optional content group, named as the SVG's layers are, which readers switch on and off; a fill lies
    /// beneath them in a group of its own. Coordinates are millimetres with three decimals. No date and no identifier is
    /// written, so that equal drawings are equal bytes. A page of which a side is longer than 5.08 m has a larger user unit,
    /// as readers refuse more units than that.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_pdf(&self, title: &str, out: &mut dyn Write) -> io::Result<()> {
        let names: Vec<String> = self.group_names().collect();
        let group = |index: usize| Ref::new(FIRST_GROUP + index as i32);
        let sides =
            [self.placement.width, self.placement.height].map(|side| side * self.placement.mm() * POINTS_PER_MM);
        let unit = (sides[0].max(sides[1]) / MAX_SIDE).max(1.0);
        let content = self.content(sides[1] / unit, POINTS_PER_MM / unit);

        let mut pdf = Pdf::new();
        pdf.set_version(1, 7);
        let mut catalog = pdf.catalog(CATALOG);
        catalog.pages(PAGES);
        let groups = || (0..names.len()).map(group);
        let mut optional = catalog.insert(Name(b"OCProperties")).dict();
        optional.insert(Name(b"OCGs")).array().items(groups());
        optional.insert(Name(b"D")).dict().insert(Name(b"Order")).array().items(groups());
        optional.finish();
        catalog.finish();
        pdf.pages(PAGES).kids([PAGE]).count(1);
        let mut page = pdf.page(PAGE);
        page.media_box(Rect::new(0.0, 0.0, (sides[0] / unit) as f32, (sides[1] / unit) as f32));
        page.parent(PAGES).contents(CONTENT);
        if unit > 1.0 {
            page.user_unit(unit as f32);
        }
        let mut resources = page.resources();
        let mut properties = resources.insert(Name(b"Properties")).dict();
        for index in 0..names.len() {
            properties.pair(Name(property(index).as_bytes()), group(index));
        }
        properties.finish();
        resources.finish();
        page.finish();
        pdf.stream(CONTENT, &content);
        pdf.document_info(INFO).title(TextStr(title)).producer(TextStr("silhouettes"));
        for (index, name) in names.iter().enumerate() {
            let mut group = pdf.indirect(group(index)).dict();
            group.pair(Name(b"Type"), Name(b"OCG")).pair(Name(b"Name"), TextStr(name));
        }
        out.write_all(&pdf.finish())
    }

    /// The names of the groups, the fill's first.
    fn group_names(&self) -> impl Iterator<Item = String> {
        let layers = self.layers.iter().map(Layer::entry_label);
        self.fill.iter().map(|_| "fill".to_owned()).chain(layers)
    }

    /// What is drawn, on a page of this height, with so many units a millimetre.
    fn content(&self, height: f64, units_per_mm: f64) -> Vec<u8> {
        let mut content = Content::new();
        let scale = units_per_mm as f32;
        content.transform([scale, 0.0, 0.0, -scale, 0.0, height as f32]);
        content.set_miter_limit(MITER_LIMIT);
        content.set_line_cap(match self.cap {
            Cap::Butt => LineCapStyle::ButtCap,
            Cap::Round => LineCapStyle::RoundCap,
            Cap::Square => LineCapStyle::ProjectingSquareCap,
        });
        content.set_line_join(match self.join {
            Join::Round => LineJoinStyle::RoundJoin,
            Join::Miter => LineJoinStyle::MiterJoin,
            Join::Bevel => LineJoinStyle::BevelJoin,
        });
        let mut first = 0;
        if let Some(fill) = &self.fill {
            in_group(0, &mut content, |content| self.fill(fill, content));
            first = 1;
        }
        for (index, layer) in (first..).zip(&self.layers) {
            in_group(index, &mut content, |content| self.stroke(layer, content));
        }
        content.finish().into_vec()
    }

    fn fill(&self, fill: &Fill, content: &mut Content) {
        let [red, green, blue] = components(fill.colour);
        content.set_fill_rgb(red, green, blue);
        fill.paths.iter().for_each(|path| self.outline(path, content));
        content.fill_even_odd();
    }

    fn stroke(&self, layer: &Layer, content: &mut Content) {
        let [red, green, blue] = components(layer.pen.colour);
        content.set_stroke_rgb(red, green, blue);
        content.set_line_width(rounded(layer.width(self.placement.unit) * self.placement.mm()) as f32);
        for path in layer.paths.iter() {
            self.outline(path, content);
            content.stroke();
        }
    }

    /// Appends a path, neither filled nor stroked.
    fn outline(&self, path: Path<'_>, content: &mut Content) {
        let mm = self.placement.mm();
        let at = |point: DVec2| (point * mm).to_array().map(|coordinate| rounded(coordinate) as f32);
        let [x, y] = at(path.start());
        content.move_to(x, y);
        for (index, segment) in path.segments().enumerate() {
            let [x, y] = at(segment.to);
            match segment.handles {
                Some(handles) => {
                    let [[x1, y1], [x2, y2]] = handles.map(at);
                    content.cubic_to(x1, y1, x2, y2, x, y);
                }
                // Closing draws it.
                None if path.closed && index + 1 == path.segment_count() => {}
                None => {
                    content.line_to(x, y);
                }
            }
        }
        if path.closed {
            content.close_path();
        }
    }
}

/// Draws in a group, by its index.
fn in_group(index: usize, content: &mut Content, draw: impl FnOnce(&mut Content)) {
    content.begin_marked_content_with_properties(Name(b"OC")).properties_named(Name(property(index).as_bytes()));
    draw(content);
    content.end_marked_content();
}

/// What a group is called among the page's resources.
fn property(index: usize) -> String {
    format!("Layer{index}")
}

fn components(colour: Colour) -> [f32; 3] {
    colour.0.map(|component| f32::from(component) / 255.0)
}
