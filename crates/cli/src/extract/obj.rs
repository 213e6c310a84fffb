//! An extraction as Wavefront OBJ: the vertices of the silhouette and one closed `l` element a loop.

use super::Extraction;
use std::collections::BTreeMap;
use std::fmt::Write;

/// The file. Vertices keep the mesh's order but not its numbers; coordinates are the mesh's own, to the last bit.
pub fn write(found: &Extraction) -> Vec<u8> {
    let mut numbers: BTreeMap<_, usize> = found.loops.iter().flatten().map(|&vertex| (vertex, 0)).collect();
    numbers.values_mut().zip(1..).for_each(|(number, next)| *number = next);
    let mut text = format!("# {} silhouette loops by {}\n", found.loops.len(), found.method);
    for vertex in numbers.keys() {
        let p = found.mesh.positions()[vertex.index()];
        let _ = writeln!(text, "v {} {} {}", p.x, p.y, p.z);
    }
    for vertices in &found.loops {
        text.push('l');
        for vertex in vertices.iter().chain(vertices.first()) {
            let _ = write!(text, " {}", numbers[vertex]);
        }
        text.push('\n');
    }
    text.into_bytes()
}
