#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Image stacks of a run as tifffile and zarr-python read them: axes, names, voxel sizes and values, the same from each format,
compression and number of ranks. Claim V-STACK-4, docs/verification.md.

    check_readers.py STROMA
"""
import subprocess
import sys
import tempfile

try:
    import numpy as np
    import tifffile
    import zarr
except ImportError as missing:
    print(f"skipped: {missing}; cmake/install_dependencies.sh test installs it")
    sys.exit(77)

STROMA = sys.argv[1]
NAMES = ["displacement_x [um]", "displacement_y [um]", "von_mises [Pa]", "strain_xy", "label"]
VOXEL = (1.5, 1.0, 2.0)
DECK = """
Stroma:
  Image:
    Phantom:
      Kind: Shapes
      Size: [20, 300, 12]
      Voxel Size [um]: [1.5, 1.0, 2.0]
      Shapes:
        rod:
          Kind: Box
          Center [um]: [15, 150, 12]
          Size [um]: [9, 200, 12]
          Label: 3
  Materials:
    gel:
      Label: 0
      Model: Neo-Hookean
      Shear Modulus [Pa]: 500
      Poisson Ratio: 0.3
    rod:
      Label: 3
      Model: Neo-Hookean
      Shear Modulus [Pa]: 500
      Poisson Ratio: 0.3
  Grid:
    Element Size [um]: [6, 10, 6]
  Boundary Conditions:
    all:
      Face: all
      Components: xyz
      Displacement Gradient: [0.1, 0.05, 0, 0, 0.2, 0, 0, 0, -0.1]
  Loading:
    Steps: 1
  Output:
    Pictures: false
    Image Stacks:
      Quantities: [displacement_x, displacement_y, von_mises, strain_xy, label]
      Frame: Both
"""


def run(folder, ranks, form, compression):
    """Runs the deck. Returns the folder of its results."""
    out = f"{folder}/{form}_{compression}_{ranks}"
    mpirun = ["mpirun", "--oversubscribe", "--bind-to", "none", "-np", str(ranks)] if ranks > 1 else []
    subprocess.run(
        mpirun + [STROMA, "run", f"{folder}/deck.yaml", "-o", out, "--quiet", "--set", f"Output|Image Stacks|Format={form}",
                  "--set", f"Output|Image Stacks|Compression={compression}"], check=True)
    return out


def of_tiff(path, origin):
    """The values (c, z, y, x) of an OME-TIFF, once its descriptions are looked at."""
    with tifffile.TiffFile(path) as file:
        assert file.is_ome and file.is_imagej, path
        values = file.series[0].asarray()
        assert file.series[0].axes == "ZCYX" and values.dtype == np.float32, file.series[0].axes
        ome = tifffile.xml2dict(file.ome_metadata)["OME"]["Image"]["Pixels"]
        assert [channel["Name"] for channel in ome["Channel"]] == NAMES, ome["Channel"]
        assert tuple(ome[f"PhysicalSize{axis}"] for axis in "XYZ") == VOXEL, ome
        assert {ome[f"PhysicalSize{axis}Unit"] for axis in "XYZ"} == {"\u00b5m"}, ome
        assert tuple(ome["Plane"][f"Position{axis}"] for axis in "XYZ") == origin, ome["Plane"]
        imagej = file.imagej_metadata
        assert (imagej["channels"], imagej["slices"], imagej["hyperstack"]) == (5, values.shape[0], True), imagej
        assert imagej["unit"] == "micron" and imagej["spacing"] == VOXEL[2], imagej
        assert imagej["Labels"] == NAMES * values.shape[0], imagej["Labels"]
        width, height = (file.pages[0].tags[f"{axis}Resolution"].value for axis in "XY")
        assert abs(width[1] / width[0] - VOXEL[0]) < 1e-6 and abs(height[1] / height[0] - VOXEL[1]) < 1e-6
    return np.moveaxis(values, 1, 0)


def of_zarr(path, origin):
    """The same of level 0 of an OME-Zarr; level 1 is held against it."""
    image = zarr.open(path, "r")
    scales = image.attrs["multiscales"][0]
    assert scales["version"] == "0.4"
    assert [axis["name"] for axis in scales["axes"]] == ["c", "z", "y", "x"]
    assert [axis.get("unit") for axis in scales["axes"]] == [None] + 3 * ["micrometer"]
    assert [channel["label"] for channel in image.attrs["omero"]["channels"]] == NAMES
    x, y, z = VOXEL
    for level, dataset in enumerate(scales["datasets"]):
        scale, translation = dataset["coordinateTransformations"]
        step = 2**level
        assert scale == {"type": "scale", "scale": [1, z, step * y, step * x]}, scale
        corner = [0, origin[2], origin[1] + (step - 1) / 2 * y, origin[0] + (step - 1) / 2 * x]
        assert translation == {"type": "translation", "translation": corner}, translation
    fine, coarse = image["0"][:], image["1"][:]
    assert len(scales["datasets"]) == 2 and fine.dtype == np.float32
    c, nz, ny, nx = coarse.shape
    assert (ny, nx) == ((fine.shape[2] + 1) // 2, (fine.shape[3] + 1) // 2)
    padded = np.pad(fine, ((0, 0), (0, 0), (0, 1), (0, 1)), constant_values=np.nan)[:, :, :2 * ny, :2 * nx]
    blocks = padded.reshape(c, nz, ny, 2, nx, 2).transpose(0, 1, 2, 4, 3, 5).reshape(c, nz, ny, nx, 4)
    with np.errstate(all="ignore"):
        import warnings
        warnings.simplefilter("ignore")
        means = np.nanmean(blocks.astype(float), axis=-1)
    np.testing.assert_allclose(coarse[:-1], means[:-1], rtol=1e-6)
    np.testing.assert_array_equal(coarse[-1], blocks[-1, ..., 0])
    return fine


def check_values(undeformed, deformed):
    """Holds the stacks against the homogeneous deformation."""
    gradient = np.array([[0.1, 0.05, 0], [0, 0.2, 0], [0, 0, -0.1]])
    F = np.eye(3) + gradient
    centres = [(np.arange(n) + 0.5) * h for n, h in zip((20, 300, 12), VOXEL)]
    X = np.stack(np.meshgrid(*centres, indexing="ij"), axis=-1).transpose(2, 1, 0, 3)  # z, y, x, component
    u = X @ gradient.T
    for component in (0, 1):
        np.testing.assert_allclose(undeformed[component], u[..., component], atol=2e-5)
    strain = 0.5 * (F.T @ F - np.eye(3))
    np.testing.assert_allclose(undeformed[3], strain[0, 1], rtol=1e-5)
    label = np.where(np.all(np.abs(X - (15, 150, 12)) < (4.5, 100, 6), axis=-1), 3, 0)
    np.testing.assert_array_equal(undeformed[4], label)
    # Where the body has gone: 20 x 1.1 and what the shear adds, 300 x 1.2, 12 x 0.9 voxels.
    nz, ny, nx = deformed[0].shape
    assert (nx, ny, nz) == (32, 360, 11), deformed.shape
    x = np.stack(np.meshgrid(*[(np.arange(n) + 0.5) * h for n, h in zip((nx, ny, nz), VOXEL)], indexing="ij"),
                 axis=-1).transpose(2, 1, 0, 3)
    X = x @ np.linalg.inv(F).T
    # Two voxels within the faces all is filled, as far without nothing is.
    extent = np.array([20, 300, 12]) * VOXEL
    inside = np.all((X > 2 * np.array(VOXEL)) & (X < extent - 2 * np.array(VOXEL)), axis=-1)
    outside = np.any((X < -2 * np.array(VOXEL)) | (X > extent + 2 * np.array(VOXEL)), axis=-1)
    assert np.isfinite(deformed[0][inside]).all() and np.isnan(deformed[0][outside]).all()
    assert (deformed[4][outside] == -1).all()
    # Means over boxes that reach up to a voxel beyond: of a field that is linear, within half a voxel's change.
    np.testing.assert_allclose(deformed[1][inside], (x - X)[inside][:, 1], atol=0.2 * VOXEL[1])
    np.testing.assert_allclose(deformed[3][inside], strain[0, 1], rtol=1e-5)
    filled = np.isfinite(deformed[0]).sum() * np.prod(VOXEL)
    volume = np.linalg.det(F) * np.prod(extent)
    assert abs(filled / volume - 1) < 0.02, (filled, volume)


def main():
    with tempfile.TemporaryDirectory(prefix="stroma_stacks_") as folder:
        with open(f"{folder}/deck.yaml", "w", encoding="utf-8") as deck:
            deck.write(DECK)
        reference = None
        cases = [(1, "OME-TIFF", "None"), (2, "OME-TIFF", "None"), (2, "OME-TIFF", "Zlib"), (1, "OME-Zarr", "Blosc"),
                 (2, "OME-Zarr", "Zlib"), (2, "OME-Zarr", "Zstd"), (1, "OME-Zarr", "None")]
        for ranks, form, compression in cases:
            out = run(folder, ranks, form, compression)
            found = []
            for frame, origin in (("undeformed", (0, 0, 0)), ("deformed", (0, 0, 0))):
                if form == "OME-TIFF":
                    found.append(of_tiff(f"{out}/image_{frame}.ome.tif", origin))
                else:
                    found.append(of_zarr(f"{out}/image_{frame}.ome.zarr", origin))
            if reference is None:
                reference = found
                check_values(*found)
            for one, other in zip(reference, found):
                for channel in range(len(NAMES)):
                    largest = np.nanmax(np.abs(one[channel]))
                    np.testing.assert_allclose(other[channel], one[channel], rtol=0, atol=1e-6 * largest)
            print(f"{form}, {compression}, {ranks} ranks: as read, {found[0].shape} and {found[1].shape}")


main()
