//! Extensions that a document requires: which are read, which change nothing here, which are refused.

use crate::edge_visibility;
use crate::load::error::Problem;

/// Extensions that are read.
const READ: [&str; 3] = ["EXT_mesh_gpu_instancing", "KHR_mesh_quantization", edge_visibility::NAME];

/// Beginnings of the names of extensions that change how a surface looks or what is known about it, but not where it is.
const HARMLESS: [&str; 19] = [
    "AGI_articulations",
    "AGI_stk_metadata",
    "CESIUM_primitive_outline",
    "EXT_instance_features",
    "EXT_lights_",
    "EXT_mesh_features",
    "EXT_mesh_manifold",
    "EXT_structural_metadata",
    "EXT_texture_",
    "FB_geometry_metadata",
    "KHR_animation_pointer",
    "KHR_lights_punctual",
    "KHR_materials_",
    "KHR_texture_",
    "KHR_xmp",
    "MSFT_lod",
    "MSFT_packing_",
    "MSFT_texture_",
    "NV_materials_",
];

/// Extensions that store triangles in a way that is not read.
const COMPRESSIONS: [&str; 3] = ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"];

/// Refuses what is required and not known: its author says that without it the document is wrong.
pub(super) fn check(required: &[String]) -> Result<(), Problem> {
    let is_known = |name: &str| READ.contains(&name) || HARMLESS.iter().any(|begin| name.starts_with(begin));
    let Some(name) = required.iter().find(|name| !is_known(name)) else { return Ok(()) };
    let mend = match COMPRESSIONS.contains(&name.as_str()) {
        true => "export without mesh compression",
        false => "export without it, or convert the file",
    };
    let name = crate::load::error::quote(name.as_bytes());
    Err(Problem::Unsupported { what: format!("the required extension {}", name.trim_matches('"')), mend })
}
