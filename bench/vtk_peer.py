# SPDX-License-Identifier: Apache-2.0
"""Draws the standard scene with VTK, under an X server (xvfb-run -s '-screen 0 1920x1080x24').

    vtk_peer.py OUTPUT FRAMES SMOOTHING

OUTPUT: film.mp4, or a folder for PNG. SMOOTHING: msaablend is 4x MSAA with blending in a fixed order, which is
comparable to poinsot; peel is depth peeling with FXAA, the usual advice for translucent surfaces.
"""
import pathlib
import subprocess
import sys

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from peer_motion import (HEIGHT, L, PLANE_DISTANCE, PLANE_HALF, SEMI_AXES, VECTOR_L_SCALE, WIDTH, frame_times,
                         herpolhode_until, polhode_B, states)

BLUE, AMBER, NAVY, PURPLE, GREEN, RED = ((.25, .45, .75), (1, .6, .2), (.1, .15, .6), (.55, .1, .6), (.05, .55, .15),
                                         (.8, .08, .08))
TUBE_RADIUS = .022


def new_window(renderer, peel):
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(WIDTH, HEIGHT)
    window.SetMultiSamples(0 if peel else 4)
    window.AddRenderer(renderer)
    renderer.SetBackground(1, 1, 1)
    if peel:
        window.SetAlphaBitPlanes(1)
        renderer.SetUseDepthPeeling(1)
        renderer.SetMaximumNumberOfPeels(6)
        renderer.SetOcclusionRatio(0.0)
        renderer.SetUseFXAA(True)
    else:  # VTK's default, a weighted-blended pass, drops MSAA on translucent actors
        renderer.SetPass(vtk.vtkRenderStepsPass())
    return window


def set_camera(renderer):
    camera = renderer.GetActiveCamera()
    camera.SetPosition(9, -8, 4.5)
    camera.SetFocalPoint(0, 0, -.7)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(36)
    camera.SetClippingRange(1, 40)


def add_actor(renderer, source, colour, opacity=1.0, smooth=True):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(colour)
    look.SetOpacity(opacity)
    look.SetAmbient(.15)
    look.SetDiffuse(.8)
    look.SetSpecular(.3)
    look.SetSpecularPower(40)
    look.SetInterpolationToPhong() if smooth else look.SetInterpolationToFlat()
    renderer.AddActor(actor)
    return actor


class Tube:
    def __init__(self, renderer, points, colour):
        self.line = vtk.vtkPolyData()
        self.set_points(points)
        producer = vtk.vtkTrivialProducer()
        producer.SetOutput(self.line)
        tube = vtk.vtkTubeFilter()
        tube.SetInputConnection(producer.GetOutputPort())
        tube.SetRadius(TUBE_RADIUS)
        tube.SetNumberOfSides(12)
        tube.CappingOn()
        self.actor = add_actor(renderer, tube, colour)

    def set_points(self, points):
        coordinates, cells = vtk.vtkPoints(), vtk.vtkCellArray()
        coordinates.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=1))
        cells.InsertNextCell(len(points))
        for i in range(len(points)):
            cells.InsertCellPoint(i)
        self.line.SetPoints(coordinates)
        self.line.SetLines(cells)
        self.line.Modified()


class Arrow:
    """Arrow from the origin with a label at its tip."""

    def __init__(self, renderer, colour, text, font):
        source = vtk.vtkArrowSource()
        source.SetShaftResolution(32)
        source.SetTipResolution(32)
        source.SetTipLength(.16)
        source.SetTipRadius(.055)
        source.SetShaftRadius(.02)
        self.actor = add_actor(renderer, source, colour)
        self.label = vtk.vtkBillboardTextActor3D()
        self.label.SetInput(text)
        type_ = self.label.GetTextProperty()
        type_.SetFontSize(48)
        type_.SetColor(colour)
        type_.SetFontFamily(vtk.VTK_FONT_FILE)
        type_.SetFontFile(font)
        renderer.AddActor(self.label)

    def set_vector(self, vector):
        length = np.linalg.norm(vector)
        x = vector / length
        y = np.cross([0, 1, 0] if abs(x[1]) < .9 else [1, 0, 0], x)
        y /= np.linalg.norm(y)
        self.actor.SetUserMatrix(matrix(np.column_stack([x * length, y * 2.5, np.cross(x, y) * 2.5])))
        self.label.SetPosition(*(vector + [.15, .15, 0]))


def matrix(rotation):
    whole = np.eye(4)
    whole[:3, :3] = rotation
    result = vtk.vtkMatrix4x4()
    result.DeepCopy(whole.ravel())
    return result


def plane_source(cells=1):
    plane = vtk.vtkPlaneSource()
    plane.SetResolution(cells, cells)
    plane.SetOrigin(-PLANE_HALF, -PLANE_HALF, -PLANE_DISTANCE)
    plane.SetPoint1(PLANE_HALF, -PLANE_HALF, -PLANE_DISTANCE)
    plane.SetPoint2(-PLANE_HALF, PLANE_HALF, -PLANE_DISTANCE)
    return plane


def ellipsoid_source():
    ellipsoid = vtk.vtkParametricEllipsoid()
    ellipsoid.SetXRadius(SEMI_AXES[0])
    ellipsoid.SetYRadius(SEMI_AXES[1])
    ellipsoid.SetZRadius(SEMI_AXES[2])
    source = vtk.vtkParametricFunctionSource()
    source.SetParametricFunction(ellipsoid)
    source.SetUResolution(128)
    source.SetVResolution(64)
    return source


def box_source():
    box = vtk.vtkCubeSource()
    box.SetXLength(2.4)
    box.SetYLength(1.7)
    box.SetZLength(.24)
    return box


class Scene:
    def __init__(self, peel):
        self.renderer = vtk.vtkRenderer()
        self.window = new_window(self.renderer, peel)
        font = subprocess.run(['fc-match', '-f', '%{file}', 'DejaVu Sans:bold'], capture_output=True, text=True,
                              check=True).stdout
        self.moving = [add_actor(self.renderer, box_source(), BLUE, smooth=False),
                       Tube(self.renderer, polhode_B, NAVY).actor]
        add_actor(self.renderer, plane_source(), (.55, .6, .65), .35).GetProperty().SetAmbient(.6)
        self.add_ellipsoid(peel)
        self.add_grid()
        self.omega = Arrow(self.renderer, RED, '\u03c9', font)
        Arrow(self.renderer, GREEN, 'L', font).set_vector(np.array([0, 0, -VECTOR_L_SCALE * L]))
        self.herpolhode = Tube(self.renderer, herpolhode_until(0), PURPLE)
        set_camera(self.renderer)

    def add_ellipsoid(self, peel):
        source = ellipsoid_source()
        if peel:
            self.moving.append(add_actor(self.renderer, source, AMBER, .35))
            return
        # Without peeling, actors blend in the order in which they are added: plane, back faces, front faces.
        back, front = (add_actor(self.renderer, source, AMBER, .35) for _ in range(2))
        back.GetProperty().FrontfaceCullingOn()
        front.GetProperty().BackfaceCullingOn()
        self.moving += [back, front]

    def add_grid(self):
        look = add_actor(self.renderer, plane_source(12), (.3, .3, .35)).GetProperty()
        look.SetRepresentationToWireframe()
        look.LightingOff()
        look.SetLineWidth(1.5)

    def draw(self, time_s):
        _, (rotation_WB,), (omega_W,) = states(time_s)
        for actor in self.moving:
            actor.SetUserMatrix(matrix(rotation_WB))
        self.omega.set_vector(omega_W)
        self.herpolhode.set_points(herpolhode_until(time_s))
        self.window.Render()


def film(scene, times_s, output):
    encoder = subprocess.Popen(
        ['ffmpeg', '-y', '-loglevel', 'error', '-f', 'rawvideo', '-pix_fmt', 'rgb24', '-s', f'{WIDTH}x{HEIGHT}',
         '-r', '30', '-i', '-', '-c:v', 'libx264', '-crf', '18', '-preset', 'medium', '-pix_fmt', 'yuv420p', output],
        stdin=subprocess.PIPE)
    pixels = vtk.vtkUnsignedCharArray()
    for time_s in times_s:
        scene.draw(time_s)
        scene.window.GetPixelData(0, 0, WIDTH - 1, HEIGHT - 1, 0, pixels, 0)
        encoder.stdin.write(vtk_to_numpy(pixels).reshape(HEIGHT, WIDTH, 3)[::-1].tobytes())
    encoder.stdin.close()
    return encoder.wait()


def pictures(scene, times_s, folder):
    image, writer = vtk.vtkWindowToImageFilter(), vtk.vtkPNGWriter()
    image.SetInput(scene.window)
    image.ReadFrontBufferOff()
    image.SetInputBufferTypeToRGB()
    image.ShouldRerenderOff()
    writer.SetInputConnection(image.GetOutputPort())
    for number, time_s in enumerate(times_s):
        scene.draw(time_s)
        image.Modified()
        writer.SetFileName(f'{folder}/frame_{number:05}.png')
        writer.Write()
    return 0


if __name__ == '__main__':
    output, frames, smoothing = sys.argv[1:]
    make = pictures if pathlib.Path(output).is_dir() else film
    sys.exit(make(Scene(smoothing == 'peel'), frame_times(int(frames)), output))
