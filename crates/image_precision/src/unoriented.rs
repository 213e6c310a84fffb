//! Section 4: polygons whose winding says nothing.
//!
//! 1. `first_layer.wgsl` draws every face as its number into a texture of the renderer's own; `unoriented.wgsl` marks the
//!    numbers that are seen. The paper reads the numbers back; here they stay on the adapter.
//! 2. All faces are drawn white: depth is that of the first layer.
//! 3. Every face that is not marked is drawn as back faces are: scaled about the eye, or by expanding its edges.
//!
//! Faces too small to cover a pixel's centre are not marked although they are in front: of the bunny's front faces that a
//! picture 16 times as fine shows, 42 % lack at 256 x 256 pixels and 3 % at 1024 x 1024. Scaling about the eye moves no
//! pixel, so that they stay without ink; expanding their edges inks them, which is why `scale` is the default here.
//! Numbers have 32 bits, and the texture as many samples a pixel as the target: a face seen by a sample of the target alone
//! would be inked.
