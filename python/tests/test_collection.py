# SPDX-License-Identifier: GPL-3.0-or-later
"""Collections: rows, resumption, and a cluster on which workers die and stall."""

import contextlib
import functools
import os
import signal
import sqlite3
import subprocess
import threading
import time
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import spherical_parameterization as sp
from conftest import bumpy

distributed = pytest.importorskip("distributed")


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """60 meshes, of which each twelfth is bad; one does not exist."""
    folder = tmp_path_factory.mktemp("meshes")
    names = []
    for i in range(60):
        points, triangles = bumpy(2, i)
        names.append(str(folder / f"{i:02}.off"))
        sp.write_mesh(names[-1], points, triangles[i % 12 == 5 :])
    return [*names, str(folder / "missing.off")]


@pytest.fixture(scope="module")
def client() -> Iterator[Any]:
    with distributed.LocalCluster(n_workers=3, threads_per_worker=1, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            yield client


def rows(store: Path) -> list[tuple[str, ...]]:
    """As they are in the file, to the byte."""
    with contextlib.closing(sqlite3.connect(store)) as connection:
        return connection.execute("SELECT name, status, message, value FROM mesh ORDER BY name").fetchall()


def slow_map(path: str) -> dict[str, Any]:
    time.sleep(0.15)
    return sp.collection.map_file(path)


def crash(item: str) -> str:
    if item == "bad":
        os._exit(1)
    return item


def test_rows(files: list[str], tmp_path: Path) -> None:
    counts = sp.collection.map(files, sp.collection.map_file, store=tmp_path / "a.sqlite")
    assert counts == {"BOUNDARY": 5, "OK": 55, "FileNotFoundError": 1}
    found = {row.key: row for row in sp.collection.read(tmp_path / "a.sqlite")}
    assert found[files[0]].value["verdict"] == "OK" and found[files[0]].value["vertices"] == 162
    assert found[files[5]].error == "BOUNDARY" and "is not closed" in found[files[5]].message
    assert found[files[5]].value is None


def test_the_tools_results_are_read(program: str, tmp_path: Path) -> None:
    """The tool writes the same kind of store; neither takes the rows of the other for its own."""
    (tmp_path / "in").mkdir()
    for i in range(3):
        sp.write_mesh(tmp_path / f"in/{i}.off", bumpy(2)[0], bumpy(2)[1][i % 2 :])
    run = [program, "map", tmp_path / "in", "-o", tmp_path / "out"]
    assert subprocess.run(run, capture_output=True).returncode == 1
    found = list(sp.collection.read(tmp_path / "out/meshes.db"))
    assert [(row.key, row.error, row.value) for row in found] == [("0", "OK", None), ("1", "BOUNDARY", None), ("2", "OK", None)]
    with pytest.raises(ValueError, match="name another file"):
        sp.collection.map([], len, store=tmp_path / "out/meshes.db")


def test_it_goes_on_where_it_was(files: list[str], tmp_path: Path) -> None:
    store = tmp_path / "a.sqlite"
    calls: list[str] = []

    def length(path: str) -> int:
        if len(calls) == 10:
            raise KeyboardInterrupt
        calls.append(path)
        return len(path)

    with pytest.raises(KeyboardInterrupt):
        sp.collection.map(files, length, store=store)
    assert len(rows(store)) == 10
    calls.clear()
    calls += [""] * 11
    new: list[int] = []
    assert sp.collection.map(files, length, store=store, progress=new.append) == {"OK": len(files)}
    assert len(calls) == 11 + len(files) - 10 and sum(new) == len(files) - 10
    with pytest.raises(ValueError, match="name another file"):
        sp.collection.map(files, os.path.getsize, store=store)


def test_what_memory_did_not_suffice_for_is_tried_again(tmp_path: Path) -> None:
    def length(path: str) -> int:
        if not os.path.exists(path + ".memory"):
            raise MemoryError
        return len(path)

    file, store = str(tmp_path / "a.off"), tmp_path / "a.sqlite"
    sp.write_mesh(file, *bumpy(1))
    assert sp.collection.map([file], length, store=store) == {"MemoryError": 1}
    Path(file + ".memory").touch()
    assert sp.collection.map([file], length, store=store) == {"OK": 1}


def test_settings_are_part_of_the_name(files: list[str], tmp_path: Path) -> None:
    for _ in range(2):
        sp.collection.map(files[:1], functools.partial(sp.collection.map_file, method=sp.Isometric()), store=tmp_path / "a")
    with pytest.raises(ValueError, match=r"map_file\(method=Isometric\(area_exponent=None, landmark_weight=inf\)\)"):
        sp.collection.map(files, sp.collection.map_file, store=tmp_path / "a")


def test_values(tmp_path: Path) -> None:
    def value(item: tuple[str, int]) -> Any:
        return {"array": np.arange(item[1]), "number": np.float64(0.1), "code": sp.ErrorCode.OK}

    sp.collection.map([("a", 1), ("b", 2)], value, store=tmp_path / "a.sqlite")
    assert [row.value["array"] for row in sp.collection.read(tmp_path / "a.sqlite")] == [[0], [0, 1]]
    assert sp.collection.map(["c"], lambda item: object(), store=tmp_path / "b.sqlite") == {"TypeError": 1}


def test_cluster(client: Any, files: list[str], tmp_path: Path) -> None:
    sp.collection.map(files, sp.collection.signature_file, store=tmp_path / "serial.sqlite")
    sp.collection.map(files, sp.collection.signature_file, client, tmp_path / "cluster.sqlite")
    assert rows(tmp_path / "cluster.sqlite") == rows(tmp_path / "serial.sqlite")


def test_bag(client: Any, files: list[str], tmp_path: Path) -> None:
    bag = pytest.importorskip("dask.bag").from_sequence(files, npartitions=7)
    function = functools.partial(sp.collection.map_file, method=sp.Balanced(3))
    sp.collection.map(bag, function, client, tmp_path / "bag.sqlite")
    sp.collection.map(bag, function, None, tmp_path / "serial.sqlite")
    assert rows(tmp_path / "bag.sqlite") == rows(tmp_path / "serial.sqlite")


def test_one_worker_dies_and_one_stalls(client: Any, files: list[str], tmp_path: Path) -> None:
    sp.collection.map(files, slow_map, store=tmp_path / "serial.sqlite")
    client.wait_for_workers(3)
    pids = list(client.run(os.getpid).values())
    is_stopped = threading.Event()

    def harm(new: int) -> None:
        if not is_stopped.is_set():
            is_stopped.set()
            os.kill(pids[0], signal.SIGKILL)
            os.kill(pids[1], signal.SIGSTOP)

    try:
        counts = sp.collection.map(
            files, slow_map, client, tmp_path / "cluster.sqlite", batch_seconds=0.5, stall_seconds=4, progress=harm
        )
    finally:
        os.kill(pids[1], signal.SIGCONT)
    assert is_stopped.is_set() and sum(counts.values()) == len(files)
    assert rows(tmp_path / "cluster.sqlite") == rows(tmp_path / "serial.sqlite")


def test_item_that_kills_workers(client: Any, tmp_path: Path) -> None:
    items = [str(i) for i in range(20)]
    counts = sp.collection.map([*items[:7], "bad", *items[7:]], crash, client, tmp_path / "a.sqlite")
    assert counts == {"OK": 20, "WORKER_LOST": 1}
    lost = [row for row in sp.collection.read(tmp_path / "a.sqlite") if row.error == "WORKER_LOST"]
    assert [row.key for row in lost] == ["bad"]


def test_another_function_is_computed_again(tmp_path: Path) -> None:
    def values(function: Any, items: Any = ("2", "3")) -> list[Any]:
        sp.collection.map(items, function, store=tmp_path / "a")
        return [row.value for row in sp.collection.read(tmp_path / "a")]

    assert values(lambda item: int(item) ** 2) == [4, 9]
    assert values(lambda item: int(item) ** 3) == [8, 27]  # another code
    for power in (4, 5):
        assert values(lambda item: int(item) ** power) == [2**power, 3**power]  # other values from outside
        assert values(lambda item, power=power: int(item) ** power) == [2**power, 3**power]  # other defaults
    with pytest.raises(ValueError, match="has results of .*test_collection.* not of .*map_file"):
        values(sp.collection.map_file)
    sp.collection.map([("a", 1)], sum_of, store=tmp_path / "b")
    sp.collection.map([("a", 2)], sum_of, store=tmp_path / "b")
    assert [row.value for row in sp.collection.read(tmp_path / "b")] == [3]


class Power:
    def __init__(self, power: int) -> None:
        self.power = power

    def of(self, item: str) -> int:
        return int(item) ** self.power


def test_what_is_used_indirectly_is_computed_again(tmp_path: Path) -> None:
    def value(function: Any) -> Any:
        sp.collection.map(["3"], function, store=tmp_path / "a")
        return next(sp.collection.read(tmp_path / "a")).value

    namespace: dict[str, Any] = {"__name__": "module"}
    exec("def f(item): return [int(item) ** POWER for _ in '1']\ndef g(item): return f(item)", namespace)
    for name in ("f", "g"):  # in a comprehension, and in a function that is called
        for power in (2, 4):
            namespace["POWER"] = power
            assert value(namespace[name]) == [3**power]
        (tmp_path / "a").unlink()
    for power in (2, 3):
        assert value(Power(power).of) == 3**power


def times(factor: Any) -> Any:
    def decorator(function: Any) -> Any:
        @functools.wraps(function)
        def decorated(item: Any) -> Any:
            return float(factor) * function(item)

        return decorated

    return decorator


class Scaled:
    def __init__(self, number: Any) -> None:
        self.number = number

    def __call__(self, item: str) -> float:
        return int(item) * float(self.number)


def decorated(number: Any) -> Any:
    return times(number)(int)


def default(number: Any) -> Any:
    def helper(item: str) -> float:
        return int(item) * float(number)

    return lambda item, helper=helper: helper(item)


def cached(number: Any) -> Any:
    helper = functools.lru_cache(lambda item: int(item) * float(number))
    return lambda item: helper(item)


def settings(number: Any) -> Any:
    helper = functools.partial(lambda item, factor: int(item) * float(factor), factor=number)
    return lambda item: helper(item)


@pytest.mark.parametrize("make", [decorated, default, cached, settings, Scaled])
@pytest.mark.parametrize("number", [float, np.float32, np.int64, Fraction])
def test_nothing_that_is_used_is_overlooked(make: Any, number: Any, tmp_path: Path) -> None:
    for factor in (2, 5):
        sp.collection.map(["3"], make(number(factor)), store=tmp_path / "a")
        assert next(sp.collection.read(tmp_path / "a")).value == 3 * factor


def test_functions_of_any_kind(tmp_path: Path) -> None:
    @times(1)
    def factorial(item: Any) -> Any:
        return 1 if int(item) < 2 else int(item) * factorial(int(item) - 1)

    def without_value() -> Any:
        return lambda item: later if item == "x" else 1  # noqa: F821
        later = 3

    for name, function, value in (("a", factorial, 6), ("b", without_value(), 1)):
        sp.collection.map(["3"], function, store=tmp_path / name)
        assert next(sp.collection.read(tmp_path / name)).value == value
    for settings in ({"x": 1, "y": 2}, {"y": 2, "x": 1}):
        sp.collection.map(["a"], functools.partial(lambda item, x, y: x, **settings), store=tmp_path / "c")


def test_a_store_is_a_file_whatever_it_is_called(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert sp.collection.map(["abc"], len, store=":memory:") == {"OK": 1}
    assert (tmp_path / ":memory:").exists()


def test_arrays_are_settings(tmp_path: Path) -> None:
    function = functools.partial(sum_of_rows, table=np.eye(3))
    for _ in range(2):
        assert sp.collection.map(["a"], function, store=tmp_path / "a") == {"OK": 1}
    with pytest.raises(ValueError, match="name another file"):
        sp.collection.map(["a"], functools.partial(sum_of_rows, table=np.ones((3, 3))), store=tmp_path / "a")


def test_numbers_that_json_has_not(tmp_path: Path) -> None:
    sp.collection.map(["a"], lambda item: {"x": [np.nan, -np.inf, 0.1], "y": "NaN"}, store=tmp_path / "a")
    assert rows(tmp_path / "a")[0][3] == '{"x": [null, null, 0.1], "y": "NaN"}'


def test_texts_that_are_no_utf8(tmp_path: Path) -> None:
    def fails(item: str) -> None:
        raise ValueError("\ud800")

    folder = tmp_path / os.fsdecode(b"scans-\xff")
    folder.mkdir()
    sp.write_mesh(folder / os.fsdecode(b"\xfe.off"), *bumpy(1))
    assert sp.collection.map(folder, fails, store=tmp_path / "a") == {"ValueError": 1}
    assert [row.key for row in sp.collection.read(tmp_path / "a")] == [str(folder / os.fsdecode(b"\xfe.off"))]


def sum_of_rows(item: str, table: np.ndarray) -> float:
    return float(table.sum())


def sum_of(item: tuple[str, int]) -> int:
    return len(item[0]) + item[1]


def test_a_changed_file_is_computed_again(tmp_path: Path) -> None:
    file, calls = tmp_path / "mesh.off", []

    def size(path: str) -> int:
        calls.append(path)
        return os.path.getsize(path)

    def value() -> Any:
        sp.collection.map([str(file)], size, store=tmp_path / "a")
        return next(sp.collection.read(tmp_path / "a")).value

    assert value() is None  # it is not there
    for contents in (b"x" * 10, b"x" * 20):
        file.write_bytes(contents)
        assert value() == len(contents)
    times = (file.stat().st_atime, file.stat().st_mtime)
    file.write_bytes(b"y" * 20)
    os.utime(file, times)  # of the same size and time
    assert value() == 20 and len(calls) == 4
    file.touch()  # of the same contents
    for _ in range(2):
        assert value() == 20 and len(calls) == 4


def test_rows_are_on_the_disk_while_a_long_item_is_computed(tmp_path: Path) -> None:
    found: list[tuple[str, ...]] = []

    def item_of(name: str) -> str:
        if name == "long":
            time.sleep(1)
            found.extend(rows(tmp_path / "a"))
        return name

    sp.collection.map(["short", "long"], item_of, store=tmp_path / "a")
    assert [row[0] for row in found] == ["short"]


def test_a_folder_is_its_meshes(files: list[str], tmp_path: Path) -> None:
    below = tmp_path / "scans" / "below"
    below.mkdir(parents=True)
    for name in ("a.off", "b.txt", "below/c.surf.gii.gz", "below/d.func.gii", "below/lh.white", "results.sqlite"):
        (tmp_path / "scans" / name).write_text("")
    for folder in (tmp_path / "scans", str(tmp_path / "scans")):
        sp.collection.map(folder, os.path.getsize, store=tmp_path / "a")
    names = [os.path.relpath(row.key, tmp_path / "scans") for row in sp.collection.read(tmp_path / "a")]
    assert names == ["a.off", "below/c.surf.gii.gz", "below/lh.white"]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("a.off", len), "files_or_bag: 'a.off' is no folder"),
        ((3, len), "files_or_bag: .* not int"),
        ((["a.off"], "coll"), "function: .* not str"),
        ((["a.off"], len, 3), "client: a distributed.Client or None is needed, not int"),
    ],
)
def test_wrong_arguments_write_nothing(arguments: Any, message: str, tmp_path: Path) -> None:
    store = tmp_path / "a.sqlite"
    with pytest.raises(TypeError, match=message):
        sp.collection.map(*arguments, store=store)
    with pytest.raises(FileNotFoundError):
        sp.collection.read(store)
    assert not store.exists()
