//! [`SilhouetteTexture`]: everything that drawing needs, as baked or as read from a file.

use crate::hull::Hull;
use crate::volume_size::VolumeSize;
use glam::{Vec2, Vec3};
use half::f16;
use silhouette_core::glam;

silhouette_core::option_choice! {
    /// Which visibility function is sampled.
    pub enum VisibilityRule {
        /// Equation 2: a hull point shows the object in a direction if the object is met before the hull is left. Outer and inner
        /// outlines are kept.
        Interior = "interior",
        /// Equation 1: it does if the object is met at all. Outer outlines only.
        Exterior = "exterior",
    }
}

/// The angles from the lobe's centre to its border, one per sample, as shares of pi.
#[derive(Debug, Clone, PartialEq)]
pub enum Angles {
    /// 8 bits: 0 to 255 stand for 0 to pi. Steps of 0.7 degrees.
    Unorm8(Vec<u8>),
    /// 16-bit floats, 0.0 to 1.0.
    Float16(Vec<f16>),
    /// The first terms of a singular value decomposition.
    Terms(Terms),
}

/// Angles as sums of few functions of azimuth, one weight per texel and function (section 3.5):
/// angle / pi = sum over terms of (`offsets[t]` + `scales[t]` * weight / 255) * `functions[t][azimuth]`.
#[derive(Debug, Clone, PartialEq)]
pub struct Terms {
    /// One function of azimuth per term, each a unit vector of `azimuths` values: right singular vectors, largest first.
    pub functions: Vec<Vec<f32>>,
    /// What a weight of 0 stands for, per term.
    pub offsets: Vec<f32>,
    /// What the step from weight 0 to 255 stands for, per term.
    pub scales: Vec<f32>,
    /// Weights, term by term and within a term in the order of texels.
    pub weights: Vec<u8>,
}

/// Where a corner of a hull face lies in the atlas.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FacePlace {
    /// Page.
    pub page: u32,
    /// Texture coordinates of the three corners: 0 to 1 across a page, (0, 0) the outer corner of the first texel.
    pub corners: [Vec2; 3],
}

/// A hull with what was baked on it.
///
/// Arrays agree in length with one another, as [`new`](Self::new) checks; all positions, directions and lengths are in the
/// object's own space.
#[derive(Debug, Clone)]
pub struct SilhouetteTexture {
    parts: Parts,
}

/// What a [`SilhouetteTexture`] consists of.
#[derive(Debug, Clone)]
pub struct Parts {
    /// The hull.
    pub hull: Hull,
    /// Per hull vertex: the middle of the lobe (C), unit.
    pub centers: Vec<Vec3>,
    /// Per hull vertex: where azimuths begin (T), unit.
    pub tangents: Vec<Vec3>,
    /// Per hull face.
    pub places: Vec<FacePlace>,
    /// Texels.
    pub size: VolumeSize,
    /// The function that the angles sample.
    pub rule: VisibilityRule,
    /// One per sample.
    pub angles: Angles,
    /// Per texel, the middle of the lobe where it is not interpolated between vertices: x, y, z and an unused component.
    pub texel_centers: Option<Vec<[f16; 4]>>,
    /// Per texel: distance from the hull point to the outline, over [`unit`](SilhouetteTexture::unit).
    pub gaps: Vec<f16>,
    /// Texels of colours and normals along a texel's side.
    pub detail: u32,
    /// Per detail texel, in rows of a page: sRGB and alpha.
    pub colors: Vec<[u8; 4]>,
    /// Per detail texel, in rows of a page: unit normal of the object, and an unused component.
    pub normals: Vec<[f16; 4]>,
}

/// Arrays of a silhouette texture that do not fit each other.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{what}: {found} values where the hull and the size of the texture ask for {expected}")]
pub struct PartsError {
    /// Which array.
    pub what: &'static str,
    /// Its length.
    pub found: u64,
    /// The length it should have.
    pub expected: u64,
}

impl SilhouetteTexture {
    /// Checks the lengths of all arrays against the hull and the size. O(1).
    ///
    /// # Errors
    /// [`PartsError`] names the first array that does not fit.
    pub fn new(parts: Parts) -> Result<Self, PartsError> {
        let (vertices, faces) = (parts.hull.mesh().positions().len() as u64, parts.hull.mesh().face_count() as u64);
        let (texels, samples) = (parts.size.texels(), parts.size.samples());
        let details = texels * u64::from(parts.detail) * u64::from(parts.detail);
        let check = |what, found: usize, expected: u64| {
            let found = found as u64;
            if found == expected { Ok(()) } else { Err(PartsError { what, found, expected }) }
        };
        check("centres", parts.centers.len(), vertices)?;
        check("tangents", parts.tangents.len(), vertices)?;
        check("places of faces", parts.places.len(), faces)?;
        match &parts.angles {
            Angles::Unorm8(values) => check("angles", values.len(), samples)?,
            Angles::Float16(values) => check("angles", values.len(), samples)?,
            Angles::Terms(terms) => {
                let count = terms.functions.len() as u64;
                check("offsets of terms", terms.offsets.len(), count)?;
                check("scales of terms", terms.scales.len(), count)?;
                for function in &terms.functions {
                    check("values of a term's function", function.len(), u64::from(parts.size.azimuths))?;
                }
                check("weights of terms", terms.weights.len(), texels * count)?;
            }
        }
        if let Some(centers) = &parts.texel_centers {
            check("centres of texels", centers.len(), texels)?;
        }
        check("gaps", parts.gaps.len(), texels)?;
        check("colours", parts.colors.len(), details)?;
        check("normals", parts.normals.len(), details)?;
        Ok(Self { parts })
    }

    /// What it consists of.
    pub fn parts(&self) -> &Parts {
        &self.parts
    }

    /// Bytes in memory, the hull's included.
    pub fn bytes(&self) -> usize {
        let Parts { hull, centers, tangents, places, angles, texel_centers, gaps, colors, normals, .. } = &self.parts;
        let angles = match angles {
            Angles::Unorm8(values) => size_of_val(values.as_slice()),
            Angles::Float16(values) => size_of_val(values.as_slice()),
            Angles::Terms(terms) => {
                let azimuths: usize = terms.functions.iter().map(Vec::len).sum();
                size_of::<f32>() * (azimuths + terms.offsets.len() + terms.scales.len()) + terms.weights.len()
            }
        };
        let (positions, triangles) = (hull.mesh().positions(), hull.mesh().triangles());
        let hull = size_of_val(positions) + size_of_val(triangles) + size_of_val(places.as_slice());
        let frames = size_of_val(centers.as_slice()) + size_of_val(tangents.as_slice());
        let of_texels = texel_centers.as_ref().map_or(0, |values| size_of_val(values.as_slice()))
            + size_of_val(gaps.as_slice())
            + size_of_val(colors.as_slice())
            + size_of_val(normals.as_slice());
        hull + frames + angles + of_texels
    }

    /// Takes it apart, to be changed and put together again.
    pub fn into_parts(self) -> Parts {
        self.parts
    }

    /// The unit of [`gaps`](Parts::gaps): the radius of the hull's bounding sphere.
    pub fn unit(&self) -> f64 {
        self.parts.hull.mesh().bounds().map_or(1.0, |bounds| bounds.radius)
    }
}
