# SPDX-License-Identifier: GPL-3.0-or-later
include(${CMAKE_CURRENT_LIST_DIR}/write_if_different.cmake)

# embed_kernels(output file...): writes the header `output` with the function kernel_source(), which returns the text of
# the files one after the other. A change of one of them makes the build configure again, and only then compile what
# includes the header: a library of headers has no build step of its own that its users could wait for.
function(embed_kernels output)
  set(longest_literal 16000) # bytes; Visual C++ takes 16380, g++ and clang++ 64 kB and more
  set(statements "")
  foreach(path IN LISTS ARGN)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
    get_filename_component(name ${path} NAME)
    file(SIZE ${path} size)
    if(size GREATER longest_literal)
      message(FATAL_ERROR "${path} has ${size} bytes: too long for a string literal, split it")
    endif()
    file(READ ${path} text)
    string(APPEND statements "  source += \"#line 1 \\\"${name}\\\"\\n\";\n  source += R\"CGAL_SP(${text})CGAL_SP\";\n")
  endforeach()
  set(header "// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization. Written by embed_kernels.cmake: change kernels/*.cl instead.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_KERNEL_SOURCES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_KERNEL_SOURCES_H

#include <string>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

inline std::string kernel_source()
{
  std::string source;
${statements}  return source;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_KERNEL_SOURCES_H
")
  write_if_different(${output} "${header}")
endfunction()
