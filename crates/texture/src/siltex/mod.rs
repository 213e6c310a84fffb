//! Files `.siltex`: a silhouette texture with everything that drawing needs.
//!
//! The layout is described byte by byte in `docs/formats/siltex.md`; `format` holds its constants. In short: little-endian, a
//! header of 32 bytes, a table of at most [`MAX_SECTIONS`] entries of 32 bytes, and the sections, each at a multiple of 8 bytes
//! and with a CRC-32 of its own.
//!
//! | section | holds | bytes |
//! |---|---|---|
//! | `SIZE` | counts, the visibility rule, the form of the angles | 40 |
//! | `POSI`, `TRIA` | the hull's positions and triangles | 12 per vertex, 12 per face |
//! | `CENT`, `TANG` | centres and tangents | 12 per vertex each |
//! | `PLAC` | places of faces in the atlas | 28 per face |
//! | `ANGL` | angles, in one of three forms | 1 or 2 per sample; or 1 per texel and term, and the functions |
//! | `TCEN` | centres of texels; left out where centres are interpolated | 8 per texel |
//! | `GAPS` | gaps | 2 per texel |
//! | `COLO`, `NORM` | colours and normals | 4 and 8 per detail texel |
//! | `META` | [`Metadata`] | 8 and the text per entry |
//!
//! [`write()`] replaces a file in one step: a failed or cancelled run leaves the old one unchanged. [`read`] trusts no size: it
//! compares lengths with the file before it allocates, so that memory stays below a small multiple of the file's length, and checks
//! that all values are in range. Whatever is written can be read again and gives the same bits.
//!
//! ```
//! use silhouette_texture::siltex::{self, Metadata, SiltexError};
//! # use silhouette_texture::{Angles, FacePlace, Hull, Parts, SilhouetteTexture, VisibilityRule, VolumeSize};
//! # use silhouette_core::{NoProgress, TriangleMesh};
//! # use silhouette_core::glam::{Vec2, Vec3};
//! # let mesh = TriangleMesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![[0, 1, 2]]).unwrap();
//! # let texture = SilhouetteTexture::new(Parts {
//! #     hull: Hull::trusted(mesh),
//! #     centers: vec![Vec3::NEG_Z; 3],
//! #     tangents: vec![Vec3::X; 3],
//! #     places: vec![FacePlace { page: 0, corners: [Vec2::ZERO; 3] }],
//! #     size: VolumeSize { width: 1, height: 1, azimuths: 3, pages: 1 },
//! #     rule: VisibilityRule::Interior,
//! #     angles: Angles::Unorm8(vec![90; 3]),
//! #     texel_centers: None,
//! #     gaps: vec![Default::default()],
//! #     detail: 1,
//! #     colors: vec![[255; 4]],
//! #     normals: vec![Default::default()],
//! # }).unwrap();
//! # let folder = tempfile::tempdir().unwrap();
//! # let path = folder.path().join("bunny.siltex");
//! let metadata = Metadata::from([("mesh".into(), "bunny.obj".into())]);
//! siltex::write(&path, &texture, &metadata, &NoProgress)?;
//! let file = siltex::read(&path)?;
//! assert_eq!(file.metadata, metadata);
//! assert_eq!(file.texture.parts().angles, texture.parts().angles);
//! # Ok::<(), SiltexError>(())
//! ```

mod check;
mod error;
mod format;
pub mod fuzz;
mod metadata;
mod read;
mod section_reader;
mod stored;
#[cfg(test)]
mod tests;
mod write;

pub use error::{Place, Problem, SiltexError};
pub use format::{MAX_DETAIL, MAX_SECTIONS, SectionType, VERSION};
pub use metadata::Metadata;
pub use read::{Siltex, read, read_from};
pub use write::{write, write_to};
