//! [`CurvePart`]: the part of a curve that a stroke stands for.

/// Which part of a curve a stroke stands for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvePart {
    /// The piece of curve, by its index in the scene.
    pub piece: u32,
    /// Its parameters at the stroke's ends.
    pub range: [f64; 2],
}

impl CurvePart {
    /// The curve's parameter where the stroke's is `t`.
    pub fn parameter(&self, t: f64) -> f64 {
        self.range[0] + (self.range[1] - self.range[0]) * t
    }
}
