# One module of the house: target bitrock_<name>, alias bitrock::<name>, the warnings and floating-point rules of all.
#
#   bitrock_module(peaks SOURCES parts.cpp scan.cpp HEADERS parts.hpp LINKS bitrock::base PRIVATE_LINKS hwy::hwy)
#
# SOURCES        what is compiled
# HEADERS        those meant for others: they are installed, and with them the module, as a component of the package
# LINKS          what the headers need
# PRIVATE_LINKS  what only the sources need, but whoever links the module must link too
# OBJECTS        is never a shared library of its own: others take it in
#
# In either list of links, $<BUILD_INTERFACE:Eigen3::Eigen> is a library of headers that only files of the house include:
# whoever uses the installed package does not need it.
#
# -ffp-contract=off: a fused multiply-add rounds once instead of twice, so whether the compiler chose one would change
# the last bit of a result between machines. Off everywhere: same input and seed, same bits.
function(bitrock_target_rules target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow
                         -Wno-missing-field-initializers  # designated initialisers leave the rest at its default on purpose
                         -ffp-contract=off
                         $<$<BOOL:${BITROCK_WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()

# Where no time is spent but the compiler's (flags, pages, tests): -O1 takes a third less of it than -O3, which otherwise is
# the one of a Release build. The last option on the command line counts. Results do not depend on it: see -ffp-contract.
# g++ 12 then sees strings leave their bounds where they are moved (its bug 105651), which it does not at -O0 and -O3.
function(bitrock_quick_to_build target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>
                         "$<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-Wno-array-bounds;-Wno-stringop-overflow>")
endfunction()

# Its public headers, which keep their folders: others include "peaks/statistics.hpp" as we do.
function(bitrock_public_headers target)
  if(ARGN)
    target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${ARGN})
  endif()
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                             $<INSTALL_INTERFACE:${BITROCK_INCLUDE_DIR}>)
endfunction()

# The package that brings a library from outside, as find_dependency takes it.
function(bitrock_package_of library result)
  string(REGEX REPLACE "::.*" "" package ${library})
  if(library STREQUAL HDF5::HDF5)
    set(package "HDF5 COMPONENTS C")
  elseif(library STREQUAL OpenMP::OpenMP_CXX)
    set(package "OpenMP COMPONENTS CXX")
  elseif(library STREQUAL onnx)
    set(package Protobuf ONNX)  # ONNX' package links Protobuf, but does not look for it
  endif()
  set(${result} ${package} PARENT_SCOPE)
endfunction()

# Makes a target a component of the package (install.cmake): what it links of ours and from outside.
function(bitrock_component target)
  get_target_property(name ${target} EXPORT_NAME)
  set(modules "")
  set(packages "")
  foreach(library ${ARGN})
    if(library MATCHES "^bitrock::(.*)")
      list(APPEND modules ${CMAKE_MATCH_1})
    elseif(NOT library MATCHES "BUILD_INTERFACE")
      bitrock_package_of(${library} found)
      list(APPEND packages ${found})
    endif()
  endforeach()
  set_property(GLOBAL APPEND PROPERTY bitrock_components ${name})
  set_property(GLOBAL PROPERTY bitrock_target_of_${name} ${target})
  set_property(GLOBAL PROPERTY bitrock_modules_of_${name} ${modules})
  set_property(GLOBAL PROPERTY bitrock_packages_of_${name} ${packages})
endfunction()

# Reading the headers of the standard library and of fmt is most of what the compiler does for most sources: it does so once
# a module. No source may rely on it: `./run lint` reads each without.
function(bitrock_precompile target links)
  # base brings fmt. Without optimising, fmt asks for -Og by a pragma, and behind a precompiled header g++ 12 goes on to say
  # that it optimises: then the headers of vector instructions are not compiled (Eigen, Highway).
  if((fmt::fmt IN_LIST links OR bitrock::base IN_LIST links) AND NOT CMAKE_BUILD_TYPE STREQUAL Debug)
    set(fmt <fmt/format.h>)
  endif()
  target_precompile_headers(${target} PRIVATE ${fmt} <algorithm> <array> <cmath> <filesystem> <functional> <limits> <map>
                            <memory> <numbers> <optional> <span> <string> <string_view> <utility> <vector>)
endfunction()

function(bitrock_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "OBJECTS" "" "SOURCES;HEADERS;LINKS;PRIVATE_LINKS")
  if(arg_OBJECTS OR NOT arg_HEADERS)  # without public headers: part of the program, not installed
    set(kind STATIC)
  endif()
  add_library(bitrock_${name} ${kind} ${arg_SOURCES})  # others: as BUILD_SHARED_LIBS says
  add_library(bitrock::${name} ALIAS bitrock_${name})
  # no symbol of its own when shared: static and shared libraries compile alike
  set_target_properties(bitrock_${name} PROPERTIES EXPORT_NAME ${name} DEFINE_SYMBOL "")
  bitrock_public_headers(bitrock_${name} ${arg_HEADERS})
  target_include_directories(bitrock_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}>)
  target_compile_features(bitrock_${name} PUBLIC cxx_std_20)  # the headers need it, so whoever includes them does
  target_link_libraries(bitrock_${name} PUBLIC ${arg_LINKS} PRIVATE ${arg_PRIVATE_LINKS})
  bitrock_target_rules(bitrock_${name})
  list(LENGTH arg_SOURCES count)
  if(count GREATER 6 AND NOT arg_OBJECTS)  # fewer are read sooner one by one
    bitrock_precompile(bitrock_${name} "${arg_LINKS}")
  endif()
  if(arg_HEADERS)
    bitrock_component(bitrock_${name} ${arg_LINKS} ${arg_PRIVATE_LINKS})
  endif()
endfunction()
