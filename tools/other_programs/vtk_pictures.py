#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws eleven typical pictures with VTK, to measure which pixels an OpenGL library moves.

    vtk_pictures.py FOLDER [--only NAME...]  draws the pictures into a folder, and prints the renderer
    vtk_pictures.py --compare ONE OTHER      prints how many pixels differ; exit code 1 if any does

Drawing needs VTK (Debian: python3-vtk9) and an X server, for example that of `xvfb-run -a`. Comparing needs neither.
"""

import argparse
import sys
from pathlib import Path

SIZE = (640, 480)


def _scene():
    """Returns a renderer with two lights and a background of two colours."""
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(0.10, 0.12, 0.20)
    renderer.SetBackground2(0.55, 0.60, 0.70)
    renderer.GradientBackgroundOn()
    return renderer


def _actor(source, **properties):
    """Returns an actor of a source. @param properties: such as Color=(1, 0, 0) for SetColor."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    for name, value in properties.items():
        getattr(actor.GetProperty(), f"Set{name}")(*(value if isinstance(value, tuple) else (value,)))
    return actor


def _ball(radius=1.0, centre=(0, 0, 0), resolution=40):
    source = vtk.vtkSphereSource()
    source.SetRadius(radius)
    source.SetCenter(*centre)
    source.SetThetaResolution(resolution)
    source.SetPhiResolution(resolution)
    return source


def _field():
    """Returns a volume of 8-bit samples of a smooth function."""
    wave = vtk.vtkRTAnalyticSource()
    wave.SetWholeExtent(-20, 20, -20, 20, -20, 20)
    cast = vtk.vtkImageShiftScale()
    cast.SetInputConnection(wave.GetOutputPort())
    cast.SetShift(-37)
    cast.SetScale(1.06)
    cast.SetOutputScalarTypeToUnsignedChar()
    cast.ClampOverflowOn()
    return cast


def _translucent(renderer):
    for index, colour in enumerate([(0.9, 0.3, 0.2), (0.2, 0.8, 0.3), (0.2, 0.4, 0.9)]):
        renderer.AddActor(_actor(_ball(0.8, (0.6 * index, 0.2 * index, 0)), Color=colour, Opacity=0.4))


def sphere(renderer):
    renderer.AddActor(_actor(_ball(), Color=(0.8, 0.5, 0.2), Specular=0.6, SpecularPower=30))


def sphere_without_msaa(renderer):
    sphere(renderer)
    return {"MultiSamples": 0}


def lines(renderer):
    outline = vtk.vtkOutlineSource()
    renderer.AddActor(_actor(outline, LineWidth=3, Color=(1, 0.9, 0.2)))
    spiral, points = vtk.vtkParametricFunctionSource(), vtk.vtkParametricConicSpiral()
    spiral.SetParametricFunction(points)
    edges = vtk.vtkExtractEdges()
    edges.SetInputConnection(spiral.GetOutputPort())
    actor = _actor(edges, LineWidth=1, Color=(0.9, 0.9, 1))
    actor.SetScale(0.2)
    renderer.AddActor(actor)


def text(renderer):
    for index, size in enumerate((10, 14, 20, 32)):
        label = vtk.vtkTextActor()
        label.SetInput(f"Torque-free rotation, {size} points")
        label.SetPosition(30, 60 + 80 * index)
        label.GetTextProperty().SetFontSize(size)
        renderer.AddActor(label)
    bar, table = vtk.vtkScalarBarActor(), vtk.vtkLookupTable()
    table.Build()
    bar.SetLookupTable(table)
    renderer.AddActor(bar)


def translucent(renderer):
    _translucent(renderer)


def depth_peeling(renderer):
    _translucent(renderer)
    renderer.UseDepthPeelingOn()
    renderer.SetMaximumNumberOfPeels(8)
    renderer.SetOcclusionRatio(0)
    return {"MultiSamples": 0, "AlphaBitPlanes": 1}


def volume(renderer):
    field, mapper = _field(), vtk.vtkOpenGLGPUVolumeRayCastMapper()
    mapper.SetInputConnection(field.GetOutputPort())
    mapper.SetAutoAdjustSampleDistances(False)
    mapper.SetSampleDistance(0.5)
    shown, opacity, colour = vtk.vtkVolume(), vtk.vtkPiecewiseFunction(), vtk.vtkColorTransferFunction()
    for value, alpha, rgb in ((0, 0, (0, 0, 0.5)), (120, 0.02, (0.1, 0.7, 0.5)), (255, 0.3, (1, 0.6, 0.1))):
        opacity.AddPoint(value, alpha)
        colour.AddRGBPoint(value, *rgb)
    shown.SetMapper(mapper)
    shown.GetProperty().SetScalarOpacity(opacity)
    shown.GetProperty().SetColor(colour)
    shown.GetProperty().SetInterpolationTypeToLinear()
    shown.GetProperty().ShadeOn()
    renderer.AddVolume(shown)


def points(renderer):
    cloud = _actor(_ball(1, (0, 0, 0), 30), PointSize=4, Color=(0.4, 0.9, 0.9), Representation=0)
    renderer.AddActor(cloud)
    balls = _actor(_ball(0.6, (1.5, 0, 0), 16), PointSize=9, Color=(0.9, 0.4, 0.6), Representation=0)
    balls.GetProperty().RenderPointsAsSpheresOn()
    renderer.AddActor(balls)


def wireframe(renderer):
    renderer.AddActor(_actor(_ball(1, (0, 0, 0), 24), Representation=1, Color=(0.9, 0.9, 0.5)))
    renderer.AddActor(_actor(_ball(0.7, (1.8, 0, 0), 16), EdgeVisibility=1, Color=(0.3, 0.5, 0.8)))


def contour(renderer):
    field, surface, mapper, actor = _field(), vtk.vtkContourFilter(), vtk.vtkPolyDataMapper(), vtk.vtkActor()
    surface.SetInputConnection(field.GetOutputPort())
    surface.GenerateValues(3, 110, 200)
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.SetScalarRange(90, 220)
    actor.SetMapper(mapper)
    actor.GetProperty().SetSpecular(0.4)
    renderer.AddActor(actor)


def texture(renderer):
    pattern, image, plane = vtk.vtkImageCanvasSource2D(), vtk.vtkTexture(), vtk.vtkPlaneSource()
    pattern.SetScalarTypeToUnsignedChar()
    pattern.SetNumberOfScalarComponents(3)
    pattern.SetExtent(0, 127, 0, 127, 0, 0)
    for square in range(64):
        column, row = square % 8 * 16, square // 8 * 16
        pattern.SetDrawColor(*((230, 200, 90) if (square + square // 8) % 2 else (30, 60, 4 * square)))
        pattern.FillBox(column, column + 15, row, row + 15)
    image.SetInputConnection(pattern.GetOutputPort())
    image.InterpolateOn()
    image.MipmapOn()
    image.RepeatOn()
    plane.SetOrigin(-3, -3, 0)
    plane.SetPoint1(3, -3, 0)
    plane.SetPoint2(-3, 3, 0)
    actor = _actor(plane)
    actor.SetTexture(image)
    actor.RotateX(-65)
    renderer.AddActor(actor)


PICTURES = (sphere, sphere_without_msaa, lines, text, translucent, depth_peeling, volume, points, wireframe, contour, texture)


def draw(picture, path):
    """Draws one picture and writes it as PPM. Returns the window."""
    renderer, window = _scene(), vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(*SIZE)
    for name, value in (picture(renderer) or {}).items():
        getattr(window, f"Set{name}")(value)
    window.AddRenderer(renderer)
    renderer.ResetCamera()
    renderer.GetActiveCamera().Azimuth(25)
    renderer.GetActiveCamera().Elevation(20)
    renderer.ResetCameraClippingRange()
    window.Render()
    grab, writer = vtk.vtkWindowToImageFilter(), vtk.vtkPNMWriter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()
    return window


def pixels(path):
    """Returns the pixels of a binary PPM, 3 bytes each."""
    return path.read_bytes().split(b"\n255\n", 1)[1]


def compare(one, other):
    """Prints a row for each picture: pixels that differ, and the largest difference of a channel. Returns their sum."""
    names = sorted(path.name for path in one.glob("*.ppm"))
    if not names or names != sorted(path.name for path in other.glob("*.ppm")):
        raise SystemExit(f"{one} and {other}: must contain the same pictures, at least one")
    moved = 0
    for name in names:
        a, b = pixels(one / name), pixels(other / name)
        steps = [max(abs(p - q) for p, q in zip(a[i:i + 3], b[i:i + 3])) for i in range(0, len(a), 3) if a[i:i + 3] != b[i:i + 3]]
        print(f"{name.removesuffix('.ppm'):20} {len(steps):7} pixels, largest difference {max(steps, default=0)}")
        moved += len(steps)
    print(f"{'all':20} {moved:7} pixels of {len(names) * SIZE[0] * SIZE[1]}")
    return moved


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--compare", action="store_true", help="compare two folders of pictures")
    parser.add_argument("--only", nargs="+", metavar="NAME", choices=[it.__name__ for it in PICTURES], help="draw only these pictures")
    parser.add_argument("folders", nargs="+", type=Path)
    asked = parser.parse_args()
    if len(asked.folders) != (2 if asked.compare else 1):
        parser.error("give one folder to draw into, or --compare and two folders")
    if asked.compare:
        return 1 if compare(*asked.folders) else 0
    global vtk
    import vtk
    asked.folders[0].mkdir(parents=True, exist_ok=True)
    # The windows stay open, because an X server may restart when its last window closes.
    windows = [draw(picture, asked.folders[0] / f"{picture.__name__}.ppm") for picture in PICTURES
               if not asked.only or picture.__name__ in asked.only]
    print("\n".join(line for line in windows[-1].ReportCapabilities().splitlines() if line.startswith("OpenGL") and "extensions" not in line))
    return 0


if __name__ == "__main__":
    sys.exit(main())
