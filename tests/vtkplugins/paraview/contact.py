"""pvbatch contact.py PLUGIN SCENE SCAN: the source AFM contact has the numbers of the map there."""

import sys

from paraview.simple import *
from paraview import servermanager

plugin, scene, scan = sys.argv[1:]
LoadPlugin(plugin, remote=False, ns=globals())
SETPOINT = 4e-9


def of(output, name):
    return output.GetPointData().GetArray(name).GetTuple(0)


# The middle pixel of 3 x 3 is the middle of the scan, where the contact is by default.
middle = servermanager.Fetch(AFMforcemap(
    Input=AFMheightmap(FileName=scan), HeightArray=["POINTS", "height"], SceneFile=scene,
    Gridpx=[3, 3], SetpointN=SETPOINT))
expected = {name: middle.GetPointData().GetArray(name).GetValue(4)
            for name in ("indentation", "contact_radius", "lateral_force")}
contact = AFMcontact(SceneFile=scene, SetpointN=SETPOINT)
surface, tip, force = (servermanager.Fetch(contact, idx=port) for port in range(3))

across, along, up = of(force, "force")
assert abs(up / SETPOINT - 1.0) < 1e-9
assert abs(across ** 2 + along ** 2 - expected["lateral_force"] ** 2) < 1e-9 * SETPOINT ** 2
for name in ("indentation", "contact_radius"):
    assert abs(of(force, name)[0] / expected[name] - 1.0) < 1e-9, (name, expected[name])
assert surface.GetNumberOfPoints() == 241 * 241
assert 0.0 < surface.GetPointData().GetArray("displacement").GetRange()[1] <= \
    expected["indentation"]
assert abs(tip.GetBounds()[4] - of(force, "tip")[2]) < 2.0 * expected["indentation"]
print(f"indentation {expected['indentation']:.4f} nm, contact radius "
      f"{expected['contact_radius']:.4f} nm")
print("done")
