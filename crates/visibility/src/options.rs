//! [`LineOptions`]: which lines are wanted.

/// Which lines are wanted of a view. The default: silhouette and boundary edges, visible parts only.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub struct LineOptions {
    /// Edges along which section planes cut. Default: yes, where the scene has some.
    pub section: bool,
    /// Silhouette edges. Default: yes.
    pub silhouette: bool,
    /// Boundary edges, of front and of back faces. Default: yes.
    pub boundary: bool,
    /// Whether boundary edges of back faces are among them: edges of a sheet seen from behind, which are no silhouette
    /// edges. Default: yes.
    pub back_boundary: bool,
    /// Convex edges whose faces' normals differ by at least this angle in degrees, 0 to 180. Default: none.
    pub ridge_deg: Option<f64>,
    /// Concave edges whose faces' normals differ by at least this angle in degrees, 0 to 180. Default: none.
    pub valley_deg: Option<f64>,
    /// Edges between faces of different labels. Default: yes, where the scene has labels.
    pub material: bool,
    /// Lines in which faces pass through each other. Costs a search of the whole scene for each new mesh. Default: no.
    pub intersection: bool,
    /// Every mesh edge. Default: no.
    pub mesh: bool,
    /// Smooth curves of the scene. Default: yes, where the scene has some.
    pub curves: bool,
    /// Largest invisibility that is wanted: 0 for visible lines only, [`u32::MAX`] for all. Default: 0.
    pub max_invisibility: u32,
    /// Whether the [outline](crate::Outline) is wanted as well. Default: no.
    pub outline: bool,
}

impl Default for LineOptions {
    fn default() -> Self {
        Self {
            section: true,
            silhouette: true,
            boundary: true,
            back_boundary: true,
            ridge_deg: None,
            valley_deg: None,
            material: true,
            intersection: false,
            mesh: false,
            curves: true,
            max_invisibility: 0,
            outline: false,
        }
    }
}
