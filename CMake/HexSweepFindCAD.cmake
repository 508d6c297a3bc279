# SPDX-License-Identifier: BSD-3-Clause
# The CAD kernel OpenCASCADE (LGPL 2.1 with exception), for the CAD reader alone.
option(HEXSWEEP_USE_OPENCASCADE "Build the CAD reader where OpenCASCADE 7.6 or later is found" ON)
set(HEXSWEEP_HAS_CAD OFF)
if (HEXSWEEP_USE_OPENCASCADE)
  # Its version file accepts its own version alone.
  find_package(OpenCASCADE QUIET)
  if (OpenCASCADE_FOUND AND OpenCASCADE_VERSION VERSION_GREATER_EQUAL 7.6)
    set(HEXSWEEP_HAS_CAD ON)
    # 7.8 has other names for the toolkits of STEP and IGES.
    set(hexsweep_cad_exchange TKXDESTEP TKSTEP TKXDEIGES TKIGES)
    if (TARGET TKDESTEP)
      set(hexsweep_cad_exchange TKDESTEP TKDEIGES)
    endif ()
    message(STATUS "HexSweep: CAD reader with OpenCASCADE ${OpenCASCADE_VERSION}")
  else ()
    message(STATUS "HexSweep: no CAD reader: OpenCASCADE 7.6 or later was not found (Debian: "
      "libocct-data-exchange-dev libocct-modeling-algorithms-dev)")
  endif ()
endif ()
