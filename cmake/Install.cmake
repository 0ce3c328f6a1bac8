# SPDX-License-Identifier: BSL-1.0
# cmake --install: the headers, a CMake package and a pkg-config file; all of it independent of the architecture and
# of the place where it is put.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_DATADIR}/cmake/Ansatz)
install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(TARGETS ansatz ansatz_precompiled EXPORT AnsatzTargets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT AnsatzTargets NAMESPACE Ansatz:: DESTINATION ${package_dir})
configure_package_config_file(cmake/AnsatzConfig.cmake.in ${PROJECT_BINARY_DIR}/package/AnsatzConfig.cmake
    INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/AnsatzConfigVersion.cmake
    COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/package/AnsatzConfig.cmake ${PROJECT_BINARY_DIR}/package/AnsatzConfigVersion.cmake
    DESTINATION ${package_dir})

# Boost ships no pkg-config file; where its headers are not in the compiler's own path, the file names their folder.
list(JOIN ANSATZ_COMPILE_OPTIONS " " pc_options)
get_target_property(pc_boost Boost::headers INTERFACE_INCLUDE_DIRECTORIES)
list(REMOVE_ITEM pc_boost ${CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES})
list(TRANSFORM pc_boost PREPEND "-isystem ")
list(JOIN pc_boost " " pc_boost)
set(pc_dir ${CMAKE_INSTALL_DATADIR}/pkgconfig)
file(RELATIVE_PATH pc_prefix ${CMAKE_INSTALL_PREFIX}/${pc_dir} ${CMAKE_INSTALL_PREFIX})
configure_file(cmake/ansatz.pc.in ${PROJECT_BINARY_DIR}/package/ansatz.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package/ansatz.pc DESTINATION ${pc_dir})
