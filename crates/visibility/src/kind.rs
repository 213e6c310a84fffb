//! [`LineKind`]: why a line is drawn.

/// Why a line is drawn. A mesh edge that qualifies for several kinds has the first of them, in this order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum LineKind {
    /// An edge along which a section plane cut the mesh open.
    Section,
    /// An edge between faces of both facings.
    Silhouette,
    /// An edge with one face.
    Boundary,
    /// A convex edge whose faces bend by at least the ridge threshold.
    Ridge,
    /// A concave edge whose faces bend by at least the valley threshold.
    Valley,
    /// An edge between faces of different labels (materials, groups).
    Material,
    /// Where two faces pass through each other away from any shared vertex.
    Intersection,
    /// A smooth curve supplied by the caller.
    Curve,
    /// Any other mesh edge.
    Mesh,
}

impl LineKind {
    /// All kinds, in order.
    pub const ALL: [Self; 9] = [
        Self::Section,
        Self::Silhouette,
        Self::Boundary,
        Self::Ridge,
        Self::Valley,
        Self::Material,
        Self::Intersection,
        Self::Curve,
        Self::Mesh,
    ];

    /// The name used on command lines and in files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Section => "section",
            Self::Silhouette => "silhouette",
            Self::Boundary => "boundary",
            Self::Ridge => "ridge",
            Self::Valley => "valley",
            Self::Material => "material",
            Self::Intersection => "intersection",
            Self::Curve => "curve",
            Self::Mesh => "mesh",
        }
    }
}
