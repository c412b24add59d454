# SPDX-License-Identifier: GPL-3.0-or-later
include(${CMAKE_CURRENT_LIST_DIR}/write_if_different.cmake)

# embed_page(output input name): writes the header `output` with the parts of the page `input` as functions that begin with
# `name`: what comes before {HEADER}, before {DATA} and after it.
function(embed_page output input name)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${input})
  file(READ ${input} rest)
  set(header "// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization. Written by embed_page.cmake: change the page instead.

#include <string>

namespace tool {
")
  foreach(part before_header before_data after_data)
    if(part STREQUAL "after_data")
      set(text "${rest}")
    else()
      string(REPLACE "before_" "" mark ${part})
      string(TOUPPER "{${mark}}" mark)
      string(FIND "${rest}" "${mark}" end)
      string(LENGTH ${mark} length)
      string(SUBSTRING "${rest}" 0 ${end} text)
      math(EXPR end "${end} + ${length}")
      string(SUBSTRING "${rest}" ${end} -1 rest)
    endif()
    string(APPEND header "\ninline std::string ${name}_${part}()\n{\n  std::string text;\n")
    string(LENGTH "${text}" length)
    set(begin 0)
    while(begin LESS length) # literals that every compiler takes
      string(SUBSTRING "${text}" ${begin} 16000 piece)
      string(APPEND header "  text += R\"CGAL_SP(${piece})CGAL_SP\";\n")
      math(EXPR begin "${begin} + 16000")
    endwhile()
    string(APPEND header "  return text;\n}\n")
  endforeach()
  string(APPEND header "\n} // namespace tool\n")
  write_if_different(${output} "${header}")
endfunction()
