//! Round trips, and files that are cut short, damaged or hostile.

mod damaged;
mod hostile;
mod places;
mod round_trip;
mod textures;
