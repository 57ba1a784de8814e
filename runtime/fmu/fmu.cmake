# The library inside an FMU, for each system that can be built for here. Sets for libraries.cpp, which carries them:
# BITROCK_FMU_DEFINITIONS (where the files are), BITROCK_FMU_LIBRARIES (the files), BITROCK_FMU_TARGETS.
set(BITROCK_FMU_DEFINITIONS "")
set(BITROCK_FMU_LIBRARIES "")
set(BITROCK_FMU_TARGETS "")
set(fmu_sources fmu/bit_block.cpp fmu/bit_slave.cpp fmu/bit_values.cpp fmu/fmu.cpp fmu/resource.cpp)

# linux64: the object files of the core and some of its own, linked like libbitrock_runtime.so: without the C++ library,
# so that it loads on systems older than the one it was built on. Debug symbols would only make FMUs large.
if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  add_library(bitrock_fmu_linux64 MODULE ${fmu_sources})
  set_target_properties(bitrock_fmu_linux64 PROPERTIES PREFIX "" OUTPUT_NAME bitrock_bit
                        LIBRARY_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/fmu/linux64
                        LINK_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/fmu/fmu.map)
  target_link_libraries(bitrock_fmu_linux64 PRIVATE bitrock_runtime_core)
  target_compile_options(bitrock_fmu_linux64 PRIVATE ${BITROCK_WITHOUT_CXX_LIBRARY})
  bitrock_target_rules(bitrock_fmu_linux64)
  target_link_options(bitrock_fmu_linux64 PRIVATE
                      -Wl,--version-script=${CMAKE_CURRENT_SOURCE_DIR}/fmu/fmu.map)
  if(NOT "${CMAKE_CXX_FLAGS}" MATCHES "fsanitize")
    target_link_options(bitrock_fmu_linux64 PRIVATE -nodefaultlibs -Wl,--no-undefined -Wl,--as-needed -Wl,--strip-all)
    target_link_libraries(bitrock_fmu_linux64 PRIVATE m c gcc)
  endif()
  set(file ${CMAKE_CURRENT_BINARY_DIR}/fmu/linux64/bitrock_bit.so)
  list(APPEND BITROCK_FMU_DEFINITIONS BITROCK_FMU_LINUX64="${file}")
  list(APPEND BITROCK_FMU_LIBRARIES ${file})
  list(APPEND BITROCK_FMU_TARGETS bitrock_fmu_linux64)
endif()

# win64: the same sources by another compiler, where there is one. Commands of their own, as CMake knows one C++ compiler
# a build.
find_program(BITROCK_WIN64_CXX NAMES x86_64-w64-mingw32-g++-posix x86_64-w64-mingw32-g++
             DOC "compiler for the Windows library inside FMUs")
if(BITROCK_WIN64_CXX)
  get_target_property(core_sources bitrock_runtime_core SOURCES)
  set(flags -std=c++20 -O2 -DNDEBUG -ffp-contract=off -fno-exceptions -fno-rtti -fno-threadsafe-statics -fno-math-errno
            -fno-stack-protector -DBITROCK_API= -I${PROJECT_SOURCE_DIR})
  set(objects "")
  foreach(source ${core_sources} ${fmu_sources})
    string(REPLACE "/" "_" name ${source})
    set(object ${CMAKE_CURRENT_BINARY_DIR}/fmu/win64/${name}.obj)
    add_custom_command(OUTPUT ${object}
                       COMMAND ${CMAKE_CXX_COMPILER_LAUNCHER} ${BITROCK_WIN64_CXX} ${flags} -MD -MF ${object}.d
                               -c ${CMAKE_CURRENT_SOURCE_DIR}/${source} -o ${object}
                       DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${source} DEPFILE ${object}.d
                       COMMENT "Building for win64 ${source}" VERBATIM)
    list(APPEND objects ${object})
  endforeach()
  file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/fmu/win64)
  set(file ${CMAKE_CURRENT_BINARY_DIR}/fmu/win64/bitrock_bit.dll)
  # no date in the head of the file: the same sources give the same bytes
  add_custom_command(OUTPUT ${file}
                     COMMAND ${BITROCK_WIN64_CXX} -shared -static -s -Wl,--no-insert-timestamp -o ${file} ${objects}
                     DEPENDS ${objects} COMMENT "Linking for win64 bitrock_bit.dll" VERBATIM)
  add_custom_target(bitrock_fmu_win64 DEPENDS ${file})
  list(APPEND BITROCK_FMU_DEFINITIONS BITROCK_FMU_WIN64="${file}")
  list(APPEND BITROCK_FMU_LIBRARIES ${file})
  list(APPEND BITROCK_FMU_TARGETS bitrock_fmu_win64)
else()
  message(STATUS "FMUs are for Linux only: no compiler for win64 (package g++-mingw-w64-x86-64-posix)")
endif()
