# `cmake --install` gives the program, the headers and a package that other projects find with find_package(bitrock).
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

get_property(modules GLOBAL PROPERTY bitrock_modules)
install(TARGETS bitrock RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS ${modules} EXPORT bitrock ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS bitrock_runtime_shared EXPORT bitrock LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT bitrock NAMESPACE bitrock:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/bitrock)
foreach(module base dem2d peaks surrogate runtime campaigns report)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${module} DESTINATION include/bitrock FILES_MATCHING PATTERN "*.hpp" PATTERN "*.h")
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/base/version.hpp DESTINATION include/bitrock/base)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/campaigns/ DESTINATION ${CMAKE_INSTALL_DATADIR}/bitrock/campaigns
        FILES_MATCHING PATTERN "*.toml")

configure_package_config_file(cmake/bitrock-config.cmake.in ${PROJECT_BINARY_DIR}/bitrock-config.cmake
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/bitrock)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/bitrock-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/bitrock-config.cmake ${PROJECT_BINARY_DIR}/bitrock-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/bitrock)
