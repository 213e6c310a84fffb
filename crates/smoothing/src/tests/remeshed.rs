//! What holds of every re-meshed mesh.
