# The libraries inside FMUs, of a bit and of a drill string, for each system that can be built for here. Sets for
# libraries.cpp, which carries them: BITROCK_FMU_DEFINITIONS (where the files are), BITROCK_FMU_LIBRARIES (the files),
# BITROCK_FMU_TARGETS.
set(BITROCK_FMU_DEFINITIONS "")
set(BITROCK_FMU_LIBRARIES "")
set(BITROCK_FMU_TARGETS "")
set(fmu_common fmu/bit_block.cpp fmu/core_memory.cpp fmu/fmu.cpp fmu/resource.cpp)
set(fmu_bit_sources ${fmu_common} fmu/bit_slave.cpp fmu/bit_values.cpp)
# and the steps of both strings, without what reads and checks cases
set(fmu_string_sources
    ${fmu_common} fmu/string_block.cpp fmu/string_slave.cpp fmu/string_start.cpp fmu/string_state.cpp
    fmu/string_values.cpp
    drillstring/bit_rock.cpp drillstring/chain.cpp drillstring/drill_string.cpp drillstring/excitation.cpp
    drillstring/hoist.cpp
    well/bit_end.cpp well/rig.cpp well/segment_motion.cpp well/soundness.cpp well/split_top.cpp well/step.cpp
    well/stress.cpp well/top_end.cpp well/well_foot.cpp well/well_string.cpp)

# linux64: the object files of the core and some of its own, linked like libbitrock_runtime.so: without the C++ library,
# so that it loads on systems older than the one it was built on. Debug symbols would only make FMUs large.
function(bitrock_fmu_linux64 inside definition)
  set(target bitrock_${inside}_fmu_linux64)
  add_library(${target} MODULE ${ARGN})
  set_target_properties(${target} PROPERTIES PREFIX "" OUTPUT_NAME bitrock_${inside}
                        LIBRARY_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/fmu/linux64
                        LINK_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/fmu/fmu.map)
  target_link_libraries(${target} PRIVATE bitrock_runtime_core)
  target_compile_options(${target} PRIVATE ${BITROCK_WITHOUT_CXX_LIBRARY})
  bitrock_target_rules(${target})
  target_link_options(${target} PRIVATE -Wl,--version-script=${CMAKE_CURRENT_SOURCE_DIR}/fmu/fmu.map)
  if(NOT "${CMAKE_CXX_FLAGS}" MATCHES "fsanitize")
    if(inside STREQUAL "string")
      target_sources(${target} PRIVATE fmu/without_cxx_library.cpp)
    endif()
    target_link_options(${target} PRIVATE -nodefaultlibs -Wl,--no-undefined -Wl,--as-needed -Wl,--strip-all)
    target_link_libraries(${target} PRIVATE m c gcc)
  endif()
  set(file ${CMAKE_CURRENT_BINARY_DIR}/fmu/linux64/bitrock_${inside}.so)
  set(BITROCK_FMU_DEFINITIONS ${BITROCK_FMU_DEFINITIONS} ${definition}="${file}" PARENT_SCOPE)
  set(BITROCK_FMU_LIBRARIES ${BITROCK_FMU_LIBRARIES} ${file} PARENT_SCOPE)
  set(BITROCK_FMU_TARGETS ${BITROCK_FMU_TARGETS} ${target} PARENT_SCOPE)
endfunction()

if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  bitrock_fmu_linux64(bit BITROCK_FMU_LINUX64 ${fmu_bit_sources})
  bitrock_fmu_linux64(string BITROCK_STRING_FMU_LINUX64 ${fmu_string_sources})
endif()

# win64: the same sources by another compiler, where there is one, with its own C++ library inside. Commands of their own,
# as CMake knows one C++ compiler a build.
find_program(BITROCK_WIN64_CXX NAMES x86_64-w64-mingw32-g++-posix x86_64-w64-mingw32-g++
             DOC "compiler for the Windows library inside FMUs")
function(bitrock_fmu_win64 inside definition)
  set(objects "")
  foreach(source ${ARGN})
    string(REPLACE "/" "_" name ${source})
    list(APPEND objects ${CMAKE_CURRENT_BINARY_DIR}/fmu/win64/${name}.obj)
  endforeach()
  set(file ${CMAKE_CURRENT_BINARY_DIR}/fmu/win64/bitrock_${inside}.dll)
  # no date in the head of the file: the same sources give the same bytes
  add_custom_command(OUTPUT ${file}
                     COMMAND ${BITROCK_WIN64_CXX} -shared -static -s -Wl,--no-insert-timestamp -o ${file} ${objects}
                     DEPENDS ${objects} COMMENT "Linking for win64 bitrock_${inside}.dll" VERBATIM)
  set(BITROCK_FMU_DEFINITIONS ${BITROCK_FMU_DEFINITIONS} ${definition}="${file}" PARENT_SCOPE)
  set(BITROCK_FMU_LIBRARIES ${BITROCK_FMU_LIBRARIES} ${file} PARENT_SCOPE)
  set(fmu_win64_files ${fmu_win64_files} ${file} PARENT_SCOPE)
endfunction()

if(BITROCK_WIN64_CXX)
  get_target_property(core_sources bitrock_runtime_core SOURCES)
  set(flags -std=c++20 -O2 -DNDEBUG -ffp-contract=off -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-math-errno
            -fno-stack-protector -DBITROCK_API= -I${PROJECT_SOURCE_DIR})
  set(win64_sources ${core_sources} ${fmu_bit_sources} ${fmu_string_sources})
  list(REMOVE_DUPLICATES win64_sources)
  file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/fmu/win64)
  foreach(source ${win64_sources})
    string(REPLACE "/" "_" name ${source})
    set(object ${CMAKE_CURRENT_BINARY_DIR}/fmu/win64/${name}.obj)
    add_custom_command(OUTPUT ${object}
                       COMMAND ${CMAKE_CXX_COMPILER_LAUNCHER} ${BITROCK_WIN64_CXX} ${flags} -MD -MF ${object}.d
                               -c ${CMAKE_CURRENT_SOURCE_DIR}/${source} -o ${object}
                       DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${source} DEPFILE ${object}.d
                       COMMENT "Building for win64 ${source}" VERBATIM)
  endforeach()
  set(fmu_win64_files "")
  bitrock_fmu_win64(bit BITROCK_FMU_WIN64 ${core_sources} ${fmu_bit_sources})
  bitrock_fmu_win64(string BITROCK_STRING_FMU_WIN64 ${core_sources} ${fmu_string_sources})
  add_custom_target(bitrock_fmu_win64 DEPENDS ${fmu_win64_files})
  list(APPEND BITROCK_FMU_TARGETS bitrock_fmu_win64)
else()
  message(STATUS "FMUs are for Linux only: no compiler for win64 (package g++-mingw-w64-x86-64-posix)")
endif()
