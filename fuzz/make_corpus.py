#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""make_corpus.py FOLDER: writes what the fuzzers of the readers start from, a small file for every dialect that the
tool reads and for a few ways to be wrong, into FOLDER/read_meshes, FOLDER/read_formats and FOLDER/read_indices. (What the other two start
from was found by the fuzzers themselves.)"""

import base64
import bz2
import gzip
import json
import lzma
import pathlib
import struct
import sys
import zlib

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

def data_array(intent, kind, numbers, encoding, order="LittleEndian"):
    layout = ("<" if order == "LittleEndian" else ">") + str(len(numbers)) + ("f" if kind == "FLOAT32" else "i")
    if encoding == "ASCII":
        text = " ".join(map(str, numbers))
    else:
        packed = struct.pack(layout, *numbers)
        text = base64.b64encode(zlib.compress(packed) if encoding == "GZipBase64Binary" else packed).decode()
    return (f'<DataArray Intent="NIFTI_INTENT_{intent}" DataType="NIFTI_TYPE_{kind}" ArrayIndexingOrder="RowMajorOrder" '
            f'Dimensionality="2" Dim0="4" Dim1="3" Encoding="{encoding}" Endian="{order}"><MetaData><MD><Name>a</Name>'
            f"<Value>b</Value></MD></MetaData><Data>{text}</Data></DataArray>")


def gifti(encoding, order="LittleEndian"):
    return ('<?xml version="1.0"?><GIFTI Version="1.0" NumberOfDataArrays="2"><MetaData/>'
            + data_array("POINTSET", "FLOAT32", [x for p in POINTS for x in p], encoding, order)
            + data_array("TRIANGLE", "INT32", [i for f in FACES for i in f], encoding, order) + "</GIFTI>")


def freesurfer(tags=b""):
    body = b"".join(struct.pack(">3f", *p) for p in POINTS) + b"".join(struct.pack(">3i", *f) for f in FACES)
    return b"\xff\xff\xfecreated by hand\n\n" + struct.pack(">2i", 4, 4) + body + tags


def gltf(uri, **node):
    points, indices = b"".join(struct.pack("<3f", *p) for p in POINTS), b"".join(struct.pack("<3H", *f) for f in FACES)
    data = points + indices
    description = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [dict(node, mesh=0)],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
        "buffers": [{"byteLength": len(data)}]}
    if uri:
        description["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    text = json.dumps(description)
    return (text + " " * (-len(text) % 4)).encode(), data


def glb(**node):
    text, data = gltf(False, **node)
    body = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
    return b"glTF" + struct.pack("<2I", 2, 12 + len(body)) + body


def zstd(data):
    """One block as it is: Python has no compressor of the format."""
    return b"\x28\xb5\x2f\xfd\x20" + bytes([len(data)]) + (1 | len(data) << 3).to_bytes(3, "little") + data


OTHER_FORMATS = ["gii", "glb", "gltf", "white", "gz"]  # as in read_formats.cpp
OTHER_MESHES = {
    "gii": {"ascii": gifti("ASCII"), "base64": gifti("Base64Binary"), "zlib": gifti("GZipBase64Binary"),
            "big": gifti("Base64Binary", "BigEndian"), "cut_short": gifti("ASCII")[:-200]},
    "glb": {"plain": glb(), "moved": glb(translation=[1, 2, 3], rotation=[0, 0, 1, 0], scale=[1, -1, 1]),
            "matrix": glb(matrix=[1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 1]), "loop": glb(children=[0]),
            "cut_short": glb()[:-9]},
    "gltf": {"plain": gltf(True)[0], "strip": gltf(True)[0].replace(b'"indices"', b'"mode": 5, "indices"')},
    "white": {"plain": freesurfer(), "tags": freesurfer(struct.pack(">2i", 2, 0)), "cut_short": freesurfer()[:-9]},
    "gz": {"gzip": gzip.compress(off().encode(), mtime=0), "xz": lzma.compress(off().encode()), "bzip2": bz2.compress(off().encode()),
           "zstd": zstd(off().encode()),
           "cut_short": gzip.compress(off().encode(), mtime=0)[:-9], "bomb": gzip.compress(bytes(20000), mtime=0)},
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
    for target in ("read_meshes", "read_formats", "read_indices"):
        (folder / target).mkdir(parents=True, exist_ok=True)
    for k, name in enumerate(FORMATS):
        for what, content in MESHES[name].items():
            data = content if isinstance(content, bytes) else content.encode()
            first = k + 130 if what.startswith("triangulated") else k  # from 128 on: triangulate; 130 = 0 mod 5
            (folder / "read_meshes" / f"{name}_{what}").write_bytes(bytes([first]) + data)
    for k, name in enumerate(OTHER_FORMATS):
        for what, content in OTHER_MESHES[name].items():
            data = content if isinstance(content, bytes) else content.encode()
            (folder / "read_formats" / f"{name}_{what}").write_bytes(bytes([k]) + data)
    for what, content in INDICES.items():
        (folder / "read_indices" / what).write_bytes(content)


if __name__ == "__main__":
    main()
