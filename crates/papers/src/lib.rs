//! Figures of papers beside ours.
//!
//! [`figure`]: the format, one row a figure. [`files`]: what a reproduction is written as. [`hall_2003`]: Hall's table of speeds, and what it does not tell.
//! [`raskar_cohen_1999`]: Raskar and Cohen's frame rates, and what their pictures show.

mod column;
pub mod figure;
pub mod files;
pub mod hall_2003;
pub mod raskar_cohen_1999;

pub use column::Column;
pub use figure::{Figure, TableError, read_figures, write_figures};
pub use files::{WriteError, check_target};

/// Style of every page, inline: a page asks nothing of the network.
const PAGE_STYLE: &str = include_str!("page.css");
