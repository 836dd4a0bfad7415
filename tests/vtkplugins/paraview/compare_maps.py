"""pvbatch compare_maps.py EXPECTED.vti MAP_RANKS_UNIT.pvti ...: in meters every bit is the same, in
another unit every value to 1e-9."""

import sys

import numpy
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPImageDataReader

LENGTHS = {"snap_in_distance", "height", "indentation", "contact_radius", "height_trace",
           "height_retrace", "error_trace", "error_retrace"}


def image_of(path):
    reader = vtkXMLPImageDataReader() if path.endswith(".pvti") else vtkXMLImageDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def arrays_of(image):
    data = image.GetPointData()
    return {data.GetArrayName(i): vtk_to_numpy(data.GetArray(i))
            for i in range(data.GetNumberOfArrays())
            if not data.GetArrayName(i).endswith("valid")}


def check(expected, path):
    unit = float(path.rsplit("_", 1)[1].removesuffix(".pvti"))
    image = image_of(path)
    found, wanted = arrays_of(image), arrays_of(expected)
    assert set(found) == set(wanted), (sorted(found), sorted(wanted))
    assert image.GetDimensions() == expected.GetDimensions()
    for axis in range(2):
        for get in ("GetSpacing", "GetOrigin"):
            here, there = getattr(image, get)()[axis] * unit, getattr(expected, get)()[axis]
            assert abs(here - there) <= 1e-12 * abs(there), (path, get, here, there)
    worst = 0.0
    for name, values in wanted.items():
        here = found[name] * unit if name in LENGTHS else found[name]
        assert (numpy.isnan(here) == numpy.isnan(values)).all(), (path, name)
        if unit == 1.0:
            same = (here == values) | numpy.isnan(values)
            assert same.all(), (path, name, here[~same][:3], values[~same][:3])
        scale = numpy.nanmax(numpy.abs(values), initial=0.0) or 1.0
        worst = max(worst, numpy.nanmax(numpy.abs(here - values), initial=0.0) / scale)
    assert worst <= 1e-9, (path, worst)
    return len(wanted), worst


expected = image_of(sys.argv[1])
for path in sys.argv[2:]:
    count, worst = check(expected, path)
    print(f"{path.rsplit('/', 1)[1]}: {count} arrays, {expected.GetDimensions()[:2]} pixels, "
          f"largest difference {worst:.2g}")
print("done")
