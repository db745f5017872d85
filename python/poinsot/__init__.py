# SPDX-License-Identifier: Apache-2.0
"""Rotating rigid bodies: exact motion as arrays, pictures and films.

    import poinsot

    scene = poinsot.load("scenes/tennis_racket.toml")
    scene                                    # in a notebook: its picture
    motion = scene.trajectory([0, 1.5, 1e6]) # exact at any time
    motion.omega_B                           # array of shape (3, 3), rad/s
    scene.render(2.0)                        # uint8 array (1080, 1920, 3)
    scene.film("racket.mp4")

A scene is the input of `poinsot render`; poinsot.loads() accepts it as text or as a dictionary. Quantities are in SI
units and radians. Suffixes name the axes of components: B for the body's axes, as the scene describes the body, and W
for inertial axes. R_WB and q_WB take components in B to components in W.
"""

from ._core import version as __version__
from ._diff import diff
from ._errors import (
    Error,
    FarTimeWarning,
    FileError,
    LimitError,
    PhysicsError,
    Problem,
    RenderError,
    SceneError,
    UsageError,
)
from ._explain import explain
from ._film import Film
from ._packages import MissingPackageError
from ._scene import Scene, load, loads
from ._trajectory import Trajectory

__all__ = [
    "Error",
    "FarTimeWarning",
    "FileError",
    "Film",
    "LimitError",
    "MissingPackageError",
    "PhysicsError",
    "Problem",
    "RenderError",
    "Scene",
    "SceneError",
    "Trajectory",
    "UsageError",
    "__version__",
    "diff",
    "explain",
    "load",
    "loads",
]
