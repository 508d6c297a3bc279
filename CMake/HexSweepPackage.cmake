# SPDX-License-Identifier: BSD-3-Clause
# What find_package(HexSweep) needs, in the build tree and in the install tree alike.
include(CMakePackageConfigHelpers)

set(hexsweep_config "${CMAKE_BINARY_DIR}/${hexsweep_cmake_destination}/HexSweepConfig.cmake")
set(hexsweep_config_version
  "${CMAKE_BINARY_DIR}/${hexsweep_cmake_destination}/HexSweepConfigVersion.cmake")
# The VTK modules as components, none with HEXSWEEP_CORE_ONLY, and what their headers need of VTK.
string(REPLACE "HexSweep::" "" HEXSWEEP_MODULES "${hexsweep_modules}")
set(HEXSWEEP_VTK_COMPONENTS)
foreach (module IN LISTS hexsweep_modules)
  _vtk_module_get_module_property("${module}" PROPERTY "depends" VARIABLE needed)
  list(APPEND HEXSWEEP_VTK_COMPONENTS ${needed})
endforeach ()
list(REMOVE_DUPLICATES HEXSWEEP_VTK_COMPONENTS)
list(FILTER HEXSWEEP_VTK_COMPONENTS INCLUDE REGEX "^VTK::")
string(REPLACE "VTK::" "" HEXSWEEP_VTK_COMPONENTS "${HEXSWEEP_VTK_COMPONENTS}")
configure_package_config_file(CMake/HexSweepConfig.cmake.in "${hexsweep_config}"
  INSTALL_DESTINATION "${hexsweep_cmake_destination}"
  NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file("${hexsweep_config_version}" COMPATIBILITY SameMinorVersion)
configure_file(CMake/HexSweepVTKPython.cmake
  "${CMAKE_BINARY_DIR}/${hexsweep_cmake_destination}/HexSweepVTKPython.cmake" COPYONLY)
install(FILES "${hexsweep_config}" "${hexsweep_config_version}" CMake/HexSweepVTKPython.cmake
  DESTINATION "${hexsweep_cmake_destination}"
  COMPONENT development)
install(FILES LICENSE THIRD_PARTY_LICENSES.md DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/licenses/HexSweep"
  COMPONENT licenses)
