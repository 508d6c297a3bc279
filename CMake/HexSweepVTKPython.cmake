# SPDX-License-Identifier: BSD-3-Clause
# hexsweep_mend_python_targets(<folder>): Debian 13 has CMake files of ParaView whose Python targets name
# files without the suffix of the interpreter (vtkCommonCore.so) that they have there
# (vtkCommonCore.cpython-313-x86_64-linux-gnu.so), so that every find_package() ends with an error. An
# export file whose targets are all there already returns before it looks. So those of the folder are
# made here, with the files that are there. Where nothing is missing nothing is done.
# HexSweepConfig.cmake needs it, too.
function (hexsweep_mend_python_targets folder)
  file(GLOB exports "${folder}/*Python*-targets.cmake")
  foreach (export IN LISTS exports)
    hexsweep_mend_python_export("${export}")
  endforeach ()
endfunction ()

function (hexsweep_mend_python_export targets_file)
  string(REGEX REPLACE "\\.cmake$" "-*.cmake" configurations "${targets_file}")
  file(GLOB configurations "${configurations}")
  if (NOT configurations)
    return ()
  endif ()
  # The prefix is as many folders up as the export file says.
  file(STRINGS "${targets_file}" ups REGEX "^get_filename_component\\(_IMPORT_PREFIX .* PATH\\)")
  set(prefix "${targets_file}")
  foreach (up IN LISTS ups)
    get_filename_component(prefix "${prefix}" DIRECTORY)
  endforeach ()

  set(missing FALSE)
  list(GET configurations 0 configuration)
  file(STRINGS "${configuration}" locations REGEX "^ *IMPORTED_LOCATION_[A-Z]+ ")
  foreach (location IN LISTS locations)
    string(REGEX REPLACE ".*{_IMPORT_PREFIX}/(.*)\\.so\".*" "\\1" stem "${location}")
    get_filename_component(module "${stem}" NAME)
    set(file "${prefix}/${stem}.so")
    if (NOT EXISTS "${file}")
      file(GLOB file "${prefix}/${stem}.cpython-*.so")
      set(missing TRUE)
    endif ()
    if (NOT file)
      return () # gone, whatever its name: the export file says so
    endif ()
    set(file_of_${module} "${file}")
  endforeach ()
  if (NOT missing)
    return ()
  endif ()

  file(STRINGS "${targets_file}" targets REGEX "^add_library\\(")
  foreach (target IN LISTS targets)
    string(REGEX MATCH "^add_library\\(([A-Za-z]+::([A-Za-z0-9_]+)) ([A-Z]+) IMPORTED" target "${target}")
    if (TARGET ${CMAKE_MATCH_1})
      continue ()
    endif ()
    add_library(${CMAKE_MATCH_1} ${CMAKE_MATCH_3} IMPORTED)
    string(REGEX REPLACE "Python$" "" module "${CMAKE_MATCH_2}")
    if (file_of_${module})
      set_target_properties(${CMAKE_MATCH_1} PROPERTIES
        IMPORTED_LOCATION "${file_of_${module}}" IMPORTED_NO_SONAME TRUE)
    endif ()
  endforeach ()
endfunction ()
