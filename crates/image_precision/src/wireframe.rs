//! Section 3.2: back faces as wireframe, depth test "nearer or equal".
//!
//! Lines are centred on the edges, and front faces hide the inner half of those along an outer outline: of a line w wide,
//! w / 2 is seen ([`SEEN_SHARE`]). Ask for twice the width to see it.
//!
//! `wireframe-lines=quads`, the default, draws lines of any width as quads by the renderer of [`screen`](crate::screen).
//! `polygon-mode` draws them as the paper does, with the adapter's polygon mode: 1 px wide, no wider anywhere, and only
//! where the device was made with wgpu's feature `POLYGON_MODE_LINE`; browsers have none.

/// Share of a line's width that is seen along an outer outline.
pub const SEEN_SHARE: f64 = 0.5;
