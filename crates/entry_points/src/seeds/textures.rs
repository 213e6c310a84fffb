//! Silhouette textures of one face, angles in each of their three forms.

use super::{Seed, seed};
use silhouette_core::glam::{Vec2, Vec3};
use silhouette_core::{NoProgress, TriangleMesh};
use silhouette_texture::siltex::{Metadata, write_to};
use silhouette_texture::{Angles, FacePlace, Hull, Parts, SilhouetteTexture, Terms, VisibilityRule, VolumeSize};

pub fn seeds() -> Vec<Seed> {
    let terms =
        Terms { functions: vec![vec![0.5; 3]; 2], offsets: vec![0.0; 2], scales: vec![0.25; 2], weights: vec![1; 4] };
    [
        ("bytes", Angles::Unorm8(vec![90; 6])),
        ("halves", Angles::Float16(vec![Default::default(); 6])),
        ("terms", Angles::Terms(terms)),
    ]
    .into_iter()
    .flat_map(|(name, angles)| {
        let file = file(angles);
        // As they are, and to be repaired: what a mutation damages is then checked behind the checksums.
        [("", b'a'), ("-repaired", b'r')]
            .map(|(suffix, first)| seed(&format!("{name}{suffix}"), [&[first], &file[..]].concat()))
    })
    .collect()
}

fn file(angles: Angles) -> Vec<u8> {
    let mesh = TriangleMesh::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y], vec![[0, 1, 2]]).expect("a triangle is a mesh");
    let texture = SilhouetteTexture::new(Parts {
        hull: Hull::trusted(mesh),
        centers: vec![Vec3::NEG_Z; 3],
        tangents: vec![Vec3::X; 3],
        places: vec![FacePlace { page: 0, corners: [Vec2::ZERO; 3] }],
        size: VolumeSize { width: 2, height: 1, azimuths: 3, pages: 1 },
        rule: VisibilityRule::Exterior,
        angles,
        texel_centers: None,
        gaps: vec![Default::default(); 2],
        detail: 1,
        colors: vec![[255; 4]; 2],
        normals: vec![Default::default(); 2],
    });
    let metadata = Metadata::from([("mesh".into(), "triangle".into())]);
    let mut bytes = Vec::new();
    write_to(&mut bytes, &texture.expect("sizes fit"), &metadata, &NoProgress)
        .expect("memory takes all that is written");
    bytes
}
