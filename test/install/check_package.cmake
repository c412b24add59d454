# SPDX-License-Identifier: GPL-3.0-or-later
# Packs a .deb, unpacks it, and checks what is in it, what it needs, and that its tool maps a mesh.
# cmake -D BUILD=... -D SCRATCH=... -D DPKG_DEB=... -D TOOL=ON|OFF -P check_package.cmake
include(${CMAKE_CURRENT_LIST_DIR}/run.cmake)

file(REMOVE_RECURSE "${SCRATCH}")
run(${CMAKE_CPACK_COMMAND} --config ${BUILD}/CPackConfig.cmake -G DEB -B "${SCRATCH}")
file(GLOB package "${SCRATCH}/cgal-spherical-parameterization_*.deb")
run(${DPKG_DEB} --extract "${package}" "${SCRATCH}/root")
foreach(name spherical_parameterization.h cgal-spherical-parameterization.pc CGAL_Spherical_parameterizationConfig.cmake)
  file(GLOB_RECURSE found "${SCRATCH}/root/usr/*/${name}")
  if(NOT found)
    message(FATAL_ERROR "${name} is not in the package")
  endif()
endforeach()
run(${DPKG_DEB} --field "${package}" Depends)
if(NOT output MATCHES "libcgal-dev \\(>= " OR (TOOL AND NOT output MATCHES "libstdc\\+\\+6"))
  message(FATAL_ERROR "it depends on ${output}")
endif()
if(TOOL)
  file(WRITE "${SCRATCH}/tetrahedron.off" "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")
  run("${SCRATCH}/root/usr/bin/spherical-parameterization" map "${SCRATCH}/tetrahedron.off" -o "${SCRATCH}/sphere.off")
endif()
