//! [`SmoothingUniform`]: the view and the options, and where all tables begin. Twin: `shaders/smoothing/frame.wgsl`.

use crate::gpu::prefix_sum::Levels;
use crate::gpu::room::Room;
use crate::gpu::tables::Tables;
use crate::options::SmoothingOptions;
use bytemuck::{Pod, Zeroable};
use silhouette_gpu::{FrameView, LocalFrame};

/// Words that a frame keeps for a face's segment: tangents and the normal of its blocking plane.
const SEGMENT_WORDS: u32 = 9;

/// Words that a frame keeps for a feature edge.
const SAMPLING_WORDS: u32 = 3;

/// What all stages know; see the twin for what each member means.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub(crate) struct SmoothingUniform {
    pub eye: [f32; 4],
    pub viewport_px: [f32; 2],
    pub tolerance_px: f32,
    pub newton_steps: u32,
    pub segment_law: u32,
    pub sampling_law: u32,
    pub perturbation_law: u32,
    pub normal_weights: u32,
    pub tangent_law: u32,
    pub groups: u32,
    pub vertices: u32,
    pub faces: u32,
    pub points: u32,
    pub features: u32,
    pub triangle_room: u32,
    pub vertex_room: u32,
    pub sides_at: u32,
    pub owners_at: u32,
    pub point_features_at: u32,
    pub group_vertices_at: u32,
    pub turned_groups_at: u32,
    pub first_corners_at: u32,
    pub group_corners_at: u32,
    pub first_groups_at: u32,
    pub first_neighbours_at: u32,
    pub neighbours_at: u32,
    pub first_feature_points_at: u32,
    pub feature_points_at: u32,
    pub feature_ends_at: u32,
    pub parameters_at: u32,
    pub sampling_at: u32,
    pub inner_points_at: u32,
    pub segments_at: u32,
    pub segment_data_at: u32,
    pub level_1_at: u32,
    pub level_2_at: u32,
    pub total_at: u32,
    pub levels: u32,
    pub leaves_out: u32,
    pub _pad: u32,
}

impl SmoothingUniform {
    /// What does not depend on the view.
    pub fn new(options: &SmoothingOptions, tables: &Tables, levels: &Levels, room: Room) -> Self {
        let (counts, at) = (&tables.counts, &tables.at);
        let parameters_at = counts.groups;
        let sampling_at = parameters_at + counts.points;
        let inner_points_at = sampling_at + SAMPLING_WORDS * counts.features;
        let segments_at = inner_points_at + counts.feature_points;
        Self {
            tolerance_px: options.tolerance_px as f32,
            newton_steps: options.newton_steps,
            segment_law: options.segments as u32,
            sampling_law: options.sampling as u32,
            perturbation_law: options.perturbation as u32,
            normal_weights: options.normals as u32,
            tangent_law: options.tangents as u32,
            groups: counts.groups,
            vertices: counts.vertices,
            faces: counts.faces,
            points: counts.points,
            features: counts.features,
            triangle_room: room.triangles as u32,
            vertex_room: room.vertices as u32,
            sides_at: at.sides,
            owners_at: at.owners,
            point_features_at: at.point_features,
            group_vertices_at: at.group_vertices,
            turned_groups_at: at.turned_groups,
            first_corners_at: at.first_corners,
            group_corners_at: at.group_corners,
            first_groups_at: at.first_groups,
            first_neighbours_at: at.first_neighbours,
            neighbours_at: at.neighbours,
            first_feature_points_at: at.first_feature_points,
            feature_points_at: at.feature_points,
            feature_ends_at: at.feature_ends,
            parameters_at,
            sampling_at,
            inner_points_at,
            segments_at,
            segment_data_at: segments_at + counts.faces,
            level_1_at: levels.level_1_at,
            level_2_at: levels.level_2_at,
            total_at: levels.total_at,
            levels: levels.count,
            ..Self::zeroed()
        }
    }

    /// Words of the buffer in which a frame keeps what it finds.
    pub fn state_words(&self) -> u64 {
        u64::from(self.segment_data_at) + u64::from(SEGMENT_WORDS) * u64::from(self.faces)
    }

    /// The same for a view of a mesh in `frame`, in which parts seen from behind are left out or not.
    pub fn of_view(&self, frame: &LocalFrame, view: &FrameView, leaves_out: bool) -> Self {
        let eye = view.object_eye();
        let eye = if view.is_perspective() {
            frame.to_local(eye.truncate()).extend(1.0)
        } else {
            eye.truncate().normalize_or_zero().as_vec3().extend(0.0)
        };
        let viewport_px = view.viewport().size_px.map(|side| side as f32);
        Self { eye: eye.to_array(), viewport_px, leaves_out: u32::from(leaves_out), ..*self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_shaders::{ALL, layout};
    use std::mem::offset_of;

    #[test]
    fn the_uniform_is_laid_out_as_its_wgsl_twin() {
        macro_rules! members {
            ($($name:ident),+) => { [$((stringify!($name), offset_of!(SmoothingUniform, $name))),+] };
        }
        let members = members![
            eye,
            viewport_px,
            tolerance_px,
            newton_steps,
            segment_law,
            sampling_law,
            perturbation_law,
            normal_weights,
            tangent_law,
            groups,
            vertices,
            faces,
            points,
            features,
            triangle_room,
            vertex_room,
            sides_at,
            owners_at,
            point_features_at,
            group_vertices_at,
            turned_groups_at,
            first_corners_at,
            group_corners_at,
            first_groups_at,
            first_neighbours_at,
            neighbours_at,
            first_feature_points_at,
            feature_points_at,
            feature_ends_at,
            parameters_at,
            sampling_at,
            inner_points_at,
            segments_at,
            segment_data_at,
            level_1_at,
            level_2_at,
            total_at,
            levels,
            leaves_out
        ];
        let size = size_of::<SmoothingUniform>();
        let mut stages = 0;
        for (path, text) in ALL.iter().filter(|(_, text)| text.contains("var<uniform> settings: SmoothingUniform")) {
            assert!(layout::matches(text, "SmoothingUniform", size, &members), "{path}");
            stages += 1;
        }
        assert_eq!(stages, 9);
    }
}
