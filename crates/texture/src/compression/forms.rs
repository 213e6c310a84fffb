//! All forms of the same angles, side by side.

use super::{
    CompressionError, blocks, check_used, expand, fewer_azimuths, interpolate_azimuths, psnr_db, shares, terms_of,
};
use crate::silhouette_texture::{Angles, SilhouetteTexture};
use half::f16;
use std::fmt;

/// A way to store angles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// 8 bits per sample; filtered by the hardware.
    Unorm8,
    /// 16-bit floats; filtered by the hardware.
    Float16,
    /// This many terms; filtered by the shader.
    Terms(u32),
    /// This many azimuths in 8 bits; filtered by the hardware.
    Azimuths(u32),
    /// [`blocks`]; filtered by hardware that supports them.
    Blocks,
}

impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unorm8 => f.write_str("8 bits"),
            Self::Float16 => f.write_str("16-bit floats"),
            Self::Terms(terms) => write!(f, "{terms} terms"),
            Self::Azimuths(azimuths) => write!(f, "{azimuths} azimuths"),
            Self::Blocks => f.write_str("BC4 blocks"),
        }
    }
}

/// The size and error of a form.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FormRow {
    /// The form.
    pub form: Form,
    /// Bytes of the angles, as [`stored_bytes`] counts them.
    pub bytes: u64,
    /// [`psnr_db`] against the texture's own angles, at the texture's own samples.
    pub psnr_db: f64,
}

/// Bytes of angles, with all that is needed to read them: 1 or 2 per sample, or 1 per texel and term and 4 per value of a function, per
/// offset and per scale.
pub fn stored_bytes(angles: &Angles) -> u64 {
    let bytes = match angles {
        Angles::Unorm8(values) => values.len(),
        Angles::Float16(values) => 2 * values.len(),
        Angles::Terms(terms) => {
            let numbers =
                terms.functions.iter().map(Vec::len).sum::<usize>() + terms.offsets.len() + terms.scales.len();
            terms.weights.len() + size_of::<f32>() * numbers
        }
    };
    bytes as u64
}

/// One row per form, in their order. `used` is as for [`compress`](super::compress).
///
/// # Errors
/// [`CompressionError`] of the first form that the texture cannot have, or where `used` does not fit the texture.
pub fn compare(
    texture: &SilhouetteTexture,
    forms: &[Form],
    used: Option<&[bool]>,
) -> Result<Vec<FormRow>, CompressionError> {
    let size = texture.parts().size;
    check_used(size, used)?;
    let reference = shares(&texture.parts().angles, size);
    let row = |&form: &Form| {
        let (bytes, angles) = match form {
            Form::Unorm8 => {
                let angles = Angles::Unorm8(reference.iter().map(|share| (share * 255.0).round() as u8).collect());
                (stored_bytes(&angles), shares(&angles, size))
            }
            Form::Float16 => {
                let angles = Angles::Float16(reference.iter().map(|&share| f16::from_f32(share)).collect());
                (stored_bytes(&angles), shares(&angles, size))
            }
            Form::Terms(terms) => {
                let terms = terms_of(&reference, size, terms, used)?;
                let expanded = expand(&terms, size);
                (stored_bytes(&Angles::Terms(terms)), expanded)
            }
            Form::Azimuths(azimuths) => {
                let fewer = fewer_azimuths(texture, azimuths)?.into_parts();
                let shares = shares(&fewer.angles, fewer.size);
                (stored_bytes(&fewer.angles), interpolate_azimuths(&shares, fewer.size, size.azimuths))
            }
            Form::Blocks => {
                let bytes = blocks::encode(texture, used)?;
                (bytes.len() as u64, blocks::decode(&bytes, size))
            }
        };
        Ok(FormRow { form, bytes, psnr_db: psnr_db(&reference, &angles, size, used)? })
    };
    forms.iter().map(row).collect()
}
