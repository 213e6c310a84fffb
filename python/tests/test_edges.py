"""Silhouette edges against a few lines of numpy, which know nothing of the package."""

from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
import silhouettes

Eye = tuple[float, float, float]


def silhouette_of(mesh: silhouettes.Mesh, eye: Any) -> npt.NDArray[np.uint32]:
    """The edges between a face that the eye is in front of and one that it is not, as sorted pairs."""
    corners = mesh.vertices.astype(np.float64)[mesh.faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    is_front = np.einsum("ij,ij->i", normals, np.asarray(eye) - corners[:, 0]) > 0
    sides = np.sort(mesh.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    edges, of_side = np.unique(sides, axis=0, return_inverse=True)
    fronts = np.bincount(of_side.ravel(), weights=np.repeat(is_front, 3))
    found: npt.NDArray[np.uint32] = edges[fronts == 1]
    return found


EYES: list[Eye] = [(3.1, 0.7, 1.3), (-2.0, 5.0, 0.5), (0.3, -4.0, 6.0)]


@pytest.mark.parametrize("eye", EYES)
@pytest.mark.parametrize("shape", ["knot", "gear", "icosphere:3"])
def test_edges_are_those_between_front_and_back(shape: str, eye: Eye) -> None:
    mesh = silhouettes.load(f"builtin:{shape}")
    found = silhouettes.edges(mesh, silhouettes.look_at(eye))
    assert found.dtype == np.uint32
    expected = silhouette_of(mesh, eye)
    np.testing.assert_array_equal(found, expected)
    assert len(expected) > 10
    # Another eye sees others: the comparison can fail.
    assert not np.array_equal(found, silhouette_of(mesh, np.roll(eye, 1)))


def extractors() -> list[str]:
    return [method["name"] for method in silhouettes.methods() if method["capabilities"]["edges"] and method["exact"]]


@pytest.mark.parametrize("method", extractors())
def test_every_exact_extractor_follows_a_path(method: str) -> None:
    mesh = silhouettes.load("builtin:knot")
    extractor = silhouettes.Extractor(mesh, method)
    for angle in np.linspace(0.0, 1.0, 12):
        eye = (6 * np.cos(angle), 1.1, 6 * np.sin(angle))
        np.testing.assert_array_equal(extractor.update(eye), silhouette_of(mesh, eye))
    assert extractor.stats["faces_tested"] + extractor.stats["nodes_visited"] > 0


def test_loops_are_the_edges_in_order() -> None:
    mesh = silhouettes.load("builtin:knot")
    camera = silhouettes.look_at((3.1, 0.7, 1.3))
    loops = silhouettes.loops(mesh, camera)
    steps = np.concatenate([np.stack([loop, np.roll(loop, -1)], axis=1) for loop in loops])
    np.testing.assert_array_equal(np.unique(np.sort(steps, axis=1), axis=0), silhouettes.edges(mesh, camera))


def test_a_tracker_keeps_ids_and_tells_what_happens() -> None:
    mesh = silhouettes.load("builtin:knot")
    tracker = silhouettes.Tracker(mesh, "tracking-exact")
    alive: set[int] = set()
    kinds: set[str] = set()
    for angle in np.linspace(0.0, 3.0, 60):
        eye = (6 * np.cos(angle), 1.1, 6 * np.sin(angle))
        loops = tracker.update(eye)
        events = tracker.events
        kinds |= {event["kind"] for event in events}
        ended = {loop for event in events for loop in event["from"]}
        alive = alive - ended | {loop for event in events for loop in event["into"]}
        assert set(tracker.ids.tolist()) == alive and len(tracker.ids) == len(loops)
        assert sum(map(len, loops)) == len(silhouette_of(mesh, eye))
    assert {"birth"} < kinds, "more than the first frame's births"
    with pytest.raises(silhouettes.Error, match="names no loops; choose tracking or tracking-exact"):
        silhouettes.Tracker(mesh, "brute-force")


def test_tracking_finds_what_is_there() -> None:
    mesh = silhouettes.load("builtin:icosphere:4")
    tracker = silhouettes.Tracker(mesh, concavity=0, tested_edges="all")
    assert tracker.update((6, 1.1, 0)) and tracker.stats["faces_tested"] == len(mesh.faces)
    for angle in (0.01, 0.02):
        eye = (6 * np.cos(angle), 1.1, 6 * np.sin(angle))
        assert sum(map(len, tracker.update(eye))) == len(silhouette_of(mesh, eye))
        assert tracker.stats["faces_tested"] < len(mesh.faces)
