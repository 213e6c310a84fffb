"""What silhouettes re-exports, with its types."""

import os
from collections.abc import Callable, Iterable, Sequence
from typing import Any, Literal, TypeAlias, final

import numpy as np
import numpy.typing as npt

__all__ = [
    "Camera",
    "Error",
    "Extractor",
    "LineFinder",
    "Mesh",
    "Texture",
    "Tracker",
    "bake",
    "compare",
    "edges",
    "load",
    "loops",
    "methods",
    "outline",
    "recommend",
    "render",
    "reproduce",
    "run_program",
    "smooth",
    "visible_lines",
    "write_lines",
]

_Progress: TypeAlias = Callable[[str, int, int], object]
# A Camera, None, or an object that silhouettes.camera reads.
_Camera: TypeAlias = Any
# Three numbers, or a camera.
_Eye: TypeAlias = Any
_Record: TypeAlias = dict[str, Any]
_Point: TypeAlias = Sequence[float] | npt.NDArray[Any]

class Error(ValueError): ...

@final
class Camera:
    def __new__(
        cls,
        *,
        view: str | None = None,
        eye: _Point | None = None,
        target: _Point | None = None,
        up: _Point | None = None,
        fov: float | None = None,
        ortho: float | str | None = None,
        up_axis: str = "y",
        size: tuple[int, int] | None = None,
    ) -> Camera: ...
    @property
    def size(self) -> list[int]: ...

@final
class Mesh:
    def __new__(cls, vertices: npt.ArrayLike, faces: npt.ArrayLike, name: str = ...) -> Mesh: ...
    @property
    def name(self) -> str: ...
    @property
    def vertices(self) -> npt.NDArray[np.float32]: ...
    @property
    def faces(self) -> npt.NDArray[np.uint32]: ...
    @property
    def origin(self) -> npt.NDArray[np.float64]: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def parts(self) -> list[str]: ...
    def select(self, *, only: Sequence[str] = ..., without: Sequence[str] = ...) -> Mesh: ...
    def weld(self, distance: float = 0.0, *, progress: _Progress | None = None) -> Mesh: ...
    def heal(self, distance: float | None = None, *, progress: _Progress | None = None) -> Mesh: ...
    def orient(self, *, progress: _Progress | None = None) -> Mesh: ...
    def cut(self, point: _Point, normal: _Point, *, progress: _Progress | None = None) -> Mesh: ...
    def inspect(self, *, progress: _Progress | None = None) -> _Record: ...

@final
class Extractor:
    def __new__(
        cls, mesh: Mesh, method: str = "brute-force", *, progress: _Progress | None = None, **options: object
    ) -> Extractor: ...
    def update(self, eye: _Eye) -> npt.NDArray[np.uint32]: ...
    @property
    def stats(self) -> dict[str, int]: ...
    @property
    def last_ms(self) -> float: ...

@final
class Tracker:
    def __new__(
        cls, mesh: Mesh, method: str = "tracking", *, progress: _Progress | None = None, **options: object
    ) -> Tracker: ...
    def update(self, eye: _Eye) -> list[npt.NDArray[np.uint32]]: ...
    @property
    def ids(self) -> npt.NDArray[np.uint64]: ...
    @property
    def events(self) -> list[_Record]: ...
    @property
    def stats(self) -> dict[str, int]: ...

@final
class LineFinder:
    def __new__(cls, mesh: Mesh, *, progress: _Progress | None = None, **options: object) -> LineFinder: ...
    def find(self, camera: _Camera = ..., *, progress: _Progress | None = None) -> list[_Record]: ...
    @property
    def last_ms(self) -> float: ...

@final
class Texture:
    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Texture: ...
    def save(self, path: str | os.PathLike[str], *, progress: _Progress | None = None) -> None: ...
    @property
    def hull(self) -> Mesh: ...
    @property
    def metadata(self) -> dict[str, str]: ...

def load(path: str | os.PathLike[str], *, progress: _Progress | None = None) -> Mesh: ...
def methods() -> list[_Record]: ...
def edges(
    mesh: Mesh, camera: _Camera = ..., method: str = "brute-force", **options: object
) -> npt.NDArray[np.uint32]: ...
def loops(
    mesh: Mesh, camera: _Camera = ..., method: str = "brute-force", **options: object
) -> list[npt.NDArray[np.uint32]]: ...
def visible_lines(
    mesh: Mesh, camera: _Camera = ..., *, progress: _Progress | None = None, **options: object
) -> list[_Record]: ...
def outline(
    mesh: Mesh, camera: _Camera = ..., *, progress: _Progress | None = None, **options: object
) -> list[list[npt.NDArray[np.float64]]]: ...
def write_lines(
    mesh: Mesh | Sequence[Mesh],
    path: str | os.PathLike[str],
    camera: _Camera = ...,
    *,
    progress: _Progress | None = None,
    **options: object,
) -> None: ...
def render(
    mesh: Mesh,
    method: str = "brute-force",
    camera: _Camera = ...,
    size: tuple[int, int] | None = None,
    *,
    lines_only: bool = False,
    width: float = 1.5,
    samples: int = 4,
    progress: _Progress | None = None,
    **options: object,
) -> npt.NDArray[np.uint8]: ...
def smooth(
    mesh: Mesh,
    camera: _Camera = ...,
    method: str = "smoothing",
    *,
    progress: _Progress | None = None,
    **options: object,
) -> _Record: ...
def bake(
    mesh: Mesh, hull: Mesh | None = None, *, progress: _Progress | None = None, **options: object
) -> Texture: ...
def compare(
    meshes: list[Mesh], *, views: bool = False, progress: _Progress | None = None, **options: object
) -> list[_Record]: ...
def recommend(mesh: Mesh, *, progress: _Progress | None = None, **options: object) -> list[_Record]: ...
def reproduce(
    paper: str,
    meshes: list[Mesh] = ...,
    *,
    profile: Literal["quick", "full"] = "quick",
    progress: _Progress | None = None,
) -> list[_Record]: ...
def run_program(words: Iterable[str]) -> int: ...
