//! [`GbufferFilter`]: what the method says of itself.

use crate::line_options::line_method_options;
use silhouette_core::method::{Method, MethodGuide, MethodInfo, MethodOptions, PrepareError, Source};
use silhouette_core::option_choice;
use silhouette_core::prepared::PreparedMesh;
use silhouette_core::progress::Progress;
use std::sync::Arc;

option_choice! {
    /// Which pixels are compared.
    pub enum Operator {
        /// Both diagonals of each four pixels around a corner (Roberts), and one more pixel along each.
        Roberts = "roberts",
        /// Each pixel and the eight around it; normals by Sobel's gradient.
        Sobel = "sobel",
    }
}

option_choice! {
    /// Which discontinuities are lines.
    pub enum FilteredEdges {
        /// Steps in depth.
        Silhouettes = "silhouettes",
        /// Those, and where normals turn.
        All = "all",
    }
}

line_method_options! {
    /// Options of [`GbufferFilter`].
    pub struct GbufferFilterOptions {
        /// Which pixels are compared: two diagonals of four pixels, or a pixel with the eight around it.
        pub operator: Operator = choice("operator", sweep ["roberts", "sobel"]),
        /// Which discontinuities are lines: steps in depth, or turns of the normal as well.
        pub edges: FilteredEdges = choice("edges"),
        /// Least step in depth that is a line: less finds more of what lies close behind, and false lines on grazing surfaces.
        pub depth_threshold: f64 = number("depth-threshold", 1e-6..=10.0 "bounding radii", default 0.02),
        /// Least angle between normals that is a line, with edges=all.
        pub normal_threshold_deg: f64 = number("normal-threshold", 0.1..=180.0 "degrees", default 30.0),
    }
}

/// Lines found by a filter over depth and normals, as most engines have them in a post-processing pass.
///
/// Prepares nothing. O(F) per view on the device, and O(pixels (log2(width) + 2)); nothing on the CPU. 28 bytes on the device for
/// each pixel of the view and of a margin as wide as the lines.
///
/// Ink is centred on the discontinuity and lies on what is nearest there, so that whatever stands before the mesh hides its lines.
/// Outlines of one sample per pixel are staircases, whose steps lie on either side of the true outline: around a sphere, lines are
/// wider than asked by up to 0.7 px (`roberts`) or 1 px (`sobel`). None is thinner than a pixel and a half or so: the filter finds
/// lines between pixels.
///
/// # Failures
/// The filter sees one sample per pixel: lines are as jagged as the mesh is without antialiasing, and parts thinner than a
/// pixel have broken ones. Steps below the threshold have no line, which nothing but the distance of two surfaces decides: contact,
/// thin plates on each other. Nor have steps within two pixels of the end of the mesh. Curved surfaces that graze the view, and
/// planes seen so nearly edge-on that they are a pixel wide, may have false lines.
#[derive(Debug, Clone)]
pub struct GbufferFilter {
    #[cfg_attr(not(feature = "gpu"), allow(dead_code, reason = "what options are for is on the device"))]
    pub(super) options: GbufferFilterOptions,
}

impl Method for GbufferFilter {
    type Options = GbufferFilterOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "gbuffer-filter",
        summary: "Draws the mesh's depth and normals, and inks their discontinuities in the image.",
        source: Source {
            authors: "Takafumi Saito and Tokiichiro Takahashi",
            title: "Comprehensible rendering of 3-D shapes",
            venue: "SIGGRAPH",
            year: 1990,
        },
        exact: false,
        needs: &[],
        options: GbufferFilterOptions::SPECS,
        guide: MethodGuide {
            origin: "Saito and Takahashi 1990",
            yields: "ink",
            accuracy: "no: lines are as jagged as one sample per pixel is",
            cost: "O(F + pixels (log2(width) + 2)) on the adapter",
            memory: "28 bytes per pixel of the view and its margin",
            choose_when: "depth and normals of the frame are there anyway, and steps below a threshold may be missed",
            limits: "steps in depth below a threshold have no line; smooth folds may get one",
        },
        published: &[],
    };

    fn prepare(
        _mesh: &Arc<PreparedMesh>,
        options: &GbufferFilterOptions,
        _progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        options.validate()?;
        Ok(Self { options: *options })
    }

    fn bytes(&self) -> usize {
        0
    }
}
