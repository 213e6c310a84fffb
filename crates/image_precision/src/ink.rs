//! Which stage of `ink.wgsl` colours lines.

use crate::settings::Settings;

/// The fragment stage for lines without a texture. The constant one where ink does not fade: it is cheaper.
pub(crate) fn solid_fragment(settings: &Settings) -> &'static str {
    if settings.depth_fade > 0.0 { "faded_fragment" } else { "solid_fragment" }
}
