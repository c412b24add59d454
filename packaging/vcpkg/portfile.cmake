# SPDX-License-Identifier: LGPL-3.0-or-later
# From a clone: vcpkg install cgal-spherical-parameterization --overlay-ports=packaging/vcpkg
set(SOURCE_PATH ${CMAKE_CURRENT_LIST_DIR}/../..)
vcpkg_check_features(OUT_FEATURE_OPTIONS features
  FEATURES tbb CGAL_SP_WITH_TBB opencl CGAL_SP_WITH_OPENCL tool CGAL_SP_WITH_TOOL)
vcpkg_cmake_configure(SOURCE_PATH ${SOURCE_PATH} OPTIONS ${features}
  -DCGAL_SP_BUILD_TESTING=OFF -DCGAL_SP_WITH_EXAMPLES=OFF -DCGAL_SP_WITH_PYTHON=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME CGAL_Spherical_parameterization
  CONFIG_PATH lib/cmake/CGAL_Spherical_parameterization)
vcpkg_fixup_pkgconfig()
if("tool" IN_LIST FEATURES)
  vcpkg_copy_tools(TOOL_NAMES spherical-parameterization AUTO_CLEAN)
endif()
file(REMOVE_RECURSE ${CURRENT_PACKAGES_DIR}/debug/include ${CURRENT_PACKAGES_DIR}/debug/share)
vcpkg_install_copyright(FILE_LIST ${SOURCE_PATH}/LICENSE ${SOURCE_PATH}/LICENSE.GPL)
