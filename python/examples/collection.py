# SPDX-License-Identifier: GPL-3.0-or-later
"""All meshes of a folder on all cores, or on a cluster: a line per mesh in an SQLite file. Call it again to go on.

    python3 collection.py scans/ results.sqlite                             # this machine
    python3 collection.py scans/ results.sqlite --scheduler tcp://host:8786 # a cluster
"""

import argparse
from pathlib import Path

from distributed import Client, LocalCluster

import spherical_parameterization as sp

parser = argparse.ArgumentParser()
parser.add_argument("folder")
parser.add_argument("store")
parser.add_argument("--scheduler")
arguments = parser.parse_args()

if __name__ == "__main__":  # the workers import this file
    files = sorted(str(path) for path in Path(arguments.folder).iterdir() if path.is_file())
    cluster = arguments.scheduler or LocalCluster(threads_per_worker=1, dashboard_address=None)
    with Client(cluster) as client:
        print(sp.collection.map(files, sp.collection.map_file, client, arguments.store))
    for row in sp.collection.read(arguments.store):
        print(row.key, row.message or f"{row.value['verdict']}, by {row.value['method']}")
