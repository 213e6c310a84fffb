//! [`BakeUniform`]: what all invocations of a bake know. Twin: `shaders/texture/bake.wgsl`.

use crate::gpu::bake::hierarchies::Hierarchies;
use crate::silhouette_texture::VisibilityRule;
use crate::tile::Source;
use bytemuck::{Pod, Zeroable};

/// See the twin for what each member means.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub(super) struct BakeUniform {
    pub hull_root: u32,
    pub first_slot: u32,
    pub level_texels: u32,
    pub first_element: u32,
    pub end_element: u32,
    pub batch_texels: u32,
    pub known_texels: u32,
    pub azimuths: u32,
    pub is_interior: u32,
    pub lobe_rule: u32,
    pub most_steps: u32,
    pub two: u32,
    pub hull_per_object: f32,
    pub beyond: f32,
    pub tolerance: f32,
    pub _pad: f32,
}

impl BakeUniform {
    /// What all dispatches have in common.
    pub fn new(source: &Source<'_>, hierarchies: &Hierarchies, most_steps: u32) -> Self {
        let visibility = source.visibility;
        let (object, hull) = (visibility.object().local_scale(), visibility.hull().local_scale());
        Self {
            hull_root: hierarchies.hull_root,
            azimuths: source.atlas.size().azimuths,
            is_interior: u32::from(visibility.rule() == VisibilityRule::Interior),
            lobe_rule: source.lobe as u32,
            most_steps,
            two: 2,
            hull_per_object: (hull / object) as f32,
            beyond: (visibility.beyond() * hull) as f32,
            tolerance: source.tolerance,
            ..Self::zeroed()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::LobeRule;
    use silhouette_shaders::{layout, texture::BORDER_SEARCH};
    use std::mem::offset_of;

    #[test]
    fn the_uniform_is_laid_out_as_its_wgsl_twin() {
        macro_rules! members {
            ($($name:ident),+) => { [$((stringify!($name), offset_of!(BakeUniform, $name))),+] };
        }
        let members = members![
            hull_root,
            first_slot,
            level_texels,
            first_element,
            end_element,
            batch_texels,
            known_texels,
            azimuths,
            is_interior,
            lobe_rule,
            most_steps,
            two,
            hull_per_object,
            beyond,
            tolerance,
            _pad
        ];
        assert!(layout::matches(BORDER_SEARCH, "BakeUniform", size_of::<BakeUniform>(), &members));
    }

    #[test]
    fn lobe_rules_have_the_numbers_of_the_wgsl_twin() {
        for (rule, name) in [(LobeRule::EqualArea, "EQUAL_AREA"), (LobeRule::LastExit, "LAST_EXIT")] {
            assert!(BORDER_SEARCH.contains(&format!("const {name}: u32 = {}u;", rule as u32)));
        }
    }
}
