//! [`PlotOptions`]: how lines become strokes on a page, and [`PlotError`]: why they cannot.

use super::layer::LayersBy;
use super::length::{Length, Unit};
use super::page::{Fit, Sheet};
use super::pen::{Colour, Dash, Pens};
use silhouette_core::progress::Cancelled;
use silhouette_core::view::{Camera, Projection};

/// What becomes of hidden lines.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Hidden {
    /// They are left out.
    Drop,
    /// They are drawn as visible ones are, in layers of their own.
    Solid,
    /// They are drawn in strokes and gaps, in layers of their own.
    Dashed(Dash),
}

/// How strokes end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Cap {
    /// At the last point.
    Butt,
    /// With half a disc.
    Round,
    /// With half a square.
    Square,
}

/// How the segments of a stroke meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Join {
    /// With a sector of a disc.
    Round,
    /// With the stroke's sides prolonged.
    Miter,
    /// With the corner cut off.
    Bevel,
}

/// How lines become strokes on a page. Lengths are lengths on paper.
#[derive(Debug, Clone, PartialEq)]
pub struct PlotOptions {
    /// The unit that the file is written in. Default: millimetres.
    pub unit: Unit,
    /// The page; without one it is the camera's viewport, a pixel a pixel. Default: A4 upright, margins of 10 mm, the
    /// lines as large as fits.
    pub sheet: Option<Sheet>,
    /// What becomes of hidden lines that were found. Default: dropped.
    pub hidden: Hidden,
    /// With what the kinds are drawn. Default: see [`Pens`].
    pub pens: Pens,
    /// What layers are parted by. Default: kinds.
    pub layers: LayersBy,
    /// What objects are called in layers of their own, in order. Default: none; each is called `object` then.
    pub object_names: Vec<String>,
    /// How strokes end. Default: round, as a pen leaves them.
    pub cap: Cap,
    /// How segments meet. Default: round.
    pub join: Join,
    /// How far a dropped point may lie from the segment that takes its place; 0 merges exactly collinear segments only.
    /// Default: 0.01 mm, finer than a plotter's step or a pen's edge.
    pub merge_tolerance: Length,
    /// Paths shorter than this are dropped, before dashes are cut; 0 keeps all. Default: 0.1 mm, less than a pen's width.
    pub min_length: Length,
    /// How wide a gap may be across which a visible contour goes on: one that a fold hides for a moment, while the same contour
    /// continues underneath. Known where lines of at least invisibility 1 were found. `None` is the width of its pen, whose round
    /// or square ends close such a gap, and 0 for [`Cap::Butt`]; 0 leaves all. Default: `None`.
    pub bridge: Option<Length>,
    /// Whether cubic curves take the place of straight segments that turn little, within the merge tolerance. Default: no.
    pub curves: bool,
    /// Whether what lies on another line is dropped: visible before hidden, silhouettes before all others; and of one layer the
    /// paths that lie in the ink of longer ones, within half the pen's width of their middles. Default: yes.
    pub dedupe: bool,
    /// Whether the outline is drawn with its pen where it was found. Default: yes.
    pub outline: bool,
    /// With what all that the meshes cover is filled, beneath all lines; needs the outline to have been found. Default: nothing.
    pub fill: Option<Colour>,
    /// Whether paths are put in an order in which the pen travels little between them. Default: yes.
    pub order: bool,
}

impl Default for PlotOptions {
    fn default() -> Self {
        Self {
            unit: Unit::Mm,
            sheet: Some(Sheet::default()),
            hidden: Hidden::Drop,
            pens: Pens::default(),
            layers: LayersBy::default(),
            object_names: Vec::new(),
            cap: Cap::Round,
            join: Join::Round,
            merge_tolerance: Length::mm(0.01),
            min_length: Length::mm(0.1),
            bridge: None,
            curves: false,
            dedupe: true,
            outline: true,
            fill: None,
            order: true,
        }
    }
}

/// Smallest and largest side of a page in millimetres.
const MIN_PAGE_MM: f64 = 1.0;
const MAX_PAGE_MM: f64 = 10_000.0;
/// Thinnest pen in millimetres: files hold three decimals of their unit.
const MIN_PEN_MM: f64 = 0.001;
/// Largest scale in millimetres a unit: more would leave nothing on any page.
const MAX_SCALE: f64 = 1e9;
/// Shortest stroke or gap of a pattern in millimetres: no pen draws shorter ones, and files stay finite.
const MIN_DASH_MM: f64 = 0.1;

impl PlotOptions {
    /// Refuses options that cannot be honoured for this camera.
    ///
    /// # Errors
    /// [`PlotError`], all but [`PlotError::Cancelled`].
    pub fn check(&self, camera: &Camera) -> Result<(), PlotError> {
        if let Some(sheet) = &self.sheet {
            let sides = sheet.page.size(Unit::Mm);
            if !sides.iter().all(|&side| (MIN_PAGE_MM..=MAX_PAGE_MM).contains(&side)) {
                return Err(PlotError::Page);
            }
            let margin = sheet.margin.to(Unit::Mm);
            if !(margin >= 0.0 && sides.iter().all(|&side| 2.0 * margin < side)) {
                return Err(PlotError::Margin { margin: sheet.margin });
            }
            if let Fit::Scale { mm_per_unit } = sheet.fit {
                if !(mm_per_unit > 0.0 && mm_per_unit <= MAX_SCALE) {
                    return Err(PlotError::Scale);
                }
                if !matches!(camera.projection(), Projection::Orthographic { .. }) {
                    return Err(PlotError::ScaleOfPerspective);
                }
            }
        }
        let is_length = |length: Length| length.to(Unit::Mm) >= 0.0 && length.to(Unit::Mm).is_finite();
        let bridge = self.bridge.unwrap_or(Length::mm(0.0));
        let lengths =
            [("merge tolerance", self.merge_tolerance), ("shortest path", self.min_length), ("widest gap", bridge)];
        for (what, length) in lengths {
            if !is_length(length) {
                return Err(PlotError::Negative { what, length });
            }
        }
        let widths = MIN_PEN_MM..=MAX_PAGE_MM;
        if let Some(pen) = self.pens.iter().find(|pen| !widths.contains(&pen.width.to(Unit::Mm))) {
            return Err(PlotError::Width { width: pen.width });
        }
        let hidden = if let Hidden::Dashed(dash) = self.hidden { Some(dash) } else { None };
        for dash in self.pens.iter().filter_map(|pen| pen.dash).chain(hidden) {
            if let Some(&length) =
                [dash.on, dash.off].iter().find(|part| !(is_length(**part) && part.to(Unit::Mm) >= MIN_DASH_MM))
            {
                return Err(PlotError::Dash { length });
            }
        }
        Ok(())
    }
}

/// Why lines cannot be plotted.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum PlotError {
    /// A side of the page is shorter than a millimetre or longer than ten metres.
    #[error("the page's sides must be 1 mm to 10 m")]
    Page,
    /// The margins are negative or leave nothing of the page.
    #[error("margins of {margin} leave nothing of the page; choose smaller ones, from 0")]
    Margin {
        /// The margin given.
        margin: Length,
    },
    /// The scale is not above 0, or beyond reason.
    #[error("the scale must be above 0 and at most 1e9, in millimetres a unit of the mesh")]
    Scale,
    /// True scale was asked for of a perspective.
    #[error("true scale needs an orthographic view: a perspective has another scale at each depth")]
    ScaleOfPerspective,
    /// Several views that do not share a page.
    #[error("several views need a page, and orthographic cameras of one scale that look at one point")]
    Views,
    /// A length that may not be negative is.
    #[error("the {what} of {length} must be a length from 0")]
    Negative {
        /// Which.
        what: &'static str,
        /// The length given.
        length: Length,
    },
    /// A pen without width.
    #[error("a pen's width of {width} must be 0.001mm to 10 m")]
    Width {
        /// The width given.
        width: Length,
    },
    /// A pattern finer than pens draw.
    #[error("strokes and gaps of a pattern must be at least 0.1mm long, not {length}")]
    Dash {
        /// The length given.
        length: Length,
    },
    /// Stopped on demand.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}
