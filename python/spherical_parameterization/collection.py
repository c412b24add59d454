# SPDX-License-Identifier: LGPL-3.0-or-later
"""Collections of meshes, on this machine or on a cluster of Dask; results in an SQLite file."""

from __future__ import annotations

import asyncio
import contextlib
import dataclasses
import errno
import functools
import hashlib
import itertools
import json
import numbers
import os
import queue
import sqlite3
import sys
import time
import types
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import Any, NamedTuple

import numpy as np

from . import _core
from .analysis import distortion, shape_signature
from .arrays import check, file_name, wrong_type
from .errors import MeshError
from .files import read_mesh
from .maps import map_to_go_on


class Row(NamedTuple):
    """The result for one item."""

    key: str  #: the item, if it is a name; if it is a tuple, its first element
    error: str  #: "OK", the code of a `MeshError`, "WORKER_LOST", or the name of another exception
    message: str  #: the text of the exception
    value: Any  #: what the function has returned, converted by JSON; None for exceptions


def map_file(path: str, **settings: Any) -> dict[str, Any]:
    """Maps a mesh: a function for `map()`. Use `functools.partial(map_file, method=...)` for other settings.

    Parameters
    ----------
    path : str
        A file for `read_mesh()`.
    **settings
        Arguments of `parameterize()`. The default policy is "sequential", since the other cores map other meshes.

    Returns
    -------
    dict
        Sizes, verdict, method and mean distortion; no times, so that the same mesh gives the same bytes.
    """
    points, triangles = read_mesh(path)
    chosen: dict[str, Any] = {"policy": "sequential", "warn": False, **settings}
    result = map_to_go_on(points, triangles, **chosen)
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
        A file for `read_mesh()`.

    Returns
    -------
    list of float
    """
    return shape_signature(*read_mesh(path), policy="sequential").tolist()


def _plain(value: Any) -> Any:
    """What JSON does not know."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return dataclasses.asdict(value)
    raise TypeError(f"a function for a collection returns what JSON can hold, and arrays; not {type(value).__name__}")


def _json(value: Any) -> str:
    """Numbers that are not finite are null, since JSON has none."""
    text = json.dumps(value, default=_plain, sort_keys=True)
    return json.dumps(json.loads(text, parse_constant=lambda name: None)) if "NaN" in text or "Infinity" in text else text


def _key(item: Any) -> str:
    return str(item[0] if isinstance(item, tuple) else item)


def _repr(value: Any) -> str:
    with np.printoptions(threshold=sys.maxsize, floatmode="unique"):
        return repr(value)


def _name(function: Any) -> str:
    """What a function is called in the store; with the settings of functools.partial."""
    if isinstance(function, functools.partial):
        settings = [_repr(value) for value in function.args]
        settings += [f"{key}={_repr(value)}" for key, value in sorted(function.keywords.items())]
        return f"{_name(function.func)}({', '.join(settings)})"
    named = function if hasattr(function, "__qualname__") else type(function)
    return f"{named.__module__}.{named.__qualname__}"


def _plainly(value: Any) -> Any:
    """Code, and plain values, so that repr() is the same in every run; of others the type."""
    if isinstance(value, types.FunctionType):
        value = value.__code__
    if isinstance(value, types.CodeType):
        return value.co_code, value.co_names, [_plainly(constant) for constant in value.co_consts]
    if isinstance(value, frozenset):
        return sorted(repr(_plainly(part)) for part in value)
    if isinstance(value, tuple):
        return [_plainly(part) for part in value]
    return value if isinstance(value, (str, bytes, numbers.Number, np.generic)) else type(value).__qualname__


def _names(code: types.CodeType) -> list[str]:
    """What a function looks up by name, also in comprehensions and in functions inside it."""
    inner = [name for constant in code.co_consts if isinstance(constant, types.CodeType) for name in _names(constant)]
    return [*code.co_names, *inner]


def _content(cell: Any) -> Any:
    try:
        return cell.cell_contents
    except ValueError:  # the variable has no value yet
        return None


def _used(value: Any, seen: list[Any]) -> Any:
    """What a function uses: plain values, and what other functions do."""
    if isinstance(value, types.MethodType):
        value = value.__func__  # the state of its object may change with every call
    is_function = isinstance(value, (types.FunctionType, functools.partial)) or "__wrapped__" in getattr(value, "__dict__", ())
    if not is_function or any(value is other for other in seen):  # functions call each other
        return _plainly(value)
    return _computation(value, seen)


def _all_used(items: Iterable[tuple[Any, Any]], seen: list[Any]) -> Any:
    return [(name, _used(value, seen)) for name, value in items]


def _attributes(thing: Any, seen: list[Any]) -> Any:
    return _all_used(getattr(thing, "__dict__", {}).items(), seen)


def _computation(function: Any, seen: list[Any]) -> Any:
    """What a function does: its code, defaults, and the plain values and functions that it uses from outside, and so on."""
    seen.append(function)
    if isinstance(function, functools.partial):
        settings = [*enumerate(function.args), *sorted(function.keywords.items())]
        return _computation(function.func, seen), _all_used(settings, seen)
    if isinstance(function, types.MethodType):
        return _computation(function.__func__, seen), _attributes(function.__self__, seen)
    if not isinstance(function, types.FunctionType):  # has attributes, as __wrapped__ of functools.lru_cache
        return _plainly(function), _used(type(function).__call__, seen), _attributes(function, seen)
    code = function.__code__
    outside = {name: function.__globals__.get(name) for name in _names(code)}
    outside.update(zip(code.co_freevars, (_content(cell) for cell in function.__closure__ or ())))
    defaults = [*(function.__defaults__ or ()), *(function.__kwdefaults__ or {}).values()]
    return _plainly(code), _all_used(enumerate(defaults), seen), _all_used(outside.items(), seen)


@functools.lru_cache(maxsize=None)
def _package() -> str:
    """The version, and what was built of it."""
    return f"{_core.__version__} {_core.version(_core.__file__)[2]}"


def _digest(*parts: Any) -> str:
    return hashlib.blake2b(_repr(parts).encode(), digest_size=16).hexdigest()


_Line = tuple[Any, tuple[int, int, str], str, str, str]  # item, version of its file, error, message, value


def _version(item: Any) -> tuple[int, int, str]:
    """Size, time of change and hash of the file, if the item is one."""
    try:
        return _core.version(os.fsencode(_key(item)))
    except ValueError:  # no name of a file
        return -1, -1, ""


def _run(function: Callable[[Any], Any], items: list[Any]) -> tuple[list[_Line], float]:
    """The rows of some items, and the seconds that they took. Runs on the workers."""
    start = time.perf_counter()
    rows: list[_Line] = []
    for item in items:
        error, message, value = "OK", "", ""
        version = _version(item)  # before the file is read: if it is changed meanwhile, the next call computes it again
        try:
            value = _json(function(item))
        except MeshError as wrong:
            error, message = str(wrong.code), str(wrong)
        except (Exception, SystemExit) as wrong:  # some readers exit
            error, message = type(wrong).__name__, str(wrong)
        rows.append((item, version, error, message, value))
    return rows, time.perf_counter() - start


class _Store:
    """The database, which is that of the tool. Only this process writes to it."""

    def __init__(self, path: str | os.PathLike[str], function: Callable[[Any], Any]) -> None:
        self._store = _core.Store(file_name("store", path))
        self._name = _name(function)
        self._computation = _digest(_computation(function, []), _package())
        settings = self._store.some_settings()
        other = settings.rpartition("\n")[0] or settings  # arrays in the name have lines, too
        if other not in ("", self._name):
            self.close()
            raise ValueError(f"{os.fspath(path)} has results of {other}, not of {self._name}: name another file")

    def _key_of(self, item: Any) -> tuple[bytes, str]:
        """The name, and all that a row depends on but the file."""
        others = _digest(item[1:]) if isinstance(item, tuple) else ""
        return os.fsencode(_key(item)), f"{self._name}\n{self._computation} {others}"

    def has(self, item: Any) -> bool:
        return self._store.is_current(*self._key_of(item))

    def save(self, rows: list[_Line]) -> None:
        self._store.put(
            [(*self._key_of(item), version, error, message.encode(errors="backslashreplace"), value) for item, version, error, message, value in rows]
        )

    def close(self) -> None:
        self._store.close()


def _items(files_or_bag: Any, client: Any) -> Iterator[Any]:
    """The items of a bag come to this process a partition at a time: let them be names. Of a folder, its meshes."""
    if isinstance(files_or_bag, (str, os.PathLike)):
        folder = os.fsdecode(files_or_bag)
        if not os.path.isdir(folder):
            raise TypeError(f"files_or_bag: {folder!r} is no folder; names have to be in a list")
        return iter([os.fsdecode(name) for name in _core.meshes_in(os.fsencode(folder))])
    if hasattr(files_or_bag, "to_delayed"):
        parts = (part.compute() if client is None else client.compute(part).result() for part in files_or_bag.to_delayed())
        return itertools.chain.from_iterable(parts)
    if isinstance(files_or_bag, bytes) or not isinstance(files_or_bag, Iterable):
        raise wrong_type("files_or_bag", "a folder, or a list or bag of names,", files_or_bag)
    return iter(files_or_bag)


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

    def next_rows(self) -> tuple[list[_Line], float]:
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
                item = batch.items[0]
                return [(item, _version(item), "WORKER_LOST", str(result), "")], 0
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
        return result

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
    files_or_bag: Iterable[Any], function: Callable[[Any], Any], client: Any = None,
    store: str | os.PathLike[str] = "results.sqlite", *, batch_seconds: float = 0.5, stall_seconds: float = 300,
    progress: Callable[[int], object] | None = None,
) -> dict[str, int]:
    """Applies a function to every item of a collection, once, and stores what it returns.

    Items that have a row in the store are skipped: after an interruption, or with more files, call it again. If a file
    has changed, it is computed again; if the function or this package has changed, everything is computed again. If an
    item fails, its row has the error. A row is on the disk before `progress` is called. Workers may come, go and die.

    Parameters
    ----------
    files_or_bag : iterable of str, of paths or of tuples; dask.bag.Bag of such; or str or path of a folder
        The items. Their names must differ; for tuples, the first elements. A folder stands for all meshes in it and
        in its subfolders.
    function : callable
        Takes one item, and returns values that JSON can represent, and arrays; NaN and infinity are stored as null. May run twice
        for an item if workers die, so it should write files atomically (`os.replace`). Examples are `map_file` and `signature_file`.
    client : distributed.Client, optional
        The cluster. Without a client the items are computed in this process, one after the other; the rows are the same.
    store : str or path
        An SQLite file with a table `mesh`, as the tool writes it: name, mesh, status, message, value, ...; value is JSON.
    batch_seconds : float
        Items are sent in batches that take about this time. For a thousand workers 10 is better.
    stall_seconds : float
        If a batch takes longer, another worker gets it, too; the first result counts. Must be more than the
        largest mesh takes.
    progress : callable, optional
        Called with the number of new rows: `tqdm(total=...).update`.

    Returns
    -------
    dict of str to int
        The number of rows in the store, by error.

    Raises
    ------
    ValueError
        If the store has results of a function with another name or with other settings.
    TypeError
        If an argument has a wrong type. The store is then not changed.

    Examples
    --------
    >>> import tempfile, os, spherical_parameterization as sp
    >>> store = os.path.join(tempfile.mkdtemp(), "squares.sqlite")
    >>> sp.collection.map(["2", "3", "four"], lambda item: int(item) ** 2, store=store)
    {'OK': 2, 'ValueError': 1}
    >>> [row.value for row in sp.collection.read(store)]
    [4, 9, None]
    """
    check(map, locals())
    if not callable(function):
        raise wrong_type("function", "a function of one item", function)
    if not (client is None or (hasattr(client, "submit") and hasattr(client, "nthreads"))):
        raise wrong_type("client", "a distributed.Client or None", client)
    if not (progress is None or callable(progress)):
        raise wrong_type("progress", "a function of a number or None", progress)
    items = _items(files_or_bag, client)
    results = _Store(store, function)
    todo = (item for item in items if not results.has(item))

    def save(rows: list[_Line]) -> None:
        results.save(rows)
        if progress is not None and rows:
            progress(len(rows))

    try:
        if client is None:
            for item in todo:
                save(_run(function, [item])[0])
        else:
            _map_on_cluster(todo, _Cluster(client, function, stall_seconds), save, batch_seconds)
    finally:
        results.close()
    return dict(_select(store, "SELECT status, COUNT(*) FROM mesh GROUP BY status ORDER BY status"))


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

    Returns
    -------
    iterator of Row

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    """
    if not os.path.exists(store):
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), os.fspath(store))
    rows = _select(store, "SELECT name, status, message, value FROM mesh ORDER BY name")
    return (Row(key, error, text, json.loads(value) if value else None) for key, error, text, value in rows)


def _select(store: str | os.PathLike[str], query: str) -> Iterator[Any]:
    with contextlib.closing(sqlite3.connect(os.path.abspath(store))) as connection:
        connection.text_factory = os.fsdecode
        yield from connection.execute(query)
