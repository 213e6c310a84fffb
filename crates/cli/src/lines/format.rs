//! The formats that lines are written in, by the ends of files' names.

use crate::failure::Failure;
use silhouette_visibility::plot::GltfContainer;
use std::path::Path;

/// A format of lines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Strokes on a page.
    Page(PageFormat),
    /// What was found, in pixels and in space.
    Json,
    /// Lines in space.
    Gltf(GltfContainer),
}

/// A format of strokes on a page.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PageFormat {
    /// With Inkscape layers.
    Svg,
    /// With optional content groups.
    Pdf,
    /// For CAD programs and cutters.
    Dxf,
    /// For pen plotters.
    Hpgl,
}

/// All formats by what follows the last full stop of a file's name.
const ENDS: [(&str, Format); 8] = [
    ("svg", Format::Page(PageFormat::Svg)),
    ("pdf", Format::Page(PageFormat::Pdf)),
    ("dxf", Format::Page(PageFormat::Dxf)),
    ("hpgl", Format::Page(PageFormat::Hpgl)),
    ("plt", Format::Page(PageFormat::Hpgl)),
    ("json", Format::Json),
    ("gltf", Format::Gltf(GltfContainer::Text)),
    ("glb", Format::Gltf(GltfContainer::Binary)),
];

impl Format {
    /// Whether areas are filled in it.
    pub const fn fills(self) -> bool {
        matches!(self, Self::Page(PageFormat::Svg | PageFormat::Pdf | PageFormat::Dxf))
    }

    /// The format of a file of this name; that of standard output where there is none.
    pub fn of(path: Option<&Path>) -> Result<Self, Failure> {
        let Some(path) = path else { return Ok(Self::Page(PageFormat::Svg)) };
        let end = path.extension().unwrap_or_default();
        let known = ENDS.iter().find(|(known, _)| end.eq_ignore_ascii_case(known));
        known.map(|(_, format)| *format).ok_or_else(|| {
            let ends = ENDS.map(|(end, _)| format!(".{end}")).join(", ");
            Failure::Input(format!("{}: unknown kind of output; end its name in one of {ends}", path.display()))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formats_are_known_by_the_ends_of_names() {
        assert_eq!(Format::of(None).unwrap(), Format::Page(PageFormat::Svg));
        for (end, format) in ENDS {
            assert_eq!(Format::of(Some(Path::new(&format!("a.b.{}", end.to_uppercase())))).unwrap(), format);
        }
        for bad in ["x", "x.", ".svg", "svg", "x.svg.gz"] {
            assert!(Format::of(Some(Path::new(bad))).is_err(), "{bad}");
        }
    }
}
