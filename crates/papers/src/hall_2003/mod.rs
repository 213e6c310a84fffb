//! T. Hall, "Silhouette Tracking", 2003: the table of the section Performance, and what it does not tell.
//!
//! The paper prints frames a second of a machine that is gone, on three models of which one can be had: the bunny, known
//! by its 69 451 faces ([`printed`]). Beside its speed-ups over brute force stand ours, twice: counted in faces, which no
//! machine changes, and in wall time over the same run's brute force. The paper does not say what is missed; the same
//! rows say it here. Rows that it lacks follow: tracking without a concave list, with single edges, in its exact mode and
//! with a budget, and extractors of today.
//!
//! 1. [`circles`]: where the eye flies. [`variants`]: what is flown.
//! 2. [`measure`]: each variant over the path. [`counted`]: faces evaluated; [`missed`]: edges, loops and length missed;
//!    [`visible`]: visible length missed; [`timed`]: time.
//! 3. [`rows`]: the figures.
//! 4. [`table`]: for a terminal. [`chart`]: time against what is missed. [`page`]: for a browser. [`write`](mod@write): as
//!    files.

pub mod chart;
pub mod circles;
pub mod counted;
pub mod measure;
pub mod missed;
pub mod page;
pub mod printed;
pub mod rows;
pub mod table;
pub mod timed;
pub mod variants;
pub mod visible;
pub mod write;

pub use measure::{MeshResult, ReproduceError, Reproduction, VariantResult, run};
pub use write::write;
