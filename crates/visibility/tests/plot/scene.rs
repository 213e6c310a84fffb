//! Lines made by hand: what a finder yields, without a finder.

use proptest::prelude::*;
use silhouette_core::EdgeId;
use silhouette_core::glam::{DVec2, DVec3, Vec3};
use silhouette_core::view::{Camera, Projection};
use silhouette_visibility::{Chain, ChainStyle, Chains, LineKind, LineStats, Lines, Outline, SegmentSource};

/// Side of the viewport in pixels.
pub const SIDE: f64 = 100.0;

pub fn orthographic() -> Camera {
    camera(Projection::Orthographic { height: 50.0 })
}

pub fn perspective() -> Camera {
    camera(Projection::Perspective { fov_y_rad: 0.7 })
}

fn camera(projection: Projection) -> Camera {
    Camera::new(Vec3::Z * 100.0, Vec3::ZERO, Vec3::Y, projection, [SIDE as u32; 2]).unwrap()
}

pub fn lines(camera: Camera) -> Lines {
    Lines {
        camera,
        chains: Chains::default(),
        outline: Outline::default(),
        origin: DVec3::ZERO,
        stats: LineStats::default(),
    }
}

/// A chain to be drawn, with points in pixels; its points in space lie in the plane z = invisibility.
#[derive(Debug, Clone)]
pub struct Drawn {
    pub kind: LineKind,
    pub invisibility: u32,
    pub closed: bool,
    pub pixels: Vec<DVec2>,
    pub handles: Vec<[DVec2; 2]>,
}

pub fn drawn(kind: LineKind, pixels: &[[f64; 2]]) -> Drawn {
    let pixels = pixels.iter().copied().map(DVec2::from).collect();
    Drawn { kind, invisibility: 0, closed: false, pixels, handles: Vec::new() }
}

impl Drawn {
    pub fn hidden(self, invisibility: u32) -> Self {
        Self { invisibility, ..self }
    }

    pub fn closed(self) -> Self {
        Self { closed: true, ..self }
    }

    /// Gives every segment handles beside its chord.
    pub fn bent(mut self) -> Self {
        let count = self.pixels.len();
        let segments = count - usize::from(!self.closed);
        self.handles = (0..segments)
            .map(|index| {
                let (from, to) = (self.pixels[index], self.pixels[(index + 1) % count]);
                let aside = (to - from).perp() * 0.2;
                [from.lerp(to, 0.3) + aside, from.lerp(to, 0.7) + aside]
            })
            .collect();
        self
    }

    pub fn push_to(&self, lines: &mut Lines) {
        let segments = self.pixels.len() - usize::from(!self.closed);
        let points: Vec<DVec3> = self.pixels.iter().map(|pixel| pixel.extend(f64::from(self.invisibility))).collect();
        let source = |index| match self.kind {
            LineKind::Curve => SegmentSource::Curve(index),
            LineKind::Intersection => SegmentSource::Intersection(index),
            _ => SegmentSource::Edge(EdgeId::new(index)),
        };
        lines.chains.push(Chain {
            style: ChainStyle { kind: self.kind, invisibility: self.invisibility, object: 0 },
            closed: self.closed,
            points: &points,
            pixels: &self.pixels,
            sources: &(0..segments as u32).map(source).collect::<Vec<_>>(),
            handles: &self.handles,
        });
    }
}

pub fn lines_of(camera: Camera, all: &[Drawn]) -> Lines {
    let mut lines = lines(camera);
    all.iter().for_each(|drawn| drawn.push_to(&mut lines));
    lines
}

/// Points on a coarse grid in and around the viewport, so that segments repeat and touch.
fn coarse() -> impl Strategy<Value = DVec2> {
    (-2..13_i32, -2..13_i32).prop_map(|(x, y)| DVec2::new(f64::from(x), f64::from(y)) * 10.0)
}

/// Points anywhere in and around the viewport.
fn fine() -> impl Strategy<Value = DVec2> {
    (-20.0..120.0, -20.0..120.0).prop_map(|(x, y)| DVec2::new(x, y))
}

/// Any chain; of a smooth curve with handles.
pub fn any_chain() -> impl Strategy<Value = Drawn> {
    let points = prop_oneof![prop::collection::vec(coarse(), 2..12), prop::collection::vec(fine(), 2..12)];
    let kind = prop::sample::select(LineKind::ALL.to_vec());
    (kind, 0..3_u32, any::<bool>(), points).prop_map(|(kind, invisibility, closed, pixels)| {
        let closed = closed && pixels.len() > 2;
        let chain = Drawn { kind, invisibility, closed, pixels, handles: Vec::new() };
        if kind == LineKind::Curve { chain.bent() } else { chain }
    })
}

pub fn any_lines() -> impl Strategy<Value = Lines> {
    prop::collection::vec(any_chain(), 0..40).prop_map(|all| lines_of(orthographic(), &all))
}
