# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT

# Headers, libraries, program, schema; what find_package and pkg-config read.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/straightedge)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/straightedge DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.hpp" PATTERN "host" EXCLUDE)
install(TARGETS straightedge_core EXPORT straightedge-core)
install(EXPORT straightedge-core NAMESPACE straightedge:: DESTINATION ${config_dir})

if(TARGET straightedge)
  if(BUILD_SHARED_LIBS)  # the host library finds the core beside it, also for programs that link it alone
    set_target_properties(straightedge PROPERTIES INSTALL_RPATH "$ORIGIN")
  endif()
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/straightedge/host
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/straightedge FILES_MATCHING PATTERN "*.hpp")
  install(TARGETS straightedge EXPORT straightedge-host)
  install(EXPORT straightedge-host NAMESPACE straightedge:: DESTINATION ${config_dir})
  if(EXISTS ${PROJECT_SOURCE_DIR}/schema/straightedge-map.xsd)
    install(FILES ${PROJECT_SOURCE_DIR}/schema/straightedge-map.xsd
            DESTINATION ${CMAKE_INSTALL_DATADIR}/straightedge)
  endif()
endif()
if(TARGET straightedge_program)
  if(BUILD_SHARED_LIBS)
    file(RELATIVE_PATH libraries_from_program ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
    set_target_properties(straightedge_program PROPERTIES INSTALL_RPATH "$ORIGIN/${libraries_from_program}")
  endif()
  install(TARGETS straightedge_program)
endif()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# CMake package.
set(package_dir ${PROJECT_BINARY_DIR}/package)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/straightedgeConfig.cmake.in
  ${package_dir}/straightedgeConfig.cmake INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${package_dir}/straightedgeConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${package_dir}/straightedgeConfig.cmake ${package_dir}/straightedgeConfigVersion.cmake
        DESTINATION ${config_dir})

# pkg-config; paths are relative to the file, so that an installed tree can be moved.
file(RELATIVE_PATH prefix_from_pc ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
set(pc_names straightedge-core)
if(TARGET straightedge)
  list(APPEND pc_names straightedge)
endif()
foreach(name ${pc_names})
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${name}.pc.in ${package_dir}/${name}.pc @ONLY)
  install(FILES ${package_dir}/${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()
