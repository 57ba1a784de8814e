#pragma once
/// Which vector units the passes are compiled for: AVX-512, AVX2 and plain code that any x86-64 or other machine runs.
/// What lies between them is not worth its code. Include before hwy/foreach_target.h.

#ifndef HWY_DISABLED_TARGETS
/// Units of x86-64 that Highway compiles nothing for.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL)
#endif
