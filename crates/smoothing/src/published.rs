//! What Wang et al. print in Table I: frames per second by their method, in perspective, and by PN triangles.

use silhouette_core::method::{PublishedRate, PublishedRates};

const COPIES: &str = "60 copies";

/// Table I.
pub(crate) const PUBLISHED: &[PublishedRates] = &[PublishedRates {
    place: "Wang et al. 2008, Table I, on a GeForce 7800 GT",
    against: "pn-triangles",
    rows: &[
        PublishedRate::new("Sphere, 200 triangles", COPIES, 347.0, 115.0),
        PublishedRate::new("Knot, 480 triangles", COPIES, 147.0, 53.0),
        PublishedRate::new("Bunny, 500 triangles", COPIES, 68.0, 50.0),
        PublishedRate::new("Fish, 500 triangles", COPIES, 114.0, 77.0),
        PublishedRate::new("Bear, 500 triangles", COPIES, 112.0, 52.0),
        PublishedRate::new("Head, 500 triangles", COPIES, 75.0, 54.0),
        PublishedRate::new("Venus, 500 triangles", COPIES, 153.0, 76.0),
        PublishedRate::new("Cat, 500 triangles", COPIES, 74.0, 52.0),
        PublishedRate::new("Cow, 500 triangles", COPIES, 80.0, 51.0),
        PublishedRate::new("Torus, 576 triangles", COPIES, 167.0, 67.0),
        PublishedRate::new("Hippo, 43,288 triangles", "one copy", 96.0, 60.0),
    ],
}];
