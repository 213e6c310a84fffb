//! Meshes over a lattice, as [`triangles`](crate::triangles) and [`drawing`](crate::drawing) take them byte by byte.

use super::{Seed, seed};

/// Behind the mesh of a drawing: one section plane, a camera that frames the mesh, all kinds of lines, dashed pens.
pub const VIEW_AND_PENS: [u8; 64] = {
    let mut bytes = [1; 64];
    // Coordinates of the plane's point on the lattice, then its normal.
    bytes[1] = 0;
    bytes[5] = 8;
    bytes[6] = 15;
    bytes
};

const CUBE: ([[i8; 3]; 8], [[u8; 3]; 12]) = (
    [[-2, -2, -2], [2, -2, -2], [2, 2, -2], [-2, 2, -2], [-2, -2, 2], [2, -2, 2], [2, 2, 2], [-2, 2, 2]],
    [
        [0, 2, 1],
        [0, 3, 2],
        [4, 5, 6],
        [4, 6, 7],
        [0, 1, 5],
        [0, 5, 4],
        [1, 2, 6],
        [1, 6, 5],
        [2, 3, 7],
        [2, 7, 6],
        [3, 0, 4],
        [3, 4, 7],
    ],
);

/// Meshes with `rest` behind them; without one, viewpoints around and inside of them.
pub fn seeds(rest: &[u8]) -> Vec<Seed> {
    let (corners, faces) = CUBE;
    let open: Vec<[u8; 3]> = faces[2..].to_vec();
    let mut twice = faces.to_vec();
    twice.extend(faces);
    twice.extend([[0, 0, 1], [3, 3, 3]]);
    // Three pages around one edge, wound alike.
    let book = ([[0, -3, 0], [0, 3, 0], [4, 0, 0], [-2, 0, 3], [-2, 0, -3]], [[0, 1, 2], [0, 1, 3], [0, 1, 4]]);
    let crossing = ([[-4, -1, 0], [4, -1, 0], [0, 4, 1], [0, -4, 2], [1, 4, -3], [-1, 3, 4]], [[0, 1, 2], [3, 4, 5]]);
    let none = [[0, 1, 200]];
    [
        ("cube", bytes(&corners, &faces, rest)),
        ("open-cube", bytes(&corners, &open, rest)),
        ("cube-twice", bytes(&corners, &twice, rest)),
        ("book", bytes(&book.0, &book.1, rest)),
        ("crossing", bytes(&crossing.0, &crossing.1, rest)),
        ("no-such-vertex", bytes(&book.0, &none, rest)),
        ("nothing", bytes(&[], &[], rest)),
    ]
    .into_iter()
    .map(|(name, bytes)| seed(name, bytes))
    .collect()
}

fn bytes(corners: &[[i8; 3]], faces: &[[u8; 3]], rest: &[u8]) -> Vec<u8> {
    let lattice = |corner: &[i8; 3]| corner.map(|x| (x + 8) as u8);
    let mut bytes = vec![corners.len() as u8, faces.len() as u8, 0];
    bytes.extend(corners.iter().flat_map(lattice));
    bytes.extend(faces.iter().flatten());
    if rest.is_empty() {
        // Five viewpoints on the lattice: an eye far off, one in a plane of faces, one inside, and two directions.
        bytes.extend([4, 0]);
        let views = [(1, [7, 5, 3]), (1, [6, 2, 2]), (1, [1, 0, 0]), (0, [1, 2, 3]), (0, [0, 0, 7])];
        bytes.extend(views.iter().flat_map(|(is_eye, at)| [*is_eye].into_iter().chain(lattice(at))));
        // The same vertices, the first of them elsewhere.
        bytes.push(0);
        bytes.extend([1, 2, 3]);
        bytes.extend(corners.iter().skip(1).flat_map(lattice));
    }
    bytes.extend(rest);
    bytes
}
