"""The code of docs/notebooks/python.ipynb, run as a notebook would, and what its pictures show."""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

NOTEBOOK = Path(__file__).parents[2] / "docs/notebooks/python.ipynb"

RUN = """
import json, sys
import matplotlib
matplotlib.use("Agg")
cells = json.load(open(sys.argv[1]))["cells"]
names = {}
for number, cell in enumerate((cell for cell in cells if cell["cell_type"] == "code"), 1):
    exec(compile("".join(cell["source"]), f"python.ipynb, code {number}", "exec"), names)
folder = sys.argv[2]
for name in ("overlay", "sweep"):
    names[name].savefig(f"{folder}/{name}.png", dpi=80)
rows = names["tracking"][["tracking.concavity", "missed_1px", "missed_1px_low", "missed_1px_high"]]
rows.to_csv(f"{folder}/tracking.csv", index=False)
kinds = sorted({chain["kind"] for chain in names["chains"]})
print(json.dumps({"kinds": kinds, "svg": names["svg"].read_text()[:100]}))
"""


def run(code: str, *words: str) -> "subprocess.CompletedProcess[str]":
    return subprocess.run([sys.executable, "-c", code, *words], capture_output=True, text=True, env={**os.environ})


@pytest.mark.usefixtures("device", "pyvista")
def test_the_notebook_runs_and_its_pictures_show_something(tmp_path: Path) -> None:
    for package in ("matplotlib", "pandas"):
        pytest.importorskip(package)
    # SILHOUETTES_PICTURES keeps them, to be looked at.
    folder = Path(os.environ.get("SILHOUETTES_PICTURES", tmp_path))
    done = run(RUN, str(NOTEBOOK), str(folder))
    assert done.returncode == 0, done.stderr
    said = json.loads(done.stdout.splitlines()[-1])
    assert "silhouette" in said["kinds"] and ("<svg" in said["svg"] or "<?xml" in said["svg"])
    for name in ("overlay", "sweep"):
        assert (folder / f"{name}.png").stat().st_size > 5000
    rows = np.loadtxt(folder / "tracking.csv", delimiter=",", skiprows=1)
    concavity, missed, low, high = rows.T
    assert len(set(concavity)) >= 4 and np.all((low <= missed) & (missed <= high))
    # What the plot is there to show: with every edge searched, at 0, nothing is missed.
    assert missed[np.argmin(concavity)] == 0 < missed[np.argmax(concavity)]


def test_the_notebook_is_stored_without_outputs() -> None:
    for cell in json.loads(NOTEBOOK.read_text())["cells"]:
        assert cell["cell_type"] == "markdown" or (not cell["outputs"] and cell["execution_count"] is None)
