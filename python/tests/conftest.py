"""What tests of several files ask for."""

import os

import pytest
import silhouettes


@pytest.fixture(scope="session")
def device() -> None:
    """Skips where nothing can be drawn, unless SILHOUETTES_GPU=require."""
    mesh = silhouettes.load("builtin:cube")
    try:
        silhouettes.render(mesh, size=(8, 8))
    except RuntimeError as error:
        if os.environ.get("SILHOUETTES_GPU") == "require":
            raise
        pytest.skip(f"no device: {error}")
