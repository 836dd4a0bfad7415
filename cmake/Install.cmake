# The libraries below core/, for programs of others: find_package(asperity), asperity::contact, ...

include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/asperity)

get_property(libraries GLOBAL PROPERTY asperity_installed_libraries)
install(TARGETS ${libraries} EXPORT asperity ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        COMPONENT libraries)
install(EXPORT asperity NAMESPACE asperity:: FILE asperityTargets.cmake DESTINATION ${package}
        COMPONENT libraries)
install(DIRECTORY core DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/asperity COMPONENT libraries
        FILES_MATCHING PATTERN "*.h")

configure_package_config_file(cmake/asperityConfig.cmake.in asperityConfig.cmake
                              INSTALL_DESTINATION ${package})
write_basic_package_version_file(asperityConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/asperityConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/asperityConfigVersion.cmake DESTINATION ${package}
        COMPONENT libraries)
