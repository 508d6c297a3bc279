# SPDX-License-Identifier: BSD-3-Clause
# What cpack needs to make .deb files of a build: hexsweep (libraries, plugin, Python package, command
# line) and hexsweep-dev (headers, CMake files, Core). A set of packages is for one release of Debian,
# whose ParaView it was built with. Utilities/package.sh makes them.
if (NOT HEXSWEEP_BUILD_PLUGIN OR NOT HEXSWEEP_WRAP_PYTHON OR NOT BUILD_SHARED_LIBS OR HEXSWEEP_SANITIZE
    OR NOT CMAKE_LIBRARY_ARCHITECTURE OR NOT EXISTS /etc/debian_version)
  return ()
endif ()
find_package(Python3 REQUIRED COMPONENTS Interpreter)
set(hexsweep_debian_dir "${CMAKE_BINARY_DIR}/Packaging/Debian")

# 12 in "~deb12", and its name, which a changelog has.
file(STRINGS /etc/os-release hexsweep_os_release)
set(hexsweep_deb_release sid)
set(hexsweep_deb_suite unstable)
foreach (line IN LISTS hexsweep_os_release)
  if (line MATCHES "^VERSION_ID=\"?([0-9.]+)")
    set(hexsweep_deb_release "${CMAKE_MATCH_1}")
  elseif (line MATCHES "^VERSION_CODENAME=\"?([a-z]+)")
    set(hexsweep_deb_suite "${CMAKE_MATCH_1}")
  endif ()
endforeach ()
set(hexsweep_deb_version "${PROJECT_VERSION}-1~deb${hexsweep_deb_release}")

# Who answers for the packages: devscripts' variables, else the author of what is built.
set(hexsweep_contact "The HexSweep authors <hexsweep@hexsweep.example>")
set(hexsweep_deb_date "Thu, 01 Jan 1970 00:00:00 +0000")
execute_process(COMMAND git log -1 "--format=%aN <%aE>;%cD"
  WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
  OUTPUT_VARIABLE hexsweep_commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if (hexsweep_commit MATCHES "^([^;]+);(.+)$")
  set(hexsweep_contact "${CMAKE_MATCH_1}")
  set(hexsweep_deb_date "${CMAKE_MATCH_2}")
endif ()
if (DEFINED ENV{DEBFULLNAME} AND DEFINED ENV{DEBEMAIL})
  set(hexsweep_contact "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
endif ()
set(HEXSWEEP_PACKAGE_CONTACT "${hexsweep_contact}" CACHE STRING "Maintainer of the Debian packages: Name <address>")
mark_as_advanced(HEXSWEEP_PACKAGE_CONTACT)

# What ParaView reads when it starts, where it has such a file (Debian 13): diverted by the package.
get_filename_component(HEXSWEEP_PARAVIEW_CONF
  "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/${HEXSWEEP_PLUGIN_SUBDIRECTORY}" DIRECTORY)
string(APPEND HEXSWEEP_PARAVIEW_CONF "/paraview.conf")
set(hexsweep_preinst)
if (EXISTS "${HEXSWEEP_PARAVIEW_CONF}")
  set(hexsweep_preinst "${hexsweep_debian_dir}/preinst")
  configure_file(Packaging/Debian/preinst.in "${hexsweep_preinst}" @ONLY)
else ()
  set(HEXSWEEP_PARAVIEW_CONF)
endif ()
configure_file(Packaging/Debian/postrm.in "${hexsweep_debian_dir}/postrm" @ONLY)
configure_file(Packaging/Debian/changelog.in "${hexsweep_debian_dir}/changelog" @ONLY)
configure_file(Packaging/Debian/Layout.cmake.in "${hexsweep_debian_dir}/Layout.cmake" @ONLY)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME hexsweep)
set(CPACK_PACKAGE_CONTACT "${HEXSWEEP_PACKAGE_CONTACT}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PRE_BUILD_SCRIPTS "${hexsweep_debian_dir}/Layout.cmake")
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL runtime python Unspecified development)
set(CPACK_COMPONENT_RUNTIME_GROUP hexsweep)
set(CPACK_COMPONENT_PYTHON_GROUP hexsweep)
set(CPACK_COMPONENT_UNSPECIFIED_GROUP hexsweep)
set(CPACK_COMPONENT_DEVELOPMENT_GROUP hexsweep-dev)

# Each description has its own first line.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_DEBIAN_PACKAGE_RELEASE "1~deb${hexsweep_deb_release}")
set(CPACK_DEBIAN_PACKAGE_SOURCE hexsweep)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(CPACK_DEBIAN_HEXSWEEP_PACKAGE_NAME hexsweep)
set(CPACK_DEBIAN_HEXSWEEP_PACKAGE_SECTION science)
set(CPACK_DEBIAN_HEXSWEEP_DESCRIPTION "all-hexahedral meshes of swept volumes, for ParaView and Python
HexSweep meshes solids with hexahedra by sweeping one face to another. It
reads CAD files (STEP, IGES, BREP) and surfaces of triangles, finds the
faces to sweep between, and proves of every hexahedron that it is valid at
every point.

This package has the command hexsweep, the plugin for ParaView, the Python
package hexsweep and the libraries that all of them share. They work with the
VTK inside ParaView (python3-paraview), which cannot be installed beside
VTK's own Python package (python3-vtk9).")
set(CPACK_DEBIAN_HEXSWEEP_PACKAGE_SHLIBDEPS ON)
math(EXPR python_next "${Python3_VERSION_MINOR} + 1")
set(CPACK_DEBIAN_HEXSWEEP_PACKAGE_DEPENDS
  "python3-paraview (>= ${ParaView_VERSION}), python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}~), python3 (<< ${Python3_VERSION_MAJOR}.${python_next}~)")
# What shows icons: ParaView's own and ours are SVG, and Debian's ParaView depends on nothing that draws them.
set(hexsweep_svg qt6-svg-plugins)
if (hexsweep_deb_release STREQUAL "12")
  set(hexsweep_svg libqt5svg5)
endif ()
set(CPACK_DEBIAN_HEXSWEEP_PACKAGE_RECOMMENDS "python3-meshio, python3-h5py, ${hexsweep_svg}")
set(CPACK_DEBIAN_HEXSWEEP_PACKAGE_SUGGESTS "hexsweep-dev, gmsh")
# cpack would write this file itself, but for plugins as well, which have no version, and then fails.
set(hexsweep_shlibs)
foreach (module IN LISTS hexsweep_modules)
  _vtk_module_get_module_property("${module}" PROPERTY "library_name" VARIABLE library)
  string(APPEND hexsweep_shlibs "lib${library} 1 hexsweep (= ${hexsweep_deb_version})\n")
endforeach ()
file(WRITE "${hexsweep_debian_dir}/shlibs" "${hexsweep_shlibs}")
set(CPACK_DEBIAN_HEXSWEEP_PACKAGE_CONTROL_EXTRA
  "${hexsweep_debian_dir}/shlibs"
  "${CMAKE_CURRENT_SOURCE_DIR}/Packaging/Debian/triggers"
  "${CMAKE_CURRENT_SOURCE_DIR}/Packaging/Debian/postinst"
  "${CMAKE_CURRENT_SOURCE_DIR}/Packaging/Debian/prerm"
  "${hexsweep_debian_dir}/postrm"
  ${hexsweep_preinst})

set(CPACK_DEBIAN_HEXSWEEP-DEV_PACKAGE_NAME hexsweep-dev)
set(CPACK_DEBIAN_HEXSWEEP-DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_HEXSWEEP-DEV_DESCRIPTION "all-hexahedral meshes of swept volumes, for C++ programs
HexSweep meshes solids with hexahedra by sweeping one face to another, and
proves of every hexahedron that it is valid at every point.

This package has the headers and the CMake files of its VTK modules, which
work with the VTK inside ParaView, and the library of its numerics, which
needs no VTK.")
set(CPACK_DEBIAN_HEXSWEEP-DEV_PACKAGE_DEPENDS
  "hexsweep (= ${hexsweep_deb_version}), paraview-dev, python3-paraview, libeigen3-dev, libopenmesh-dev, coinor-libcbc-dev")
include(CPack)
