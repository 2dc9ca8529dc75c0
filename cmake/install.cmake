# The installed package, for find_package(pendula) and pkg-config.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/pendula)
install(TARGETS pendula EXPORT pendula-targets FILE_SET HEADERS)
install(EXPORT pendula-targets NAMESPACE pendula:: DESTINATION ${package_dir})
configure_package_config_file(cmake/pendula-config.cmake.in package/pendula-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(package/pendula-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/pendula-config.cmake ${PROJECT_BINARY_DIR}/package/pendula-config-version.cmake
    DESTINATION ${package_dir})

# Paths relative to the .pc file, so that the installed tree can be moved.
file(RELATIVE_PATH pc_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(cmake/pendula.pc.in package/pendula.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package/pendula.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
