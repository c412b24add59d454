# SPDX-License-Identifier: GPL-3.0-or-later
"""A collection of small meshes in a loop, on a LocalCluster, and on one of which a worker is killed every ten seconds.

    python3 cluster.py [MESHES] [WORKERS] [BATCH_SECONDS]

Seconds of processor count on a machine that does other things, too: those of all processes, start of workers included.
"""

import multiprocessing.forkserver
import os
import random
import resource
import signal
import sys
import tempfile
import threading
import time

# Before Dask is imported: workers that are there again at once, and less housekeeping. See doc/python_collections.md.
SETTINGS = {
    "WORKER__MULTIPROCESSING_METHOD": "forkserver",
    "WORKER__PROFILE__ENABLED": "False",
    "ADMIN__TICK__INTERVAL": "1s",
    "WORKER__MEMORY__MONITOR_INTERVAL": "1s",
}
for name, value in SETTINGS.items():
    os.environ.setdefault(f"DASK_DISTRIBUTED__{name}", value)

import numpy as np  # noqa: E402
from distributed import Client, LocalCluster  # noqa: E402

import spherical_parameterization as sp  # noqa: E402


def map_number(number: int) -> dict[str, object]:
    """A body with waves, made from its number, so that no disk is measured."""
    points, triangles = sp.icosphere(3)
    frequencies = np.random.default_rng(number).normal(size=(4, 3)) * 3
    points = points * (1 + 0.1 * np.sin(points @ frequencies.T).sum(axis=1))[:, None]
    result = sp.parameterize(points, triangles, policy="sequential", warn=False)
    return {"verdict": result.error, "residual": result.residual, "sphere": result.sphere.sum()}


busy: list[float] = []  # seconds of the batches that have arrived


class Watched(sp.collection._Cluster):
    """Writes down how long the workers were at work."""

    def next_rows(self) -> tuple[list[sp.collection._Line], float]:
        rows, seconds = super().next_rows()
        busy.append(seconds)
        return rows, seconds


sp.collection._Cluster = Watched  # type: ignore[misc]


def processor() -> float:
    """Seconds of this process and of its children that have ended. Workers are children of the server that forks them."""
    multiprocessing.forkserver._forkserver._stop()  # type: ignore[attr-defined]
    usages = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(usage.ru_utime + usage.ru_stime for usage in usages)


def on_cluster(meshes: int, workers: int, batch_seconds: float, store: str, is_harmed: bool) -> None:
    is_done = threading.Event()
    killed = 0
    with LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster:

        def kill() -> None:
            nonlocal killed
            while not is_done.wait(10):
                pids = [nanny.pid for nanny in cluster.workers.values() if nanny.pid]
                if pids:
                    os.kill(random.choice(pids), signal.SIGKILL)
                    killed += 1

        with Client(cluster) as client:
            if is_harmed:
                threading.Thread(target=kill, daemon=True).start()
            busy.clear()
            start = time.perf_counter()
            counts = sp.collection.map(range(meshes), map_number, client, store, batch_seconds=batch_seconds)
            seconds = time.perf_counter() - start
            is_done.set()
            share = sum(busy) / workers / seconds
            print(f"  map(): {seconds:.1f} s, {share:.1%} of it in batches; rows: {counts}; killed: {killed}", flush=True)


def main() -> None:
    meshes = int(sys.argv[1]) if len(sys.argv) > 1 else 10000
    workers = int(sys.argv[2]) if len(sys.argv) > 2 else os.cpu_count() or 1
    batch_seconds = float(sys.argv[3]) if len(sys.argv) > 3 else 0.5
    scratch = tempfile.TemporaryDirectory()  # is removed at the end
    serial = os.path.join(scratch.name, "serial.sqlite")

    before, start = processor(), time.perf_counter()
    sp.collection.map(range(meshes), map_number, store=serial)
    loop, loop_processor = time.perf_counter() - start, processor() - before
    print(f"one process: {meshes} meshes, {loop:.1f} s, {loop_processor:.1f} s of processor", flush=True)
    expected = list(sp.collection.read(serial))
    for name in ("cluster", "cluster with deaths"):
        store = os.path.join(scratch.name, f"{name}.sqlite")
        before, start = processor(), time.perf_counter()
        on_cluster(meshes, workers, batch_seconds, store, name != "cluster")
        wall, used = time.perf_counter() - start, processor() - before
        print(
            f"{name}: {workers} workers, {wall:.1f} s, {used:.1f} s of processor; the loop's {loop_processor / used:.1%} of "
            f"that, {loop / workers / wall:.1%} of the wall clock; the same rows: {list(sp.collection.read(store)) == expected}",
            flush=True,
        )


if __name__ == "__main__":
    main()
