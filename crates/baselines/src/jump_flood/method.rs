//! [`JumpFlood`]: what the method says of itself.

use crate::line_options::line_method_options;
use silhouette_core::method::{Method, MethodGuide, MethodInfo, MethodOptions, PrepareError, Source};
use silhouette_core::option_choice;
use silhouette_core::prepared::PreparedMesh;
use silhouette_core::progress::Progress;
use std::sync::Arc;

option_choice! {
    /// How the outer rim of an outline ends.
    pub enum Antialiasing {
        /// At the samples of the target: with one sample per pixel, at whole pixels.
        Samples = "samples",
        /// Blended by the share of a pixel that it covers, however many samples the target has.
        Coverage = "coverage",
    }
}

line_method_options! {
    /// Options of [`JumpFlood`].
    pub struct JumpFloodOptions {
        /// How the outer rim ends: at the samples of the target, or blended by the share of a pixel that it covers.
        pub antialiasing: Antialiasing = choice("antialiasing", sweep ["samples", "coverage"]),
    }
}

/// Outlines of objects, as selections in editors have them: ink as far around an object as the width says, found by jump flooding.
///
/// Prepares nothing. O(F) per view on the device, and O(pixels (log2(width) + 2)); nothing on the CPU. 40 bytes on the device for
/// each pixel of the view and of a margin as wide as the lines.
///
/// Ink lies outside. Only outer outlines are drawn: where a part of an object stands before another part of the same object there
/// is no line. Several objects in one field, each with an outline of its own, are a group (`JumpFloodGroup` of feature `gpu`).
///
/// # Failures
/// Parts between samples, a quarter of a pixel thin, have no outline. Lines of objects more than 256 px outside the view are
/// missing within it. A pixel is inked for its nearest seed alone: where something of the application's hides that object's
/// outline there, the outline of another object a little farther away is missing too. Jump flooding finds a seed for some pixels
/// that is farther than the nearest by a fraction of a pixel.
#[derive(Debug, Clone)]
pub struct JumpFlood {
    #[cfg_attr(not(feature = "gpu"), allow(dead_code, reason = "what options are for is on the device"))]
    pub(super) options: JumpFloodOptions,
}

impl Method for JumpFlood {
    type Options = JumpFloodOptions;

    const INFO: MethodInfo = MethodInfo {
        name: "jump-flood",
        summary: "Inks what lies around an object in the image, found by jump flooding: outlines of any width.",
        source: Source {
            authors: "Guodong Rong and Tiow-Seng Tan",
            title: "Jump flooding in GPU with applications to Voronoi diagram and distance transform",
            venue: "Symposium on Interactive 3D Graphics and Games",
            year: 2006,
        },
        exact: false,
        needs: &[],
        options: JumpFloodOptions::SPECS,
        guide: MethodGuide {
            origin: "Rong and Tan 2006, with a number per object",
            yields: "ink",
            accuracy: "no: outer outlines alone, to a tenth of a pixel, and a quarter around sharp corners",
            cost: "O(F + pixels (log2(width) + 2)) on the adapter",
            memory: "40 bytes per pixel of the view and its margin",
            choose_when: "objects are to stand out by outlines of any width, which stay apart where objects overlap",
            limits: "no lines inside of the outline",
        },
        published: &[],
    };

    fn prepare(
        _mesh: &Arc<PreparedMesh>,
        options: &JumpFloodOptions,
        _progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        options.validate()?;
        Ok(Self { options: *options })
    }

    fn bytes(&self) -> usize {
        0
    }
}
