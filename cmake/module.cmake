# One module of the house: target bitrock_<name>, alias bitrock::<name>, the warnings and floating-point rules of all.
#
#   bitrock_module(peaks SOURCES parts.cpp scan.cpp LINKS bitrock::base)
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
                         $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-Wno-array-bounds>)
endfunction()

function(bitrock_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LINKS;PRIVATE_LINKS")
  add_library(bitrock_${name} STATIC ${arg_SOURCES})
  add_library(bitrock::${name} ALIAS bitrock_${name})
  set_target_properties(bitrock_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(bitrock_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                             $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}> $<INSTALL_INTERFACE:include/bitrock>)
  target_compile_features(bitrock_${name} PUBLIC cxx_std_20)  # the headers need it, so whoever includes them does
  target_link_libraries(bitrock_${name} PUBLIC ${arg_LINKS} PRIVATE ${arg_PRIVATE_LINKS})
  bitrock_target_rules(bitrock_${name})
  set_property(GLOBAL APPEND PROPERTY bitrock_modules bitrock_${name})
endfunction()
