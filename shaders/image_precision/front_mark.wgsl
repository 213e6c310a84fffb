// Bit of an entry in a list of faces, or of edges given by the corner where they begin: the face is front. No mesh has so many
// corners.
const FRONT: u32 = 0x40000000u;
