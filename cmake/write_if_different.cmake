# SPDX-License-Identifier: GPL-3.0-or-later

# write_if_different(output text): what includes a generated header is compiled again only if it has changed.
function(write_if_different output text)
  set(old "")
  if(EXISTS ${output})
    file(READ ${output} old)
  endif()
  if(NOT old STREQUAL text)
    file(WRITE ${output} "${text}")
  endif()
endfunction()
