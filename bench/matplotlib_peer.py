# SPDX-License-Identifier: Apache-2.0
"""Draws the standard scene with Matplotlib's mplot3d, and writes a film with its FFMpegWriter.

    matplotlib_peer.py film.mp4 FRAMES
"""
import sys

import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.animation import FFMpegWriter
from matplotlib.colors import LightSource
from matplotlib.patches import FancyArrowPatch
from mpl_toolkits.mplot3d import proj3d
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from peer_motion import (HEIGHT, L, PLANE_DISTANCE, PLANE_HALF, SEMI_AXES, VECTOR_L_SCALE, WIDTH, frame_times,
                         herpolhode_until, polhode_B, states)

BLUE, AMBER, NAVY, PURPLE, GREEN, RED = ((.25, .45, .75), (1, .6, .2), (.1, .15, .6), (.55, .1, .6), (.05, .55, .15),
                                         (.8, .08, .08))
DPI = 100
BOX_FACES = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
TO_LIGHT = np.array([.6, -.6, .55])


class Arrow(FancyArrowPatch):
    def __init__(self, vector, colour):
        super().__init__((0, 0), (0, 0), mutation_scale=28, shrinkA=0, shrinkB=0, lw=6, arrowstyle='-|>', color=colour)
        self.vector = np.asarray(vector)

    def do_3d_projection(self, renderer=None):
        x, y, z = proj3d.proj_transform(*np.c_[np.zeros(3), self.vector], self.axes.M)
        self.set_positions((x[0], y[0]), (x[1], y[1]))
        return min(z)


def ellipsoid_points():
    """Returns a grid of points, as fine as in vtk_peer.py."""
    u, v = np.meshgrid(np.linspace(0, 2 * np.pi, 129), np.linspace(0, np.pi, 65))
    return np.stack([SEMI_AXES[0] * np.cos(u) * np.sin(v), SEMI_AXES[1] * np.sin(u) * np.sin(v),
                     SEMI_AXES[2] * np.cos(v)], -1)


def box_corners():
    signs = (-1, 1)
    return np.array([[x, y, z] for x in signs for y in signs for z in signs]) * [1.2, .85, .12]


class Scene:
    def __init__(self):
        self.figure = plt.figure(figsize=(WIDTH / DPI, HEIGHT / DPI), dpi=DPI)
        self.axes = self.new_axes()
        self.add_plane()
        self.axes.add_artist(Arrow([0, 0, -VECTOR_L_SCALE * L], GREEN))
        self.axes.text(.15, .15, -VECTOR_L_SCALE * L, '$L$', size=36, color=GREEN)
        self.omega = self.axes.add_artist(Arrow([0, 0, 1], RED))
        self.polhode, = self.axes.plot([], [], [], lw=4, color=NAVY)
        self.herpolhode, = self.axes.plot([], [], [], lw=4, color=PURPLE)
        self.ellipsoid_B, self.box_B = ellipsoid_points(), box_corners()
        self.of_this_frame = []

    def new_axes(self):
        axes = self.figure.add_axes([-.25, -.3, 1.5, 1.6], projection='3d', computed_zorder=True)
        axes.set_proj_type('persp', focal_length=1.6)
        axes.view_init(21, -41.6)
        axes.set_axis_off()
        span = (-PLANE_HALF, PLANE_HALF)
        axes.set(xlim=span, ylim=span, zlim=span)
        axes.set_box_aspect((1, 1, 1))
        return axes

    def add_plane(self):
        ticks = np.linspace(-PLANE_HALF, PLANE_HALF, 13)
        x, y = np.meshgrid(ticks, ticks)
        self.axes.plot_surface(x, y, 0 * x - PLANE_DISTANCE, color=(.75, .78, .8, .35), edgecolor=(.3, .3, .35), lw=.8,
                               rstride=1, cstride=1, shade=False)

    def draw(self, time_s):
        _, (rotation_WB,), (omega_W,) = states(time_s)
        while self.of_this_frame:
            self.of_this_frame.pop().remove()
        self.of_this_frame = [self.ellipsoid(rotation_WB), self.box(rotation_WB),
                              self.axes.text(*(omega_W + [.15, .15, 0]), r'$\omega$', size=36, color=RED)]
        self.omega.vector = omega_W
        self.polhode.set_data_3d(*(polhode_B @ rotation_WB.T).T)
        self.herpolhode.set_data_3d(*herpolhode_until(time_s).T)

    def ellipsoid(self, rotation_WB):
        x, y, z = np.moveaxis(self.ellipsoid_B @ rotation_WB.T, -1, 0)
        return self.axes.plot_surface(x, y, z, color=(*AMBER, .35), lw=0, rstride=1, cstride=1,
                                      lightsource=LightSource(-45, 45), antialiased=False)

    def box(self, rotation_WB):
        corners = self.box_B @ rotation_WB.T
        normals = np.array([np.cross(corners[b] - corners[a], corners[c] - corners[a]) for a, b, c, _ in BOX_FACES])
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        light = .45 + .55 * np.clip(normals @ TO_LIGHT, 0, 1)
        return self.axes.add_collection3d(Poly3DCollection([corners[face] for face in BOX_FACES],
                                                           facecolors=np.outer(light, BLUE)))


def film(output, frames):
    scene = Scene()
    writer = FFMpegWriter(fps=30, codec='libx264',
                          extra_args=['-crf', '18', '-preset', 'medium', '-pix_fmt', 'yuv420p'])
    with writer.saving(scene.figure, output, DPI):
        for time_s in frame_times(frames):
            scene.draw(time_s)
            writer.grab_frame()


if __name__ == '__main__':
    film(sys.argv[1], int(sys.argv[2]))
