//! The methods that compete with silhouette smoothing, compared on shapes whose outlines are known, and on broken ones.

mod filled;
mod outline;
mod surfaces;
mod watertight;
