//! H. Wu, L.-Y. Wei, X. Wang and B. Guo, "Silhouette Texture", Eurographics Symposium on Rendering 2006.

mod printed;
mod subjects;
