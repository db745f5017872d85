#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Draws a body's stability map: the time between two flips for each direction of L in the body, with the separatrix.

Needs python3-matplotlib. Writes stability_map.png, or the file that you name.
"""

import sys

import matplotlib
import numpy as np

import poinsot

matplotlib.use("Agg")
from matplotlib import colors, pyplot  # noqa: E402

SCENE = {"body": {"principal_moments": [1, 2, 2.5]}, "motion": {"omega_body": [0.05, 2, 0]}}


def main():
    map = poinsot.loads(SCENE).sweep_map()
    scale = map["scale"]
    norm = (colors.LogNorm if scale["logarithmic"] else colors.Normalize)(scale["least"], scale["most"])
    figure, axes = pyplot.subplots(figsize=(7, 4))
    times = np.minimum(map["flip_interval"], scale["most"])  # infinite on the separatrix
    mesh = axes.pcolormesh(map["phi"], map["theta"], times, norm=norm, cmap="magma", shading="gouraud")
    for x, y, z in np.moveaxis(map["separatrix_P"], -1, 1):
        axes.plot(np.arctan2(y, x) % (2 * np.pi), np.arccos(z), ".", color="white", markersize=1)
    axes.plot(map["scene"]["phi"], map["scene"]["theta"], "o", color="tab:red")
    axes.invert_yaxis()
    axes.set(xlabel=map["labels"]["phi"], ylabel=map["labels"]["theta"])
    figure.colorbar(mesh, label=map["labels"]["flip_interval"])
    figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "stability_map.png", dpi=150)


if __name__ == "__main__":
    main()
