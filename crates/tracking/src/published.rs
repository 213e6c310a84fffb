//! What Hall prints: frames per second with tracking and by brute force.

use silhouette_core::method::{PublishedRate, PublishedRates};

const BUNNY: &str = "Bunny, 69,451 faces";
const UFO: &str = "UFO, 19,608 faces";
const ALIEN: &str = "Alien, 41,265 faces";

/// The table of the paper; N is its concavity level in radians.
pub(crate) const PUBLISHED: &[PublishedRates] = &[PublishedRates {
    place: "Hall 2003, on a Pentium III of 650 MHz",
    against: "brute-force",
    rows: &[
        PublishedRate::new(BUNNY, "N = 0", 4.98, 4.42),
        PublishedRate::new(BUNNY, "N = 0.01", 5.68, 4.42),
        PublishedRate::new(BUNNY, "N = 0.1", 11.47, 4.42),
        PublishedRate::new(BUNNY, "N = 0.2", 18.92, 4.42),
        PublishedRate::new(BUNNY, "N = 0.5", 30.48, 4.42),
        PublishedRate::new(BUNNY, "N = 1", 34.85, 4.42),
        PublishedRate::new(UFO, "N = 0", 19.54, 18.35),
        PublishedRate::new(UFO, "N = 0.01", 23.18, 18.35),
        PublishedRate::new(UFO, "N = 0.1", 43.29, 18.35),
        PublishedRate::new(UFO, "N = 0.2", 57.15, 18.35),
        PublishedRate::new(UFO, "N = 0.5", 59.07, 18.35),
        PublishedRate::new(UFO, "N = 1", 59.15, 18.35),
        PublishedRate::new(ALIEN, "N = 0", 8.04, 7.73),
        PublishedRate::new(ALIEN, "N = 0.01", 8.52, 7.73),
        PublishedRate::new(ALIEN, "N = 0.1", 12.15, 7.73),
        PublishedRate::new(ALIEN, "N = 0.2", 16.15, 7.73),
        PublishedRate::new(ALIEN, "N = 0.5", 21.44, 7.73),
        PublishedRate::new(ALIEN, "N = 1", 27.34, 7.73),
    ],
}];
