//! Polygons, fans and strips as triangles, and the sides of these.

/// Appends the fan of a polygon about its first corner: `[c0, c1, c2], [c0, c2, c3], ...`. O(corners).
///
/// Right for convex polygons; [`super::concave`] replaces the fans of others.
pub(super) fn fan(corners: &[u32], triangles: &mut Vec<[u32; 3]>) {
    let Some((&first, rest)) = corners.split_first() else { return };
    triangles.extend(rest.windows(2).map(|pair| [first, pair[0], pair[1]]));
}

/// Appends the triangles of a strip, with every second one turned round so that all wind alike. O(corners).
///
/// Triangles that name a vertex twice are left out: strips use them as joins, and they cover nothing.
pub(super) fn strip(corners: &[u32], triangles: &mut Vec<[u32; 3]>) {
    let whole = corners.windows(3).enumerate().filter(|(_, c)| c[0] != c[1] && c[1] != c[2] && c[2] != c[0]);
    triangles.extend(whole.map(|(i, c)| if i % 2 == 0 { [c[0], c[1], c[2]] } else { [c[1], c[0], c[2]] }));
}

/// The sides of a triangle as pairs of vertices, lower first.
pub(super) fn sides([a, b, c]: [u32; 3]) -> impl Iterator<Item = [u32; 2]> {
    [[a, b], [b, c], [c, a]].into_iter().map(|[a, b]| [a.min(b), a.max(b)])
}
