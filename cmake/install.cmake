# SPDX-License-Identifier: GPL-3.0-or-later
# `cmake --install`: headers, tool, what find_package() and pkg-config need; `cpack`: a .deb and a .tar.gz of them, and a .deb
# of the Python package.
# Nothing of it knows the prefix, so that the installed tree can be moved.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME main) # the Python package is the other one

set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/CGAL_Spherical_parameterization)
install(TARGETS CGAL_Spherical_parameterization EXPORT CGAL_Spherical_parameterization)
# An export of its own: it depends on the components that it was built with, which users of the headers need not have.
install(TARGETS CGAL_Spherical_parameterization_compiled CGAL_Spherical_parameterization_preparation
  EXPORT CGAL_Spherical_parameterization_compiled)
install(EXPORT CGAL_Spherical_parameterization_compiled DESTINATION ${config_folder}
  NAMESPACE CGAL_Spherical_parameterization:: FILE CGAL_Spherical_parameterization-compiled.cmake)
set(CGAL_SP_COMPILED_WITH "")
if(CGAL_SP_WITH_TBB)
  list(APPEND CGAL_SP_COMPILED_WITH TBB)
endif()
if(CGAL_SP_WITH_OPENCL)
  list(APPEND CGAL_SP_COMPILED_WITH OpenCL)
endif()
install(EXPORT CGAL_Spherical_parameterization DESTINATION ${config_folder}
  NAMESPACE CGAL_Spherical_parameterization:: FILE CGAL_Spherical_parameterization-targets.cmake)
configure_package_config_file(cmake/config.cmake.in CGAL_Spherical_parameterizationConfig.cmake
  INSTALL_DESTINATION ${config_folder} PATH_VARS CMAKE_INSTALL_INCLUDEDIR)
write_basic_package_version_file(CGAL_Spherical_parameterizationConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/CGAL_Spherical_parameterizationConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/CGAL_Spherical_parameterizationConfigVersion.cmake
  DESTINATION ${config_folder})

install(DIRECTORY include/CGAL DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
if(CGAL_SP_WITH_OPENCL)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/include/CGAL DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endif()

# In the .pc file: -frounding-math is what CGAL::CGAL adds, since the exact predicates of its kernels change the rounding
# mode; -ffp-contract=off, what our target adds.
set(pc_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH CGAL_SP_PREFIX_FROM_PC /prefix/${pc_folder} /prefix)
configure_file(cmake/package.pc.in cgal-spherical-parameterization.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/cgal-spherical-parameterization.pc DESTINATION ${pc_folder})

install(FILES README.md CHANGELOG.md CITATION.cff LICENSE LICENSE.GPL DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_BINARY_DIR}/doc/html DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL) # if the target doc is built
if(CGAL_SP_WITH_TOOL)
  install(TARGETS spherical-parameterization)
  install(FILES ${PROJECT_BINARY_DIR}/src/manual/spherical-parameterization.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  # where bash-completion looks: under the name of the program
  install(FILES ${PROJECT_BINARY_DIR}/src/manual/spherical-parameterization.bash RENAME spherical-parameterization
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
endif()

set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME cgal-spherical-parameterization)
set(CPACK_PACKAGE_VENDOR "the authors of CGAL Spherical Parameterization")
set(CPACK_PACKAGE_CONTACT "the authors of CGAL Spherical Parameterization <cgal-spherical-parameterization@localhost>")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ${CGAL_SP_WITH_TOOL})
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libcgal-dev (>= ${CGAL_SP_OLDEST_CGAL}), libboost-dev, libeigen3-dev")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libtbb-dev, ocl-icd-opencl-dev, opencl-clhpp-headers")
set(CPACK_DEBIAN_PACKAGE_SECTION math)

# A .deb for each component
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL main)
set(CPACK_DEBIAN_MAIN_PACKAGE_NAME ${CPACK_PACKAGE_NAME})
if(CGAL_SP_WITH_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "${PROJECT_DESCRIPTION}: the Python package spherical_parameterization")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-spherical-parameterization)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  math(EXPR next "${Python3_VERSION_MINOR} + 1") # the module is for one version
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-meshio, python3-nibabel, python3-distributed")
endif()
include(CPack)
