//! [`LineErrors`]: where a picture of lines errs, by kind of line and by what is known to make methods err.
//!
//! Lengths are lengths of true line, as everywhere. Spurious ink has no length of its own: it is stated as the length that the
//! pen would draw with as much ink, its pixels over the pen's width.

use super::ink::Ink;
use super::lines::TruePen;
use crate::truth::mesh_facts::{Circumstance, EdgeKind};
use crate::truth::samples::TrueLines;
use crate::truth::view_facts::ViewFacts;
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// Tolerance in pixels: the same as that of `missed_1px` and `spurious_1px`.
pub const TOLERANCE_PX: f64 = 1.0;

/// How far ink may lie from a line and still be on it, in pixels: the pen's width and a pixel.
pub fn reach_px(pen_width_px: f64) -> f64 {
    pen_width_px + 1.0
}

/// What a length states about itself.
#[derive(Debug, Clone, Copy)]
pub struct LengthSpec {
    /// Name in results: a field of [`LineErrors`].
    pub name: &'static str,
    /// What it is.
    pub summary: &'static str,
    /// Reads it; `None` where it was not measured.
    pub value: fn(&LineErrors) -> Option<f64>,
    value_mut: fn(&mut LineErrors) -> Option<&mut f64>,
}

/// Declares the fields and the table of them.
macro_rules! lengths {
    (always { $($name:ident: $summary:literal,)+ } optional { $($optional:ident: $text:literal,)+ }) => {
        /// Lengths of a view, or averaged over several, in pixels. Every value is finite.
        #[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
        pub struct LineErrors {
            $(#[doc = $summary] pub $name: f64,)+
            $(#[doc = $text] pub $optional: Option<f64>,)+
        }

        /// Every length, in the order of results.
        pub const LENGTHS: &[LengthSpec] = &[
            $(LengthSpec {
                name: stringify!($name),
                summary: $summary,
                value: |errors| Some(errors.$name),
                value_mut: |errors| Some(&mut errors.$name),
            },)+
            $(LengthSpec {
                name: stringify!($optional),
                summary: $text,
                value: |errors| errors.$optional,
                value_mut: |errors| errors.$optional.as_mut(),
            },)+
        ];
    };
}

lengths! {
    always {
        true_silhouette_px: "True line along edges that are neither creases nor boundary edges.",
        true_crease_px: "True line along creases: edges whose faces' normals differ by 30 degrees or more.",
        true_boundary_px: "True line along boundary edges: edges with one face.",
        missed_silhouette_px: "Of `true_silhouette_px`, what has no ink within 1 px.",
        missed_crease_px: "Of `true_crease_px`, what has no ink within 1 px.",
        missed_boundary_px: "Of `true_boundary_px`, what has no ink within 1 px.",
        spurious_silhouette_px: "Spurious ink at 1 px, over the pen's width, that lies on an edge which is neither: seen or hidden.",
        spurious_crease_px: "Spurious ink on a crease: on one that is a silhouette edge, seen or hidden, or on any other that is seen.",
        spurious_boundary_px: "Spurious ink on a boundary edge, of a front or a back face, seen or hidden.",
        spurious_nothing_px: "Spurious ink on no line: farther than the pen's width and a pixel from all of these.",
        true_open_boundary_px: "True line where the surface ends: the same as `true_boundary_px`.",
        true_inward_winding_px: "True line along other edges with a face that is wound inwards, or whose two faces are wound against each other.",
        true_small_faces_px: "True line along other edges each of whose faces covers less than a pixel.",
        true_unexplained_px: "True line along all other edges.",
        missed_open_boundary_px: "Of `true_open_boundary_px`, what has no ink within 1 px.",
        missed_inward_winding_px: "Of `true_inward_winding_px`, what has no ink within 1 px.",
        missed_small_faces_px: "Of `true_small_faces_px`, what has no ink within 1 px.",
        missed_unexplained_px: "Of `true_unexplained_px`, what has no ink within 1 px: no known cause.",
        spurious_open_boundary_px: "Spurious ink where the back of a face of an open part is seen, or else on a boundary edge.",
        spurious_inward_winding_px: "Spurious ink where the back of a face is seen that is wound inwards, or else on an edge of such a face.",
        spurious_small_faces_px: "Other spurious ink where the face that is seen, or else each face of the edge, covers less than a pixel.",
        spurious_unexplained_px: "All other spurious ink: no known cause.",
    }
    optional {
        true_inner_px: "True line inside of the outline, where the mesh covers both sides; empty where the outline is not known.",
        missed_inner_px: "Of `true_inner_px`, what has no ink within 1 px.",
    }
}

impl LineErrors {
    /// Length of all true lines.
    pub fn true_px(&self) -> f64 {
        self.true_silhouette_px + self.true_crease_px + self.true_boundary_px
    }

    /// Length of all that is missed.
    pub fn missed_px(&self) -> f64 {
        self.missed_silhouette_px + self.missed_crease_px + self.missed_boundary_px
    }

    /// All spurious ink over the pen's width.
    pub fn spurious_px(&self) -> f64 {
        self.spurious_silhouette_px + self.spurious_crease_px + self.spurious_boundary_px + self.spurious_nothing_px
    }

    /// The average of several, each counting the same; `None` of none. A length that any of them lacks is lacking.
    pub fn mean(all: &[Self]) -> Option<Self> {
        let mut mean = *all.first()?;
        for length in LENGTHS {
            let sum: Option<f64> = all.iter().map(length.value).sum();
            if let Some(place) = (length.value_mut)(&mut mean) {
                *place = sum.unwrap_or_default() / all.len() as f64;
            }
            if sum.is_none() {
                (mean.true_inner_px, mean.missed_inner_px) = (None, None);
            }
        }
        Some(mean)
    }

    fn true_of_kind(&mut self, kind: EdgeKind) -> [&mut f64; 2] {
        match kind {
            EdgeKind::Silhouette => [&mut self.true_silhouette_px, &mut self.missed_silhouette_px],
            EdgeKind::Crease => [&mut self.true_crease_px, &mut self.missed_crease_px],
            EdgeKind::Boundary => [&mut self.true_boundary_px, &mut self.missed_boundary_px],
        }
    }

    fn true_of(&mut self, circumstance: Circumstance) -> [&mut f64; 2] {
        match circumstance {
            Circumstance::OpenBoundary => [&mut self.true_open_boundary_px, &mut self.missed_open_boundary_px],
            Circumstance::InwardWinding => [&mut self.true_inward_winding_px, &mut self.missed_inward_winding_px],
            Circumstance::SmallFaces => [&mut self.true_small_faces_px, &mut self.missed_small_faces_px],
            Circumstance::Unexplained => [&mut self.true_unexplained_px, &mut self.missed_unexplained_px],
        }
    }
}

/// Measures where a picture errs. `seen` yields what may make methods err on the face that is seen at a place of the picture;
/// it is asked for spurious pixels only. O(pixels + samples).
///
/// # Panics
/// If the facts are of other lines than `truth`.
pub fn line_errors(
    ink: &Ink,
    truth: &TrueLines,
    pen: TruePen<'_>,
    facts: &ViewFacts,
    seen: impl Fn(DVec2) -> Option<Circumstance>,
) -> LineErrors {
    assert_eq!(truth.samples.len(), facts.samples.len(), "facts of these lines");
    let mut errors = LineErrors::default();
    let mut inner = [0.0, 0.0];
    for (at, (sample, facts_here)) in truth.samples.iter().zip(&facts.samples).enumerate() {
        let missed = if ink.has_ink_within(sample.pixel, TOLERANCE_PX) { 0.0 } else { sample.length_px };
        let is_inner = facts.is_inner.as_ref().is_some_and(|is_inner| is_inner[at]);
        let add = |[whole, part]: [&mut f64; 2]| {
            *whole += sample.length_px;
            *part += missed;
        };
        add(errors.true_of_kind(facts_here.kind));
        add(errors.true_of(facts_here.circumstance));
        if is_inner {
            let [whole, part] = &mut inner;
            add([whole, part]);
        }
    }
    if facts.is_inner.is_some() {
        (errors.true_inner_px, errors.missed_inner_px) = (Some(inner[0]), Some(inner[1]));
    }
    let length = 1.0 / pen.width_px;
    for (x, y) in ink.ink_pixels() {
        let center = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
        if pen.picture.has_ink_within(center, TOLERANCE_PX) {
            continue;
        }
        let line = facts.near(center);
        *match line.map(|line| line.kind) {
            Some(EdgeKind::Silhouette) => &mut errors.spurious_silhouette_px,
            Some(EdgeKind::Crease) => &mut errors.spurious_crease_px,
            Some(EdgeKind::Boundary) => &mut errors.spurious_boundary_px,
            None => &mut errors.spurious_nothing_px,
        } += length;
        let circumstance = circumstance(seen(center), line.map(|line| line.circumstance));
        *match circumstance {
            Circumstance::OpenBoundary => &mut errors.spurious_open_boundary_px,
            Circumstance::InwardWinding => &mut errors.spurious_inward_winding_px,
            Circumstance::SmallFaces => &mut errors.spurious_small_faces_px,
            Circumstance::Unexplained => &mut errors.spurious_unexplained_px,
        } += length;
    }
    errors
}

/// That of ink on a face and on a line: whose back is seen says most, then which edge it is, then how small faces are.
fn circumstance(face: Option<Circumstance>, line: Option<Circumstance>) -> Circumstance {
    let is_certain = |one: &Circumstance| matches!(one, Circumstance::OpenBoundary | Circumstance::InwardWinding);
    let certain = face.filter(is_certain).or(line.filter(is_certain));
    certain.or(face).or(line).unwrap_or(Circumstance::Unexplained)
}

#[cfg(test)]
mod tests;
