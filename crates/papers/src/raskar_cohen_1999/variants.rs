//! What is drawn: every variant of the paper at the settings that its text names, and ours.

use silhouette_compare::drawing::{DrawError, Drawing, FrameStyle, Ground};
use silhouette_compare::metrics::{Ink, PictureKind};
use silhouette_compare::registry::Entry;
use silhouette_compare::runner::DEFAULT_PEN_WIDTH_PX;
use silhouette_core::method::{OptionError, OptionValues, PrepareError};
use silhouette_core::view::Camera;
use silhouette_core::{Method, PreparedMesh, Progress};
use silhouette_image_precision::ImagePrecision;
use silhouette_render::Gpu;
use std::sync::Arc;

/// One variant with its options.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Variant {
    /// Its label in tables.
    pub label: &'static str,
    /// `name=value` words, separated by spaces.
    pub words: &'static str,
    /// What decides the width of its lines.
    pub law: &'static str,
}

/// Ours: edges of back faces expanded in the image.
pub const SCREEN: Variant = variant("screen", "variant=screen", "the width that is asked for, at any level of detail");
/// Back faces scaled about the eye, the largest factor that the paper names.
pub const SCALE_99: Variant = variant("scale 0.99", "variant=scale scale=0.99", SCALE_LAW);
/// The same with the smallest factor.
pub const SCALE_95: Variant = variant("scale 0.95", "variant=scale scale=0.95", SCALE_LAW);
/// Fattening by the paper's law, without a bound.
pub const AS_PRINTED: Variant = variant(
    "fatten, as printed",
    "variant=fatten fatten-law=as-printed fatten-clamp=0",
    "spikes without a bound, and wider off the axis of the image",
);

const SCALE_LAW: &str = "the square of the pull over 8 radii of curvature on smooth rims";

/// All of them, in the order of the tables.
pub const VARIANTS: [Variant; 16] = [
    SCREEN,
    variant("equal", "variant=equal", "depths differ at pixel centres, so that next to nothing is drawn"),
    variant("wireframe", "variant=wireframe width=2", "half of the width: front faces hide the inner half"),
    variant("fixed pull", "variant=fixed-pull", "the square of the pull on smooth rims; magnifies"),
    SCALE_99,
    SCALE_95,
    variant("near plane out", "variant=depth-range plane-factor=1.05", "as scaling, less where the far plane is near"),
    variant(
        "far plane closer",
        "variant=depth-range depth-plane=far plane-factor=0.8",
        "pushes back faces away and draws nothing, against the paper's text",
    ),
    variant(
        "far plane out",
        "variant=depth-range depth-plane=far plane-factor=1.25",
        "pulls as moving the near plane out",
    ),
    variant(
        "offset 4",
        "variant=offset offset-slope=4",
        "4 px where the front face is seen face-on, half on smooth rims",
    ),
    variant("offset 16", "variant=offset offset-slope=16", "the same with 16 px"),
    variant("fatten", "variant=fatten", "the width that is asked for, with spikes cut at four edge lengths"),
    variant("fatten, no clamp", "variant=fatten fatten-clamp=0", "spikes without a bound, longer on finer meshes"),
    AS_PRINTED,
    variant("fatten, no sine", "variant=fatten-simple", "wider where edges point at the viewer"),
    variant("charcoal", "variant=charcoal interior=paper", "grey strokes on either side"),
];

/// A variant that draws what is not in the first layer, for meshes whose winding says nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Unoriented {
    /// The variant.
    pub variant: Variant,
    /// The one that draws the same where the winding is consistent and every face covers a pixel's centre.
    pub oriented: Variant,
}

/// Both of them.
pub const UNORIENTED: [Unoriented; 2] = [
    Unoriented {
        variant: variant(
            "unoriented",
            "variant=unoriented",
            "as scale 0.99: no pixel moves, so that small faces cannot ink",
        ),
        oriented: SCALE_99,
    },
    Unoriented {
        variant: variant(
            "unoriented, screen",
            "variant=unoriented unoriented-lines=screen",
            "as screen; front faces too small to cover a pixel's centre are inked as well",
        ),
        oriented: SCREEN,
    },
];

const fn variant(label: &'static str, words: &'static str, law: &'static str) -> Variant {
    Variant { label, words, law }
}

impl Variant {
    /// Its options, defaults filled in.
    ///
    /// # Errors
    /// [`OptionError`], which a test rules out for every variant here.
    pub fn options(&self) -> Result<OptionValues, OptionError> {
        OptionValues::parse(ImagePrecision::INFO.options, self.words.split(' '))
    }

    /// The variant, ready to draw a mesh.
    ///
    /// # Errors
    /// [`DrawError`]: cancelled, or a device that failed or cannot hold the mesh.
    pub fn drawing(
        &self,
        gpu: &Gpu,
        mesh: &Arc<PreparedMesh>,
        style: FrameStyle,
        progress: &dyn Progress,
    ) -> Result<Drawing, DrawError> {
        let options = self.options().map_err(PrepareError::from)?;
        let method: Entry = Entry::of::<ImagePrecision>().lines().into();
        Drawing::new(gpu, mesh, method.prepare(mesh, &options, progress)?, PictureKind::Lines, style)
    }

    /// The ink of one view, one sample per pixel.
    ///
    /// # Errors
    /// [`DrawError`]: cancelled, or a device that failed or cannot hold the mesh.
    pub fn ink(
        &self,
        gpu: &Gpu,
        mesh: &Arc<PreparedMesh>,
        camera: &Camera,
        progress: &dyn Progress,
    ) -> Result<Ink, DrawError> {
        let mut drawing = self.drawing(gpu, mesh, style(camera.size(), 1), progress)?;
        drawing.draw(gpu, camera)?;
        Ok(Ink::from_picture(&drawing.picture(gpu)?))
    }
}

/// How all pictures are drawn: the pen of every comparison, and this many samples per pixel.
pub fn style(size: [u32; 2], samples: u32) -> FrameStyle {
    FrameStyle { size, pen_width_px: DEFAULT_PEN_WIDTH_PX, samples, ground: Ground::Paper }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn variants_are_options_and_labels_are_unique() {
        let all = || VARIANTS.into_iter().chain(UNORIENTED.map(|unoriented| unoriented.variant));
        let labels: BTreeSet<_> = all().map(|variant| variant.label).collect();
        assert_eq!(labels.len(), all().count());
        assert!(all().all(|variant| variant.options().is_ok()));
        assert!(UNORIENTED.iter().all(|unoriented| VARIANTS.contains(&unoriented.oriented)));
    }
}
