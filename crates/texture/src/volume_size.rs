//! [`VolumeSize`]: how many texels a silhouette texture has, and in which order they are stored.

/// Most texels along a side of a page, and most pages: what the file format and all loops over texels are bounded by.
pub const MAX_SIDE: u32 = 16_384;
/// Most azimuths per texel.
pub const MAX_AZIMUTHS: u32 = 1024;
/// Most samples of a whole texture.
pub const MAX_SAMPLES: u64 = 1 << 33;

/// The texels of a silhouette texture: one or more pages, each a 3-D texture of `width` x `height` x `azimuths` samples.
///
/// Samples are stored page by page, then azimuth by azimuth, then row by row: x runs fastest. Values per texel (centres, gaps)
/// leave the azimuths out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct VolumeSize {
    /// Texels along x, at least 1.
    pub width: u32,
    /// Texels along y, at least 1.
    pub height: u32,
    /// Azimuths per texel, at least 3.
    pub azimuths: u32,
    /// 3-D textures, at least 1.
    pub pages: u32,
}

/// A size beyond what is supported.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error(
    "a silhouette texture of {} pages of {} x {} x {} samples is not supported: sides are 1 to {MAX_SIDE}, azimuths 3 to \
     {MAX_AZIMUTHS}, samples in all at most {MAX_SAMPLES}", .0.pages, .0.width, .0.height, .0.azimuths
)]
pub struct VolumeSizeError(pub VolumeSize);

impl VolumeSize {
    /// The same size, checked against the limits of this module.
    ///
    /// # Errors
    /// [`VolumeSizeError`].
    pub fn checked(self) -> Result<Self, VolumeSizeError> {
        let sides = [self.width, self.height, self.pages].iter().all(|side| (1..=MAX_SIDE).contains(side));
        let fits = sides && (3..=MAX_AZIMUTHS).contains(&self.azimuths);
        // Below 2^52 with the limits above.
        if fits && self.texels() * u64::from(self.azimuths) <= MAX_SAMPLES {
            Ok(self)
        } else {
            Err(VolumeSizeError(self))
        }
    }

    /// Texels of all pages.
    pub fn texels(&self) -> u64 {
        u64::from(self.width) * u64::from(self.height) * u64::from(self.pages)
    }

    /// Samples of all pages: texels times azimuths.
    pub fn samples(&self) -> u64 {
        self.texels() * u64::from(self.azimuths)
    }

    /// The index of a texel among all texels.
    pub fn texel(&self, page: u32, x: u32, y: u32) -> usize {
        ((page as usize * self.height as usize) + y as usize) * self.width as usize + x as usize
    }

    /// The index of a sample among all samples.
    pub fn sample(&self, page: u32, azimuth: u32, x: u32, y: u32) -> usize {
        let slice = page as usize * self.azimuths as usize + azimuth as usize;
        (slice * self.height as usize + y as usize) * self.width as usize + x as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_are_counted_and_ordered_as_described() {
        let size = VolumeSize { width: 5, height: 4, azimuths: 3, pages: 2 };
        assert_eq!((size.texels(), size.samples()), (40, 120));
        assert_eq!(size.sample(0, 0, 1, 0), 1);
        assert_eq!(size.sample(0, 0, 0, 1), 5);
        assert_eq!(size.sample(0, 1, 0, 0), 20);
        assert_eq!(size.sample(1, 2, 4, 3) as u64 + 1, size.samples());
        assert_eq!(size.texel(1, 4, 3) as u64 + 1, size.texels());
    }

    #[test]
    fn sizes_beyond_the_limits_are_refused() {
        let size = VolumeSize { width: 512, height: 512, azimuths: 64, pages: 1 };
        assert!(size.checked().is_ok());
        for refused in [
            VolumeSize { width: 0, ..size },
            VolumeSize { azimuths: 2, ..size },
            VolumeSize { pages: 20_000, ..size },
            VolumeSize { width: 16_384, height: 16_384, azimuths: 1024, pages: 16_384 },
        ] {
            assert_eq!(refused.checked(), Err(VolumeSizeError(refused)));
        }
    }
}
