"""Find, draw and compare the silhouettes of triangle meshes.

    import silhouettes

    mesh = silhouettes.load("builtin:torus")
    edges = silhouettes.edges(mesh, silhouettes.look_at((3, 1, 2)))
    picture = silhouettes.render(mesh, size=(512, 512), lines_only=True)

Meshes and cameras are in the coordinates of the mesh's file, right-handed. Pixels count from the top left of the picture, x to the right
and y down, with centres at .5. Bad input raises ``silhouettes.Error``, a ValueError, with one line that says what is wrong, where,
and what mends it; what fails while it runs raises RuntimeError. Long calls let other threads run, stop at Ctrl-C, and report to
``progress(stage, done, total)``.
"""

from ._silhouettes import (
    Camera,
    Error,
    Extractor,
    LineFinder,
    Mesh,
    Texture,
    Tracker,
    bake,
    compare,
    edges,
    load,
    loops,
    methods,
    outline,
    recommend,
    render,
    reproduce,
    smooth,
    visible_lines,
    write_lines,
)
from .cameras import camera, from_matrices, look_at

__all__ = [
    "Camera",
    "Error",
    "Extractor",
    "LineFinder",
    "Mesh",
    "Texture",
    "Tracker",
    "bake",
    "camera",
    "compare",
    "edges",
    "from_matrices",
    "load",
    "look_at",
    "loops",
    "methods",
    "outline",
    "recommend",
    "render",
    "reproduce",
    "smooth",
    "visible_lines",
    "write_lines",
]
