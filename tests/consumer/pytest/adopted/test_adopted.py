# SPDX-License-Identifier: Apache-2.0
"""Tests that were written for pytest-mpl."""

import os

import matplotlib.pyplot as plt
import pytest

FAULT = os.environ.get("POINSOT_FAULT", "")


def line(slope):
    figure, axes = plt.subplots(figsize=(4, 3))
    axes.plot([0, 1], [0, slope])
    return figure


@pytest.mark.mpl_image_compare
def test_line():
    return line(3 if FAULT == "slope" else 2)


@pytest.mark.mpl_image_compare(baseline_dir="pictures", filename="steep.png", tolerance=5, style="default", savefig_kwargs={"dpi": 60})
def test_steep():
    return line({"slight": 4.1, "slighter": 4.01}.get(FAULT, 4))


@pytest.mark.mpl_image_compare(remove_text=True)
@pytest.mark.parametrize("slope", [1, -1])
def test_slopes(slope):
    return line(slope)
