# SPDX-License-Identifier: BSD-3-Clause
# Most of a compiler's time goes into headers of Eigen, VTK and GoogleTest and into the templates that
# each source instantiates anew. Sources in one compilation share both.
option(HEXSWEEP_UNITY_BUILD
  "Compile sources of a folder together: quicker as a whole, slower after a change in one" OFF)

# hexsweep_unity_build(<target> <batch>): at most `batch` sources in one compilation, all of one
# folder, so that names which a source has for itself need to be unique in its folder only.
function (hexsweep_unity_build target batch)
  if (NOT HEXSWEEP_UNITY_BUILD)
    return ()
  endif ()
  set(folders)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cxx$")
  foreach (source IN LISTS sources)
    get_filename_component(path "${source}" ABSOLUTE)
    get_filename_component(path "${path}" DIRECTORY)
    get_filename_component(folder "${path}" NAME)
    list(APPEND folders "${folder}")
    list(APPEND sources_of_${folder} "${source}")
  endforeach ()
  list(REMOVE_DUPLICATES folders)
  foreach (folder IN LISTS folders)
    list(LENGTH sources_of_${folder} count)
    math(EXPR groups "(${count} + ${batch} - 1) / ${batch}")
    set(i 0)
    foreach (source IN LISTS sources_of_${folder})
      math(EXPR group "${i} * ${groups} / ${count}")
      math(EXPR i "${i} + 1")
      set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${folder}${group}")
    endforeach ()
  endforeach ()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # GCC takes a source that is included for a header, whose types without linkage would be at fault.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endfunction ()
