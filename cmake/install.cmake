# `cmake --install` gives the program, what it ships, and a package that other projects find with
# find_package(bitrock COMPONENTS ...): the libraries that have public headers, and these headers.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/bitrock)
install(TARGETS bitrock RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
set(parts bitrock)  # all that is compiled before it can be installed
if(BITROCK_PYTHON)
  list(APPEND parts bitrock_python)
endif()

# One file a component, so that nothing is asked for that nobody uses.
get_property(components GLOBAL PROPERTY bitrock_components)
foreach(name ${components})
  get_property(target GLOBAL PROPERTY bitrock_target_of_${name})
  get_property(modules GLOBAL PROPERTY bitrock_modules_of_${name})
  get_property(packages GLOBAL PROPERTY bitrock_packages_of_${name})
  list(APPEND parts ${target})
  install(TARGETS ${target} EXPORT bitrock_${name} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} FILE_SET HEADERS DESTINATION ${BITROCK_INCLUDE_DIR})
  install(EXPORT bitrock_${name} FILE bitrock-${name}-targets.cmake NAMESPACE bitrock:: DESTINATION ${package_dir})
  set(needs "")
  foreach(module ${modules})
    string(APPEND needs "include(\"\${CMAKE_CURRENT_LIST_DIR}/bitrock-${module}.cmake\")\n"
                        "if(NOT bitrock_${module}_FOUND)\n  return()\nendif()\n")
  endforeach()
  foreach(package ${packages})
    string(APPEND needs "find_dependency(${package})\n")
  endforeach()
  configure_file(cmake/component.cmake.in ${PROJECT_BINARY_DIR}/package/bitrock-${name}.cmake @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/package/bitrock-${name}.cmake DESTINATION ${package_dir})
endforeach()

# For those who compile in C by one line.
file(RELATIVE_PATH way_to_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(cmake/bitrock_runtime.pc.in ${PROJECT_BINARY_DIR}/package/bitrock_runtime.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package/bitrock_runtime.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# Target of `./run install`; and what `cmake --install` looks at first (the root CMakeLists.txt), to say in words what is
# not built yet.
add_custom_target(bitrock_installed DEPENDS ${parts})
set(part_files "")
foreach(part ${parts})
  string(APPEND part_files "  \"$<TARGET_FILE:${part}>\"\n")
endforeach()
configure_file(cmake/whole.cmake.in ${PROJECT_BINARY_DIR}/package/whole.cmake.in @ONLY)
file(GENERATE OUTPUT ${BITROCK_WHOLE} INPUT ${PROJECT_BINARY_DIR}/package/whole.cmake.in)

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

# What people run, and what came of it. The program finds it from its own place (cli/shipped.hpp), so the prefix may be
# moved; in the build folder a link stands in the same place beside the program.
set(BITROCK_DATA_DIR ${CMAKE_INSTALL_DATADIR}/bitrock)
bitrock_install_tree(${PROJECT_SOURCE_DIR}/campaigns ${BITROCK_DATA_DIR}/campaigns *.toml features*.csv survey*.csv model.json COMPONENT data)
bitrock_install_tree(${PROJECT_SOURCE_DIR}/examples ${CMAKE_INSTALL_DOCDIR}/examples *.txt *.md *.c *.cpp *.csv *.toml *.py)
install(FILES README.md LICENSE CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
bitrock_install_tree(${PROJECT_SOURCE_DIR}/docs ${CMAKE_INSTALL_DOCDIR}/docs *.md *.bib)

list(JOIN components " " components)
configure_package_config_file(cmake/bitrock-config.cmake.in ${PROJECT_BINARY_DIR}/package/bitrock-config.cmake
                              INSTALL_DESTINATION ${package_dir} PATH_VARS BITROCK_DATA_DIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/bitrock-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/bitrock-config.cmake
              ${PROJECT_BINARY_DIR}/package/bitrock-config-version.cmake DESTINATION ${package_dir})
