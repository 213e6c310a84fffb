//! [`DeviceTexel`]: a texel as a device reads it. Twin: `shaders/texture/bake.wgsl`.

use crate::tile::Texel;
use crate::visibility_function::VisibilityFunction;
use bytemuck::{Pod, Zeroable};

/// In place of a slot, where there is none.
pub(super) const NO_SLOT: u32 = u32::MAX;

/// See the twin for what each member means.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub(super) struct DeviceTexel {
    pub in_object: [f32; 3],
    pub seed_before: u32,
    pub in_hull: [f32; 3],
    pub seed_after: u32,
    pub normal: [f32; 3],
    pub _pad_0: f32,
    pub center: [f32; 3],
    pub _pad_1: f32,
    pub tangent: [f32; 3],
    pub _pad_2: f32,
}

impl DeviceTexel {
    /// Moved to local coordinates in `f64`.
    pub fn new(texel: &Texel, [seed_before, seed_after]: [u32; 2], visibility: &VisibilityFunction) -> Self {
        let position = texel.point.position;
        Self {
            in_object: visibility.object().to_local(position).as_vec3().to_array(),
            seed_before,
            in_hull: visibility.hull().to_local(position).as_vec3().to_array(),
            seed_after,
            normal: texel.point.normal.to_array(),
            center: texel.frame.center.to_array(),
            tangent: texel.frame.tangent.to_array(),
            ..Self::zeroed()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use silhouette_rays::ray::FlatNode;
    use silhouette_shaders::{layout, texture::BORDER_SEARCH};
    use std::mem::offset_of;

    #[test]
    fn elements_of_buffers_are_laid_out_as_their_wgsl_twins() {
        macro_rules! members {
            ($ty:ty: $($name:ident),+) => { [$((stringify!($name), offset_of!($ty, $name))),+] };
        }
        let texel = members![DeviceTexel: in_object, seed_before, in_hull, seed_after, normal, center, tangent];
        assert!(layout::matches(BORDER_SEARCH, "DeviceTexel", size_of::<DeviceTexel>(), &texel));
        let node = members![FlatNode: low, faces, high, first];
        assert!(layout::matches(BORDER_SEARCH, "Node", size_of::<FlatNode>(), &node));
    }
}
