#!/usr/bin/env python3
"""Has `silhouettes recommend` choose for every goal on each mesh, and checks each promise in views that nothing saw before.

    benches/recommend.py MESH... [--views 200] [--max-ms lines=200] [--error fill=xor_share=0.02] [--silhouettes PROGRAM] -o FILE.csv

Each calibration is made anew. One row per mesh and goal: what is recommended, what was measured of it, and the shares of the checked
views within the error, within the time, and within both. Ends with exit code 1 where a promise was broken in more than 5 % of the views.
"""

import argparse
import csv
import json
import os
import subprocess
import sys

GOALS = ["lines", "fill", "loops"]
COLUMNS = [
    "mesh", "goal", "metric", "max_error", "max_ms", "seconds", "candidates", "method", "set", "median_ms", "prepare_ms",
    "bytes", "artefacts", "views", "over", "confidence", "error_bound", "ms_bound", "runner_up", "one_step_better",
    "checked_views", "within_error", "within_ms", "within_both", "worst_error", "worst_ms", "not_measured",
]


def name(finding):
    return "" if finding is None else " ".join(filter(None, [finding["method"], finding["set"]]))


def row(answer):
    request, chosen, check = answer["request"], answer["chosen"], answer["check"]
    better = answer["one_step_better"]
    cells = {
        "mesh": os.path.basename(answer["mesh"]),
        "goal": request["goal"],
        "metric": request["limit"]["metric"],
        "max_error": request["limit"]["max"],
        "max_ms": request["max_ms"],
        "seconds": round(answer["seconds"], 2),
        "candidates": len(answer["measured"]),
        "runner_up": name(answer["runner_up"]),
        "one_step_better": name(better and better["better"]),
        "not_measured": len(answer["not_measured"]),
    }
    if chosen:
        made = chosen["preparation"]
        cells |= {
            "method": chosen["method"],
            "set": chosen["set"],
            "median_ms": chosen["ms"],
            "prepare_ms": made["cost"]["prepare_ms"] + made["cost"]["renderer_ms"],
            "bytes": made["cost"]["bytes"],
            "artefacts": " ".join(artefact["name"] for artefact in made["artefacts"]),
        }
        promise = chosen["promise"]
        if promise:
            cells |= {key: promise[key] for key in ["views", "over", "confidence"]}
            cells |= {"error_bound": promise["measured_error"], "ms_bound": promise["measured_ms"]}
    if check:
        cells |= {"checked_views": check["views"], "worst_error": check["worst_error"], "worst_ms": check["worst_ms"]}
        cells |= {key: check[key] / check["views"] for key in ["within_error", "within_ms", "within_both"]}
    return cells


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("meshes", nargs="+", metavar="MESH")
    parser.add_argument("--views", type=int, default=200)
    parser.add_argument("--max-ms", action="append", default=[], metavar="GOAL=MS")
    parser.add_argument("--error", action="append", default=[], metavar="GOAL=NAME=MAX")
    parser.add_argument("--silhouettes", default="silhouettes")
    parser.add_argument("-o", "--output", required=True)
    arguments = parser.parse_args()
    max_ms = dict(limit.split("=") for limit in arguments.max_ms)
    errors = dict(limit.split("=", 1) for limit in arguments.error)
    broken = 0
    with open(arguments.output, "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        for mesh in arguments.meshes:
            for goal in GOALS:
                command = [arguments.silhouettes, "recommend", mesh, "--goal", goal, "--no-cache", "--json"]
                command += ["--check", str(arguments.views)] + (["--max-ms", max_ms[goal]] if goal in max_ms else [])
                command += ["--error", errors[goal]] if goal in errors else []
                answer = json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout)
                cells = row(answer)
                writer.writerow(cells)
                file.flush()
                broken += cells.get("within_both", 1) < 0.95
                print(cells["mesh"], goal, cells.get("method", "nothing fits"), cells.get("within_both", ""), file=sys.stderr)
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
