# The installed package: find_package(pendula) and pkg-config.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/pendula)
install(TARGETS pendula EXPORT pendula-targets FILE_SET HEADERS)
install(EXPORT pendula-targets NAMESPACE pendula:: DESTINATION ${package_dir})
configure_package_config_file(cmake/pendula-config.cmake.in pendula-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(pendula-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/pendula-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/pendula-config-version.cmake
    DESTINATION ${package_dir})

# Paths relative to the .pc file keep the installed tree movable.
file(RELATIVE_PATH pc_to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(cmake/pendula.pc.in pendula.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/pendula.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
