#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""make_corpus.py FOLDER: writes what the fuzzers of the readers start from, a small file for every dialect that the
tool reads and for a few ways to be wrong, into FOLDER/read_meshes, FOLDER/read_formats, FOLDER/read_data and FOLDER/read_indices. (What the other two start
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


def mni(colours=0):
    text = "P 0.3 0.3 0.4 10 1 4\n" + 2 * rows(faces=[]) + f"\n4\n{colours}" + " 1 0 0.5 1" * (4 if colours else 1)
    return text + "\n 3 6 9 12\n" + "".join(" ".join(map(str, f)) + "\n" for f in FACES)


def off_binary(order, colours):
    body = struct.pack(order + "3i12f", 4, 4, 6, *(x for p in POINTS for x in p))
    return b"OFF BINARY\n" + body + b"".join(struct.pack(order + "4i", 3, *f) + colours for f in FACES)


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
        "binary": off_binary(">", bytes(4)), "binary_pmp": off_binary("<", b""),
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
        "mni": mni(), "mni_colours": mni(2), "concave": "v 0 0 0\nv 1 1 0\nv 9 0 0\nv 0 9 0\nf 1 2 3 4\nf 4 3 2 1\n",
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

DATA_FORMATS = ["curv", "annot", "label", "csv", "func.gii", "label.gii", "ply", "vtk", "vtp"]  # as in read_data.cpp


def annot(version):
    colours = [(25, 5, 25, 0), (0, 10, 200, 55)]
    values = [25 | 5 << 8 | 25 << 16, 10 << 8 | 200 << 16, 0, 7]
    head = struct.pack(">i8i", 4, *(x for v, value in enumerate(values) for x in (v, value)))
    table = struct.pack(">i", 1) + (struct.pack(">3i", -2, 9, 2) + b"t\0" + struct.pack(">i", 2) if version == 2 else struct.pack(">2i", 2, 2) + b"t\0")
    for k, colour in enumerate(colours):
        table += (struct.pack(">i", 4 * k) if version == 2 else b"") + struct.pack(">i", 2) + bytes([97 + k, 0]) + struct.pack(">4i", *colour)
    return head + table


def gifti_data(intent, kind, numbers, encoding, table=""):
    array = data_array(intent, kind, numbers, encoding, "LittleEndian").replace('Dim1="3"', 'Dim1="1"')
    return f'<?xml version="1.0"?>\n<GIFTI Version="1.0" NumberOfDataArrays="1"><LabelTable>{table}</LabelTable>{array}</GIFTI>'


def vtk(kind, version="4.2", dataset="POLYDATA"):
    def numbers(form, *rows):
        if kind == "ASCII":
            return "".join(" ".join(map(str, row)) + "\n" for row in rows).encode()
        return b"".join(struct.pack(">" + str(len(row)) + form, *row) for row in rows) + b"\n"

    body = f"# vtk DataFile Version {version}\nby hand\n{kind}\nDATASET {dataset}\nPOINTS 4 float\n".encode() + numbers("f", *POINTS)
    if version > "5":
        body += b"POLYGONS 5 12\nOFFSETS vtktypeint64\n" + numbers("q", range(0, 15, 3)) + b"CONNECTIVITY vtktypeint64\n" + numbers("q", *FACES)
    else:
        body += (b"CELLS" if dataset != "POLYDATA" else b"POLYGONS") + b" 4 16\n" + numbers("i", *((3,) + f for f in FACES))
    if dataset != "POLYDATA":
        body += b"CELL_TYPES 4\n" + numbers("i", (5, 6, 7, 5))
        body += b"FIELD FieldData 1\ntexts 1 2 string\n" + (b"a\nb%20c\n" if kind == "ASCII" else b"\xc1a\x80\3b c\n")
    body += b"POINT_DATA 4\nSCALARS a%20b double 1\nLOOKUP_TABLE default\n" + numbers("d", (1, 2.5, -1, 0))
    body += b"FIELD FieldData 2\nkind 1 4 int\n" + numbers("i", (1, 2, 1, 7)) + b"METADATA\nINFORMATION 0\n\nv 2 4 short\n" + numbers("h", range(8))
    return body + b"NORMALS n float\n" + numbers("f", *POINTS)


def vtp(form, is_compressed=False, encoding="base64", dataset="PolyData"):
    appended = []

    def array(name, kind, numbers, components=1):
        numbers = list(numbers)
        head = f'<DataArray type="{kind[1]}" Name="{name}" NumberOfComponents="{components}" format="{form}"'
        if form == "ascii":
            return head + ">" + " ".join(map(str, numbers)) + "</DataArray>"
        data = struct.pack(f"<{len(numbers)}{kind[0]}", *numbers)
        blocks = [struct.pack("<I", len(data)) + data]
        if is_compressed:
            parts = [data[:32], data[32:]] if 32 < len(data) else [data]
            folded = [zlib.compress(part) for part in parts]
            sizes = [len(parts), 32 if len(parts) > 1 else len(data), len(parts[1]) if len(parts) > 1 else 0] + [len(f) for f in folded]
            blocks = [struct.pack(f"<{len(sizes)}I", *sizes), b"".join(folded)]
        bytes_of = b"".join(blocks if encoding == "raw" else [base64.b64encode(block) for block in blocks])
        if form == "binary":
            return head + ">" + bytes_of.decode() + "</DataArray>"
        appended.append(bytes_of)
        return head + f' offset="{sum(map(len, appended[:-1]))}"/>'

    compressor = ' compressor="vtkZLibDataCompressor"' if is_compressed else ""
    text = f'<?xml version="1.0"?>\n<VTKFile type="{dataset}" version="0.1" byte_order="LittleEndian"{compressor}><{dataset}>'
    cells = "Polys" if dataset == "PolyData" else "Cells"
    text += f'<Piece NumberOfPoints="4" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOf{cells}="4"><PointData>'
    text += array("a", ("d", "Float64"), [1, 2.5, -1, 0]) + array("kind", ("q", "Int64"), [1, 2, 1, 7]) + "</PointData><Points>"
    text += array("Points", ("f", "Float32"), [x for p in POINTS for x in p], 3) + f"</Points><{cells}>"
    text += array("connectivity", ("i", "Int32"), [i for f in FACES for i in f]) + array("offsets", ("i", "Int32"), [3, 6, 9, 12])
    if dataset != "PolyData":
        text += array("types", ("B", "UInt8"), [5, 6, 7, 5])
    text = (text + f"</{cells}></Piece></{dataset}>").encode()
    if appended:
        text += f'<AppendedData encoding="{encoding}">_'.encode() + b"".join(appended) + b"</AppendedData>"
    return text + b"</VTKFile>"


DATA = {
    "curv": {"new": b"\xff\xff\xff" + struct.pack(">3i4f", 4, 4, 1, 1, 2.5, -1, 0), "old": b"\0\0\4\0\0\4" + struct.pack(">4h", 100, -5, 0, 7),
             "cut_short": b"\xff\xff\xff" + struct.pack(">3i3f", 4, 4, 1, 1, 2.5, -1)},
    "annot": {"old": annot(1), "new": annot(2), "cut_short": annot(2)[:-9]},
    "label": {"plain": "#!ascii label  , from subject me\n2\n3 1.0 2 3 0.5\n1 1 1 1 0\n", "outside": "2\n4 0 0 0 0\n"},
    "csv": {"plain": 'a,"b, c",d\r\n1,x,\n2.5,"y ""z""",NaN\n-1,,NA\n1e999,x,inf\n', "short": "a,b\n1,2\n3\n", "numbers": "1\n2\n3\n4\n5\n"},
    "func.gii": {kind: gifti_data("SHAPE", "FLOAT32", [1, 2.5, -1, 0], kind) for kind in ("ASCII", "Base64Binary", "GZipBase64Binary")},
    "label.gii": {"plain": gifti_data("LABEL", "INT32", [1, 2, 1, 7], "ASCII", '<Label Key="1" Red="1" Green="0" Blue="0.5" Alpha="1">one</Label>'
                                                                               '<Label Key="2">two &amp; two</Label>')},
    "ply": {"ascii": ply("ascii", "property uchar red\n"), "binary": ply("binary_little_endian", "property uchar kind\n"),
            "big": ply("binary_big_endian", "property char kind\n")},
    "vtk": {"text": vtk("ASCII"), "bytes": vtk("BINARY"), "text_5": vtk("ASCII", "5.1"), "bytes_5": vtk("BINARY", "5.1"),
            "cells": vtk("BINARY", dataset="UNSTRUCTURED_GRID"), "cells_text": vtk("ASCII", dataset="UNSTRUCTURED_GRID"), "cut_short": vtk("BINARY")[:-60]},
    "vtp": {"text": vtp("ascii"), "base64": vtp("binary"), "zlib": vtp("binary", True), "raw": vtp("appended", encoding="raw"),
            "raw_zlib": vtp("appended", True, "raw"), "appended": vtp("appended", True),
            "cells": vtp("binary", dataset="UnstructuredGrid"), "cut_short": vtp("appended", True, "raw")[:-80]},
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
    for target in ("read_meshes", "read_formats", "read_data", "read_indices"):
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
    for k, name in enumerate(DATA_FORMATS):
        for what, content in DATA[name].items():
            data = content if isinstance(content, bytes) else content.encode()
            (folder / "read_data" / f"{name}_{what}").write_bytes(bytes([k, 4]) + data)
    for what, content in INDICES.items():
        (folder / "read_indices" / what).write_bytes(content)


if __name__ == "__main__":
    main()
