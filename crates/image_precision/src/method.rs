//! [`ImagePrecision`]: what the method says of itself, and its preparation.

use crate::feature_edges::feature_edges;
use crate::options;
use crate::polygons::Polygons;
use crate::settings::{ExtraEdges, Settings};
use silhouette_core::Topology;
use silhouette_core::method::{Method, MethodInfo, OptionValues, PrepareError, Source};
use silhouette_core::prepared::PreparedMesh;
use silhouette_core::progress::Progress;
use std::sync::Arc;

/// Raskar and Cohen's method, prepared for a mesh: which is to say, with its options read.
#[derive(Debug, Clone)]
pub struct ImagePrecision {
    mesh: Arc<PreparedMesh>,
    settings: Settings,
    extra_edges: Vec<[u32; 2]>,
    polygons: Option<Polygons>,
}

impl Method for ImagePrecision {
    const INFO: MethodInfo = MethodInfo {
        name: "image-precision",
        summary: "Draws back faces black over white front faces, so that they show along silhouettes alone; or, by \
                  default, their edges expanded in the image plane.",
        source: Source {
            authors: "Ramesh Raskar and Michael Cohen",
            title: "Image precision silhouette edges",
            venue: "Symposium on Interactive 3D Graphics",
            year: 1999,
        },
        exact: false,
        needs: &[],
        options: options::ALL,
    };

    fn prepare(
        mesh: &Arc<PreparedMesh>,
        options: &OptionValues,
        progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        let settings = Settings::read(options)?;
        let extra_edges = if settings.extra_edges == ExtraEdges::None {
            Vec::new()
        } else {
            let topology = mesh.artefact::<Topology>(Self::INFO.name, progress)?;
            feature_edges(mesh.mesh(), &topology, settings.extra_edges)
        };
        let polygons = settings.fans.then(|| Polygons::from_fans(mesh.mesh()));
        Ok(Self { mesh: Arc::clone(mesh), settings, extra_edges, polygons })
    }

    fn bytes(&self) -> usize {
        size_of_val(&self.extra_edges[..]) + self.polygons.as_ref().map_or(0, Polygons::bytes)
    }
}

impl ImagePrecision {
    /// The mesh it was prepared for.
    pub fn mesh(&self) -> &Arc<PreparedMesh> {
        &self.mesh
    }

    /// What the options say.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Vertices of the edges that are drawn along.
    pub fn extra_edges(&self) -> &[[u32; 2]] {
        &self.extra_edges
    }

    /// The polygons that are fattened, where they are not the triangles.
    pub fn polygons(&self) -> Option<&Polygons> {
        self.polygons.as_ref()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::settings::Variant;
    use silhouette_core::method::OptionKind;
    use silhouette_core::progress::NoProgress;
    use silhouette_core::shapes::Cuboid;

    fn prepare(words: &[&str]) -> (ImagePrecision, Arc<PreparedMesh>) {
        let mesh = Arc::new(PreparedMesh::new(Cuboid::default().mesh().unwrap()));
        let options = OptionValues::parse(ImagePrecision::INFO.options, words.iter().copied()).unwrap();
        (ImagePrecision::prepare(&mesh, &options, &NoProgress).unwrap(), mesh)
    }

    #[test]
    fn no_variant_derives_anything_but_for_extra_edges() {
        let OptionKind::Choice(variants) = options::VARIANT.kind else { panic!("variant is a choice") };
        for variant in variants {
            let (method, mesh) = prepare(&[&format!("variant={variant}"), "polygons=fans"]);
            assert!(mesh.report().is_empty(), "{variant}");
            assert_eq!(method.polygons().map(Polygons::count), Some(6));
        }
        let (method, mesh) = prepare(&["extra-edges=boundary-and-creases"]);
        assert_eq!((mesh.report().len(), mesh.report()[0].name), (1, "topology"));
        assert_eq!(method.extra_edges().len(), 12);
    }

    #[test]
    fn options_are_read_into_their_variant() {
        assert_eq!(prepare(&[]).0.settings().variant, Variant::Screen);
        assert_eq!(prepare(&["variant=scale", "scale=0.95"]).0.settings().variant, Variant::Scale { k: 0.95 });
        assert_eq!(prepare(&["variant=unoriented"]).0.settings().variant, Variant::Unoriented { k: Some(0.99) });
    }

    #[test]
    fn scales_that_are_none_are_refused() {
        for word in ["scale=0", "scale=-0.5", "scale=1.01", "scale=nan", "width=-1"] {
            assert!(OptionValues::parse(ImagePrecision::INFO.options, [word]).is_err(), "{word}");
        }
        assert!(OptionValues::parse(ImagePrecision::INFO.options, ["scale=1"]).is_ok());
    }
}
