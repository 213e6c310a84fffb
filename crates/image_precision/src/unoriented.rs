//! Section 4: polygons whose winding means nothing.
//!
//! 1. `first_layer.wgsl` draws every face as its id into a texture of the renderer; `mark_seen.wgsl` marks the ids that are
//!    seen. The paper reads the ids back; here they stay on the adapter.
//! 2. All faces are drawn white, so that the depth buffer holds the first layer.
//! 3. Every face without a mark is drawn as back faces are (`later_faces.wgsl`): scaled about the eye, or by expanding its edges.
//!
//! Faces too small to cover a pixel's centre get no mark although they are in front: 42 % of the bunny's front faces that a
//! picture 16 times as fine shows at 256 x 256 pixels, 3 % at 1024 x 1024. Scaling about the eye moves no pixel, so that they
//! get no ink; expanding their edges would ink them, which is why `scale` is the default here. Ids have 32 bits, and the
//! texture has as many samples per pixel as the target: otherwise a face that only one of several samples sees would be inked.
