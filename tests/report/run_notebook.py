#!/usr/bin/env python3
"""Runs the code of docs/notebooks/results.ipynb on a report, as a notebook would. Exit code 1 where a cell fails.

    run_notebook.py REPORT-DIR

Needs pandas and Polars; without them it says so and exits with 77.
"""

import json
import os
import sys
from importlib.util import find_spec
from pathlib import Path

NOTEBOOK = Path(__file__).parents[2] / "docs/notebooks/results.ipynb"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    missing = [name for name in ("pandas", "polars") if find_spec(name) is None]
    if missing:
        print(f"skipped: {' and '.join(missing)} not installed (pip install pandas polars)")
        sys.exit(77)
    os.environ["SILHOUETTES_REPORT"] = sys.argv[1]
    cells = json.loads(NOTEBOOK.read_text())["cells"]
    sources = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
    names = {}
    for number, source in enumerate(sources, 1):
        exec(compile(source, f"{NOTEBOOK.name}, code {number}", "exec"), names)
    if names["polars_fronts"].is_empty():
        sys.exit(f"{sys.argv[1]}: the notebook finds no front")
    print(f"{NOTEBOOK.name}: {len(sources)} pieces of code ran")


if __name__ == "__main__":
    main()
