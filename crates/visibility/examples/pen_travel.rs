//! What ordering saves, and what it costs: strokes as a drawing has them, in an order as bad as can be.
//!
//!     cargo run --release -p silhouette-visibility --example pen_travel [STROKES...]

use silhouette_core::glam::{DVec2, DVec3, Vec3};
use silhouette_core::view::{Camera, Projection};
use silhouette_core::{EdgeId, NoProgress};
use silhouette_visibility::plot::{Length, PlotOptions, plot};
use silhouette_visibility::{Chain, ChainStyle, Chains, LineKind, LineStats, Lines, Outline, SegmentSource};
use std::error::Error;
use std::io::Write;

/// Sides of the viewport in pixels; a page has as many tenths of a millimetre.
const SIDES: [u32; 2] = [2100, 2970];

fn main() -> Result<(), Box<dyn Error>> {
    let counts: Vec<usize> = std::env::args().skip(1).map(|count| count.parse()).collect::<Result<_, _>>()?;
    let mut out = std::io::stdout();
    writeln!(out, "strokes     placed to dashed   ordered   pen-up travel before and after")?;
    for count in if counts.is_empty() { vec![1_000, 10_000, 100_000] } else { counts } {
        for (name, reach) in [("scattered", 1.0), ("in clusters", 0.05)] {
            let drawing = plot(&strokes(count, reach)?, &options(), &NoProgress)?;
            let stats = drawing.stats;
            let [prepare, order] = [stats.prepare, stats.order].map(|time| time.as_secs_f64() * 1e3);
            let (before, after) = (stats.travel.before / 1e3, stats.travel.after / 1e3);
            writeln!(out, "{count:>7} {name:<11} {prepare:>8.1} ms {order:>8.1} ms {before:>10.2} m {after:>8.2} m")?;
        }
    }
    Ok(())
}

fn options() -> PlotOptions {
    PlotOptions { min_length: Length::mm(0.0), ..PlotOptions::default() }
}

/// Strokes of up to two hundredths of the page, about centres that lie everywhere or, at a small reach, close together.
fn strokes(count: usize, reach: f64) -> Result<Lines, Box<dyn Error>> {
    let camera = Camera::new(Vec3::Z, Vec3::ZERO, Vec3::Y, Projection::Orthographic { height: 1.0 }, SIDES)?;
    let sides = DVec2::from_array(SIDES.map(f64::from));
    let mut random = Random(1);
    let centres: Vec<DVec2> = (0..20).map(|_| random.point()).collect();
    let mut chains = Chains::default();
    for stroke in 0..count {
        let around = if reach < 1.0 { centres[stroke % centres.len()] } else { DVec2::ZERO };
        let from = around * (1.0 - reach) + random.point() * reach;
        let to = (from + (random.point() - 0.5) * 0.02).clamp(DVec2::ZERO, DVec2::ONE);
        chains.push(Chain {
            style: ChainStyle { kind: LineKind::Mesh, invisibility: 0, object: 0 },
            closed: false,
            points: &[from.extend(0.0), to.extend(0.0)],
            pixels: &[from * sides, to * sides],
            sources: &[SegmentSource::Edge(EdgeId::new(0))],
            handles: &[],
        });
    }
    Ok(Lines { camera, chains, outline: Outline::default(), origin: DVec3::ZERO, stats: LineStats::default() })
}

/// The same numbers in every run: a linear congruential generator, of which the upper bits are taken.
struct Random(u64);

impl Random {
    fn point(&mut self) -> DVec2 {
        DVec2::new(self.share(), self.share())
    }

    fn share(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / (1_u64 << 31) as f64
    }
}
