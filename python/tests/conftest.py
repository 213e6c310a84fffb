"""What tests of several files ask for."""

import os
import subprocess
import sys
from typing import Any

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


# A process of its own: where VTK finds nothing to draw with, it may end the process.
DRAW = """
import pyvista
plotter = pyvista.Plotter(off_screen=True, window_size=(32, 32))
plotter.add_mesh(pyvista.Sphere(), color="black")
plotter.show(auto_close=False)
assert plotter.screenshot(return_img=True).min() < 100
"""


@pytest.fixture(scope="session")
def pyvista() -> Any:
    """PyVista; skips where it is not installed, or draws nothing."""
    module = pytest.importorskip("pyvista", exc_type=ImportError)
    drawn = subprocess.run([sys.executable, "-c", DRAW], capture_output=True, text=True)
    if drawn.returncode != 0:
        pytest.skip(f"PyVista draws nothing here: {drawn.stderr.strip().splitlines()[-1:]}")
    return module
