# SPDX-License-Identifier: BSD-3-Clause
# Warnings for our own code only: VTK's, Eigen's and OpenMesh's headers are system headers, and
# generated code (Python wrapping, client-server wrapping, Qt) never calls this. PEDANTIC is for
# code without VTK: vtkTypeMacro and its like leave an extra semicolon. GCC's guess at
# uninitialized values is off: it looks into inlined system headers and is wrong about them.
function (hexsweep_target_warnings target)
  target_compile_options(${target} PRIVATE
    $<$<COMPILE_LANGUAGE:CXX>:-Wall> $<$<COMPILE_LANGUAGE:CXX>:-Wextra>
    $<$<COMPILE_LANGUAGE:CXX>:-Wshadow>
    $<$<COMPILE_LANGUAGE:CXX>:-Wconversion> $<$<COMPILE_LANGUAGE:CXX>:-Wno-sign-conversion>
    $<$<COMPILE_LANGUAGE:CXX>:-Wnon-virtual-dtor> $<$<COMPILE_LANGUAGE:CXX>:-Wcast-align>
    $<$<COMPILE_LANGUAGE:CXX>:-Wdouble-promotion>
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  if ("PEDANTIC" IN_LIST ARGN)
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-Wpedantic>)
  endif ()
  if (HEXSWEEP_WERROR)
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-Werror>)
  endif ()
endfunction ()
