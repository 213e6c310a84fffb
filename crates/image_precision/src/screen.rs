//! Ours: edges of back faces expanded in the image plane, as wide as asked for everywhere.
//!
//! 1. `face_list.wgsl` classifies every face once and lists back faces.
//! 2. `back_edges.wgsl` counts, for each edge of a listed face, the listed faces that have it. Edges are known by the positions
//!    of their ends, so that a soup without shared vertices is served as well. An edge counted twice lies between back faces
//!    and cannot be a silhouette edge; the others are listed.
//! 3. `screen.wgsl` draws each listed edge as a convex polygon beside the projected edge, outwards of its face and around either
//!    end, which rounds corners: two triangles for lines of 2 px. The edge is clipped at the near plane first. Depth is that of
//!    the edge, so that front faces before it hide it and it covers what lies behind.
//!
//! Fattening in the polygon's plane, as the paper does, slides along the edge and makes spikes
//! ([`fatten`](crate::fatten)); moving the edge in the image does not.
//!
//! Counting needs no preparation and no adjacency: it is O(F) on the adapter in every frame. An edge that finds no place in
//! the table within the longest probe is drawn, hidden or not. Of an edge between four faces both back
//! ones cancel, so that objects that share an edge may lack it.

/// Draws listed lines by the vertex stage `vertex` of `shaders/image_precision/screen.wgsl`, which decides what the entries of the list
/// are.
#[cfg(feature = "gpu")]
pub(crate) fn pipeline(
    device: &wgpu::Device,
    formats: silhouette_gpu::TargetFormats,
    settings: &crate::settings::Settings,
    vertex: &str,
) -> wgpu::RenderPipeline {
    let is_solid = settings.texture == crate::options::Texture::Solid;
    let camera = silhouette_gpu::CameraBinding::layout(device);
    let mesh = silhouette_gpu::MeshBinding::layout(device);
    silhouette_gpu::kit::RenderStage {
        label: "image precision: lines",
        wgsl: silhouette_shaders::image_precision::SCREEN,
        vertex,
        fragment: if is_solid { crate::ink::solid_fragment(settings) } else { "textured_fragment" },
        bindings: &[Some(&camera), Some(&mesh), Some(&crate::back_edges::drawing_layout(device))],
        depth: Some(formats.depth_state(formats.nearer_or_equal())),
        color: formats.color,
        blend: crate::ink::blend(settings),
        samples: formats.samples,
        ..silhouette_gpu::kit::RenderStage::default()
    }
    .build(device)
}
