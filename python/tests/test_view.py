# SPDX-License-Identifier: GPL-3.0-or-later
import base64
import importlib.util
import json
import re

import numpy as np
import pytest
import spherical_parameterization as sp
from conftest import ellipsoid

if not importlib.util.find_spec("spherical_parameterization._preparation"):
    pytest.skip("the module under the GPL is not there", allow_module_level=True)


def parts(page):
    header = json.loads(re.search(r'id="header"[^>]*>(.*?)</script>', page.html, re.S).group(1))
    data = base64.b64decode(re.search(r'id="data"[^>]*>(.*?)</script>', page.html, re.S).group(1))
    return header, data


def test_the_page_holds_the_mesh_the_map_and_its_certificate(tmp_path):
    points, triangles = ellipsoid(3)
    page = sp.view(points, triangles, name="an <ellipsoid>")
    header, data = parts(page)
    assert header["report"]["input"] == "an <ellipsoid>"
    assert header["report"]["flipped_faces"] == 0 and header["report"]["degree"] == 1
    n, m = len(points), len(triangles)
    assert len(data) == 2 * 6 * n + 2 * 3 * m + 3 * 3 * m
    steps = np.frombuffer(data[: 6 * n], "<u2").reshape(3, n)
    low, step = np.array(header["coordinates"][:3]).T
    assert abs(low + step * steps.T - points).max() < 1e-4
    page.save(tmp_path / "page.html")
    assert (tmp_path / "page.html").read_text(encoding="utf-8") == page.html
    assert "srcdoc" in page._repr_html_()


def test_a_given_map_is_shown_and_a_wrong_one_refused():
    points, triangles = ellipsoid(3)
    sphere = sp.icosphere(3)[0]
    header, _ = parts(sp.view(points, triangles, sphere))
    assert "method_used" not in header["report"]
    with pytest.raises(sp.MeshError):
        sp.view(points, triangles, sphere * [1, 1, -1])
    with pytest.raises(sp.MeshError):
        sp.view(points, triangles[1:])
