# SPDX-License-Identifier: BSD-3-Clause
"""As Project/sweep_part.cxx, in pvpython: sweep_part.py <plugin> <part.step> <size> <mesh.vtu>"""

import sys

from paraview import simple

plugin, part, size, mesh = sys.argv[1:]
simple.LoadPlugin(plugin, remote=False, ns=globals())
simple.SaveData(mesh, proxy=ManyToManySweep(Solid=simple.OpenDataFile(part), Size=float(size)))  # noqa: F821
