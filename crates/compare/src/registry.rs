//! [`Registry`]: the list of methods, as a value that callers extend.
//!
//! An [`Entry`] prepares its method for a mesh once; what it was registered with decides what the prepared method can be asked
//! for. Capabilities add up: a method may extract edges, draw lines, fill an image and make triangles for each view.
//!
//! ```
//! use silhouette_compare::registry::{Entry, Registry};
//! use silhouette_extraction::BruteForce;
//!
//! let registry = Registry::builtin().with(Entry::of::<BruteForce>().loops());
//! assert!(registry.find("brute-force").is_ok());
//! ```

mod entry;
mod found_edges;

pub use entry::{Capabilities, Entry, EntryBuilder, FillMethod, LineMethod, Prepared};
pub use found_edges::FoundEdges;

#[cfg(feature = "simplify")]
use silhouette_baselines::LodMesh;
use silhouette_baselines::{FineMesh, GbufferFilter, InvertedHull, JumpFlood};
use silhouette_core::Method;
use silhouette_edge_mesh::EdgeMesh;
use silhouette_extraction::{BruteForce, BruteForceSimd, ClusterCones, Randomized};
use silhouette_image_precision::ImagePrecision;
use silhouette_smoothing::{
    AdaptiveRefinement, BoundaryCurve, InterpolatedContours, PhongTessellation, PnTriangles, Smoothing,
};
use silhouette_texture::{NormalMapHull, Texture, TextureLines};
use silhouette_tracking::{ExactTracking, Tracking};

/// The baseline: speeds are stated as ratios to it.
pub const BASELINE: &str = BruteForce::INFO.name;

/// Methods by name, in the order in which they are listed and compared.
#[derive(Debug, Clone, Default)]
pub struct Registry {
    entries: Vec<Entry>,
}

/// There is no method of this name.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("there is no method '{name}'; there are {known}")]
pub struct UnknownMethod {
    /// What was asked for.
    pub name: String,
    /// The names that exist, separated by commas.
    pub known: String,
}

impl Registry {
    /// Every method of this workspace; `lod-mesh` with the cargo feature `simplify` alone.
    pub fn builtin() -> Self {
        let methods = Self::default()
            .with(Entry::of::<BruteForce>().loops())
            .with(Entry::of::<BruteForceSimd>().loops().moving())
            .with(Entry::of::<ClusterCones>().loops())
            .with(Entry::of::<Randomized>().edges())
            .with(Entry::of::<Tracking>().loops().moving())
            .with(Entry::of::<ExactTracking>().loops().moving())
            .with(Entry::of::<ImagePrecision>().lines())
            .with(Entry::of::<EdgeMesh>().edges().lines())
            .with(Entry::of::<FineMesh>().fill())
            .with(Entry::of::<InvertedHull>().lines())
            .with(Entry::of::<GbufferFilter>().lines())
            .with(Entry::of::<JumpFlood>().lines())
            .with(Entry::of::<Smoothing>().curves().fill().triangles())
            .with(Entry::of::<InterpolatedContours>().curves())
            .with(Entry::of::<BoundaryCurve>().curves().fill().triangles())
            .with(Entry::of::<PnTriangles>().fill().triangles())
            .with(Entry::of::<PhongTessellation>().fill().triangles())
            .with(Entry::of::<AdaptiveRefinement>().fill().triangles())
            .with(Entry::of::<Texture>().fill())
            .with(Entry::of::<TextureLines>().lines())
            .with(Entry::of::<NormalMapHull>().fill());
        #[cfg(feature = "simplify")]
        let methods = methods.with(Entry::of::<LodMesh>().fill());
        methods
    }

    /// The same methods and one more; one of the same name is replaced.
    #[must_use]
    pub fn with(mut self, entry: impl Into<Entry>) -> Self {
        let entry = entry.into();
        match self.entries.iter_mut().find(|known| known.info().name == entry.info().name) {
            Some(known) => *known = entry,
            None => self.entries.push(entry),
        }
        self
    }

    /// Every method, in order.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// The method of this name.
    ///
    /// # Errors
    /// [`UnknownMethod`] lists the names that exist.
    pub fn find(&self, name: &str) -> Result<&Entry, UnknownMethod> {
        let found = self.entries.iter().find(|entry| entry.info().name == name);
        found.ok_or_else(|| UnknownMethod { name: name.to_owned(), known: self.names(|_| true) })
    }

    /// Names of the methods that `is_wanted` holds for, separated by commas.
    pub fn names(&self, is_wanted: impl Fn(&Entry) -> bool) -> String {
        let names = self.entries.iter().filter(|entry| is_wanted(entry)).map(|entry| entry.info().name);
        names.collect::<Vec<_>>().join(", ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::method::OptionValues;
    use silhouette_core::{NoProgress, PreparedMesh, TriangleMesh};
    use silhouette_testing::prepare::cheap_options;
    use std::collections::BTreeSet;
    use std::sync::Arc;

    #[test]
    fn names_are_unique_in_kebab_case_and_found() {
        let registry = Registry::builtin();
        let names: BTreeSet<_> = registry.entries().iter().map(|entry| entry.info().name).collect();
        assert_eq!(names.len(), registry.entries().len());
        for name in names {
            assert!(name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-'), "{name}");
            assert_eq!(registry.find(name).unwrap().info().name, name);
        }
        assert!(registry.find(BASELINE).unwrap().capabilities().loops);
    }

    #[test]
    fn an_unknown_name_is_answered_with_the_known_ones() {
        let registry = Registry::builtin();
        let error = registry.find("brute-farce").unwrap_err().to_string();
        assert!(registry.entries().iter().all(|entry| error.contains(entry.info().name)), "{error}");
    }

    #[test]
    fn an_entry_of_a_known_name_replaces_it() {
        let registry = Registry::builtin();
        let edges_only = registry.clone().with(Entry::of::<BruteForce>().edges());
        assert_eq!(edges_only.entries().len(), registry.entries().len());
        assert!(!edges_only.find(BASELINE).unwrap().capabilities().loops);
    }

    #[test]
    fn prepared_methods_answer_what_their_entries_say() {
        let mesh = Arc::new(PreparedMesh::new(TriangleMesh::new(vec![], vec![]).unwrap()));
        for entry in Registry::builtin().entries() {
            let options = OptionValues::defaults(entry.info().options);
            let mut prepared = entry.prepare(&mesh, &options, &NoProgress).unwrap();
            let answered = Capabilities {
                edges: prepared.edges().is_some(),
                moving_edges: false,
                loops: prepared.loops().is_some(),
                curves: prepared.curves().is_some(),
                lines: prepared.lines().is_some(),
                fill: prepared.fill().is_some(),
                triangles: prepared.triangles().is_some(),
            };
            let answered = Capabilities { moving_edges: prepared.into_moving_edges().is_ok(), ..answered };
            assert_eq!(answered, entry.capabilities(), "{}", entry.info().name);
            assert_ne!(answered, Capabilities::default(), "{} can do nothing", entry.info().name);
        }
    }

    #[test]
    fn preparation_asks_for_what_the_method_says_it_needs_and_no_more() {
        for entry in Registry::builtin().entries() {
            let info = entry.info();
            let mesh = Arc::new(PreparedMesh::new(silhouette_core::shapes::by_name("cube").unwrap()));
            entry.prepare(&mesh, &cheap_options(info.options), &NoProgress).unwrap();
            let report = mesh.report();
            let asked: BTreeSet<_> = report.iter().filter(|a| a.asked_by.contains(info.name)).map(|a| a.name).collect();
            assert_eq!(asked, BTreeSet::from_iter(info.needs.iter().copied()), "{}", info.name);
            assert!(!info.needs.is_empty() || report.is_empty(), "{} needs triangles only", info.name);
        }
    }

    #[test]
    fn every_value_of_every_sweep_fits_its_option() {
        let mut sweeps = 0;
        for entry in Registry::builtin().entries() {
            let info = entry.info();
            for spec in info.options {
                let values = spec.sweep_values(9);
                assert_eq!(values.is_empty(), spec.sweep.is_none(), "{}.{}", info.name, spec.name);
                for value in values {
                    let word = format!("{}={value}", spec.name);
                    assert!(OptionValues::parse(info.options, [word.as_str()]).is_ok(), "{}.{word}", info.name);
                    sweeps += 1;
                }
            }
        }
        assert!(sweeps > 50, "{sweeps}");
    }
}
