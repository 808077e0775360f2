#!/usr/bin/env python3
"""A plan on a Dask cluster: batch.py PLAN FOLDER [SCHEDULER]

Without a scheduler's address the cluster is this machine, a worker a core. On another one, workers need the package mien and the
command, and plan and folder are on a file system that all of them see. What a worker that was lost had drawn is not drawn again.
"""
import sys

from dask.distributed import Client, LocalCluster, as_completed

import mien.dask


def main(plan, folder, scheduler=None):
    with Client(scheduler or LocalCluster(threads_per_worker=1, host="127.0.0.1", dashboard_address=None)) as client:
        for part in as_completed(mien.dask.submit(plan, client, folder)):
            print(part.result())
    print(mien.dask.join(plan, folder))


if __name__ == "__main__":
    main(*sys.argv[1:])
