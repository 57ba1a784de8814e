# `cmake --install` gives the program, the headers and a package that other projects find with find_package(bitrock).
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

get_property(modules GLOBAL PROPERTY bitrock_modules)
install(TARGETS bitrock RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS ${modules} EXPORT bitrock ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS bitrock_runtime_shared EXPORT bitrock LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT bitrock NAMESPACE bitrock:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/bitrock)

# Files of a tree, each in the folder it stands in; install(DIRECTORY) would make every folder, also those that stay
# empty. Looked up again in every build, so that a new file is not forgotten.
# COMPONENT: for those who install a part (the Python package takes `data`).
function(bitrock_install_tree root destination)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "COMPONENT" "")
  set(component "")
  if(arg_COMPONENT)
    set(component COMPONENT ${arg_COMPONENT})
  endif()
  foreach(pattern ${arg_UNPARSED_ARGUMENTS})
    file(GLOB_RECURSE files CONFIGURE_DEPENDS RELATIVE ${root} ${root}/${pattern})
    foreach(file ${files})
      get_filename_component(folder ${file} DIRECTORY)
      install(FILES ${root}/${file} DESTINATION ${destination}/${folder} ${component})
    endforeach()
  endforeach()
endfunction()

foreach(module base dem2d peaks surrogate runtime report studies views)
  bitrock_install_tree(${PROJECT_SOURCE_DIR}/${module} include/bitrock/${module} *.hpp *.h)
endforeach()

# What people run, and what came of it. The program finds it from its own place (cli/shipped.hpp), so the prefix may be
# moved; in the build folder a link stands in the same place beside the program.
set(data ${CMAKE_INSTALL_DATADIR}/bitrock/campaigns)
bitrock_install_tree(${PROJECT_SOURCE_DIR}/campaigns ${data} *.toml features*.csv model.json COMPONENT data)
install(FILES README.md LICENSE CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
bitrock_install_tree(${PROJECT_SOURCE_DIR}/docs ${CMAKE_INSTALL_DOCDIR}/docs *.md *.bib)

configure_package_config_file(cmake/bitrock-config.cmake.in ${PROJECT_BINARY_DIR}/bitrock-config.cmake
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/bitrock)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/bitrock-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/bitrock-config.cmake ${PROJECT_BINARY_DIR}/bitrock-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/bitrock)
