//! [`MethodGuide`]: what a reader needs in order to choose a method.

/// What a method says of itself to those who choose among methods: in tables, in reports and on the command line.
///
/// Each text is a phrase without a full stop, in Markdown of one line at most: names in backquotes, no links, no `|`. F faces, E edges,
/// V vertices and S silhouette edges may stand for themselves. An empty text says that nothing is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, serde::Serialize)]
pub struct MethodGuide {
    /// What it goes back to, as short as a table bears: `Hall 2003, corrected`.
    pub origin: &'static str,
    /// What it yields: `exact edges and loops`.
    pub yields: &'static str,
    /// How close it comes: what is guaranteed, or what was measured.
    pub accuracy: &'static str,
    /// What a view costs, and where.
    pub cost: &'static str,
    /// Memory beyond the mesh.
    pub memory: &'static str,
    /// When to choose it, as the end of *choose it when*.
    pub choose_when: &'static str,
    /// Where it fails, or what it cannot do.
    pub limits: &'static str,
}

impl MethodGuide {
    /// Every text with its heading, in the order of the fields.
    pub const fn texts(&self) -> [(&'static str, &'static str); 7] {
        [
            ("goes back to", self.origin),
            ("yields", self.yields),
            ("accuracy", self.accuracy),
            ("cost per view", self.cost),
            ("memory", self.memory),
            ("choose it when", self.choose_when),
            ("where it fails", self.limits),
        ]
    }
}
