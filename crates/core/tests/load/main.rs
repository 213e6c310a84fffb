//! Loading: what each format yields, down to the bit, and how each bad file is refused.

mod bounds;
mod cancelling;
mod expectations;
mod far;
mod feature_edges;
mod gltf;
mod gltf_edges;
mod gltf_placed;
mod gltf_refused;
mod independent_reader;
mod mutated;
mod obj;
mod off;
mod parts;
mod paths;
mod ply;
mod polygons;
mod real_models;
mod robustness;
mod stl;
mod weld;
