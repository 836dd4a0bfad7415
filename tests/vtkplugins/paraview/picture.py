"""pvbatch picture.py PLUGIN SCENE SCAN OUT.png: adhesion over a scan with the tip, and the contact
there. Nanometers throughout: ParaView shades a surface given in meters black and white."""

import sys

from paraview.simple import *

plugin, scene, scan, out = sys.argv[1:]
PLACE = [260, 250]  # nm from the lower left corner
LoadPlugin(plugin, remote=False, ns=globals())


def view_of(size):
    view = CreateView("RenderView")
    view.ViewSize = size
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    return view


def show(source, view, color=None, opacity=1.0):
    shown = Show(source, view)
    shown.ColorArrayName = [None, ""]
    shown.Representation = "Surface"
    shown.DiffuseColor = color or [0.8, 0.8, 0.8]
    shown.Opacity = opacity
    return shown


def paint(source, view, array, title, preset, limits):
    shown = show(source, view)
    ColorBy(shown, ("POINTS", array))
    table = GetColorTransferFunction(array)
    table.ApplyPreset(preset, True)
    table.RescaleTransferFunction(*limits)
    bar = GetScalarBar(table, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.WindowLocation = "Upper Right Corner"
    bar.TitleColor = bar.LabelColor = [0, 0, 0]
    shown.SetScalarBarVisibility(view, True)
    return shown


def look(view, elevation, closer=1.2):
    ResetCamera(view)
    camera = GetActiveCamera()
    camera.Elevation(elevation)
    ResetCamera(view)
    camera.Dolly(closer)
    Render(view)


far = AFMcontact(SceneFile=scene, PlaceLengthUnit=PLACE)
contact = AFMcontact(SceneFile=scene, PlaceLengthUnit=PLACE, HalfWidthLengthUnit=16)
parts = [OutputPort(contact, port) for port in range(3)]

whole = view_of([640, 480])
force_map = AFMforcemap(Input=AFMheightmap(FileName=scan), SceneFile=scene, Gridpx=[96, 96],
                        HeightArray=["POINTS", "height"], Quantities="height, adhesion_force")
warped = WarpByScalar(Input=force_map, Scalars=["POINTS", "height"])
paint(warped, whole, "adhesion_force", "adhesion force (N)", "Viridis (matplotlib)",
      [1e-8, 4e-8])
show(OutputPort(far, 1), whole, [0.3, 0.5, 0.9], 0.6)
show(OutputPort(far, 2), whole, [0.85, 0.2, 0.1])
look(whole, -55, 1.35)

zoom = view_of([640, 480])
paint(parts[0], zoom, "displacement", "displacement (nm)", "Cool to Warm", [-0.1, 0.1])
show(parts[1], zoom, [0.3, 0.5, 0.9], 0.35)
show(parts[2], zoom, [0.85, 0.2, 0.1])
look(zoom, -65, 1.5)

layout = CreateLayout("both")
layout.SplitHorizontal(0, 0.5)
AssignViewToLayout(view=whole, layout=layout, hint=1)
AssignViewToLayout(view=zoom, layout=layout, hint=2)
layout.SetSize(1280, 480)
SaveScreenshot(out, layout, ImageResolution=[1280, 480])
print("done")
