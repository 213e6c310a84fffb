#!/bin/sh
# Runs one small comparison in one process, and by each of GNU parallel, HyperQueue (with a task that is killed) and Slurm that is
# installed, and compares what the pictures are worth, byte for byte.
#
#   docs/sweeps/check.sh [parallel|hyperqueue|slurm...]    (SILHOUETTES and PYTHON name the programs)
set -eu
here=$(cd "$(dirname "$0")" && pwd)
SILHOUETTES=$(command -v "${SILHOUETTES:-silhouettes}")
PYTHON=${PYTHON:-python3}
export SILHOUETTES
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
set_of() { echo builtin:cube builtin:gear builtin:torus --methods brute-force,tracking,image-precision,fine-mesh --set tracking.concavity=0,0.5,1; }

# The columns of a table but those of times and bytes.
accuracy() {
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) keep[i] = $i !~ /_ms$|bytes/ }
        { line = ""; for (i = 1; i <= NF; i++) if (keep[i]) line = line "," $i; print line }' "$1/results.csv"
}
check() {
    accuracy "$work/$1" > "$work/$1.csv"
    cmp "$work/whole.csv" "$work/$1.csv"
    echo "$1: $(($(wc -l < "$work/$1.csv") - 1)) rows, the same bytes as of one process"
}
wanted() { [ -z "$names" ] || echo " $names " | grep -q " $1 "; }

names=$*
# shellcheck disable=SC2046
"$SILHOUETTES" compare $(set_of) -o "$work/whole"
accuracy "$work/whole" > "$work/whole.csv"

if wanted parallel && command -v parallel > /dev/null; then
    # shellcheck disable=SC2046
    "$here/parallel.sh" 4 "$work/parallel" $(set_of)
    check parallel
else
    echo "parallel: not tried"
fi
if wanted hyperqueue && "$PYTHON" -c 'import hyperqueue' 2> /dev/null; then
    # One task dies in the middle of its work.
    (until pkill -9 -n -f -- "--shard [0-9]*/20 -o $work/hyperqueue"; do sleep 0.1; done && touch "$work/killed") &
    killer=$!
    # shellcheck disable=SC2046
    "$PYTHON" "$here/hq_array.py" 20 "$work/hyperqueue" $(set_of) > /dev/null 2>&1
    kill "$killer" 2> /dev/null || true
    test -e "$work/killed" || { echo "hyperqueue: no task could be killed" >&2; exit 1; }
    check hyperqueue
else
    echo "hyperqueue: not tried"
fi
if wanted slurm && command -v slurmctld > /dev/null && [ "$(id -u)" = 0 ]; then
    # shellcheck disable=SC2046
    "$here/slurm-here.sh" 4 "$work/cells" $(set_of)
    "$SILHOUETTES" merge "$work/cells" -o "$work/slurm"
    check slurm
else
    echo "slurm: not tried"
fi
