//! Balls in round hulls, whose lobes have a closed form, and pictures of them.

use crate::silhouette_texture::{Angles, FacePlace, Parts, SilhouetteTexture, Terms, VisibilityRule};
use crate::{Frame, Hull, VolumeSize};
use glam::{DMat4, DVec3, Vec2, Vec3};
use half::f16;
use silhouette_core::view::{Camera, ClipRange, DepthDirection, Projection};
use silhouette_core::{TriangleMesh, glam};
use silhouette_gpu::{FrameRenderer, FrameView, TargetFormats, Viewport};
use silhouette_render::{DEFAULT_FORMATS, Gpu, Image, Load, Target};
use silhouette_testing::builtin;
use std::f32::consts::{PI, TAU};

/// Texels along a side of a face's block in the atlas.
const BLOCK: u32 = 12;

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball {
    pub center: Vec3,
    pub radius: f32,
}

/// A ball of radius 0.8 off the middle of its hull, whose lobes have no symmetry.
pub const ECCENTRIC: Ball = Ball { center: Vec3::new(0.08, -0.05, 0.06), radius: 0.8 };

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stored {
    Unorm8,
    Float16,
    /// The first modes of a Fourier series, in 8 bits each: compression of which the functions are known beforehand.
    Terms(usize),
}

pub struct Scene {
    pub hull: TriangleMesh,
    /// For each vertex and face of the hull, the ball of its component.
    pub balls: Vec<Ball>,
    pub vertices_per_ball: usize,
    pub azimuths: u32,
    pub pages: u32,
    pub stored: Stored,
    pub has_texel_centers: bool,
    /// Azimuths begin here. Frames turn fast from texel to texel where lobes have this direction or its opposite, so that it
    /// should be far from any outline: along the view.
    pub axis: Vec3,
}

impl Scene {
    /// A ball in the unit icosphere of a level.
    pub fn new(ball: Ball, level: u32) -> Self {
        let hull = builtin(&format!("icosphere:{level}"));
        Self {
            vertices_per_ball: hull.positions().len(),
            hull,
            balls: vec![ball],
            azimuths: 32,
            pages: 1,
            stored: Stored::Float16,
            has_texel_centers: false,
            axis: EYE,
        }
    }

    /// The same for another shot.
    pub fn seen_by(self, shot: &Shot) -> Self {
        Self { axis: shot.view().object_eye().truncate().as_vec3(), ..self }
    }

    /// Balls with a hull each, in one texture. Hulls are `scale` times the unit icosphere about each ball's centre.
    pub fn many(balls: &[Ball], scale: f32, reversed: bool) -> Self {
        let one = builtin("icosphere:2");
        let count = one.positions().len();
        let positions =
            balls.iter().flat_map(|ball| one.positions().iter().map(|&p| p * scale + ball.center)).collect();
        let mut triangles: Vec<[u32; 3]> = (0..balls.len())
            .flat_map(|ball| one.triangles().iter().map(move |t| t.map(|v| v + (ball * count) as u32)))
            .collect();
        if reversed {
            triangles.reverse();
        }
        let hull = TriangleMesh::new(positions, triangles).unwrap();
        Self { hull, balls: balls.to_vec(), vertices_per_ball: count, ..Self::new(balls[0], 0) }
    }

    fn ball(&self, vertex: u32) -> Ball {
        self.balls[vertex as usize / self.vertices_per_ball]
    }

    pub fn texture(&self) -> SilhouetteTexture {
        let (positions, triangles) = (self.hull.positions(), self.hull.triangles());
        let faces_per_page = triangles.len().div_ceil(self.pages as usize) as u32;
        let columns = f64::from(faces_per_page).sqrt().ceil() as u32;
        let rows = faces_per_page.div_ceil(columns);
        let (width, height, azimuths, pages) = (columns * BLOCK, rows * BLOCK, self.azimuths, self.pages);
        let size = VolumeSize { width, height, azimuths, pages };
        let centers: Vec<Vec3> =
            (0..).zip(positions).map(|(vertex, &p)| tilted(self.ball(vertex).center - p)).collect();
        let tangents: Vec<Vec3> = centers.iter().map(|&center| Frame::new(center, self.axis).tangent).collect();
        let texels = size.texels() as usize;
        let mut angles = vec![0.0_f32; size.samples() as usize];
        let (mut gaps, mut normals) = (vec![f16::ZERO; texels], vec![[f16::ZERO; 4]; texels]);
        let (mut colors, mut texel_centers) = (vec![[0; 4]; texels], vec![[f16::ZERO; 4]; texels]);
        let unit = self.hull.bounds().unwrap().radius as f32;
        let mut places = Vec::new();
        for (face, corners) in (0..).zip(triangles) {
            let (page, block) = (face % pages, face / pages);
            let low = [block % columns * BLOCK, block / columns * BLOCK];
            let place =
                |x: u32, y: u32| Vec2::new((low[0] + x) as f32 / width as f32, (low[1] + y) as f32 / height as f32);
            places.push(FacePlace { page, corners: [place(1, 1), place(BLOCK - 1, 1), place(1, BLOCK - 1)] });
            let ball = self.ball(corners[0]);
            for (x, y) in (0..BLOCK).flat_map(|y| (0..BLOCK).map(move |x| (x, y))) {
                // Beyond the third side, the plane of the face goes on.
                let [s, t] = [x, y].map(|at| (at as f32 - 0.5) / (BLOCK - 2) as f32);
                let blend = |of: &dyn Fn(usize) -> Vec3| {
                    (1.0 - s - t) * of(corners[0] as usize) + s * of(corners[1] as usize) + t * of(corners[2] as usize)
                };
                let point = blend(&|vertex| positions[vertex]);
                let to_ball = ball.center - point;
                let center = if self.has_texel_centers { tilted(to_ball) } else { blend(&|vertex| centers[vertex]) };
                let frame = Frame::new(center, blend(&|vertex| tangents[vertex]));
                let texel = size.texel(page, low[0] + x, low[1] + y);
                for azimuth in 0..azimuths {
                    let angle = cone_border(&frame, to_ball, ball.radius, azimuth as f32 / azimuths as f32);
                    angles[size.sample(page, azimuth, low[0] + x, low[1] + y)] = angle / PI;
                }
                gaps[texel] = f16::from_f32((to_ball.length_squared() - ball.radius * ball.radius).sqrt() / unit);
                let half_floats = |v: Vec3| v.normalize().extend(0.0).to_array().map(f16::from_f32);
                (normals[texel], texel_centers[texel]) = (half_floats(-to_ball), half_floats(tilted(to_ball)));
                colors[texel] = [220, (40 * (face % 5)) as u8, 120, 255];
            }
        }
        let angles = self.store(size, &angles);
        let texel_centers = self.has_texel_centers.then_some(texel_centers);
        let (hull, rule) = (Hull::trusted(self.hull.clone()), VisibilityRule::Interior);
        let parts = Parts {
            hull,
            centers,
            tangents,
            places,
            size,
            rule,
            angles,
            texel_centers,
            gaps,
            detail: 1,
            colors,
            normals,
        };
        SilhouetteTexture::new(parts).unwrap()
    }

    fn store(&self, size: VolumeSize, shares: &[f32]) -> Angles {
        match self.stored {
            Stored::Unorm8 => Angles::Unorm8(shares.iter().map(|share| (share * 255.0).round() as u8).collect()),
            Stored::Float16 => Angles::Float16(shares.iter().copied().map(f16::from_f32).collect()),
            Stored::Terms(count) => Angles::Terms(self.fourier(size, shares, count)),
        }
    }

    fn fourier(&self, size: VolumeSize, shares: &[f32], count: usize) -> Terms {
        let (azimuths, texels) = (self.azimuths as usize, size.texels() as usize);
        let mut terms = Terms { functions: vec![], offsets: vec![], scales: vec![], weights: vec![] };
        let per_page = (size.width * size.height) as usize;
        for term in 0..count {
            let wave = |azimuth: usize| {
                let turn = TAU * azimuth as f32 / azimuths as f32 * term.div_ceil(2) as f32;
                if term % 2 == 1 { turn.sin() } else { turn.cos() }
            };
            let values: Vec<f32> = (0..azimuths).map(wave).collect();
            let length = values.iter().map(|value| value * value).sum::<f32>().sqrt();
            let function: Vec<f32> = values.iter().map(|value| value / length).collect();
            let weight = |texel: usize| -> f32 {
                let (page, at) = (texel / per_page, texel % per_page);
                let sample = |azimuth| shares[(page * azimuths + azimuth) * per_page + at];
                (0..azimuths).map(|azimuth| sample(azimuth) * function[azimuth]).sum()
            };
            let weights: Vec<f32> = (0..texels).map(weight).collect();
            let [low, high] = [f32::min, f32::max].map(|of| weights.iter().copied().reduce(of).unwrap());
            let scale = (high - low).max(1e-6);
            terms.weights.extend(weights.iter().map(|weight| ((weight - low) / scale * 255.0).round() as u8));
            terms.functions.push(function);
            terms.offsets.push(low);
            terms.scales.push(scale);
        }
        terms
    }
}

/// A lobe's centre off its axis, so that its border is no circle about the centre.
fn tilted(to_ball: Vec3) -> Vec3 {
    (to_ball.normalize() + Vec3::new(0.2, -0.15, 0.1)).normalize()
}

/// The angle from a frame's centre at which directions of an azimuth leave the cone about a ball.
fn cone_border(frame: &Frame, to_ball: Vec3, radius: f32, azimuth: f32) -> f32 {
    let axis = to_ball.normalize();
    let cos_half = (1.0 - (radius / to_ball.length()).powi(2)).max(0.0).sqrt();
    // sin(angle) across + cos(angle) along = cos_half at the border; the second solution lies on the far side.
    let (across, along) = (frame.direction(azimuth, 0.5 * PI).dot(axis), frame.center.dot(axis));
    across.atan2(along) + (cos_half / across.hypot(along)).min(1.0).acos()
}

/// What a test draws with.
#[derive(Debug, Clone, Copy)]
pub struct Shot {
    pub is_perspective: bool,
    pub direction: DepthDirection,
    pub model: DMat4,
    pub viewport: Viewport,
    pub samples: u32,
}

/// Where the plain shot is taken from.
const EYE: Vec3 = Vec3::new(1.0, 1.7, 2.9);

pub const PLAIN: Shot = Shot {
    is_perspective: true,
    direction: DepthDirection::Reversed,
    model: DMat4::IDENTITY,
    viewport: Viewport { origin_px: [0, 0], size_px: [160, 120] },
    samples: 1,
};

impl Shot {
    pub fn view(&self) -> FrameView {
        let projection = if self.is_perspective {
            Projection::Perspective { fov_y_rad: 0.75 }
        } else {
            Projection::Orthographic { height: 2.6 }
        };
        let camera = Camera::new(EYE, Vec3::ZERO, Vec3::Y, projection, self.viewport.size_px).unwrap();
        let range = ClipRange { near: 0.5, far: 20.0 };
        let view = FrameView::from_camera(&camera, range, self.direction).unwrap();
        view.with_model(self.model).unwrap().with_viewport(self.viewport).unwrap()
    }

    pub fn formats(&self) -> TargetFormats {
        TargetFormats { depth_direction: self.direction, samples: self.samples, ..DEFAULT_FORMATS }
    }

    /// The viewport's part of the picture.
    pub fn draw(&self, gpu: &Gpu, renderers: &mut [&mut dyn FrameRenderer]) -> Image {
        let view = self.view();
        let [[x, y], [width, height]] = [self.viewport.origin_px, self.viewport.size_px];
        let target = Target::new(gpu, [x + width + 7, y + height + 5], self.formats()).unwrap();
        for renderer in renderers.iter_mut() {
            renderer.prepare(gpu.device(), gpu.queue(), &view).unwrap();
        }
        gpu.draw(&target, Load::Clear([0.0; 4]), |pass| renderers.iter().for_each(|renderer| renderer.draw(pass)))
            .unwrap();
        let whole = target.read_color(gpu).unwrap();
        let mut rgba = Vec::new();
        for row in 0..whole.height {
            for column in 0..whole.width {
                let is_inside = (x..x + width).contains(&column) && (y..y + height).contains(&row);
                let pixel = whole.pixel(column, row);
                if is_inside {
                    rgba.extend(pixel);
                } else {
                    assert_eq!(pixel, [0; 4], "outside of the viewport");
                }
            }
        }
        Image { width, height, rgba }
    }
}

/// The ray of a pixel, in the object's own space: origin and direction.
pub fn ray(view: &FrameView, x: f64, y: f64) -> (DVec3, DVec3) {
    let [width, height] = view.viewport().size_px.map(f64::from);
    let (x, y) = (2.0 * x / width - 1.0, 1.0 - 2.0 * y / height);
    let range = view.depth_law().range();
    let [near, far] = [range.near, range.far].map(|depth| {
        view.object_to_clip().inverse().project_point3(DVec3::new(x, y, view.depth_law().value_at(depth)))
    });
    (near, (far - near).normalize())
}

/// How far a pixel's middle lies outside the outline of a ball, in pixels; below 0 inside.
pub fn outside_px(view: &FrameView, ball: &Ball, x: u32, y: u32) -> f64 {
    let beyond = |x: f64, y: f64| {
        let (origin, direction) = ray(view, x, y);
        (ball.center.as_dvec3() - origin).cross(direction).length() - f64::from(ball.radius)
    };
    let (x, y) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
    let step = 0.01;
    let slope = [beyond(x + step, y) - beyond(x - step, y), beyond(x, y + step) - beyond(x, y - step)];
    beyond(x, y) * 2.0 * step / slope[0].hypot(slope[1])
}
