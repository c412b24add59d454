# SPDX-License-Identifier: LGPL-3.0-or-later
"""Collections of meshes, on this machine or on a cluster of Dask; results in an SQLite file."""

from __future__ import annotations

import asyncio
import dataclasses
import functools
import itertools
import json
import os
import queue
import sqlite3
import time
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import Any, NamedTuple

import numpy as np

from .analysis import distortion, shape_signature
from .errors import MeshError
from .files import read_mesh
from .maps import parameterize


class Row(NamedTuple):
    """What became of one item."""

    key: str  #: the item, if it is a name; of a tuple its first element
    error: str  #: "OK", the code of a `MeshError`, "WORKER_LOST", or the name of another exception
    message: str  #: of the exception
    value: Any  #: what the function has returned, through JSON; None for exceptions


def map_file(path: str, **settings: Any) -> dict[str, Any]:
    """Maps a mesh: a function for `map()`. Use `functools.partial(map_file, method=...)` for other settings.

    Parameters
    ----------
    path : str
        For `read_mesh()`.
    **settings
        Of `parameterize()`. Default policy: "sequential", since the other cores have meshes of their own.

    Returns
    -------
    dict
        Sizes, verdict, method and mean distortion; no times, so that the same mesh gives the same bytes.
    """
    points, triangles = read_mesh(path)
    chosen: dict[str, Any] = {"policy": "sequential", "warn": False, **settings}
    result = parameterize(points, triangles, **chosen)
    summary = distortion(points, triangles, result.sphere, policy="sequential")
    return {
        "vertices": result.number_of_vertices,
        "faces": result.number_of_faces,
        "verdict": result.error,
        "method": result.method,
        "flipped_faces": result.flipped_faces,
        "degree": result.degree,
        "residual": result.residual,
        "dilatation": summary.dilatation.mean,
        "symmetric_dirichlet": summary.symmetric_dirichlet.mean,
    }


def signature_file(path: str) -> list[float]:
    """The `shape_signature()` of a mesh: a function for `map()`.

    Parameters
    ----------
    path : str
        For `read_mesh()`.

    Returns
    -------
    list of float
    """
    signature: list[float] = shape_signature(*read_mesh(path), policy="sequential").tolist()
    return signature


def _plain(value: Any) -> Any:
    """What JSON does not know."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return dataclasses.asdict(value)
    raise TypeError(f"a function for a collection returns what JSON can hold, and arrays; not {type(value).__name__}")


def _key(item: Any) -> str:
    return str(item[0] if isinstance(item, tuple) else item)


def _name(function: Any) -> str:
    """What a function is called in the store; with the settings of functools.partial."""
    if isinstance(function, functools.partial):
        settings = [*(repr(value) for value in function.args), *(f"{key}={value!r}" for key, value in function.keywords.items())]
        return f"{_name(function.func)}({', '.join(settings)})"
    return str(getattr(function, "__qualname__", type(function).__qualname__))


def _run(function: Callable[[Any], Any], items: list[Any]) -> tuple[list[tuple[str, str, str, str | None]], float]:
    """The rows of some items, and the seconds that they took. Runs on the workers."""
    start = time.perf_counter()
    rows: list[tuple[str, str, str, str | None]] = []
    for item in items:
        try:
            value = json.dumps(function(item), default=_plain, sort_keys=True)
            rows.append((_key(item), "OK", "", value))
        except MeshError as error:
            rows.append((_key(item), str(error.code), str(error), None))
        except (Exception, SystemExit) as error:  # some readers exit
            rows.append((_key(item), type(error).__name__, str(error), None))
    return rows, time.perf_counter() - start


class _Store:
    """The SQLite file. Only this process writes to it, in the journal mode that works on network drives, too."""

    def __init__(self, path: str | os.PathLike[str], function: Callable[[Any], Any]) -> None:
        name = _name(function)
        self._connection = sqlite3.connect(path)
        self._committed = time.monotonic()
        with self._connection as c:
            c.execute("CREATE TABLE IF NOT EXISTS about (function TEXT)")
            c.execute("CREATE TABLE IF NOT EXISTS results (key TEXT PRIMARY KEY, error TEXT, message TEXT, value TEXT)")
            stored = c.execute("SELECT function FROM about").fetchone()
            if stored is None:
                c.execute("INSERT INTO about VALUES (?)", (name,))
            elif stored[0] != name:
                raise ValueError(f"{os.fspath(path)} has results of {stored[0]}, not of {name}: name another file")

    def has(self, item: Any) -> bool:
        found = self._connection.execute("SELECT 1 FROM results WHERE key = ?", (_key(item),))
        return found.fetchone() is not None

    def save(self, rows: list[tuple[str, str, str, str | None]]) -> int:
        """Returns how many are new: a row that is there already stays. They reach the disk within about a second."""
        new = self._connection.executemany("INSERT OR IGNORE INTO results VALUES (?, ?, ?, ?)", rows).rowcount
        if time.monotonic() - self._committed > 1:
            self._connection.commit()
            self._committed = time.monotonic()
        return new

    def counts(self) -> dict[str, int]:
        return dict(self._connection.execute("SELECT error, COUNT(*) FROM results GROUP BY error ORDER BY error"))

    def close(self) -> None:
        self._connection.commit()
        self._connection.close()


def _items(files_or_bag: Any, client: Any) -> Iterator[Any]:
    """The items of a bag come to this process a partition at a time: let them be names."""
    if hasattr(files_or_bag, "to_delayed"):
        for part in files_or_bag.to_delayed():
            yield from part.compute() if client is None else client.compute(part).result()
    else:
        yield from files_or_bag


@dataclasses.dataclass
class _Batch:
    items: list[Any]
    futures: list[Any] = dataclasses.field(default_factory=list)  #: copies of the same work
    since: float = 0  #: when the last copy was submitted


class _Cluster:
    """Batches on their way. A worker that dies is the business of Dask; one that stalls, of this class."""

    def __init__(self, client: Any, function: Callable[[Any], Any], stall_seconds: float) -> None:
        self._client = client
        self._function = function
        self._stall_seconds = stall_seconds
        self._batches: dict[str, _Batch] = {}  # by the keys of their futures
        self._arrivals: queue.Queue[tuple[Any, Any]] = queue.Queue()
        self._fetchers = ThreadPoolExecutor(8)  # a worker that stalls while it sends holds up one of them
        self._room = 0
        self._room_since = -np.inf

    def has_room(self) -> bool:
        """Enough on their way for every thread to have the next batch waiting."""
        if time.monotonic() - self._room_since > 5:
            self._room = 2 * sum(self._client.nthreads().values()) + 2
            self._room_since = time.monotonic()
        return len(self._batches) < self._room

    def is_idle(self) -> bool:
        return not self._batches

    def submit(self, batch: _Batch, workers: list[str] | None = None) -> None:
        future = self._client.submit(_run, self._function, batch.items, pure=False, workers=workers)
        batch.futures.append(future)
        batch.since = time.monotonic()
        self._batches[future.key] = batch
        future.add_done_callback(lambda done: self._fetchers.submit(self._fetch, done))

    def _fetch(self, future: Any) -> None:
        try:
            self._arrivals.put((future, future.result(timeout=self._stall_seconds)))
        except BaseException as error:  # goes to the thread that waits
            self._arrivals.put((future, error))

    def next_rows(self) -> tuple[list[tuple[str, str, str, str | None]], float]:
        """What has arrived, perhaps nothing; and the seconds that it took."""
        from distributed.scheduler import KilledWorker

        try:
            future, result = self._arrivals.get(timeout=min(1.0, self._stall_seconds / 4))
        except queue.Empty:
            self._copy_what_stalls()
            return [], 0
        batch = self._batches.get(future.key)
        if batch is None:  # a copy of it was faster
            return [], 0
        if isinstance(result, KilledWorker):  # several workers have died of it, or beside it
            self._forget(batch)
            if len(batch.items) == 1:
                return [(_key(batch.items[0]), "WORKER_LOST", str(result), None)], 0
            for item in batch.items:
                self.submit(_Batch([item]))
            return [], 0
        if isinstance(result, (TimeoutError, asyncio.TimeoutError)) or future.cancelled():
            self._copy(batch)
            return [], 0
        if isinstance(result, BaseException):
            raise result
        self._forget(batch)
        self._copy_what_stalls()
        rows, seconds = result
        return rows, seconds

    def _copy_what_stalls(self) -> None:
        now = time.monotonic()
        for batch in {id(b): b for b in self._batches.values()}.values():
            if now - batch.since > self._stall_seconds:
                self._copy(batch)

    def _copy(self, batch: _Batch) -> None:
        """The same work once more, on workers that do not have it, if there are any."""
        keys = {future.key for future in batch.futures}
        busy = {worker for worker, tasks in self._client.processing().items() if keys.intersection(tasks)}
        others = [worker for worker in self._client.nthreads() if worker not in busy]
        self.submit(batch, others or None)

    def _forget(self, batch: _Batch) -> None:
        for future in batch.futures:
            self._batches.pop(future.key, None)
        copies = [future for future in batch.futures if not future.done()]
        if copies:
            self._client.cancel(copies)

    def close(self) -> None:
        for batch in list(self._batches.values()):
            self._forget(batch)
        self._fetchers.shutdown(wait=False)


def map(
    files_or_bag: Iterable[Any],
    function: Callable[[Any], Any],
    client: Any = None,
    store: str | os.PathLike[str] = "results.sqlite",
    *,
    batch_seconds: float = 1,
    stall_seconds: float = 300,
    progress: Callable[[int], object] | None = None,
) -> dict[str, int]:
    """Applies a function to every item of a collection, once, and stores what it returns.

    Items that the store has already are left out: after an interruption, or with more files, call it again. What goes
    wrong with an item becomes its row. Workers may come, go and die meanwhile.

    Parameters
    ----------
    files_or_bag : iterable of str, of paths or of tuples; or dask.bag.Bag of such
        The items. Their names have to differ: of tuples, those of their first elements.
    function : callable
        Of one item; returns what JSON can hold, and arrays. May run twice for an item if workers die: files that it
        writes should be complete or not there (`os.replace`). `map_file` and `signature_file` are such functions.
    client : distributed.Client, optional
        The cluster. Without one all is done in this process, one after the other; the rows are the same.
    store : str or path
        An SQLite file with the table results (key, error, message, value); value is JSON.
    batch_seconds : float
        Items are sent in batches that take about so long. For a thousand workers 10 is better.
    stall_seconds : float
        A batch that is out for longer is given to another worker, too; the first result counts. More than the
        largest mesh takes.
    progress : callable, optional
        Called with the number of new rows: `tqdm(total=...).update`.

    Returns
    -------
    dict of str to int
        How many rows the store has, by error.

    Raises
    ------
    ValueError
        If the store has results of another function.

    Examples
    --------
    >>> import tempfile, os, spherical_parameterization as sp
    >>> store = os.path.join(tempfile.mkdtemp(), "squares.sqlite")
    >>> sp.collection.map(["2", "3", "four"], lambda item: int(item) ** 2, store=store)
    {'OK': 2, 'ValueError': 1}
    >>> [row.value for row in sp.collection.read(store)]
    [4, 9, None]
    """
    results = _Store(store, function)
    todo = (item for item in _items(files_or_bag, client) if not results.has(item))

    def save(rows: list[tuple[str, str, str, str | None]]) -> None:
        new = results.save(rows) if rows else 0
        if progress is not None and new > 0:
            progress(new)

    try:
        if client is None:
            for item in todo:
                save(_run(function, [item])[0])
        else:
            _map_on_cluster(todo, _Cluster(client, function, stall_seconds), save, batch_seconds)
        return results.counts()
    finally:
        results.close()


def _map_on_cluster(todo: Iterator[Any], cluster: _Cluster, save: Callable[[Any], None], batch_seconds: float) -> None:
    try:
        seconds_per_item = batch_seconds  # the first batches are one item
        is_more = True
        while is_more or not cluster.is_idle():
            while is_more and cluster.has_room():
                size = int(min(max(batch_seconds / seconds_per_item, 1), 1000))
                items = list(itertools.islice(todo, size))
                is_more = len(items) == size
                if items:
                    cluster.submit(_Batch(items))
            rows, seconds = cluster.next_rows()
            save(rows)
            if seconds > 0:
                seconds_per_item += 0.5 * (seconds / len(rows) - seconds_per_item)
    finally:
        cluster.close()


def read(store: str | os.PathLike[str]) -> Iterator[Row]:
    """The rows of a store, sorted by key.

    Parameters
    ----------
    store : str or path

    Yields
    ------
    Row
    """
    connection = sqlite3.connect(store)
    try:
        for key, error, message, value in connection.execute("SELECT * FROM results ORDER BY key"):
            yield Row(key, error, message, None if value is None else json.loads(value))
    finally:
        connection.close()
