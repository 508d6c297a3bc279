# SPDX-License-Identifier: BSD-3-Clause
# The VTK modules, their Python package and the ParaView plugin.
include(CMake/HexSweepModule.cmake)

# The folders of the modules, each with its vtk.module.
set(hexsweep_module_folders Filters IO/Mesh)
if (HEXSWEEP_HAS_CAD)
  list(APPEND hexsweep_module_folders IO/CAD)
endif ()

# The plugin is scanned first: its XML files decide nothing about the module, but ParaView wants
# to know its plugins before modules are built.
set(hexsweep_plugins)
if (HEXSWEEP_BUILD_PLUGIN)
  paraview_plugin_scan(
    PLUGIN_FILES            "${CMAKE_CURRENT_SOURCE_DIR}/Plugin/paraview.plugin"
    PROVIDES_PLUGINS        hexsweep_plugins
    ENABLE_BY_DEFAULT       ON
    HIDE_PLUGINS_FROM_CACHE ON)
endif ()

# Filters/vtk.module is a symbolic link to the one at the top level: VTK builds a module in the
# folder of its vtk.module, and the top folder cannot be added to itself.
set(hexsweep_module_files)
foreach (folder IN LISTS hexsweep_module_folders)
  list(APPEND hexsweep_module_files "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/vtk.module")
endforeach ()
vtk_module_scan(
  MODULE_FILES            ${hexsweep_module_files}
  PROVIDES_MODULES        hexsweep_modules
  WANT_BY_DEFAULT         ON
  HIDE_MODULES_FROM_CACHE ON
  ENABLE_TESTS            OFF)
vtk_module_build(
  MODULES             ${hexsweep_modules}
  PACKAGE             HexSweep
  VERSION             1.0
  SOVERSION           1
  INSTALL_EXPORT      HexSweep
  INSTALL_HEADERS     ON
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/hexsweep"
  CMAKE_DESTINATION   "${hexsweep_cmake_destination}"
  TEST_DIRECTORY_NAME NONE)

if (HEXSWEEP_WRAP_PYTHON)
  add_subdirectory(Python)
endif ()

if (hexsweep_plugins)
  set(HEXSWEEP_PLUGIN_SUBDIRECTORY "paraview-${ParaView_VERSION_MAJOR}.${ParaView_VERSION_MINOR}/plugins")
  paraview_plugin_build(
    PLUGINS              ${hexsweep_plugins}
    PLUGINS_FILE_NAME    "hexsweep.plugins.xml"
    LIBRARY_SUBDIRECTORY "${HEXSWEEP_PLUGIN_SUBDIRECTORY}"
    INSTALL_HEADERS      OFF)
  set(HEXSWEEP_PLUGIN_FILE
    "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/${HEXSWEEP_PLUGIN_SUBDIRECTORY}/HexSweep/HexSweep.so")
endif ()
