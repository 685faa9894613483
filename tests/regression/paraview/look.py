# SPDX-License-Identifier: BSD-3-Clause
"""Run by pvpython: opens folders by the macro of the docs, and finds in ParaView's data what history.csv says; draws pictures, and
finds holes in them. See check_paraview.py.

    look.py MACRO FOLDER_WITH_RUNS pictures FOLDER boxes|discs [FOLDER_ALIKE]
    look.py MACRO FOLDER_WITH_RUNS grids|points FOLDER
"""
import csv
import importlib.util
import math
import os
import sys

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
from vtkmodules.vtkIOImage import vtkPNGReader

MACRO, RUNS, CHECK, *ARGUMENTS = sys.argv[1:]
MATERIALS = ["gel", "vessel"]
SKIN = 1.0  # half a voxel's diagonal and more [um]
BLACK = [0.0, 0.0, 0.0]

loaded = importlib.util.spec_from_file_location("macro", MACRO)
macro = importlib.util.module_from_spec(loaded)
loaded.loader.exec_module(macro)


def history(folder):
    with open(os.path.join(folder, "history.csv"), encoding="utf-8") as file:
        return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]


def blocks_of(data):
    """(name, data set) of all that is in an output, the parts of a block under one name."""
    if data.IsA("vtkDataSet"):
        return [("", data)]
    if data.IsA("vtkPartitionedDataSetCollection"):
        return [(data.GetMetaData(n).Get(vtkCompositeDataSet.NAME()), data.GetPartition(n, p))
                for n in range(data.GetNumberOfPartitionedDataSets()) for p in range(data.GetNumberOfPartitions(n))]
    raise AssertionError(f"a {data.GetClassName()}")


def arrays(block):
    """Of the points, where there are any of the particles."""
    data = block.GetPointData()
    return {data.GetArrayName(n): vtk_to_numpy(data.GetArray(n)) for n in range(data.GetNumberOfArrays())}


def particles_by_material(source, time):
    source.UpdatePipeline(time)
    found = {name: [] for name in MATERIALS}
    for name, block in blocks_of(source.GetClientSideObject().GetOutputDataObject(0)):
        values = arrays(block)
        if name:
            assert name in MATERIALS, name
            found[name].append(values)
        else:
            for n, material in enumerate(MATERIALS, start=1):
                is_of = values["material"] == n
                found[material].append({key: value[is_of] for key, value in values.items()})
    names = ["von_mises", "jacobian", "volume"]
    return {material: {name: np.concatenate([part[name] for part in parts]) for name in names}
            for material, parts in found.items()}


def same(one, other, what):
    assert math.isclose(one, other, rel_tol=1e-9, abs_tol=1e-9), f"{what}: {one} instead of {other}"


def check_numbers(folder, particles, grid):
    rows = history(folder)
    for source in (particles, grid):
        times = macro.times_of(source)
        assert np.allclose(times, [row["time"] for row in rows], rtol=1e-12, atol=0), times
    for row in rows:
        for material, values in particles_by_material(particles, row["time"]).items():
            volume = values["volume"] * values["jacobian"]
            same(volume.sum(), row[f"{material}.volume"], "volume of " + material)
            same((volume * values["von_mises"]).sum() / volume.sum(), row[f"{material}.von_mises_mean"], "mean of " + material)
            same(values["von_mises"].max(), row[f"{material}.von_mises_max"], "largest of " + material)
    # Where the load has moved them: x to 1.1, y to 1.2 and z to 0.95 times 24 um, without a turn.
    last = rows[-1]["time"]
    for source, skin in ((particles, SKIN), (grid, 1e-9)):
        source.UpdatePipeline(last)
        moved = macro.lengths(source.GetDataInformation().GetBounds())
        for length, stretch in zip(moved, (1.1, 1.2, 0.95)):
            assert 24 * stretch - 2 * skin < length < 24 * stretch + 1e-9, (moved, skin)


def pixels_of(name):
    """(row, column, rgb) of a saved picture."""
    reader = vtkPNGReader()
    reader.SetFileName(os.path.join(RUNS, name + ".png"))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[:, :, :3].astype(int)


def picture(view, name):
    """Pixels of a view without anything but particles, before black."""
    view.AxesGrid.Visibility = view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground, view.Background = 0, BLACK
    simple.SaveScreenshot(os.path.join(RUNS, name + ".png"), view)
    return pixels_of(name)


def holes(pixels):
    """Pixels of the background with the body on all four sides, of a body that is convex."""
    is_body = pixels.max(axis=2) > 8
    is_hole = ~is_body
    for axis in (0, 1):
        is_hole &= np.maximum.accumulate(is_body, axis=axis)
        is_hole &= np.flip(np.maximum.accumulate(np.flip(is_body, axis), axis=axis), axis)
    return int(is_hole.sum())


def show(folder, boxes):
    macro.BOXES_UP_TO = 10**9 if boxes else 0
    view = simple.CreateView("RenderView")
    view.ViewSize = [600, 500]
    particles, grid, _ = macro.show_results(os.path.join(RUNS, folder), view)
    return particles, grid, view


def fill(view, particles):
    """By the particles' bounds, which are those of other ranks to rounding; a view's own bounds may not be."""
    view.ResetCamera(*(round(bound, 6) for bound in particles.GetDataInformation().GetBounds()))


def look_along(view, axis, particles):
    """In perspective, along the rows of particles in the middle of the body, where the ranks of a spread run meet."""
    direction = [0.0, 0.0, 0.0]
    direction[axis] = 100.0
    view.CameraParallelProjection = 0
    view.CameraPosition = [c + d for c, d in zip(view.CameraFocalPoint, direction)]
    view.CameraViewUp = [0.0, -1.0, 0.0] if axis != 1 else [0.0, 0.0, 1.0]
    fill(view, particles)


def check_pictures(folder, shape, like=None):
    """And that they are those of another folder, which has the same particles on other ranks and was looked at before."""
    particles, grid, view = show(folder, shape == "boxes")
    simple.SaveScreenshot(os.path.join(RUNS, f"macro_{folder}_{shape}.png"), view)
    if shape == "boxes":
        check_numbers(os.path.join(RUNS, folder), particles, grid)
    simple.Hide(grid, view)
    simple.GetDisplayProperties(particles, view).SetScalarBarVisibility(view, False)
    for source in simple.GetSources().values():
        if source.SMProxy.GetXMLName() == "TimeToTextConvertor":
            simple.Hide(source, view)
    fill(view, particles)
    for side in ("aslant", 0, 1, 2):
        if side != "aslant":
            look_along(view, side, particles)
        name = f"{shape}_{side}"
        pixels = picture(view, f"{folder}_{name}")
        assert (pixels.max(axis=2) > 8).mean() > 0.1, "there is no body"
        assert holes(pixels) == 0, f"{folder}, {name}: {holes(pixels)} pixels see through the body"
        if like:
            apart = int(abs(pixels - pixels_of(f"{like}_{name}")).max())
            assert apart <= 2, f"{folder}, {name}: {apart} of 255 apart from {like}"


def check_grids_of_their_own(folder):
    """A grid that is reset has a file for each step; ParaView takes them for one."""
    path = os.path.join(RUNS, folder)
    particles, grid, _ = macro.show_results(path)
    assert macro.times_of(grid) == macro.times_of(particles) == [0.0, 0.5, 2.0], macro.times_of(grid)
    for time, stretch in ((0.5, 1.05), (2.0, 1.2)):
        grid.UpdatePipeline(time)
        height = macro.lengths(grid.GetDataInformation().GetBounds())[1]
        assert 24 * stretch - 1e-9 < height < 24 * stretch + 2 * 3 * stretch, height  # with the body, or two elements more
    simple.SetActiveSource(particles)
    assert macro.folder_of_active_source() == path


def check_that_points_have_holes(folder):
    """What the macro is for, and that holes are found: ParaView's own points are two pixels wide."""
    particles, grid, view = show(folder, True)
    simple.Hide(grid, view)
    simple.GetDisplayProperties(particles, view).SetRepresentationType("Points")
    look_along(view, 2, particles)
    assert holes(picture(view, f"{folder}_points")) > 100


{"pictures": check_pictures, "grids": check_grids_of_their_own, "points": check_that_points_have_holes}[CHECK](*ARGUMENTS)
