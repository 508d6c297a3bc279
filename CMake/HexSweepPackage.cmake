# SPDX-License-Identifier: BSD-3-Clause
# What find_package(HexSweep) needs, in the build tree and in the install tree alike.
include(CMakePackageConfigHelpers)

set(hexsweep_config "${CMAKE_BINARY_DIR}/${hexsweep_cmake_destination}/HexSweepConfig.cmake")
set(hexsweep_config_version
  "${CMAKE_BINARY_DIR}/${hexsweep_cmake_destination}/HexSweepConfigVersion.cmake")
set(HEXSWEEP_HAS_FILTERS ON)
if (HEXSWEEP_CORE_ONLY)
  set(HEXSWEEP_HAS_FILTERS OFF)
endif ()
configure_package_config_file(CMake/HexSweepConfig.cmake.in "${hexsweep_config}"
  INSTALL_DESTINATION "${hexsweep_cmake_destination}"
  NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file("${hexsweep_config_version}" COMPATIBILITY SameMinorVersion)
install(FILES "${hexsweep_config}" "${hexsweep_config_version}"
  DESTINATION "${hexsweep_cmake_destination}"
  COMPONENT development)
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/licenses/HexSweep"
  COMPONENT licenses)
