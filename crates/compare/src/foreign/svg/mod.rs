//! Line drawings as SVG: every stroke is a line, whatever its width and, unless it is white, its colour.
//!
//! 1. `page`: where the document's own coordinates lie in the picture.
//! 2. `style`: what is drawn and stroked, by attributes, `style` and style sheets.
//! 3. `arcs`: whether arcs are small enough to be followed.
//! 4. `shape`: lines, polylines, polygons, paths, rectangles, circles and ellipses, under their transforms.
//!
//! Read are `svg`, `g`, `a`, `switch` and these shapes. Fills, text and pictures are no lines. `use` and nested `svg` are refused rather
//! than skipped, since lines would be missing. So are entities: they grow without bound.

mod arcs;
mod page;
mod shape;
mod style;

use super::error::ForeignFault;
use super::trace::{Frame, Polyline, Tracer};
use glam::{DAffine2, DVec2};
use roxmltree::{Document, Node, ParsingOptions};
use std::fmt::Display;
use style::{Style, Styles};

/// Most elements, texts and comments of a document.
pub const MAX_NODES: u32 = 2_000_000;

/// How deep groups may lie in each other.
pub const MAX_DEPTH: u32 = 128;

/// The lines of a document in pixels of the view, and what its user should know. O(bytes + rules of style sheets x elements).
///
/// # Errors
/// [`ForeignFault`] with the line of the element and the attribute that do not fit.
pub fn read(bytes: &[u8], frame: Frame) -> Result<(Vec<Polyline>, Vec<String>), ForeignFault> {
    let form = |place: String, message: &str| ForeignFault::Form { place, message: message.to_owned() };
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let line = bytes[..error.valid_up_to()].iter().filter(|&&byte| byte == b'\n').count() + 1;
        form(format!("line {line}"), "is no UTF-8; save it as such, uncompressed")
    })?;
    if let Some(at) = text.find("<!ENTITY") {
        let line = text[..at].lines().count();
        return Err(form(format!("line {line}"), "entities are not read; write what they stand for"));
    }
    let options = ParsingOptions { allow_dtd: true, nodes_limit: MAX_NODES, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, options).map_err(|error| {
        let position = error.pos();
        form(format!("line {}, column {}", position.row, position.col), &format!("{error}; write it anew"))
    })?;
    let root = document.root_element();
    if root.tag_name().name() != "svg" {
        return Err(form("line 1".to_owned(), &format!("<{}> is no SVG document", root.tag_name().name())));
    }
    let placed = page::place(&root, frame.size)?;
    let styles = Styles::of(&document)?;
    let mut reader = Reader { styles, tracer: Tracer::new(frame), shapes: 0, dashed: 0, paper: 0, clipped: 0 };
    let style = reader.styles.of_element(&root, Style::default());
    if style.is_displayed {
        reader.children(&root, placed.transform * shape::transform(&root)?, style, 0)?;
    }
    let Reader { tracer, shapes, dashed, paper, clipped, .. } = reader;
    let lines = tracer.finished()?;
    if lines.is_empty() && shapes > 0 {
        let why = format!(": none of its {shapes} shapes has a stroke that shows on white");
        return Err(ForeignFault::NoLines { why, mend: "stroke what is a line, or give a picture (.png)" });
    }
    let mut notes: Vec<String> = placed.note.into_iter().collect();
    if dashed > 0 {
        notes.push(format!(
            "{dashed} of its strokes are dashed; they count as lines all along, so leave out what is hidden"
        ));
    }
    if clipped > 0 {
        notes.push(format!("{clipped} of its elements are clipped or masked; they count as if they were not"));
    }
    if paper > 0 {
        notes.push(format!("{paper} of its strokes are white; they are left out, and cover nothing"));
    }
    Ok((lines, notes))
}

struct Reader<'a> {
    styles: Styles<'a>,
    tracer: Tracer,
    /// Shapes that are displayed.
    shapes: usize,
    /// Dashed strokes among them.
    dashed: usize,
    /// White ones.
    paper: usize,
    /// Elements with a clip path or a mask.
    clipped: usize,
}

impl Reader<'_> {
    fn children(
        &mut self,
        parent: &Node<'_, '_>,
        outer: DAffine2,
        style: Style,
        depth: u32,
    ) -> Result<(), ForeignFault> {
        for node in parent.children().filter(Node::is_element) {
            if node.tag_name().namespace().is_none_or(|namespace| namespace == "http://www.w3.org/2000/svg") {
                self.element(&node, outer, style, depth + 1)?;
            }
        }
        Ok(())
    }

    fn element(
        &mut self,
        node: &Node<'_, '_>,
        outer: DAffine2,
        inherited: Style,
        depth: u32,
    ) -> Result<(), ForeignFault> {
        let name = node.tag_name().name();
        if depth > MAX_DEPTH {
            let message = format!("<{name}> lies deeper than {MAX_DEPTH} groups in each other; ungroup it");
            return Err(at(node, None, &message));
        }
        let style = self.styles.of_element(node, inherited);
        if !style.is_displayed {
            return Ok(());
        }
        self.clipped += usize::from(style.is_clipped);
        match name {
            "g" | "a" | "switch" => self.children(node, outer * shape::transform(node)?, style, depth),
            "use" | "svg" => Err(at(
                node,
                None,
                &format!("<{name}> is not read; write its lines themselves, for clones unlink them"),
            )),
            _ => {
                let Some(outline) = shape::of(node)? else { return Ok(()) };
                self.shapes += 1;
                self.dashed += usize::from(style.is_dashed && style.leaves_ink());
                self.paper += usize::from(style.is_paper());
                if style.leaves_ink() {
                    let placed = outer * shape::transform(node)?;
                    outline.trace(node, placed, &mut self.tracer)?;
                }
                Ok(())
            }
        }
    }
}

/// A fault of an element, or of one of its attributes, with its line.
fn at(node: &Node<'_, '_>, attribute: Option<&str>, message: &dyn Display) -> ForeignFault {
    let line = node.document().text_pos_at(node.range().start).row;
    let place = attribute.map_or_else(|| format!("line {line}"), |attribute| format!("line {line}: {attribute}"));
    ForeignFault::Form { place, message: message.to_string() }
}

/// A point under a transform, which must be finite.
fn finite(node: &Node<'_, '_>, attribute: &str, point: DVec2) -> Result<DVec2, ForeignFault> {
    if point.is_finite() {
        return Ok(point);
    }
    let line = node.document().text_pos_at(node.range().start).row;
    Err(ForeignFault::NotFinite {
        place: format!("line {line}: {attribute}"),
        number: format!("{}, {}", point.x, point.y),
    })
}

#[cfg(test)]
mod tests;
