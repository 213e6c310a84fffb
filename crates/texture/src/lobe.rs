//! The angle from a lobe's centre to its border at one azimuth (section 3.3, figure 7).
//!
//! Seen from its centre C, the lobe is meant to be star-shaped: along each meridian from C to its opposite, the object is shown up
//! to one angle and not beyond. Where a meridian leaves the lobe and meets it again, one angle cannot say so, and [`LobeRule`]
//! chooses.

use crate::frame::Frame;
use glam::{DVec3, Vec3};
use silhouette_core::glam;
use std::f32::consts::PI;

silhouette_core::option_choice! {
    /// Which angle stands for a meridian along which the object is shown in several parts.
    pub enum LobeRule {
        /// The angle up to which it would be shown if its parts were moved together: the lobe keeps its solid angle.
        EqualArea = "equal-area",
        /// The end of the last part: nothing that should be shown is lost, gaps are filled.
        LastExit = "last-exit",
        /// The end of the first part, or 0 if C itself is not shown.
        FirstExit = "first-exit",
    }
}

/// Most borders that are kept per meridian.
pub const MOST_BORDERS: usize = 6;

/// Where a direction along a meridian enters the hull: a range of angles from the centre, in radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// Smallest angle.
    pub from: f32,
    /// Largest angle.
    pub to: f32,
}

/// Where the object is shown along a meridian: from border to border, within a [`Span`].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Meridian {
    borders: [f32; MOST_BORDERS],
    count: u8,
    /// Whether it is shown where the span begins.
    pub is_shown_first: bool,
}

impl Span {
    /// The angles at which directions at an azimuth run against a face's outward normal. The angles are one range, as the
    /// meridian is half a circle; it is empty (`from` is `to`) if there is none.
    pub fn new(frame: &Frame, across: Vec3, normal: Vec3) -> Self {
        let (along, aside) = (frame.center.dot(normal), across.dot(normal));
        if along < 0.0 {
            Self { from: 0.0, to: (-along).atan2(aside) }
        } else {
            Self { from: along.atan2(-aside).clamp(0.0, PI), to: PI }
        }
    }
}

impl Meridian {
    /// The angles at which what is shown begins or ends, ascending, strictly inside the span.
    pub fn borders(&self) -> &[f32] {
        &self.borders[..usize::from(self.count)]
    }

    /// A meridian with these borders, ascending. Of more than [`MOST_BORDERS`], those of the narrowest parts are left out.
    pub fn new(is_shown_first: bool, mut borders: Vec<f32>) -> Self {
        while borders.len() > MOST_BORDERS {
            let width = |at: usize| borders[at + 1] - borders[at];
            let narrowest = (0..borders.len() - 1).min_by(|&a, &b| width(a).total_cmp(&width(b))).unwrap_or(0);
            borders.drain(narrowest..narrowest + 2);
        }
        let mut meridian = Self { is_shown_first, count: borders.len() as u8, ..Self::default() };
        meridian.borders[..borders.len()].copy_from_slice(&borders);
        meridian
    }

    /// The ranges of angles in which the object is shown.
    pub fn parts(&self, span: Span) -> impl Iterator<Item = [f32; 2]> + '_ {
        let at = move |index: usize| match index {
            0 => span.from,
            index if index <= usize::from(self.count) => self.borders[index - 1],
            _ => span.to,
        };
        let first = usize::from(!self.is_shown_first);
        (first..=usize::from(self.count)).step_by(2).map(move |index| [at(index), at(index + 1)])
    }

    /// The angle of the lobe's border, in radians from 0 to pi; 0 where nothing is shown.
    pub fn angle(&self, span: Span, rule: LobeRule) -> f32 {
        match rule {
            LobeRule::EqualArea => {
                // Twice the squared sine of half the angle is 1 - cos, without cancellation for narrow lobes.
                let share = |angle: f32| (angle * 0.5).sin().powi(2);
                let area = self.parts(span).fold(0.0, |area, [from, to]| area + share(to) - share(from));
                2.0 * area.clamp(0.0, 1.0).sqrt().asin()
            }
            LobeRule::LastExit => self.parts(span).last().map_or(0.0, |[_, to]| to),
            LobeRule::FirstExit => match self.parts(span).next() {
                Some([from, to]) if from <= 0.0 => to,
                _ => 0.0,
            },
        }
    }

    /// The sum of all directions in which the object is shown, weighted by the solid angle next to the meridian, per radian of
    /// azimuth.
    pub fn moment(&self, span: Span, center: Vec3, across: Vec3) -> DVec3 {
        let part = |[from, to]: [f32; 2]| {
            let (from, to) = (f64::from(from), f64::from(to));
            let along = (to.sin().powi(2) - from.sin().powi(2)) * 0.5;
            let aside = (to - from) * 0.5 - ((2.0 * to).sin() - (2.0 * from).sin()) * 0.25;
            along * center.as_dvec3() + aside * across.as_dvec3()
        };
        self.parts(span).map(part).sum()
    }
}
