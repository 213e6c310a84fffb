//! [`ImagePrecision`]: what the method says of itself, and its preparation.

use crate::feature_edges::feature_edges;
use crate::options::ImagePrecisionOptions;
use crate::polygons::Polygons;
use crate::published::PUBLISHED;
use crate::settings::{ExtraEdges, Settings};
use silhouette_core::Topology;
use silhouette_core::method::{Method, MethodGuide, MethodInfo, MethodOptions, PrepareError, Source};
use silhouette_core::prepared::PreparedMesh;
use silhouette_core::progress::Progress;
use std::sync::Arc;

/// Raskar and Cohen's method, prepared for a mesh: its options interpreted, and what they ask of the mesh.
#[derive(Debug, Clone)]
pub struct ImagePrecision {
    mesh: Arc<PreparedMesh>,
    settings: Settings,
    extra_edges: Vec<[u32; 2]>,
    polygons: Option<Polygons>,
}

impl Method for ImagePrecision {
    type Options = ImagePrecisionOptions;

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
        options: ImagePrecisionOptions::SPECS,
        guide: MethodGuide {
            origin: "Raskar and Cohen 1999, every variant; `screen`, the default, is our own",
            yields: "ink",
            accuracy: "no: `screen` missed nothing on six closed models",
            cost: "O(F) on the adapter, none on the processor",
            memory: "24 bytes per face, `screen` 24 to 32 more",
            choose_when: "there is no adjacency, or it changes every frame: even lines from a triangle soup at about \
                          the cost of drawing it. Positions are replaced in the device's buffer each frame \
                          (`MeshBuffers::set_positions`, or a buffer of your own); new triangles take new buffers",
            limits: "boundary edges of open meshes have no ink unless `extra-edges` asks for it, which builds the \
                     topology; lines between parts of a pixel or two turn grey; where four faces share an edge a \
                     silhouette edge may be dropped",
        },
        published: PUBLISHED,
    };

    fn prepare(
        mesh: &Arc<PreparedMesh>,
        options: &ImagePrecisionOptions,
        progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        options.validate()?;
        let settings = Settings::from(*options);
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

    /// The options, interpreted.
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
    use silhouette_core::method::{OptionChoice, OptionError};
    use silhouette_core::shapes::Cuboid;

    fn prepare(words: &[&str]) -> (ImagePrecision, Arc<PreparedMesh>) {
        let mesh = Arc::new(PreparedMesh::new(Cuboid::default().mesh().unwrap()));
        let options = ImagePrecisionOptions::parse(words.iter().copied()).unwrap();
        (ImagePrecision::new(&mesh, options).unwrap(), mesh)
    }

    #[test]
    fn no_variant_derives_anything_but_for_extra_edges() {
        for variant in crate::options::VariantChoice::WORDS {
            let (method, mesh) = prepare(&[&format!("variant={variant}"), "polygons=fans"]);
            assert!(mesh.report().is_empty(), "{variant}");
            assert_eq!(method.polygons().map(Polygons::count), Some(6));
        }
        let (method, mesh) = prepare(&["extra-edges=boundary-and-creases"]);
        assert_eq!((mesh.report().len(), mesh.report()[0].name), (1, "topology"));
        assert_eq!(method.extra_edges().len(), 12);
    }

    #[test]
    fn values_out_of_range_are_refused() {
        for word in ["scale=0", "scale=-0.5", "scale=1.01", "scale=nan", "width=-1"] {
            assert!(ImagePrecisionOptions::parse([word]).is_err(), "{word}");
        }
        assert!(ImagePrecisionOptions::parse(["scale=1"]).is_ok());
        let mesh = Arc::new(PreparedMesh::new(Cuboid::default().mesh().unwrap()));
        let options = ImagePrecisionOptions { ink_alpha: 1.5, ..ImagePrecisionOptions::default() };
        let error = ImagePrecision::new(&mesh, options).unwrap_err();
        assert!(matches!(error, PrepareError::Option(OptionError::Value { name: "ink-alpha", .. })), "{error}");
    }
}
