"""pvbatch force_map.py PLUGIN SCAN SCENE|- LENGTH_UNIT WxH MODE SETPOINT OUT.pvti"""

import sys
import time

from paraview.simple import *
from paraview import servermanager

plugin, scan, scene, unit, grid, mode, setpoint, out = sys.argv[1:]
LoadPlugin(plugin, remote=False, ns=globals())
reader = OpenDataFile(scan)
assert type(reader).__name__ == "AFMheightmap", reader
reader.LengthUnitm = float(unit)
force_map = AFMforcemap(Input=reader, SceneFile=scene.removeprefix("-"), LengthUnitm=float(unit),
                        HeightArray=["POINTS", "height"],
                        Gridpx=[int(number) for number in grid.split("x")],
                        Mode=["approach", "contact"].index(mode), SetpointN=float(setpoint),
                        Threads=1)
begin = time.time()
force_map.UpdatePipeline()
ranks = servermanager.ActiveConnection.GetNumberOfDataPartitions()
print(f"{ranks} rank(s): {time.time() - begin:.2f} s")
SaveData(out, proxy=force_map)
print("done")
