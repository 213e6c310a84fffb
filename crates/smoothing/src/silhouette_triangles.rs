//! Section II, step 2: a *silhouette triangle* is a face whose vertices are not all visible or all invisible.

use silhouette_core::FaceId;

/// A face that the silhouette runs through: between one corner and the two others.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SilhouetteTriangle {
    /// The face.
    pub face: FaceId,
    /// The corner whose visibility differs from that of the two others.
    pub lone: u32,
    /// Whether that corner is the visible one.
    pub lone_is_visible: bool,
}

/// The corner of a face that differs from the two others, with its own visibility; `None` if all are alike.
#[inline]
fn lone_corner(is_visible: [bool; 3]) -> Option<(u32, bool)> {
    let [a, b, c] = is_visible;
    match (a == b, b == c) {
        (true, true) => None,
        (false, true) => Some((0, a)),
        (false, false) => Some((1, b)),
        (true, false) => Some((2, c)),
    }
}

/// Replaces `out` by the silhouette triangles, ascending, given the shading vertices of each face and whether each is visible.
/// O(F).
pub fn silhouette_triangles(triangles: &[[u32; 3]], is_visible: &[bool], out: &mut Vec<SilhouetteTriangle>) {
    out.clear();
    for (face, corners) in triangles.iter().enumerate() {
        if let Some((lone, lone_is_visible)) = lone_corner(corners.map(|corner| is_visible[corner as usize])) {
            out.push(SilhouetteTriangle { face: FaceId::from_usize(face), lone, lone_is_visible });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lone_corner_is_the_one_that_differs() {
        for bits in 0..8_u32 {
            let visible = [0, 1, 2].map(|corner| bits >> corner & 1 == 1);
            match lone_corner(visible) {
                None => assert!(visible == [true; 3] || visible == [false; 3]),
                Some((lone, is_visible)) => {
                    let others = visible.iter().enumerate().filter(|(corner, _)| *corner != lone as usize);
                    assert_eq!(visible[lone as usize], is_visible);
                    assert!(others.into_iter().all(|(_, other)| *other != is_visible));
                }
            }
        }
    }
}
