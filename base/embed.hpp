#pragma once
/// Files carried inside the program, byte for byte. Usable from .cpp files alone: it defines symbols.

#include <string_view>

/// `symbol_bytes()` gives the bytes of `file`. The assembler copies a file as it is, in no time; the same bytes as a
/// C++ array would take the compiler seconds. It does not see that the object depends on the file: name it in
/// OBJECT_DEPENDS. On an address divisible by 16, with a 0 behind the end.
#define BITROCK_EMBED(symbol, file)                            \
  asm(".pushsection .rodata\n.balign 16\n"                     \
      ".global bitrock_" #symbol                               \
      "_begin\n"                                               \
      ".global bitrock_" #symbol                               \
      "_end\n"                                                 \
      "bitrock_" #symbol "_begin:\n.incbin \"" file            \
      "\"\n"                                                   \
      "bitrock_" #symbol "_end:\n.byte 0\n.popsection\n");     \
  extern "C" const char bitrock_##symbol##_begin[];            \
  extern "C" const char bitrock_##symbol##_end[];              \
  static std::string_view symbol##_bytes() {                   \
    return {bitrock_##symbol##_begin, bitrock_##symbol##_end}; \
  }
