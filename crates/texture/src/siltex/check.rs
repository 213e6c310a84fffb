//! What every value of a texture must satisfy, on its way out as on its way in.

use super::error::{Place, Problem, Range, SiltexError};
use super::format::{Form, MAX_DETAIL, SectionType, Sizes};
use crate::silhouette_texture::{Angles, FacePlace, Parts, Terms};
use glam::{Vec2, Vec3};
use half::f16;
use silhouette_core::glam;

/// By how much the length of a unit vector of 32-bit floats may differ from 1.
const UNIT_TOLERANCE: f32 = 1e-3;

/// The sizes, before anything is computed from them. O(1).
pub(super) fn sizes(sizes: &Sizes) -> Result<(), SiltexError> {
    let place = Place::Section(SectionType::SIZE);
    sizes.volume.checked().map_err(|error| place.error(error))?;
    let range = |what, found, least, most| {
        let problem = || Problem::Range { what, found: u64::from(found), range: Range(least, most) };
        if (least..=most).contains(&found) { Ok(()) } else { Err(place.error(problem())) }
    };
    range("the detail of colours", sizes.detail, 0, MAX_DETAIL)?;
    match sizes.form {
        Form::Terms => range("the number of terms", sizes.terms, 1, sizes.volume.azimuths),
        Form::Unorm8 | Form::Float16 => range("the number of terms", sizes.terms, 0, 0),
    }
}

/// All values except the mesh's, which checks itself. O(samples).
pub(super) fn values(parts: &Parts) -> Result<(), SiltexError> {
    let is_unit = |v: &Vec3| (v.length() - 1.0).abs() <= UNIT_TOLERANCE;
    let are_finite = |values: &[f16; 4]| values.iter().all(|value| value.is_finite());
    let share = |value: &f16| (0.0..=1.0).contains(&value.to_f32());
    let distance = |value: &f16| value.is_finite() && value.to_f32() >= 0.0;
    let on_page = |corner: &Vec2| corner.cmpge(Vec2::ZERO).all() && corner.cmple(Vec2::ONE).all();

    all(SectionType::CENTERS, "centre", "a unit vector", &parts.centers, is_unit)?;
    all(SectionType::TANGENTS, "tangent", "a unit vector", &parts.tangents, is_unit)?;
    let is_place = |place: &FacePlace| place.page < parts.size.pages && place.corners.iter().all(on_page);
    all(SectionType::PLACES, "place", "on a page of the atlas", &parts.places, is_place)?;
    match &parts.angles {
        Angles::Unorm8(_) => {}
        Angles::Float16(angles) => all(SectionType::ANGLES, "angle", "from 0 to 1", angles, share)?,
        Angles::Terms(terms) => terms_are_finite(terms)?,
    }
    if let Some(centers) = &parts.texel_centers {
        all(SectionType::TEXEL_CENTERS, "centre of texel", "finite", centers, are_finite)?;
    }
    all(SectionType::GAPS, "gap", "a finite distance", &parts.gaps, distance)?;
    all(SectionType::NORMALS, "normal", "finite", &parts.normals, are_finite)
}

fn terms_are_finite(terms: &Terms) -> Result<(), SiltexError> {
    let finite = |value: &f32| value.is_finite();
    for function in &terms.functions {
        all(SectionType::ANGLES, "value of a function", "finite", function, finite)?;
    }
    all(SectionType::ANGLES, "offset of term", "finite", &terms.offsets, finite)?;
    all(SectionType::ANGLES, "scale of term", "finite", &terms.scales, finite)
}

/// Names the first value that does not pass.
fn all<T>(
    section: SectionType,
    what: &'static str,
    rule: &'static str,
    values: &[T],
    passes: impl Fn(&T) -> bool,
) -> Result<(), SiltexError> {
    match values.iter().position(|value| !passes(value)) {
        Some(index) => Err(Place::Section(section).error(Problem::Value { what, index, rule })),
        None => Ok(()),
    }
}
