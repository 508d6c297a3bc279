# SPDX-License-Identifier: BSD-3-Clause
# hexsweep_add_module(<module>): the VTK module of the folder that calls it. Every vtk*.cxx is a
# public, wrapped class; every other source is private to the module.
function (hexsweep_add_module module)
  file(GLOB class_files CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}"
    "${CMAKE_CURRENT_SOURCE_DIR}/vtk*.cxx")
  file(GLOB private_sources CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}"
    "${CMAKE_CURRENT_SOURCE_DIR}/HexSweep*.cxx")
  set(classes)
  foreach (class_file IN LISTS class_files)
    get_filename_component(class "${class_file}" NAME_WE)
    list(APPEND classes "${class}")
  endforeach ()
  set_property(GLOBAL APPEND PROPERTY HEXSWEEP_CLASSES ${classes})

  vtk_module_add_module(${module}
    CLASSES ${classes}
    SOURCES ${private_sources})
  vtk_module_link(${module} PRIVATE HexSweepCore)
  vtk_module_include(${module} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
  string(REPLACE "HexSweep::" "" target "${module}")
  hexsweep_target_warnings(${target})
endfunction ()
