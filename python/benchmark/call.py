# SPDX-License-Identifier: GPL-3.0-or-later
"""What a call costs beside the C++ call in it, which copies it makes, and how two threads of Python share two cores.

    python3 call.py [LEVEL]    # of an icosphere; 7 has 163,842 vertices
"""

import statistics
import sys
import time
import tracemalloc
from concurrent.futures import ThreadPoolExecutor

import numpy as np

import spherical_parameterization as sp

points, triangles = sp.icosphere(int(sys.argv[1]) if len(sys.argv) > 1 else 7)
points = points * [1, 2, 3]
overheads, totals = [], []
for _ in range(9):
    start = time.perf_counter()
    result = sp.parameterize(points, triangles, sp.Balanced(), policy="sequential")
    totals.append(time.perf_counter() - start)
    overheads.append(totals[-1] - result.seconds.total)
share = statistics.median(overheads) / statistics.median(totals)
print(f"{len(points)} vertices: {statistics.median(totals):.3f} s, of which Python {1e3 * statistics.median(overheads):.2f} ms, {share:.2%}")

tracemalloc.start()
sp.parameterize(points, triangles, sp.Balanced(), policy="sequential")
peak = tracemalloc.get_traced_memory()[1]
tracemalloc.stop()
print(f"memory of numpy and Python in a call: {peak} bytes, the sphere is {result.sphere.nbytes}, the points {points.nbytes}")


def seconds(threads: int) -> float:
    """Of as many threads, each of which maps the mesh three times."""

    def work(_: int) -> None:
        for _ in range(3):
            sp.parameterize(points, triangles, sp.Balanced(), policy="sequential")

    start = time.perf_counter()
    with ThreadPoolExecutor(threads) as pool:
        list(pool.map(work, range(threads)))
    return time.perf_counter() - start


ratios = [2 * seconds(1) / seconds(2) for _ in range(3)]
print(f"two threads do {np.median(ratios):.2f} times the work of one in the same time")
