//! Charts of tables, as SVG.
//!
//! [`trade`]: two metrics against each other, a panel per table and a mark per row. [`bars`]: metrics side by side, a bar per
//! row. [`map`]: two rivals over a grid. `place`: where words beside marks have room.

pub mod bars;
pub mod map;
mod place;
pub mod trade;

/// A chart.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Chart {
    /// Its file.
    pub file_name: &'static str,
    /// What stands above it.
    pub title: &'static str,
    /// The chart, as an SVG document.
    pub svg: String,
}
