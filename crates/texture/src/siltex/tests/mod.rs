//! Round trips, and files that are cut short, damaged or hostile.

mod another_reader;
mod damaged;
mod hostile;
mod places;
mod round_trip;
mod textures;
