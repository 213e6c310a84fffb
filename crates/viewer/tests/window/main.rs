//! The window, driven by the labels of its controls, on whatever adapter there is.
//!
//! With `SILHOUETTES_SCREENSHOTS=DIR` each test leaves pictures of the window in DIR.

mod choosing;
mod labels;
mod measuring;
mod opening;
mod saving;
mod seeing;
mod stage;
mod steering;
