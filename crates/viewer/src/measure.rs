//! [`Measurement`]: how fast the window is, while a mesh is opened and while the eye goes round it; `--measure`.
//!
//! The window draws frames without a pause meanwhile, as it does under a pointer that moves. A frame of the window lasts from the moment at
//! which its contents are asked for to the same moment of the next.

use crate::clock::{ThreadTime, process_time};
use std::fmt;
use std::time::{Duration, Instant};

/// So many frames of a window are its own start: fonts are set, and the window's shaders compiled.
const FIRST_FRAMES: usize = 2;

/// How long the eye takes once round.
const TURN: Duration = Duration::from_secs(6);

/// A frame of the window.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Frame {
    lasted: Duration,
    /// What the window's thread did meanwhile, where that is known.
    thread: Option<ThreadTime>,
}

/// Frames one after another.
#[derive(Debug, Clone)]
pub struct Stretch {
    begun: Instant,
    process_at_begin: Option<Duration>,
    process: Option<Duration>,
    frames: Vec<Frame>,
    last: (Instant, Option<ThreadTime>),
}

impl Stretch {
    /// A stretch that begins now.
    fn new(now: Instant) -> Self {
        let process_at_begin = process_time();
        Self { begun: now, process_at_begin, process: None, frames: Vec::new(), last: (now, ThreadTime::now()) }
    }

    /// A stretch that begins with the frame that has not ended yet.
    fn branch(&self) -> Self {
        let process_at_begin = self.process_at_begin.map(|begun| begun + self.process.unwrap_or_default());
        Self { begun: self.last.0, process_at_begin, process: None, frames: Vec::new(), last: self.last }
    }

    /// A frame ends, and the next begins.
    fn frame(&mut self, now: Instant) {
        let thread = ThreadTime::now();
        let (begun, before) = self.last;
        let thread_meanwhile = thread.zip(before).map(|(now, before)| now.since(before));
        self.frames.push(Frame { lasted: now.duration_since(begun), thread: thread_meanwhile });
        self.last = (now, thread);
        self.process = process_time().zip(self.process_at_begin).map(|(now, begun)| now.saturating_sub(begun));
    }

    /// How long it lasts so far.
    pub fn lasted(&self) -> Duration {
        self.last.0.duration_since(self.begun)
    }

    /// Frames per second; 0 of a stretch without a frame, as what is prepared within one frame leaves.
    pub fn rate(&self) -> f64 {
        if self.frames.is_empty() { 0.0 } else { self.frames.len() as f64 / self.lasted().as_secs_f64() }
    }

    /// The longest frame.
    pub fn longest(&self) -> Duration {
        self.frames.iter().map(|frame| frame.lasted).max().unwrap_or_default()
    }

    /// How many frames were longer than a time.
    pub fn above(&self, time: Duration) -> usize {
        self.frames.iter().filter(|frame| frame.lasted > time).count()
    }
}

/// Frames longer than this are counted: what is drawn seems to stand still.
const LONG: Duration = Duration::from_millis(100);

impl fmt::Display for Stretch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = self.frames.len();
        write!(f, "{:.2} s, {count} frames of the window, {:.1} per second", self.lasted().as_secs_f64(), self.rate())?;
        if let Some(longest) = self.frames.iter().max_by_key(|frame| frame.lasted) {
            let above = self.above(LONG);
            write!(f, "; {above} above {} ms; the longest {:.1} ms", LONG.as_millis(), in_ms(longest.lasted))?;
            if let Some(ThreadTime { ran, waited }) = longest.thread {
                write!(
                    f,
                    ", of which its thread ran {:.1} ms and waited for a core {:.1} ms",
                    in_ms(ran),
                    in_ms(waited)
                )?;
            }
        }
        if let Some(process) = self.process {
            write!(f, "; all threads ran {:.1} ms per frame", in_ms(process) / count.max(1) as f64)?;
        }
        Ok(())
    }
}

/// What a window is asked to do next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Step {
    /// Wait for the first picture.
    Wait,
    /// Turn the eye by this angle.
    Turn {
        /// About the up axis.
        angle_rad: f64,
    },
    /// Show what was measured.
    End,
}

/// A measurement that is running.
#[derive(Debug, Clone)]
pub struct Measurement {
    orbit: Duration,
    start: Option<Stretch>,
    preparing: Option<Stretch>,
    first_picture: Option<Stretch>,
    orbiting: Option<Stretch>,
    /// Pictures of each method when the eye began to move.
    pictures_at_begin: Vec<u64>,
    pictures: Vec<u64>,
}

impl Measurement {
    /// One that moves the eye for a time.
    pub fn new(orbit: Duration) -> Self {
        Self {
            orbit,
            start: None,
            preparing: None,
            first_picture: None,
            orbiting: None,
            pictures_at_begin: Vec::new(),
            pictures: Vec::new(),
        }
    }

    /// A frame of the window begins: how many pictures each method has drawn, and whether all are prepared.
    pub fn frame(&mut self, now: Instant, pictures: &[u64], are_prepared: bool) -> Step {
        let Some(orbiting) = &mut self.orbiting else {
            let is_drawn = pictures.iter().all(|&pictures| pictures > 0);
            if let Some(first_picture) = &mut self.first_picture {
                first_picture.frame(now);
            } else if let Some(preparing) = &mut self.preparing {
                if are_prepared {
                    // The drawing may have begun at once, within this frame.
                    let mut first_picture = preparing.branch();
                    first_picture.frame(now);
                    self.first_picture = Some(first_picture);
                } else {
                    preparing.frame(now);
                }
            } else if let Some(start) = &mut self.start {
                start.frame(now);
                if start.frames.len() >= FIRST_FRAMES {
                    self.preparing = Some(Stretch::new(now));
                }
            } else {
                self.start = Some(Stretch::new(now));
            }
            if is_drawn && self.first_picture.is_some() {
                self.pictures_at_begin = pictures.to_vec();
                self.orbiting = Some(Stretch::new(now));
            }
            return Step::Wait;
        };
        let last = orbiting.last.0;
        orbiting.frame(now);
        self.pictures = pictures.to_vec();
        if orbiting.lasted() >= self.orbit {
            return Step::End;
        }
        let angle_rad = std::f64::consts::TAU * now.duration_since(last).as_secs_f64() / TURN.as_secs_f64();
        Step::Turn { angle_rad }
    }

    /// While the mesh was opened and its methods were prepared, after the first frames of the window.
    pub fn preparing(&self) -> Option<&Stretch> {
        self.preparing.as_ref()
    }

    /// While the eye moved.
    pub fn orbiting(&self) -> Option<&Stretch> {
        self.orbiting.as_ref()
    }

    /// Pictures per second of each method, while the eye moved.
    pub fn picture_rates(&self) -> Vec<f64> {
        let seconds = self.orbiting.as_ref().map_or(0.0, |orbiting| orbiting.lasted().as_secs_f64());
        let drawn = self.pictures.iter().zip(&self.pictures_at_begin).map(|(now, begun)| now - begun);
        drawn.map(|pictures| pictures as f64 / seconds).collect()
    }

    /// All of it, one row per stretch and per method: its name, and the middle of its frame times in milliseconds.
    pub fn report(&self, methods: &[(&str, Option<f64>)]) -> String {
        let stretches = [
            ("start", &self.start),
            ("preparing", &self.preparing),
            ("first picture", &self.first_picture),
            ("orbit", &self.orbiting),
        ];
        let rows = stretches.iter().filter_map(|(name, stretch)| Some(format!("{name}: {}\n", stretch.as_ref()?)));
        let of_method = |(&(name, median_ms), rate): (&(&str, Option<f64>), f64)| {
            let median = median_ms.map(|ms| format!(", median frame of the method {ms:.1} ms")).unwrap_or_default();
            format!("{name}: {rate:.1} pictures per second{median}\n")
        };
        rows.chain(methods.iter().zip(self.picture_rates()).map(of_method)).collect()
    }
}

fn in_ms(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_and_pictures_are_counted_over_the_time_that_they_took() {
        let begin = Instant::now();
        let at = |ms: i32| begin + Duration::from_millis((1000 + ms) as u64);
        let mut measurement = Measurement::new(Duration::from_millis(400));
        for ms in [-900, -400, 0, 150] {
            assert_eq!(measurement.frame(at(ms), &[0], false), Step::Wait);
        }
        assert_eq!(measurement.frame(at(160), &[0], true), Step::Wait);
        assert_eq!(measurement.frame(at(170), &[5], true), Step::Wait);
        let Step::Turn { angle_rad } = measurement.frame(at(270), &[6], true) else { panic!("it goes round") };
        assert!((angle_rad - std::f64::consts::TAU / 60.0).abs() < 1e-9, "{angle_rad}");
        for ms in [370, 470] {
            assert!(matches!(measurement.frame(at(ms), &[9], true), Step::Turn { .. }));
        }
        assert_eq!(measurement.frame(at(570), &[15], true), Step::End);
        let (preparing, orbiting) = (measurement.preparing().unwrap(), measurement.orbiting().unwrap());
        assert_eq!((preparing.longest(), preparing.above(LONG)), (Duration::from_millis(150), 1));
        assert!((orbiting.rate() - 10.0).abs() < 1e-9 && orbiting.above(LONG) == 0);
        assert!((measurement.picture_rates()[0] - 25.0).abs() < 1e-9, "{:?}", measurement.picture_rates());
        let report = measurement.report(&[("brute-force", Some(12.34))]);
        assert!(Stretch::new(begin).rate().abs() < 1e-9);
        assert!(report.contains("first picture: 0.02 s, 2 frames of the window"), "{report}");
        assert!(report.contains("1 above 100 ms; the longest 150.0 ms"), "{report}");
        assert!(
            report.contains("brute-force: 25.0 pictures per second, median frame of the method 12.3 ms"),
            "{report}"
        );
    }
}
