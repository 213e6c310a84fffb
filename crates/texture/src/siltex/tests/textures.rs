//! Random small textures, and their parts as bits.

use crate::siltex::{Metadata, write_to};
use crate::{Angles, FacePlace, Hull, Parts, SilhouetteTexture, Terms, VisibilityRule, VolumeSize};
use glam::{Vec2, Vec3};
use half::f16;
use proptest::prelude::*;
use silhouette_core::{NoProgress, TriangleMesh, glam};
use silhouette_testing::Random;

/// How a texture's angles are stored.
#[derive(Debug, Clone, Copy)]
pub enum Form {
    Unorm8,
    Float16,
    Terms(u32),
}

/// What a texture is made by.
#[derive(Debug, Clone, Copy)]
pub struct Recipe {
    pub vertices: usize,
    pub faces: usize,
    pub size: VolumeSize,
    pub form: Form,
    pub rule: VisibilityRule,
    pub has_texel_centers: bool,
    pub detail: u32,
    pub seed: u64,
}

/// The smallest texture that has every section.
pub const SMALL: Recipe = Recipe {
    vertices: 3,
    faces: 1,
    size: VolumeSize { width: 2, height: 1, azimuths: 3, pages: 1 },
    form: Form::Terms(2),
    rule: VisibilityRule::Exterior,
    has_texel_centers: true,
    detail: 1,
    seed: 1,
};

pub fn recipes() -> impl Strategy<Value = Recipe> {
    let size = (1_u32..6, 1_u32..6, 3_u32..9, 1_u32..3).prop_map(|(width, height, azimuths, pages)| VolumeSize {
        width,
        height,
        azimuths,
        pages,
    });
    let form = prop_oneof![Just(Form::Unorm8), Just(Form::Float16), (1_u32..4).prop_map(Form::Terms)];
    let rule = prop_oneof![Just(VisibilityRule::Interior), Just(VisibilityRule::Exterior)];
    (1_usize..9, 0_usize..9, size, form, rule, any::<bool>(), 0_u32..4, any::<u64>()).prop_map(
        |(vertices, faces, size, form, rule, has_texel_centers, detail, seed)| Recipe {
            vertices,
            faces,
            size,
            form,
            rule,
            has_texel_centers,
            detail,
            seed,
        },
    )
}

impl Recipe {
    pub fn texture(&self) -> SilhouetteTexture {
        let random = &mut Random::new(self.seed);
        let (texels, samples) = (self.size.texels() as usize, self.size.samples() as usize);
        let details = texels * (self.detail * self.detail) as usize;
        let positions = many(self.vertices, || random.vector().as_vec3());
        let triangles = many(self.faces, || std::array::from_fn(|_| random.below(self.vertices) as u32));
        let halves = |random: &mut Random| std::array::from_fn(|_| f16::from_f64(random.signed()));
        SilhouetteTexture::new(Parts {
            hull: Hull::trusted(TriangleMesh::new(positions, triangles).unwrap()),
            centers: many(self.vertices, || unit(random)),
            tangents: many(self.vertices, || unit(random)),
            places: many(self.faces, || FacePlace {
                page: random.below(self.size.pages as usize) as u32,
                corners: std::array::from_fn(|_| Vec2::new(random.unit() as f32, random.unit() as f32)),
            }),
            size: self.size,
            rule: self.rule,
            angles: match self.form {
                Form::Unorm8 => Angles::Unorm8(many(samples, || random.bits() as u8)),
                Form::Float16 => Angles::Float16(many(samples, || f16::from_f64(random.unit()))),
                Form::Terms(terms) => Angles::Terms(Terms {
                    functions: many(terms as usize, || many(self.size.azimuths as usize, || random.signed() as f32)),
                    offsets: many(terms as usize, || random.signed() as f32),
                    scales: many(terms as usize, || random.signed() as f32),
                    weights: many(texels * terms as usize, || random.bits() as u8),
                }),
            },
            texel_centers: self.has_texel_centers.then(|| many(texels, || halves(random))),
            gaps: many(texels, || f16::from_f64(random.unit())),
            detail: self.detail,
            colors: many(details, || std::array::from_fn(|_| random.bits() as u8)),
            normals: many(details, || halves(random)),
        })
        .unwrap()
    }

    pub fn file(&self) -> Vec<u8> {
        let metadata = Metadata::from([("mesh".into(), "a.obj".into()), ("note".into(), "\u{e9}\n".into())]);
        file_of(&self.texture(), &metadata)
    }
}

pub fn file_of(texture: &SilhouetteTexture, metadata: &Metadata) -> Vec<u8> {
    let mut bytes = Vec::new();
    write_to(&mut bytes, texture, metadata, &NoProgress).unwrap();
    bytes
}

fn many<T>(count: usize, mut one: impl FnMut() -> T) -> Vec<T> {
    (0..count).map(|_| one()).collect()
}

fn unit(random: &mut Random) -> Vec3 {
    random.vector().as_vec3().try_normalize().unwrap_or(Vec3::X)
}

/// Whether all parts are the same, bit for bit (NaN and the sign of zero included).
pub fn same_bits(a: &SilhouetteTexture, b: &SilhouetteTexture) -> bool {
    let floats = |parts: &Parts| {
        let mut floats = Vec::new();
        for vector in parts.hull.mesh().positions().iter().chain(&parts.centers).chain(&parts.tangents) {
            floats.extend(vector.to_array());
        }
        floats.extend(parts.places.iter().flat_map(|place| place.corners).flat_map(|corner| corner.to_array()));
        if let Angles::Terms(terms) = &parts.angles {
            floats.extend(terms.functions.iter().flatten().chain(&terms.offsets).chain(&terms.scales));
        }
        floats.into_iter().map(f32::to_bits).collect::<Vec<_>>()
    };
    let halves = |parts: &Parts| {
        let mut halves: Vec<f16> =
            parts.normals.iter().chain(parts.texel_centers.iter().flatten()).flatten().copied().collect();
        halves.extend(&parts.gaps);
        if let Angles::Float16(angles) = &parts.angles {
            halves.extend(angles);
        }
        halves.into_iter().map(f16::to_bits).collect::<Vec<_>>()
    };
    let bytes = |parts: &Parts| match &parts.angles {
        Angles::Unorm8(angles) => (0, angles.clone()),
        Angles::Float16(_) => (1, Vec::new()),
        Angles::Terms(terms) => (2, terms.weights.clone()),
    };
    let pages = |parts: &Parts| parts.places.iter().map(|place| place.page).collect::<Vec<_>>();
    let (a, b) = (a.parts(), b.parts());
    let counts = |parts: &Parts| (parts.size, parts.rule, parts.detail, parts.texel_centers.as_ref().map(Vec::len));
    counts(a) == counts(b)
        && a.hull.mesh().triangles() == b.hull.mesh().triangles()
        && floats(a) == floats(b)
        && halves(a) == halves(b)
        && bytes(a) == bytes(b)
        && pages(a) == pages(b)
        && a.colors == b.colors
}
