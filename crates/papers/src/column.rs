//! [`Column`]: a column of a table that people read.

/// A column: its head, its unit, what it tells.
pub struct Column {
    /// Its head.
    pub title: &'static str,
    /// Unit; empty for a ratio.
    pub unit: &'static str,
    /// What it tells.
    pub meaning: &'static str,
}
