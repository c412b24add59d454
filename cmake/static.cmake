# SPDX-License-Identifier: GPL-3.0-or-later
# For -D CMAKE_PROJECT_INCLUDE: the tool as one file that needs no library, not even that of C. Without OpenCL, whose drivers are
# loaded when a program runs. scripts/make_packages.sh uses it.
set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
set(CGAL_Boost_USE_STATIC_LIBS ON CACHE BOOL "Static libraries of Boost")
set(CMAKE_EXE_LINKER_FLAGS "${CMAKE_EXE_LINKER_FLAGS} -static")
set(CMAKE_CXX_STANDARD_LIBRARIES "-lbz2 -llzma -lzstd -lz") # what Boost.Iostreams needs
set(CGAL_SP_WITH_OPENCL OFF CACHE BOOL "OpenCL_device: the solvers on OpenCL devices")
