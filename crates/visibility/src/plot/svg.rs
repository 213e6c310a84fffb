//! A drawing as SVG: one Inkscape layer a pen.

use super::Drawing;
use super::decimal::{number, printed, push_steps};
use super::fill::Fill;
use super::layer::{FILL, Layer, LayerName};
use super::options::{Cap, Join};
use super::paths::Path;
use silhouette_core::glam::DVec2;
use std::io::{self, Write};
use std::ops::Range;

impl Drawing {
    /// Writes the drawing as SVG 1.1, path by path; `title` becomes the title of the document.
    ///
    /// Width and height carry the unit, the view box makes it the unit of all coordinates. Each layer is an Inkscape
    /// layer whose label begins with its number, by which vpype and the AxiDraw software know layers, too: the same number for
    /// the same kind in every file. Views of one page are groups in them. Coordinates have three decimals, so that equal drawings
    /// are equal bytes. The outline is one path with `fill-rule="evenodd"`. A fill is a layer beneath all others, whose label
    /// begins with `%`, by which the AxiDraw software knows what is not to be plotted, and holds a number of its own, so that vpype,
    /// which draws its border, keeps it apart.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write_svg(&self, title: &str, out: &mut dyn Write) -> io::Result<()> {
        let mut text = Vec::with_capacity(64 * 1024);
        self.push_head(title, &mut text);
        if let Some(fill) = &self.fill {
            push_fill(fill, &mut text);
        }
        for layers in self.layers.chunk_by(|one, other| one.number == other.number) {
            if let [layer] = layers {
                push_layer_tag(layer, &self.pen_of(layer), &mut text);
                self.push_paths(layer, &mut text, out)?;
            } else {
                push_layer_tag(&layers[0], "", &mut text);
                for layer in layers {
                    text.extend(format!("<g id=\"{}\"{}>\n", layer.entry_id(), self.pen_of(layer)).bytes());
                    self.push_paths(layer, &mut text, out)?;
                    text.extend(b"</g>\n");
                }
            }
            text.extend(b"</g>\n");
        }
        text.extend(b"</svg>\n");
        out.write_all(&text)
    }

    fn push_head(&self, title: &str, text: &mut Vec<u8>) {
        let unit = self.placement.unit.suffix();
        let [width, height] = [self.placement.width, self.placement.height].map(number);
        let cap = match self.cap {
            Cap::Butt => "butt",
            Cap::Round => "round",
            Cap::Square => "square",
        };
        let join = match self.join {
            Join::Round => "round",
            Join::Miter => "miter",
            Join::Bevel => "bevel",
        };
        text.extend(b"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"");
        text.extend(b" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\"");
        text.extend(
            format!(" width=\"{width}{unit}\" height=\"{height}{unit}\" viewBox=\"0 0 {width} {height}\"").bytes(),
        );
        text.extend(format!(" fill=\"none\" stroke-linecap=\"{cap}\" stroke-linejoin=\"{join}\">\n").bytes());
        text.extend(format!("<title>{}</title>\n", escaped(title)).bytes());
    }

    /// Attributes of a layer's pen.
    fn pen_of(&self, layer: &Layer) -> String {
        let (colour, width) = (layer.pen.colour, number(layer.width(self.placement.unit)));
        format!(" stroke=\"{colour}\" stroke-width=\"{width}\"")
    }

    /// The paths of a layer, in a group per view where there are several.
    fn push_paths(&self, layer: &Layer, text: &mut Vec<u8>, out: &mut dyn Write) -> io::Result<()> {
        if layer.views.is_empty() {
            return push_run(layer, 0..layer.paths.len(), text, out);
        }
        for (view, paths) in &layer.views {
            text.extend(format!("<g id=\"{}-{view}\">\n", layer.entry_id()).bytes());
            push_run(layer, paths.clone(), text, out)?;
            text.extend(b"</g>\n");
        }
        Ok(())
    }
}

fn push_layer_tag(layer: &Layer, pen: &str, text: &mut Vec<u8>) {
    let (number, label) = (layer.number, escaped(&layer.label).replace('"', "&quot;"));
    let id = layer.id();
    text.extend(
        format!("<g inkscape:groupmode=\"layer\" id=\"{id}\" inkscape:label=\"{number} {label}\"{pen}>\n").bytes(),
    );
}

/// Some paths of a layer; those of the outline as one.
fn push_run(layer: &Layer, paths: Range<usize>, text: &mut Vec<u8>, out: &mut dyn Write) -> io::Result<()> {
    let outline = layer.name == LayerName::Outline;
    if outline {
        text.extend(b"<path fill-rule=\"evenodd\" d=\"");
    }
    for path in paths.map(|index| layer.paths.get(index)) {
        if outline {
            push_data(path, text);
        } else {
            text.extend(b"<path d=\"");
            push_data(path, text);
            text.extend(b"\"/>\n");
        }
        if text.len() > 32 * 1024 {
            out.write_all(text)?;
            text.clear();
        }
    }
    text.extend(if outline { &b"\"/>\n"[..] } else { b"" });
    Ok(())
}

/// The layer of what is filled, with a number above those of all others.
fn push_fill(fill: &Fill, text: &mut Vec<u8>) {
    text.extend(b"<g inkscape:groupmode=\"layer\" id=\"fill\"");
    text.extend(format!(" inkscape:label=\"% {FILL} fill\"").bytes());
    text.extend(format!(" fill=\"{}\" stroke=\"none\">\n<path fill-rule=\"evenodd\" d=\"", fill.colour).bytes());
    fill.paths.iter().for_each(|path| push_data(path, text));
    text.extend(b"\"/>\n</g>\n");
}

/// A path's data: M, then L or C, and Z for a closed one.
fn push_data(path: Path<'_>, text: &mut Vec<u8>) {
    text.push(b'M');
    push_point(path.start(), text);
    if path.handles.is_empty() {
        for (index, &point) in path.points[1..].iter().enumerate() {
            text.push(if index == 0 { b'L' } else { b' ' });
            push_point(point, text);
        }
    } else {
        for (index, segment) in path.segments().enumerate() {
            text.push(if index == 0 { b'C' } else { b' ' });
            for handle in segment.handles.into_iter().flatten() {
                push_point(handle, text);
                text.push(b' ');
            }
            push_point(segment.to, text);
        }
    }
    if path.closed {
        text.push(b'Z');
    }
}

fn push_point(point: DVec2, text: &mut Vec<u8>) {
    let [x, y] = printed(point);
    push_steps(x, text);
    text.push(b' ');
    push_steps(y, text);
}

/// Text as XML content, without characters that XML cannot hold.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '\u{fffe}' | '\u{ffff}' => escaped.push('\u{fffd}'),
            control if control.is_control() => escaped.push(' '),
            other => escaped.push(other),
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn titles_are_escaped() {
        assert_eq!(escaped("a<b> & \u{1}\"c\""), "a&lt;b&gt; &amp;  \"c\"");
    }
}
