# SPDX-License-Identifier: BSD-3-Clause
"""Shows the folder of a run in ParaView: the particles where the load has moved them, coloured by von Mises stress, each as large
as its share of the body; the grid, as the load has warped it; time and lengths.

In ParaView: Macros > Import new macro; open any file of the folder (particles.e, or the first of spread files), press the macro.
Without a window:

    pvpython paraview_macro.py FOLDER [PICTURE.png]

Y points downwards, as image viewers show the image.
"""
import glob
import math
import os
import re
import sys

from paraview import simple

BOXES_UP_TO = 300000  # particles; more are drawn as discs, which take less time and memory
QUANTITY, UNIT = "von_mises", "Pa"


def open_fields(folder, name):
    """The fields of particles or grid: `name`.e, the first of the files name.e.N.r, or name.hdf.series; None without any.
    Moved by the displacement."""
    for pattern in (f"{name}.e", f"{name}.e.*.*", f"{name}.hdf.series"):
        files = sorted(glob.glob(os.path.join(glob.escape(folder), pattern)))
        if not files:
            continue
        reader = simple.OpenDataFile(files[0])
        reader.UpdatePipelineInformation()
        if not pattern.endswith(".series"):
            reader.ApplyDisplacements = 1
            return reader
        warped = simple.WarpByVector(Input=reader)
        warped.Vectors = ["POINTS", "displacement"]
        return warped
    return None


def times_of(source):
    """Those of the file behind a filter."""
    while hasattr(source, "Input"):
        source = source.Input
    return list(source.TimestepValues)


def lengths(bounds):
    return [bounds[2 * d + 1] - bounds[2 * d] for d in range(3)]


def text_of(folder, name):
    try:
        with open(os.path.join(folder, name), encoding="utf-8") as file:
            return file.read()
    except OSError:
        return ""


def sides_of_share(folder, particles):
    """Sides [um] of the box of the undeformed body that a particle stands for: such as a voxel's."""
    voxel = re.search(r"voxels of (\S+) x (\S+) x (\S+) um", text_of(folder, "log.txt"))
    sides = [float(side) for side in voxel.groups()] if voxel else [1.0, 1.0, 1.0]
    volume = particles.PointData["volume"].GetRange(0)[1]
    share = (volume / math.prod(sides)) ** (1 / 3)
    return [share * side for side in sides]


def show_particles(folder, particles, view):
    at_points = particles
    if QUANTITY in particles.CellData.keys():  # of vertices, so that nothing is averaged
        at_points = simple.CellDatatoPointData(Input=particles)
        at_points.UpdatePipeline(view.ViewTime)
    are_boxes = particles.GetDataInformation().GetNumberOfPoints() <= BOXES_UP_TO
    strain = at_points.PointData["strain"]
    # An edge e of the share has the length |F e| = sqrt(1 + 2 E_ee) |e|.
    edges = [f"{side:g}*sqrt(1+2*strain_{strain.GetComponentName(d)})"
             for d, side in enumerate(sides_of_share(folder, at_points))]
    sized = simple.Calculator(Input=at_points, ResultArrayName="size")
    sized.Function = ("{}*iHat+{}*jHat+{}*kHat" if are_boxes else "sqrt(0.5)*max(max({},{}),{})").format(*edges)
    display = simple.Show(sized, view)
    if are_boxes:
        display.SetRepresentationType("3D Glyphs")
        display.GlyphType = "Box"
        display.Orient = 0
        display.Ambient, display.Diffuse = 0.5, 0.5  # colours near those of the bar
        display.Scaling = 1
        display.ScaleMode = "Vector Components"
        display.SelectScaleArray = "size"
        display.ScaleFactor = 1.0
    else:  # discs round the largest of their sides
        display.SetRepresentationType("Point Gaussian")
        display.ShaderPreset = "Plain circle"
        display.ScaleByArray = 1
        display.SetScaleArray = ["POINTS", "size"]
        display.UseScaleFunction = 0
        display.GaussianRadius = 1.0
    simple.ColorBy(display, ("POINTS", QUANTITY))
    display.RescaleTransferFunctionToDataRange(False)
    bar = simple.GetScalarBar(simple.GetColorTransferFunction(QUANTITY), view)
    bar.Title, bar.ComponentTitle = f"von Mises stress [{UNIT}]", ""
    display.SetScalarBarVisibility(view, True)
    return sized


def show_grid(grid, view):
    display = simple.Show(grid, view)
    display.SetRepresentationType("Wireframe")
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = [1.0, 1.0, 1.0]
    display.Opacity = 0.3


def show_time(folder, source, view):
    has_time = re.search(r'name="(Duration|Times) \[s\]"', text_of(folder, "deck.xml"))
    time = simple.AnnotateTimeFilter(Input=source)
    time.Format = "time {time:g} s" if has_time else "load {time:g}"
    simple.Show(time, view).WindowLocation = "Upper Left Corner"


def look(view, bounds):
    """From the side of the image's first plane, y downwards; straight at a slice."""
    size = lengths(bounds)
    centre = [0.5 * (bounds[2 * d] + bounds[2 * d + 1]) for d in range(3)]
    is_slice = 10 * size[2] < min(size[:2])
    direction = (0.0, 0.0, -1.0) if is_slice else (0.45, -0.35, -0.82)
    view.CameraParallelProjection = int(is_slice)
    view.CameraFocalPoint = centre
    view.CameraPosition = [centre[d] + 3 * max(size) * direction[d] for d in range(3)]
    view.CameraViewUp = [0.0, -1.0, 0.0]
    axes = view.AxesGrid
    axes.Visibility = 1
    axes.XTitle, axes.YTitle, axes.ZTitle = "x [um]", "y [um]", "z [um]"
    simple.ResetCamera(view)


def show_results(folder, view=None):
    """Shows a folder at its last step. Returns the particles, the grid (or None) and the view."""
    view = view or simple.GetActiveViewOrCreate("RenderView")
    particles, grid = open_fields(folder, "particles"), open_fields(folder, "grid")
    if particles is None:
        raise RuntimeError(f"no particles.e or particles.hdf.series in '{folder}'")
    simple.HideAll(view)
    scene = simple.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    last = scene.AnimationTime = view.ViewTime = times_of(particles)[-1]
    particles.UpdatePipeline(last)
    particles = show_particles(folder, particles, view)
    if grid is not None:
        show_grid(grid, view)
    show_time(folder, particles, view)
    look(view, particles.GetDataInformation().GetBounds())
    simple.SetActiveSource(particles)
    simple.Render(view)
    return particles, grid, view


def folder_of_active_source():
    source = simple.GetActiveSource()
    while source is not None and not hasattr(source, "FileName"):
        source = getattr(source, "Input", None)
    if source is None:
        raise RuntimeError("open a file of the run's folder first, or say: pvpython paraview_macro.py FOLDER")
    name = source.FileName
    return os.path.dirname(name if isinstance(name, str) else name[0])


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if not word.startswith("-")]
    is_named = bool(words) and os.path.isdir(words[0])
    shown = show_results(words[0] if is_named else folder_of_active_source())
    if is_named and len(words) > 1:
        shown[2].ViewSize = [1200, 900]
        simple.SaveScreenshot(words[1], shown[2])
