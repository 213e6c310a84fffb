"""Find, draw and compare the silhouettes of triangle meshes."""

from ._silhouettes import (
    Camera,
    Error,
    Extractor,
    Mesh,
    edges,
    load,
    loops,
    render,
)
from .cameras import camera, from_matrices, look_at

__all__ = [
    "Camera",
    "Error",
    "Extractor",
    "Mesh",
    "camera",
    "edges",
    "from_matrices",
    "load",
    "look_at",
    "loops",
    "render",
]
