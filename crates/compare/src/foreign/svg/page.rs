//! Step 1: where a document's own coordinates lie in the picture.

use super::at;
use crate::foreign::error::ForeignFault;
use glam::{DAffine2, DVec2};
use roxmltree::Node;
use std::str::FromStr;
use svgtypes::{Length, LengthUnit, ViewBox};

/// By how much the shape of a document may differ from that of the picture, in pixels of the picture: what decimals of a size in
/// millimetres round.
const ROUNDING_PX: f64 = 0.5;

/// A document in the picture.
pub struct Placed {
    /// From its own coordinates to pixels.
    pub transform: DAffine2,
    /// What its user should know.
    pub note: Option<String>,
}

/// Places a document of the picture's shape so that it fills the picture. One that states no size is in pixels.
///
/// # Errors
/// [`ForeignFault::WrongSize`] for one of another shape.
pub fn place(root: &Node<'_, '_>, size: [u32; 2]) -> Result<Placed, ForeignFault> {
    let view_box = root.attribute("viewBox").map(ViewBox::from_str).transpose();
    let view_box = view_box.map_err(|error| at(root, Some("viewBox"), &error))?;
    let view_box = view_box.map(|view_box| [DVec2::new(view_box.x, view_box.y), DVec2::new(view_box.w, view_box.h)]);
    let [width, height] = [side(root, "width")?, side(root, "height")?];
    let of_box = view_box.map(|[_, extent]| extent);
    // A side that is not stated follows from the other and the view box.
    let page = match (width, height, of_box) {
        (Some(width), Some(height), _) => Some(DVec2::new(width, height)),
        (Some(width), None, Some(extent)) => Some(extent * (width / extent.x)),
        (None, Some(height), Some(extent)) => Some(extent * (height / extent.y)),
        (None, None, extent) => extent,
        _ => None,
    };
    let Some(page) = page else { return Ok(Placed { transform: DAffine2::IDENTITY, note: None }) };
    let picture = DVec2::from(size.map(f64::from));
    let scale = picture.x / page.x;
    let wrong =
        || ForeignFault::WrongSize { found: format!("is {} x {} units", page.x as f32, page.y as f32), wanted: size };
    if !(page.is_finite() && page.min_element() > 0.0 && (page.y * scale - picture.y).abs() <= ROUNDING_PX) {
        return Err(wrong());
    }
    let inside = match view_box {
        None => DAffine2::IDENTITY,
        Some([corner, extent])
            if root.attribute("preserveAspectRatio").is_some_and(|word| word.trim().starts_with("none")) =>
        {
            DAffine2::from_scale(page / extent) * DAffine2::from_translation(-corner)
        }
        // The box lies in the middle of the page, as large as it fits.
        Some([corner, extent]) => {
            let fit = (page / extent).min_element();
            DAffine2::from_translation((page - extent * fit) * 0.5)
                * DAffine2::from_scale(DVec2::splat(fit))
                * DAffine2::from_translation(-corner)
        }
    };
    let is_scaled = (scale - 1.0).abs() * picture.max_element() > ROUNDING_PX;
    let note = is_scaled.then(|| {
        format!("is {} x {} units, and is scaled to the view's {} x {} pixels", page.x, page.y, size[0], size[1])
    });
    Ok(Placed { transform: DAffine2::from_scale(DVec2::splat(scale)) * inside, note })
}

/// A side of the page in user units, 96 to an inch; nothing where it is not stated or is a share of something else.
fn side(root: &Node<'_, '_>, name: &str) -> Result<Option<f64>, ForeignFault> {
    let Some(text) = root.attribute(name).filter(|text| text.trim() != "auto") else { return Ok(None) };
    let length = Length::from_str(text).map_err(|error| at(root, Some(name), &error))?;
    Ok(in_user_units(length))
}

/// A length in user units; nothing for one that depends on a font or on the page.
pub fn in_user_units(length: Length) -> Option<f64> {
    let per_unit = match length.unit {
        LengthUnit::None | LengthUnit::Px => 1.0,
        LengthUnit::In => 96.0,
        LengthUnit::Cm => 96.0 / 2.54,
        LengthUnit::Mm => 96.0 / 25.4,
        LengthUnit::Pt => 96.0 / 72.0,
        LengthUnit::Pc => 16.0,
        LengthUnit::Em | LengthUnit::Ex | LengthUnit::Percent => return None,
    };
    Some(length.number * per_unit)
}
