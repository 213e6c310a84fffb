//! The wedge on the outer side of a turn. Twin of `shaders/gpu/line_joins.wgsl` as to the instance.

use bytemuck::{Pod, Zeroable};
use glam::DVec3;

/// One turn. Twin of the struct in `shaders/gpu/line_joins.wgsl`.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub(crate) struct JoinInstance {
    pub corner: [f32; 3],
    pub before: [f32; 3],
    pub after: [f32; 3],
}

/// Turns below this angle in radians get no wedge. The gaps along a curve add up with its total turn, however finely it
/// is divided, so this is small: a circle of 60 000 steps would still be joined.
const MIN_TURN_RAD: f64 = 1e-4;

impl JoinInstance {
    pub const LAYOUT: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
        array_stride: size_of::<Self>() as u64,
        step_mode: wgpu::VertexStepMode::Instance,
        attributes: &wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32x3],
    };

    /// The turn at `corner`; `None` where the line goes straight on.
    pub fn new(before: DVec3, corner: DVec3, after: DVec3) -> Option<Self> {
        let incoming = (corner - before).truncate().try_normalize()?;
        let outgoing = (after - corner).truncate().try_normalize()?;
        let turns = incoming.distance(outgoing) > MIN_TURN_RAD;
        let array = |p: DVec3| p.as_vec3().to_array();
        turns.then(|| Self { corner: array(corner), before: array(before), after: array(after) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_turns_are_joined() {
        let at = |x, y| DVec3::new(x, y, 0.5);
        assert!(JoinInstance::new(at(0.0, 0.0), at(1.0, 0.0), at(2.0, 0.0)).is_none());
        assert!(JoinInstance::new(at(0.0, 0.0), at(1.0, 0.0), at(1.0, 0.0)).is_none());
        assert!(JoinInstance::new(at(0.0, 0.0), at(1.0, 0.0), at(2.0, 0.1)).is_some());
        assert!(JoinInstance::new(at(0.0, 0.0), at(1.0, 0.0), at(0.0, 0.0)).is_some(), "a reversal");
    }
}
