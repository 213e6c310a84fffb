// In lists of faces, and of edges as the corners where they begin: the face is in front. No mesh has so many corners.
const FRONT: u32 = 0x40000000u;
