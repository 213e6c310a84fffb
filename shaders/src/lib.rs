//! Every WGSL stage of the silhouette crates, as text.
//!
//! A module holds the stages of one crate. What several stages use lies in `shared/` and is joined in front of them by
//! concatenation, so a constant here is a complete module for `wgpu::ShaderSource::Wgsl`. A stage shares its file stem
//! with the Rust file that uploads its structs or does the same on the CPU; the test that compares their layouts lies
//! beside the Rust struct and uses `layout` (feature of the same name).

#[cfg(any(test, feature = "layout"))]
pub mod layout;

/// Stages of `silhouette-render`.
pub mod render {
    /// Filled triangles: flat, lit, or depth alone.
    pub const FILL: &str = concat!(include_str!("../shared/camera.wgsl"), include_str!("../render/fill.wgsl"));
    /// The id of the face that is nearest.
    pub const FACE_IDS: &str = concat!(
        include_str!("../shared/camera.wgsl"),
        include_str!("../shared/mesh.wgsl"),
        include_str!("../render/face_ids.wgsl")
    );
    /// Strokes of single segments.
    pub const LINE_SEGMENTS: &str =
        concat!(include_str!("../shared/line_visibility.wgsl"), include_str!("../render/line_segments.wgsl"));
    /// Wedges between consecutive strokes.
    pub const LINE_JOINS: &str =
        concat!(include_str!("../shared/line_visibility.wgsl"), include_str!("../render/line_joins.wgsl"));
    /// A depth buffer as 32-bit floats.
    pub const DEPTH_READBACK: &str =
        concat!(include_str!("../shared/full_screen.wgsl"), include_str!("../render/depth_readback.wgsl"));
    /// The average of n x n samples.
    pub const BOX_DOWNSAMPLE: &str =
        concat!(include_str!("../shared/full_screen.wgsl"), include_str!("../render/box_downsample.wgsl"));
}

/// Stages of `silhouette-image-precision`.
pub mod image_precision {
    /// A stage of this crate behind the camera and the lines' style, and behind the shared texts named.
    macro_rules! stage {
        ($($text:literal),*) => {
            concat!(
                include_str!("../shared/camera.wgsl"),
                include_str!("../shared/image_precision/style.wgsl"),
                $(include_str!($text)),*
            )
        };
    }

    /// Front faces, as paper or shaded.
    pub const FRONT_FACES: &str = stage!("../image_precision/front_faces.wgsl");
    /// Back faces, black, pulled.
    pub const BACK_FACES: &str = stage!("../shared/image_precision/ink.wgsl", "../image_precision/back_faces.wgsl");
    /// Lists faces whose edges are drawn.
    pub const FACE_LIST: &str = stage!(
        "../shared/mesh.wgsl",
        "../shared/image_precision/facing.wgsl",
        "../shared/image_precision/front_mark.wgsl",
        "../shared/image_precision/invocation.wgsl",
        "../image_precision/face_list.wgsl"
    );
    /// Lists edges of the faces in that list.
    pub const BACK_EDGES: &str = stage!(
        "../shared/mesh.wgsl",
        "../shared/image_precision/front_mark.wgsl",
        "../shared/image_precision/invocation.wgsl",
        "../image_precision/back_edges.wgsl"
    );
    /// Lines expanded in the image plane.
    pub const SCREEN: &str = stage!(
        "../shared/mesh.wgsl",
        "../shared/image_precision/front_mark.wgsl",
        "../shared/image_precision/ink.wgsl",
        "../image_precision/screen.wgsl"
    );
    /// Fattened triangles as triangles whose corners are cut off.
    pub const CUT_TRIANGLES: &str = stage!(
        "../shared/mesh.wgsl",
        "../shared/image_precision/polygon.wgsl",
        "../shared/image_precision/push.wgsl",
        "../shared/image_precision/fattened.wgsl",
        "../shared/image_precision/invocation.wgsl",
        "../shared/image_precision/cut_triangle.wgsl",
        "../image_precision/cut_triangles.wgsl"
    );
    /// Other fattened polygons.
    pub const FANS: &str = stage!(
        "../shared/mesh.wgsl",
        "../shared/image_precision/polygon.wgsl",
        "../shared/image_precision/push.wgsl",
        "../shared/image_precision/fattened.wgsl",
        "../shared/image_precision/invocation.wgsl",
        "../image_precision/fans.wgsl"
    );
    /// Draws fattened polygons.
    pub const FATTEN: &str = stage!("../shared/image_precision/ink.wgsl", "../image_precision/fatten.wgsl");
    /// Every face as its number.
    pub const FIRST_LAYER: &str = stage!("../shared/mesh.wgsl", "../image_precision/first_layer.wgsl");
    /// Marks the faces that are seen and lists the others.
    pub const UNORIENTED: &str = stage!(
        "../shared/image_precision/invocation.wgsl",
        "../shared/image_precision/seen_single.wgsl",
        "../image_precision/unoriented.wgsl"
    );
    /// The same for targets with several samples a pixel.
    pub const UNORIENTED_MULTISAMPLED: &str = stage!(
        "../shared/image_precision/invocation.wgsl",
        "../shared/image_precision/seen_multiple.wgsl",
        "../image_precision/unoriented.wgsl"
    );
    /// Faces behind the first layer.
    pub const LATER_FACES: &str =
        stage!("../shared/mesh.wgsl", "../shared/image_precision/ink.wgsl", "../image_precision/later_faces.wgsl");
}

/// Every stage with its path below the crate's folder.
pub const ALL: [(&str, &str); 18] = [
    ("render/fill.wgsl", render::FILL),
    ("render/face_ids.wgsl", render::FACE_IDS),
    ("render/line_segments.wgsl", render::LINE_SEGMENTS),
    ("render/line_joins.wgsl", render::LINE_JOINS),
    ("render/depth_readback.wgsl", render::DEPTH_READBACK),
    ("render/box_downsample.wgsl", render::BOX_DOWNSAMPLE),
    ("image_precision/front_faces.wgsl", image_precision::FRONT_FACES),
    ("image_precision/back_faces.wgsl", image_precision::BACK_FACES),
    ("image_precision/face_list.wgsl", image_precision::FACE_LIST),
    ("image_precision/back_edges.wgsl", image_precision::BACK_EDGES),
    ("image_precision/screen.wgsl", image_precision::SCREEN),
    ("image_precision/cut_triangles.wgsl", image_precision::CUT_TRIANGLES),
    ("image_precision/fans.wgsl", image_precision::FANS),
    ("image_precision/fatten.wgsl", image_precision::FATTEN),
    ("image_precision/first_layer.wgsl", image_precision::FIRST_LAYER),
    ("image_precision/unoriented.wgsl", image_precision::UNORIENTED),
    ("image_precision/unoriented.wgsl", image_precision::UNORIENTED_MULTISAMPLED),
    ("image_precision/later_faces.wgsl", image_precision::LATER_FACES),
];

#[cfg(test)]
mod tests {
    use super::ALL;
    use std::path::Path;

    #[test]
    fn every_stage_parses_and_validates() {
        for (path, text) in ALL {
            let module =
                naga::front::wgsl::parse_str(text).unwrap_or_else(|e| panic!("{path}: {}", e.emit_to_string(text)));
            assert!(!module.entry_points.is_empty(), "{path} has no entry point");
            naga::valid::Validator::new(naga::valid::ValidationFlags::all(), naga::valid::Capabilities::empty())
                .validate(&module)
                .unwrap_or_else(|e| panic!("{path}: {}", e.emit_to_string(text)));
        }
    }

    #[test]
    fn every_file_is_listed() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let mut on_disk = Vec::new();
        for folder in ["render", "image_precision"] {
            for entry in std::fs::read_dir(root.join(folder)).unwrap() {
                on_disk.push(format!("{folder}/{}", entry.unwrap().file_name().to_str().unwrap()));
            }
        }
        on_disk.sort();
        let mut listed = ALL.map(|(path, _)| path.to_owned()).to_vec();
        listed.sort();
        listed.dedup();
        assert_eq!(on_disk, listed);
    }
}
