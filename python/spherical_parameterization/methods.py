# SPDX-License-Identifier: LGPL-3.0-or-later
"""Methods and weights with their options; the values that are there are the defaults."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Union


def one_of(option: str, value: str, *allowed: str) -> None:
    """Raises ValueError for a word that is not among the allowed ones."""
    if value not in allowed:
        raise ValueError(f"{option} {value!r}: one of {', '.join(map(repr, allowed))} is needed")


@dataclass(frozen=True)
class Automatic:
    """The first valid map of `Balanced`, `Balanced` with a larger exponent, and `Isometric`.

    Parameters
    ----------
    spring_exponent : float
        Of the first map, see `Balanced`.
    larger_spring_exponent : float
        Of the second map.
    area_exponent : float
        Of the third map, see `Isometric`.

    Notes
    -----
    If none is valid, the best one is returned: of degree 1 before others, then with the fewest flipped faces.
    """

    spring_exponent: float = 2
    larger_spring_exponent: float = 3
    area_exponent: float = 1


@dataclass(frozen=True)
class Balanced:
    """Moebius-centred harmonic maps, the fast method.

    Parameters
    ----------
    spring_exponent : float
        Exponent of the spring energy, 2 or more. Larger ones equalize areas at the cost of angles.

    Notes
    -----
    `accuracy` bounds the residual (default 5e-9), `iterations` the descent steps (default 500).
    """

    spring_exponent: float = 2


@dataclass(frozen=True)
class Isometric:
    """Maps of low symmetric Dirichlet energy, bijective in every step. Weights are not used.

    Parameters
    ----------
    area_exponent : float
        0 preserves angles, 1 lengths, 30 or more areas.
    landmark_weight : float
        Infinite: fixed vertices stay exactly where they are put. Finite and positive: they are only pulled there, by
        this weight times the mean of their squared distances, added to the mean distortion (4 = isometric).

    Notes
    -----
    `accuracy` is the relative gain of energy at which to stop (default 5e-4), `iterations` bounds the Newton steps
    for the whole mesh (default 20).
    """

    area_exponent: float = 1
    landmark_weight: float = math.inf


@dataclass(frozen=True)
class SaddlePoint:
    """The published method (Athanasiadis and Fudos, SMI 2011); converges with fixed vertices or a good start only.

    Parameters
    ----------
    splitting : {"jacobi", "gauss-seidel"}
        The splitting of the Laplacian for the sweeps.
    start : {"centroid", "harmonic", "given"}
        Where to start; "given" needs the argument `start` of `parameterize()`.
    relaxation : float
        In (0, 1), with "gauss-seidel" in (0, 2).
    check_interval : int
        Sweeps between two tests for convergence.
    """

    splitting: str = "jacobi"
    start: str = "centroid"
    relaxation: float = 0.95
    check_interval: int = 1000

    def __post_init__(self) -> None:
        one_of("splitting", self.splitting, "jacobi", "gauss-seidel")
        one_of("start", self.start, "centroid", "harmonic", "given")


@dataclass(frozen=True)
class ConformalWeights:
    """Cotangent weights with other bounds than those of `weights="conformal"`.

    Parameters
    ----------
    minimum_angle, maximum_angle : float
        What angles are clamped to, degrees in (0, 90).
    """

    minimum_angle: float = 5
    maximum_angle: float = 85


@dataclass(frozen=True)
class MajorityVote:
    """Segmentation by girth profiles and four concavity segmentations, which vote. The default.

    Parameters
    ----------
    minimum_area : float
        Segments smaller than this share of the whole area, in [0, 1], are given to a neighbour.
    number_of_segments : int
        0: the method chooses; otherwise the least convincing cuts are left out until there are so many.
    """

    minimum_area: float = 0.01
    number_of_segments: int = 0


@dataclass(frozen=True)
class GirthProfiles:
    """Segmentation by girth profiles alone: cuts limbs off. Parameters as for `MajorityVote`."""

    minimum_area: float = 0.01
    number_of_segments: int = 0


@dataclass(frozen=True)
class RegionGrowing:
    """The published segmentation: region growing over the stretch.

    Parameters
    ----------
    minimum_area, number_of_segments
        As for `MajorityVote`.
    threshold : float
        By how much the logarithmic stretch of a region may differ from that of its seed.
    """

    minimum_area: float = 0.01
    number_of_segments: int = 0
    threshold: float = 1


Method = Union[Automatic, Balanced, Isometric, SaddlePoint]
Segmentation = Union[MajorityVote, GirthProfiles, RegionGrowing]
