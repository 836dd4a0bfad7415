"""pvpython client.py PLUGIN SCAN PORT: a force map by a server, of whose ranks each has its rows."""

import sys

from paraview.simple import *
from paraview import servermanager

plugin, scan, port = sys.argv[1:]
Connect("127.0.0.1", int(port))
LoadPlugin(plugin, remote=True, ns=globals())
force_map = AFMforcemap(Input=AFMheightmap(FileName=scan), HeightArray=["POINTS", "height"],
                        Gridpx=[16, 12], Quantities="adhesion_force")
force_map.UpdatePipeline()
ranks = servermanager.ActiveConnection.GetNumberOfDataPartitions()
low, high = force_map.PointData["adhesion_force"].GetRange()
print(f"{ranks} ranks: {low:.6g} N to {high:.6g} N,",
      force_map.GetDataInformation().GetExtent())
assert ranks == 2 and 0.0 < low < high < 1e-6
assert force_map.GetDataInformation().GetExtent()[:4] == (0, 15, 0, 11)
print("done")
Disconnect()
