//! What Wu et al. print in Table 1: frames per second of the silhouette texture and of the mesh itself.

use silhouette_core::method::{PublishedRate, PublishedRates};

/// Table 1.
pub(crate) const PUBLISHED: &[PublishedRates] = &[PublishedRates {
    place: "Wu et al. 2006, Table 1, on a GeForce 7800 GT",
    against: "fine-mesh",
    rows: &[
        PublishedRate::new("Armadillo, 40,002 vertices", "hull of 1000 vertices, 512 x 512 px", 725.0, 308.0),
        PublishedRate::new("Bunny, 34,834 vertices", "hull of 500 vertices, 512 x 512 px", 638.0, 411.0),
        PublishedRate::new("Gargoyle, 30,002 vertices", "hull of 500 vertices, 512 x 512 px", 762.0, 460.0),
        PublishedRate::new("Dragon, 40,525 vertices", "hull of 970 vertices, 512 x 512 px", 674.0, 523.0),
        PublishedRate::new("Lucy, 1,000,000 vertices", "hull of 10,000 vertices, 1024 x 1024 px", 273.0, 1.5),
    ],
}];
