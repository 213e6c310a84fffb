#!/bin/sh
# A comparison in N processes on this machine, by GNU parallel.
#
#   docs/sweeps/parallel.sh N REPORT [MESH...] [OPTIONS OF silhouettes compare]
set -eu
count=$1 report=${2%/}
shift 2
silhouettes=${SILHOUETTES:-silhouettes}
seq "$count" | parallel --halt soon,fail=1 --jobs "$count" "$silhouettes" compare "$@" --shard "{}/$count" -o "$report.cells"
"$silhouettes" merge "$report.cells" -o "$report"
rm -r "$report.cells"
