//! Which stage of `ink.wgsl` colours lines, and how ink joins what the target holds.

use crate::settings::{Interior, Settings};

/// The fragment stage for lines without a texture. The constant one where ink does not fade: it is cheaper.
pub(crate) fn solid_fragment(settings: &Settings) -> &'static str {
    if settings.depth_fade > 0.0 { "faded_fragment" } else { "solid_fragment" }
}

/// How lines join what the target holds: ink that is translucent, or that fades where there is no paper, is blended.
pub(crate) fn blend(settings: &Settings) -> Option<wgpu::BlendState> {
    let fades_out = settings.depth_fade > 0.0 && !is_on_paper(settings);
    (settings.ink_alpha < 1.0 || fades_out).then_some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING)
}

/// Whether front faces are drawn in a colour, which lines fade to.
pub(crate) fn is_on_paper(settings: &Settings) -> bool {
    !matches!(settings.interior, Interior::DepthOnly | Interior::None)
}
