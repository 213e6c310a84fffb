// Entries of lists of edges, and chunks of lines. Twin: crates/edge_mesh/src/chunks.rs

// Lines that an instance draws.
const CHUNK: u32 = 1024u;

// In an entry of the list of features: a valley. The other bits are the number of the record.
const LISTED_VALLEY: u32 = 0x80000000u;
