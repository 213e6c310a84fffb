//! [`ImagePrecision`]: what the method says of itself, and its options.

use silhouette_core::method::{Method, MethodInfo, OptionKind, OptionSpec, OptionValues, PrepareError, Source};
use silhouette_core::prepared::PreparedMesh;
use silhouette_core::progress::Progress;
use std::sync::Arc;

/// Raskar and Cohen's method, prepared for a mesh: which is to say, with its options read.
#[derive(Debug, Clone)]
pub struct ImagePrecision {
    mesh: Arc<PreparedMesh>,
    scale: f64,
    skips_inside: bool,
}

const SCALE: OptionSpec = OptionSpec {
    name: "scale",
    summary: "Scale of back faces about the eye: 1 draws nothing, smaller is thicker and shows through sooner; the \
              paper uses 0.95 to 0.99",
    unit: "",
    kind: OptionKind::Number { min: 0.01, max: 1.0, default: 0.99 },
};

const EYE_INSIDE: OptionSpec = OptionSpec {
    name: "eye-inside",
    summary: "With the eye inside a closed mesh: skip the back faces, or draw them as the paper does, all black",
    unit: "",
    kind: OptionKind::Choice(&["skip", "draw"]),
};

impl Method for ImagePrecision {
    const INFO: MethodInfo = MethodInfo {
        name: "image-precision",
        summary: "Draws back faces black and slightly scaled towards the eye, over white front faces.",
        source: Source {
            authors: "Ramesh Raskar and Michael Cohen",
            title: "Image precision silhouette edges",
            venue: "Symposium on Interactive 3D Graphics",
            year: 1999,
        },
        exact: false,
        needs: &[],
        options: &[SCALE, EYE_INSIDE],
    };

    fn prepare(
        mesh: &Arc<PreparedMesh>,
        options: &OptionValues,
        _progress: &dyn Progress,
    ) -> Result<Self, PrepareError> {
        Ok(Self {
            mesh: Arc::clone(mesh),
            scale: options.number(SCALE.name)?,
            skips_inside: options.choice(EYE_INSIDE.name)? == "skip",
        })
    }

    fn bytes(&self) -> usize {
        0
    }
}

impl ImagePrecision {
    /// The mesh it was prepared for.
    pub fn mesh(&self) -> &Arc<PreparedMesh> {
        &self.mesh
    }

    /// Scale of back faces about the eye, k in the paper, above 0 and at most 1.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// Whether back faces are left out while the eye is inside a closed mesh.
    pub fn skips_inside(&self) -> bool {
        self.skips_inside
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::mesh::TriangleMesh;
    use silhouette_core::progress::NoProgress;

    #[test]
    fn preparation_derives_nothing() {
        let mesh = Arc::new(PreparedMesh::new(TriangleMesh::new(vec![], vec![]).unwrap()));
        let options = OptionValues::parse(ImagePrecision::INFO.options, ["scale=0.95"]).unwrap();
        let method = ImagePrecision::prepare(&mesh, &options, &NoProgress).unwrap();
        assert!((method.scale() - 0.95).abs() < 1e-12 && method.skips_inside());
        assert!(mesh.report().is_empty());
    }

    #[test]
    fn scales_that_are_none_are_refused() {
        for word in ["scale=0", "scale=-0.5", "scale=1.01", "scale=nan"] {
            assert!(OptionValues::parse(ImagePrecision::INFO.options, [word]).is_err(), "{word}");
        }
        assert!(OptionValues::parse(ImagePrecision::INFO.options, ["scale=1"]).is_ok());
    }
}
