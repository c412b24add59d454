# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws compactness, generalization and specificity, which `atlas` has written: model_quality.py ATLAS/quality.csv OUT.png"""

import sys

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

table = np.genfromtxt(sys.argv[1], delimiter=",", names=True)
figure, axes = plt.subplots(1, 3, figsize=(10, 3), layout="constrained")
for axis, name in zip(axes, ("compactness", "generalization", "specificity")):
    error = 2 * table["specificity_error"] if name == "specificity" else None  # 95 % of a normal distribution
    axis.errorbar(table["modes"], table[name], error, marker=".", capsize=2)
    axis.set(title=name, xlabel="modes", ylim=(0, None))
    axis.xaxis.get_major_locator().set_params(integer=True)
figure.savefig(sys.argv[2], dpi=120)
