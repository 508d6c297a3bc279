# SPDX-License-Identifier: BSD-3-Clause
# ParaView where it is found and wanted, and the VTK that belongs to it; otherwise VTK alone.

# What the library itself needs first; what only wrapping and tests need is optional.
set(hexsweep_vtk_components
  CommonCore CommonDataModel CommonExecutionModel CommonMisc CommonSystem FiltersCore
  FiltersGeneral FiltersGeometry IOCore IOXML ParallelCore vtksys)
set(hexsweep_vtk_optional_components
  Python WrappingPythonCore FiltersExtraction FiltersSources FiltersVerdict
  IOLegacy IOImage InteractionStyle RenderingCore RenderingFreeType RenderingOpenGL2 RenderingUI
  TestingCore
  TestingRendering)
if (HEXSWEEP_USE_PARAVIEW)
  find_package(ParaView 5.11 QUIET
    COMPONENTS RemotingServerManager RemotingViews VTKExtensionsCore pqComponents)
endif ()
if (ParaView_FOUND)
  find_package(VTK REQUIRED
    COMPONENTS ${hexsweep_vtk_components}
    OPTIONAL_COMPONENTS ${hexsweep_vtk_optional_components}
    PATHS "${ParaView_DIR}/vtk" NO_DEFAULT_PATH)
  message(STATUS "HexSweep: ParaView ${ParaView_VERSION} with VTK ${VTK_VERSION}")
else ()
  find_package(VTK 9.1 REQUIRED
    COMPONENTS ${hexsweep_vtk_components}
    OPTIONAL_COMPONENTS ${hexsweep_vtk_optional_components})
  message(STATUS "HexSweep: VTK ${VTK_VERSION}, no ParaView")
endif ()
