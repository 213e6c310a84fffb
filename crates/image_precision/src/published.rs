//! What Raskar and Cohen print in section 5: frames per second with silhouettes and without.

use silhouette_core::method::{PublishedRate, PublishedRates};

/// The figures of section 5, of two machines. The method `fine-mesh` stands for drawing without silhouettes.
pub(crate) const PUBLISHED: &[PublishedRates] = &[
    PublishedRates {
        place: "Raskar and Cohen 1999, section 5, on an SGI Indigo2 with MaxImpact graphics",
        against: "fine-mesh",
        rows: &[
            PublishedRate::new("Venus, 5672 triangles", "wireframe", 40.0, 66.0),
            PublishedRate::new("Venus, 5672 triangles", "translated", 50.0, 66.0),
            PublishedRate::new("Venus, 5672 triangles", "fattened", 11.5, 66.0),
            PublishedRate::new("Face, 13,408 triangles", "charcoal", 5.0, 30.0),
        ],
    },
    PublishedRates {
        place: "Raskar and Cohen 1999, section 5, on SGI InfiniteReality graphics",
        against: "fine-mesh",
        rows: &[PublishedRate::new("Auxiliary machine room, 252,000 triangles", "wireframe", 4.2, 6.0)],
    },
];
