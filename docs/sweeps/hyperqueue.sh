#!/bin/sh
# A comparison as an array of N tasks for the workers of a HyperQueue server that is running.
#
#   docs/sweeps/hyperqueue.sh N REPORT [MESH...] [OPTIONS OF silhouettes compare]
set -eu
count=$1 report=$2
shift 2
silhouettes=${SILHOUETTES:-silhouettes}
hq=${HQ:-hq}
# Single quotes: the task's own shell knows its number.
# shellcheck disable=SC2016
"$hq" submit --wait --array "1-$count" --crash-limit 10 --stdout none --stderr none -- \
    sh -c 'count=$1 cells=$2; shift 2; exec "$@" --shard "$HQ_TASK_ID/$count" -o "$cells"' task \
    "$count" "$report.cells" "$silhouettes" compare "$@"
"$silhouettes" merge "$report.cells" -o "$report"
rm -r "$report.cells"
