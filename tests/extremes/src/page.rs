//! `docs/STABILITY.md`: a table per family.
