#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""make_corpus.py FOLDER: writes what the fuzzers of the readers start from, a small file for every dialect that the
tool reads and for a few ways to be wrong, into FOLDER/read_meshes and FOLDER/read_indices. (What the other two start
from was found by the fuzzers themselves.)"""

import pathlib
import struct
import sys

POINTS = [(1.0, 1.0, 1.0), (-1.0, -1.0, 1.0), (-1.0, 1.0, -1.0), (1.0, -1.0, -1.0)]
FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
SPHERE = [tuple(x * 0.57735026918962584 for x in p) for p in POINTS]
FORMATS = ["off", "ply", "obj", "stl", "txt"]  # as in read_meshes.cpp


def rows(points=POINTS, faces=FACES, prefix="", columns=""):
    text = "".join(f"{x} {y} {z}{columns}\n" for x, y, z in points)
    return text + "".join(prefix + " ".join(map(str, (len(f),) + f)) + "\n" for f in faces)


def off(header="OFF", **options):
    return f"{header}\n4 4 0\n" + rows(**options)


def ply(kind, extra="", index="uint"):
    header = (f"ply\nformat {kind} 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\nproperty float y\n"
              f"property float z\n{extra}element face 4\nproperty list uchar {index} vertex_indices\nend_header\n")
    if kind == "ascii":
        return header + rows(columns=" 7" if extra else "")
    order = "<" if kind == "binary_little_endian" else ">"
    body = b"".join(struct.pack(order + "3f", *p) + (b"\7" if extra else b"") for p in POINTS)
    return header.encode() + body + b"".join(struct.pack(order + "B3I", 3, *f) for f in FACES)


def obj(relative=False, slashes=""):
    text = "# by hand\nmtllib none.mtl\no thing\n" + "".join("v {} {} {}\n".format(*p) for p in POINTS) + "vt 0 0\nvn 0 0 1\n"
    return text + "".join("f " + " ".join(f"{i - 4 if relative else i + 1}{slashes}" for i in f) + "\n" for f in FACES)


def stl_text():
    text = "solid by hand\n"
    for f in FACES:
        text += "facet normal 0 0 0\n outer loop\n" + "".join("  vertex {} {} {}\n".format(*POINTS[i]) for i in f)
        text += " endloop\nendfacet\n"
    return text + "endsolid by hand\n"


def stl_binary():
    body = b"".join(struct.pack("<12fH", 0, 0, 0, *(x for i in f for x in POINTS[i]), 0) for f in FACES)
    return b"binary".ljust(80, b"\0") + struct.pack("<I", 4) + body


CUBE = ("OFF\n8 6 12\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
        "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n")

MESHES = {
    "off": {
        "plain": off(), "sphere": off(points=SPHERE), "one_line": "OFF 4 4 6\n" + rows(), "coff": off("COFF", columns=" 9 9 9 255"),
        "noff": off("NOFF", columns=" 0 0 1"), "windows": off().replace("\n", "\r\n"), "cube": CUBE, "triangulated_cube": CUBE,
        "cut_short": off()[:-20], "nan": off().replace("-1.0", "nan", 1), "open": off(faces=FACES[:3]).replace("4 4 0", "4 3 0"),
        "opposed": off(faces=FACES[:3] + [(3, 2, 1)]), "twice": off(faces=FACES[:3] + [(1, 1, 3)]),
        "huge_count": off().replace("4 4 0", "4 4000000000 0"), "largest": off().replace("1.0", "1.7976931348623157e308"),
        "mark": "\ufeff" + off(), "comments": "# a\nOFF # b\n\n4 4 0\n# c\n" + rows(),
    },
    "ply": {
        "ascii": ply("ascii"), "little": ply("binary_little_endian"), "big": ply("binary_big_endian"),
        "colour": ply("binary_little_endian", extra="property uchar red\n"), "ascii_colour": ply("ascii", extra="property uchar red\n"),
        "signed": ply("ascii", index="int"), "no_end": ply("ascii").replace("end_header\n", ""),
        "cut_short": ply("binary_little_endian")[:-9], "lists": ply("ascii").replace("uchar uint", "double int"),
    },
    "obj": {
        "plain": obj(), "relative": obj(relative=True), "slashes": obj(slashes="/1/1"), "normals": obj(slashes="//1"),
        "continued": obj().replace("f 1 3", "f 1 \\\n 3"), "zero": obj().replace("f 1 ", "f 0 "), "points_only": obj().split("f ")[0],
    },
    "stl": {"text": stl_text(), "binary": stl_binary(), "cut_short": stl_binary()[:-30], "loud": stl_text().upper()},
    "txt": {"fixed": "0 1 0 0\n3 0 1 0\n7 0 0 2.5 # a comment\n", "twice": "0 1 0 0\n0 0 1 0\n"},
}

# Bytes of a good index that are other ones: offset in two bytes, value.
INDICES = {
    "empty": b"",
    "no_magic": bytes([0, 0, 0]),
    "format": bytes([71, 0, 1]),
    "page_size": bytes([16, 0, 2]),
    "pages": bytes([31, 0, 200, 100, 0, 5]),
    "cells": b"".join(bytes([k, page * 16, 255]) for page in range(1, 5) for k in (0, 3, 4, 8)),
    "records": b"".join(bytes([255, page * 16 + 15, 250]) for page in range(5)),
}


def main():
    folder = pathlib.Path(sys.argv[1])
    for target in ("read_meshes", "read_indices"):
        (folder / target).mkdir(parents=True, exist_ok=True)
    for k, name in enumerate(FORMATS):
        for what, content in MESHES[name].items():
            data = content if isinstance(content, bytes) else content.encode()
            first = k + 130 if what.startswith("triangulated") else k  # from 128 on: triangulate; 130 = 0 mod 5
            (folder / "read_meshes" / f"{name}_{what}").write_bytes(bytes([first]) + data)
    for what, content in INDICES.items():
        (folder / "read_indices" / what).write_bytes(content)


if __name__ == "__main__":
    main()
