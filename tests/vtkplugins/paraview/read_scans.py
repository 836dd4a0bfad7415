"""pvbatch read_scans.py PLUGIN TASKS.json: each file as a converted copy of it, to the bit."""

import json
import sys

import numpy
from paraview.simple import *
from paraview import servermanager
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader


def expected_of(path):
    reader = vtkXMLImageDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def check(task):
    reader = AFMheightmap(FileName=task["file"], LengthUnitm=1.0, ScanSizem=[task["size"]] * 2,
                          HeightperValuem=task["height"])
    reader.UpdatePipeline()
    image = servermanager.Fetch(reader)
    heights = image.GetPointData().GetArray("height")
    Delete(reader)
    if task["refused"]:
        assert heights is None, f"{task['file']}: read, though asperity refuses it"
        return "refused"
    expected = expected_of(task["expected"])
    assert heights is not None, f"{task['file']}: not read"
    assert image.GetDimensions() == expected.GetDimensions(), task["file"]
    here = vtk_to_numpy(heights)
    there = vtk_to_numpy(expected.GetPointData().GetArray("height"))
    same = (here == there) | (numpy.isnan(here) & numpy.isnan(there))
    assert same.all(), (task["file"], here[~same][:3], there[~same][:3])
    assert numpy.allclose(image.GetSpacing()[:2], expected.GetSpacing()[:2], rtol=1e-12, atol=0.0)
    return "x".join(map(str, image.GetDimensions()[:2]))


LoadPlugin(sys.argv[1], remote=False, ns=globals())
with open(sys.argv[2]) as file:
    for task in json.load(file):
        print(task["file"].rsplit("/", 1)[1], check(task), "ok")
print("done")
