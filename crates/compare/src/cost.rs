//! What a method costs: preparation once per mesh, and frames, never mixed.

use crate::interval;
use serde::{Deserialize, Serialize};

/// Median, 95th percentile and maximum of repeated measurements.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Spread {
    /// Middle value; of an even number of values the mean of the two middle ones.
    pub median: f64,
    /// Ends of the 95 % [interval] of the median.
    pub interval: [f64; 2],
    /// 95th percentile, by nearest rank.
    pub p95: f64,
    /// Largest value.
    pub max: f64,
}

impl Spread {
    /// Spread of some values in the order of their measurement, in their unit; `None` of no value. O(n log n), a thousand times.
    pub fn of(values: &[f64]) -> Option<Self> {
        Self::of_passes(&[values.to_vec()])
    }

    /// The same of all values of several passes over one path.
    pub fn of_passes(passes: &[Vec<f64>]) -> Option<Self> {
        let mut sorted = passes.concat();
        sorted.sort_by(f64::total_cmp);
        let count = sorted.len();
        let rank = (count as f64 * 0.95).ceil() as usize;
        let max = *sorted.last()?;
        let median = (sorted[(count - 1) / 2] + sorted[count / 2]) * 0.5;
        let interval = interval::of_median(passes)?;
        Some(Self { median, interval, p95: sorted[rank.clamp(1, count) - 1], max })
    }
}

/// What preparing a method for a mesh cost.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PrepareCost {
    /// Wall time of the preparation in milliseconds, every artefact it asks for included: nothing was there before.
    pub prepare_ms: f64,
    /// Wall time until the renderer is ready on the device: buffers filled, pipelines built.
    pub renderer_ms: f64,
    /// Bytes of the artefacts and of the prepared method, in main memory.
    pub bytes: u64,
}

/// What frames cost along a camera path, warm-up frames excluded.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct FrameCost {
    /// Number of frames measured, in all passes over the path.
    pub frames: u32,
    /// Number of frames drawn before each pass, not measured.
    pub warm_up: u32,
    /// Wall time of a whole frame in milliseconds: extraction, upload, encoding, submission and waiting for the device.
    /// Nothing is read back inside the clock.
    pub frame_ms: Spread,
    /// Time in render passes by the device's own clock in milliseconds, where it has timestamps.
    pub gpu_ms: Option<Spread>,
    /// Wall time of the extraction alone in milliseconds, for methods that extract edges.
    pub extract_ms: Option<Spread>,
    /// Counters of the extraction, averaged over the frames, for methods that extract edges.
    pub counters: Option<Counters>,
}

/// [`ExtractionStats`](silhouette_core::method::ExtractionStats) averaged over frames.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Counters {
    /// Faces whose facing was evaluated.
    pub faces_tested: f64,
    /// Edge tests.
    pub edges_tested: f64,
    /// Nodes of a hierarchy whose bounds were evaluated.
    pub nodes_visited: f64,
    /// Faces decided by exact arithmetic.
    pub exact_fallbacks: f64,
}

/// What one frame took.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FrameSample {
    /// Wall time of the whole frame.
    pub frame_ms: f64,
    /// Time in render passes, where the device reports it.
    pub gpu_ms: Option<f64>,
    /// The extraction, for methods that extract edges.
    pub extraction: Option<ExtractionSample>,
}

/// What the extraction of one frame took.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ExtractionSample {
    /// Wall time.
    pub extract_ms: f64,
    /// Counters.
    pub stats: silhouette_core::method::ExtractionStats,
}

impl FrameCost {
    /// Summary of all frames of all passes over a path but the first `warm_up` of each; `None` where no frame remains.
    pub fn of(passes: &[Vec<FrameSample>], warm_up: u32) -> Option<Self> {
        let passes: Vec<&[FrameSample]> = passes.iter().filter_map(|frames| frames.get(warm_up as usize..)).collect();
        let measured = passes.concat();
        let spread = |value: fn(&FrameSample) -> Option<f64>| {
            let of_pass = |frames: &&[FrameSample]| frames.iter().filter_map(value).collect();
            Spread::of_passes(&passes.iter().map(of_pass).collect::<Vec<_>>())
        };
        Some(Self {
            frames: u32::try_from(measured.len()).unwrap_or(u32::MAX),
            warm_up,
            frame_ms: spread(|frame| Some(frame.frame_ms))?,
            gpu_ms: spread(|frame| frame.gpu_ms),
            extract_ms: spread(|frame| frame.extraction.map(|extraction| extraction.extract_ms)),
            counters: mean_counters(&measured),
        })
    }
}

fn mean_counters(frames: &[FrameSample]) -> Option<Counters> {
    let stats: Vec<_> = frames.iter().filter_map(|frame| frame.extraction).map(|extraction| extraction.stats).collect();
    let mean = |value: fn(&silhouette_core::method::ExtractionStats) -> u64| {
        stats.iter().map(|stats| value(stats) as f64).sum::<f64>() / stats.len() as f64
    };
    (!stats.is_empty()).then(|| Counters {
        faces_tested: mean(|stats| stats.faces_tested),
        edges_tested: mean(|stats| stats.edges_tested),
        nodes_visited: mean(|stats| stats.nodes_visited),
        exact_fallbacks: mean(|stats| stats.exact_fallbacks),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_core::method::ExtractionStats;

    #[test]
    fn spread_of_a_known_series() {
        let values: Vec<f64> = (1..=100).rev().map(f64::from).collect();
        let spread = Spread::of(&values).unwrap();
        assert_eq!((spread.median, spread.p95, spread.max), (50.5, 95.0, 100.0));
        assert!(spread.interval[0] < 50.5 && 50.5 < spread.interval[1], "{spread:?}");
        assert_eq!(Spread::of(&[7.0]), Some(Spread { median: 7.0, interval: [7.0; 2], p95: 7.0, max: 7.0 }));
        assert_eq!(Spread::of(&[]), None);
    }

    #[test]
    fn warm_up_frames_of_every_pass_are_excluded() {
        let frame = |frame_ms, faces_tested| FrameSample {
            frame_ms,
            gpu_ms: None,
            extraction: Some(ExtractionSample {
                extract_ms: frame_ms * 0.5,
                stats: ExtractionStats { faces_tested, ..ExtractionStats::default() },
            }),
        };
        let passes = [vec![frame(900.0, 9), frame(3.0, 10), frame(1.0, 20)], vec![frame(700.0, 9), frame(2.0, 30)]];
        let cost = FrameCost::of(&passes, 1).unwrap();
        assert_eq!((cost.frames, cost.warm_up, cost.gpu_ms), (3, 1, None));
        assert_eq!((cost.frame_ms.median, cost.frame_ms.max), (2.0, 3.0));
        assert_eq!(cost.extract_ms.unwrap().median.to_bits(), 1.0_f64.to_bits());
        assert_eq!(cost.counters.unwrap().faces_tested.to_bits(), 20.0_f64.to_bits());
        assert_eq!(FrameCost::of(&passes, 3), None);
        assert_eq!(FrameCost::of(&passes, 5), None);
    }
}
