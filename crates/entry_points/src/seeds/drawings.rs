//! Drawings of 64 by 48 pixels, as other programs make them.

use super::{Seed, seed};
use image::{ExtendedColorType, ImageEncoder as _, codecs::png::PngEncoder};

const SVG: &str = r##"s<svg xmlns="http://www.w3.org/2000/svg" width="64" height="48" viewBox="0 0 64 48">
<style>.thin { stroke: #333; stroke-width: 0.5 } g > path { fill: none }</style>
<g transform="translate(2 3) rotate(10) scale(1.5 -1)" stroke="black"><path d="M0 0L10,10h5v-5C1 2 3 4 5 6s7 8 9 1q2 2 4 4t1 1a5 3 10 1 0 8 8z"/>
<line x1="1" y1="2" x2="30" y2="40" class="thin"/><polyline points="1,1 20,5 30,30" fill="none"/></g>
<rect x="3" y="4" width="20" height="10" rx="2" stroke="#000" fill="none"/><circle cx="30" cy="20" r="8" style="stroke:black;fill:none"/>
<ellipse cx="40" cy="30" rx="8" ry="4" stroke="black" stroke-dasharray="2 1"/><polygon points="5 5 9 5 7 9" stroke="white"/></svg>
"##;

pub fn seeds() -> Vec<Seed> {
    vec![
        seed("svg", SVG),
        seed("edges", r#"j{"method":"mine","mesh":{"vertices":4,"triangles":4},"edges":[[0,1],[1,2]]}"#),
        seed("polylines", r#"j{"size":[64,48],"polylines":[[[1,2],[30,40],[5,5]],[[0,0],[9,0],[9,9],[0,0]]]}"#),
        seed(
            "chains",
            r#"j{"chains":[{"kind":"silhouette","closed":true,"visible":true,"pixels":[[1,2],[30,40],[5,5]],
"handles":[[[2,3],[4,5]],[[6,7],[8,9]],[[1,1],[2,2]]]},{"pixels":[[-100,5],[1e6,7]]}]}"#,
        ),
        seed("png", [b"p", &png()[..]].concat()),
    ]
}

/// A slanted line.
fn png() -> Vec<u8> {
    let (width, height) = (64_u32, 48_u32);
    let pixel = |at: u32| if at % width == at / width { 0_u8 } else { 255 };
    let pixels: Vec<u8> = (0..width * height).map(pixel).collect();
    let mut bytes = Vec::new();
    let written = PngEncoder::new(&mut bytes).write_image(&pixels, width, height, ExtendedColorType::L8);
    written.expect("a small picture fits into memory");
    bytes
}
