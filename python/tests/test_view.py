# SPDX-License-Identifier: GPL-3.0-or-later
import base64
import json
import re

import numpy as np
import pytest
import spherical_parameterization as sp

needs_page = pytest.mark.skipif(not __import__("importlib").util.find_spec("spherical_parameterization._preparation"),
                                reason="the module under the GPL is not there")


@pytest.fixture
def ellipsoid():
    points, triangles = sp.icosphere(3)
    return points * [3, 2, 1], triangles


def parts(page):
    header = json.loads(re.search(r'id="header"[^>]*>(.*?)</script>', page.html, re.S).group(1))
    data = base64.b64decode(re.search(r'id="data"[^>]*>(.*?)</script>', page.html, re.S).group(1))
    return header, data


@needs_page
def test_the_page_holds_the_mesh_the_map_and_its_certificate(ellipsoid, tmp_path):
    points, triangles = ellipsoid
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


@needs_page
def test_a_given_map_is_shown_and_a_wrong_one_refused(ellipsoid):
    points, triangles = ellipsoid
    sphere = sp.icosphere(3)[0]
    header, _ = parts(sp.view(points, triangles, sphere))
    assert "method_used" not in header["report"]
    with pytest.raises(sp.MeshError):
        sp.view(points, triangles, sphere * [1, 1, -1])
    with pytest.raises(sp.MeshError):
        sp.view(points, triangles[1:])


def test_morph_keeps_the_ends_and_does_not_shrink_on_a_turn(ellipsoid):
    points, _ = ellipsoid
    turned = points[:, [1, 2, 0]]
    way = sp.morph(points, turned, 7)
    assert way.shape == (8, *points.shape)
    assert (way[0] == points).all() and (way[-1] == turned).all()
    size = np.linalg.norm(points, axis=1)
    assert max(abs(np.linalg.norm(shape, axis=1) - size).max() for shape in way) < 1e-12
    for wrong in (lambda: sp.morph(points, points[1:]), lambda: sp.morph(points, turned, 0),
                  lambda: sp.morph(points, points * np.nan), lambda: sp.morph(points[:0], points[:0])):
        with pytest.raises(ValueError):
            wrong()
