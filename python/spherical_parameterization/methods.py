# SPDX-License-Identifier: LGPL-3.0-or-later
"""Methods and weights with their options and defaults."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Union

from .arrays import check, one_of


class _Options:
    def __post_init__(self) -> None:
        for kind in type(self).__mro__:
            if "__annotations__" in vars(kind):
                check(kind, vars(self))


@dataclass(frozen=True)
class Automatic(_Options):
    """Tries `Balanced`, then `Isometric`, and returns the first map that is valid and usable.

    Parameters
    ----------
    spring_exponent : float
        Exponent of the first method, see `Balanced`.
    area_exponent : float, optional
        Exponent of the second method, see `Isometric`.
    largest_shrinkage : float
        A valid map is not usable if lengths shrink by more than this factor, relative to the mean of the map, on more than a
        thousandth of the surface. Infinite: every valid map is usable.

    Notes
    -----
    With the argument `density` of `parameterize()` only `Isometric` is tried: harmonic maps do not follow densities.

    If no map is valid and usable, the best one is returned: a valid map, else one of degree 1 with the fewest flipped faces.
    """

    spring_exponent: float = 2
    area_exponent: float | None = None
    largest_shrinkage: float = 1e4


@dataclass(frozen=True)
class Balanced(_Options):
    """Moebius-centred harmonic maps, the fast method.

    Parameters
    ----------
    spring_exponent : float
        Exponent of the spring energy, 2 or more. Larger exponents equalize areas at the cost of angles.

    Notes
    -----
    `accuracy` bounds the residual (default 2e-9), `iterations` the descent steps (default 500).
    """

    spring_exponent: float = 2


@dataclass(frozen=True)
class Isometric(_Options):
    """Maps of low symmetric Dirichlet energy, bijective in every step. Weights are not used.

    Parameters
    ----------
    area_exponent : float, optional
        0 preserves angles, 1 lengths, 30 or more areas. Default: 1, with the argument `density` of `parameterize()` 10.
    landmark_weight : float
        Infinite: fixed vertices stay exactly at their positions. Finite and positive: they are pulled there. This weight
        times the mean of their squared distances is added to the mean distortion (4 is isometric).

    Notes
    -----
    `accuracy` is the relative gain of energy at which to stop (default 5e-4), `iterations` bounds the Newton steps
    for the whole mesh (default 20).
    """

    area_exponent: float | None = None
    landmark_weight: float = math.inf


@dataclass(frozen=True)
class SaddlePoint(_Options):
    """The published method (Athanasiadis and Fudos, SMI 2011). It converges only with fixed vertices or a good start.

    Parameters
    ----------
    splitting : {"jacobi", "gauss-seidel"}
        The splitting of the Laplacian for the sweeps.
    start : {"centroid", "harmonic", "given"}
        The start map; "given" needs the argument `start` of `parameterize()`.
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
        super().__post_init__()
        one_of("splitting", self.splitting, "jacobi", "gauss-seidel")
        one_of("start", self.start, "centroid", "harmonic", "given")


@dataclass(frozen=True)
class ClampedWeights(_Options):
    """Cotangent weights with other bounds than those of `weights="clamped"`.

    Parameters
    ----------
    minimum_angle, maximum_angle : float
        Bounds of the angles, in degrees, in (0, 90).
    """

    minimum_angle: float = 5
    maximum_angle: float = 85


@dataclass(frozen=True)
class _SegmentLimits(_Options):
    minimum_area: float = 0.01
    number_of_segments: int = 0


@dataclass(frozen=True)
class MajorityVote(_SegmentLimits):
    """Segmentation by a vote of girth profiles, four segmentations along creases, and one by the light inside. The default.

    Parameters
    ----------
    minimum_area : float
        Segments smaller than this share of the whole area, in [0, 1], are merged with a neighbour.
    number_of_segments : int
        0: the method chooses; otherwise the least convincing cuts are left out until there are this many segments.
    """


@dataclass(frozen=True)
class GirthProfiles(_SegmentLimits):
    """Segmentation by girth profiles alone: cuts limbs off. Parameters as for `MajorityVote`."""


@dataclass(frozen=True)
class RegionGrowing(_SegmentLimits):
    """The published segmentation: region growing over the stretch. Parameters as for `MajorityVote`, and one more.

    Parameters
    ----------
    threshold : float
        By how much the logarithmic stretch of a region may differ from that of its seed.
    """

    threshold: float = 1


Method = Union[str, Automatic, Balanced, Isometric, SaddlePoint]
METHODS = {"automatic": Automatic, "balanced": Balanced, "isometric": Isometric, "saddle-point": SaddlePoint}
Segmentation = Union[str, MajorityVote, GirthProfiles, RegionGrowing]
SEGMENTATIONS = {"majority-vote": MajorityVote, "girth-profiles": GirthProfiles, "region-growing": RegionGrowing}
