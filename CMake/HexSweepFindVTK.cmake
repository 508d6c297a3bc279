# SPDX-License-Identifier: BSD-3-Clause
# ParaView where it is found and wanted, and the VTK that belongs to it; otherwise VTK alone.
include("${CMAKE_CURRENT_LIST_DIR}/HexSweepVTKPython.cmake")

# What the library itself needs first; what only wrapping and tests need is optional.
set(hexsweep_vtk_components
  CommonCore CommonDataModel CommonExecutionModel CommonMisc CommonSystem FiltersCore
  FiltersGeneral FiltersGeometry IOCore IOXML ParallelCore vtksys)
set(hexsweep_vtk_optional_components
  Python WrappingPythonCore FiltersExtraction FiltersSources FiltersVerdict
  IOLegacy IOImage InteractionStyle RenderingCore RenderingFreeType RenderingOpenGL2 RenderingUI
  TestingCore
  TestingRendering)

# hexsweep_list_configurations(<variable> <package>): the folders of the CMake files that there are of a
# package, in the order in which find_package() takes them; none of them is read.
macro (hexsweep_list_configurations variable package)
  set(hexsweep_folder "${${package}_DIR}")
  find_package(${package} 9999 QUIET) # all are too old, so all are looked at
  set(${variable})
  foreach (config IN LISTS ${package}_CONSIDERED_CONFIGS)
    get_filename_component(config "${config}" DIRECTORY)
    list(APPEND ${variable} "${config}")
  endforeach ()
  set(${package}_DIR "${hexsweep_folder}" CACHE PATH "Folder of ${package}'s CMake files" FORCE)
endmacro ()

set(hexsweep_paraview_components RemotingServerManager RemotingViews VTKExtensionsCore pqComponents)
set(hexsweep_paraview_folders)
if (HEXSWEEP_USE_PARAVIEW)
  hexsweep_list_configurations(hexsweep_paraview_folders ParaView)
  foreach (folder IN LISTS hexsweep_paraview_folders)
    hexsweep_mend_python_targets("${folder}")
    hexsweep_mend_python_targets("${folder}/vtk")
    break ()
  endforeach ()
  find_package(ParaView 5.11 QUIET COMPONENTS ${hexsweep_paraview_components})
endif ()
if (ParaView_FOUND)
  find_package(VTK REQUIRED
    COMPONENTS ${hexsweep_vtk_components}
    OPTIONAL_COMPONENTS ${hexsweep_vtk_optional_components}
    PATHS "${ParaView_DIR}/vtk" NO_DEFAULT_PATH)
  message(STATUS "HexSweep: ParaView ${ParaView_VERSION} with VTK ${VTK_VERSION}")
elseif (hexsweep_paraview_folders)
  # There is one, so it is meant: better an error than a build without the plugin. Once more, aloud, as
  # only the packages that ParaView looks for say what is missing.
  find_package(ParaView 5.11 COMPONENTS ${hexsweep_paraview_components})
  set(hexsweep_hindrances ${ParaView_NOT_FOUND_MESSAGE})
  foreach (component IN LISTS hexsweep_paraview_components)
    list(APPEND hexsweep_hindrances ${ParaView_${component}_NOT_FOUND_MESSAGE})
  endforeach ()
  list(REMOVE_DUPLICATES hexsweep_hindrances)
  list(JOIN hexsweep_hindrances "\n  " hexsweep_hindrances)
  list(JOIN hexsweep_paraview_folders "\n  " hexsweep_paraview_folders)
  message(FATAL_ERROR "HexSweep: there is a ParaView, but it cannot be built against:\n  ${hexsweep_paraview_folders}\n"
    "What is missing:\n  ${hexsweep_hindrances}\n"
    "and what is said above of packages that were not found; HexSweep needs ParaView 5.11 or later. On Debian "
    "Utilities/install-dependencies.sh installs all that it needs. To build without ParaView, against VTK "
    "alone, configure with -DHEXSWEEP_USE_PARAVIEW=OFF.")
else ()
  hexsweep_list_configurations(hexsweep_vtk_folders VTK)
  foreach (folder IN LISTS hexsweep_vtk_folders)
    hexsweep_mend_python_targets("${folder}")
    break ()
  endforeach ()
  find_package(VTK 9.1 REQUIRED
    COMPONENTS ${hexsweep_vtk_components}
    OPTIONAL_COMPONENTS ${hexsweep_vtk_optional_components})
  message(STATUS "HexSweep: VTK ${VTK_VERSION}, no ParaView (Debian: paraview-dev python3-paraview)")
endif ()
