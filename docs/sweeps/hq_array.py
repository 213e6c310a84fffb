#!/usr/bin/env python3
"""A comparison in N tasks of HyperQueue.

    docs/sweeps/hq_array.py N REPORT [MESH...] [OPTIONS OF silhouettes compare]

Needs `hyperqueue` from PyPI. HQ_SERVER_DIR names the directory of a server that is running, whose workers then do the work;
without it, server and workers are started on this machine for as long as the comparison takes. Tasks that fail, because somebody
killed them for example, are submitted again: each measures what is missing of its share.
"""

import os
import subprocess
import sys
from pathlib import Path

from hyperqueue import Client, Job, LocalCluster
from hyperqueue.cluster import WorkerConfig

ATTEMPTS = 3


def submit(client, count, cells, arguments, silhouettes):
    """Runs all shards; whether all succeeded."""
    job = Job(max_fails=None)
    for number in range(1, count + 1):
        command = [silhouettes, "compare", *arguments, "--shard", f"{number}/{count}", "-o", str(cells)]
        job.program(command, stdout=None, stderr=None)
    return client.wait_for_jobs([client.submit(job)], raise_on_error=False)


def main(words):
    if len(words) < 2 or not words[0].isdigit():
        sys.exit(__doc__)
    count, report, arguments = int(words[0]), Path(words[1]).resolve(), words[2:]
    cells = report.with_name(report.name + ".cells")
    silhouettes = os.environ.get("SILHOUETTES", "silhouettes")
    server = os.environ.get("HQ_SERVER_DIR")
    cluster = None if server else LocalCluster()
    if cluster:
        cluster.start_worker(WorkerConfig(cores=os.cpu_count()))
    client = Client(server) if server else cluster.client()
    try:
        if not any(submit(client, count, cells, arguments, silhouettes) for _ in range(ATTEMPTS)):
            sys.exit(f"hyperqueue: some shards failed {ATTEMPTS} times; what is finished lies in {cells}")
    finally:
        if cluster:
            cluster.stop()
    subprocess.run([silhouettes, "merge", str(cells), "-o", str(report)], check=True)


if __name__ == "__main__":
    main(sys.argv[1:])
