//! Silhouettes that appear in the image: nothing is searched, the depth buffer finds them.
//!
//! Ramesh Raskar and Michael Cohen, "Image precision silhouette edges", Symposium on Interactive 3D Graphics 1999,
//! section 3.2, first way of the z-scaled translation: back faces scaled about the eye.
//!
//! 1. The background is cleared to white, depth to the farthest value: the application's render pass.
//! 2. `front_faces.rs`: front faces, white, depth test "nearer".
//! 3. [`back_faces`]: back faces, black, scaled about the eye by k, depth test "nearer or equal".
//!
//! A back face is hidden by the front faces before it, except along a silhouette edge, where the two meet and k puts a
//! strip of it in front.
//!
//! # When to choose it
//! For a triangle soup: no adjacency, no preparation, positions and triangles are enough. Two passes over the mesh, O(F) a
//! view on the GPU; on the CPU nothing, unless the eye is within the mesh's bounding box, where telling inside from outside
//! is O(F). (The renderer uploads positions once; a mesh that moves needs a renderer anew.) The price is a width that follows the shape
//! ([`back_faces::rim_width`]): thin on smooth rims, thick on sharp edges. Where thickness has to be even, use a method
//! that knows edges.
//!
//! # Departures from the paper
//! 1. Scaling about the eye moves no point in the image, so only clip-space z changes, by a constant
//!    ([`back_faces::clip_z_offset`]); x, y and w stay the same bits and the same pixels are covered. The paper scales
//!    the model-view matrix.
//! 2. An orthographic camera has no eye to scale about. There, back faces are pulled along the axis by 1 - k of the
//!    distance between the camera's eye and its target; the paper does not say.
//! 3. The near plane is brought in by k, so that what is pulled across it is not clipped. The paper does not mention it.
//! 4. With the eye inside a closed mesh only back faces are in sight, and the paper's method turns the view black.
//!    [`eye_inside`] recognises that without adjacency and leaves step 3 out; `eye-inside=draw` brings it back.
//!
//! # Input and output
//! Triangles counter-clockwise from outside; facing is decided by the rasteriser from the winding of the projected
//! triangle. Objects that touch or intersect get lines along their contact as well. Ink lies inside the outline, on the
//! front face. k = 1 draws (almost) nothing: a back face at a pixel's centre is behind the front face there, and only
//! rounding makes them equal.
//!
//! # Failures
//! Open meshes: a back face seen through a hole is black all over, and boundary edges get no ink, so a single sheet draws
//! nothing from the front and is black from behind. An eye on the surface may count as outside or inside.
//!
//! Small k bleeds: a back face behind a front face shows through it where the two are closer along the line of sight than
//! 1 - k of their distance from the eye. A plate of thickness 0.02 seen from 4 is black all over below k = 0.995.

pub mod back_faces;
pub mod eye_inside;
#[cfg(feature = "gpu")]
mod front_faces;
mod method;
#[cfg(feature = "gpu")]
mod renderer;

pub use method::ImagePrecision;
#[cfg(feature = "gpu")]
pub use renderer::Renderer;
