# SPDX-License-Identifier: Apache-2.0
"""Tests of a package that draws with Matplotlib and PIL. POINSOT_FAULT plants a fault in the pictures."""

import os

import matplotlib.pyplot as plt
import numpy as np
import pytest
from PIL import Image, ImageDraw

FAULTS = os.environ.get("POINSOT_FAULT", "").split(",")


@pytest.mark.golden
def test_wave():
    figure, axes = plt.subplots(figsize=(4, 3))
    x = np.linspace(0, 6, 60)
    axes.plot(x, np.sin(x), color="tab:orange" if "colour" in FAULTS else "tab:blue")
    axes.set_title("Vave" if "title" in FAULTS else "Wave")
    return figure


@pytest.mark.golden(ignore=[(0, 0, 200, 20)], reason="the date is printed at the top")
def test_picture_with_a_date():
    picture = Image.new("RGB", (200, 100), "white")
    draw = ImageDraw.Draw(picture)
    draw.text((5, 3), os.environ.get("POINSOT_DATE", "today"), fill="black")
    draw.ellipse((60, 30, 140, 92 if "ellipse" in FAULTS else 90), fill="navy")
    return picture


@pytest.mark.parametrize("level", [40, 200])
def test_arrays(golden, level):
    shift = 1 if "level" in FAULTS else 0
    golden(np.full((30, 40, 3), level + shift, np.uint8), name="colour", rule="same")
    golden(np.full((30, 40), level, np.uint16), name="grey")
