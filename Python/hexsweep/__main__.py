# SPDX-License-Identifier: BSD-3-Clause
"""Sweeps a tessellated solid from the command line::

    python3 -m hexsweep faces part.vtk                               # lists the faces
    python3 -m hexsweep part.vtk --source 3 --layers 6 -o part.vtu   # meshes it with hexahedra
"""

import sys

from .commandline import main

if __name__ == "__main__":
    sys.exit(main())
