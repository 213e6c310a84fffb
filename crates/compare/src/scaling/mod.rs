//! How the time of an extraction grows with the mesh: timings of any tool in one form, and laws fitted to them.
//!
//! 1. [`ExtractionRow`]: one method on one mesh, as a line of a file that every tool can write ([`read_rows`],
//!    [`write_rows`]).
//! 2. [`series()`]: the rows of one method, by size.
//! 3. [`PowerLaw`]: time as a power of the number of faces.
//! 4. [`rows_of_cells`]: the extractions of a comparison in the same form.

mod of_cells;
mod power_law;
mod rows;
mod series;

pub use of_cells::rows_of_cells;
pub use power_law::PowerLaw;
pub use rows::{ExtractionRow, MAX_LINE_BYTES, OURS, RowFault, RowsError, read_rows, write_rows};
pub use series::{Growth, MIN_SIZES, Series, series};

#[cfg(test)]
pub(crate) use rows::tests::row;
