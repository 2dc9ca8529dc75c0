// Refuses to compile under flags that change results. cmake/strict.cmake overrides -ffast-math. This header finds flags that
// cannot be overridden, and protects builds that do not use the CMake files of pendula. Macros do not show all flags: clang
// defines none for -funsafe-math-optimizations, and no compiler defines one for -ffp-contract.
#pragma once

#if defined __FAST_MATH__ || (defined __FINITE_MATH_ONLY__ && __FINITE_MATH_ONLY__)
#error "pendula gives the same bits everywhere only by IEEE-754 arithmetic: compile without -ffast-math and its parts"
#endif

#if defined __ASSOCIATIVE_MATH__ || defined __RECIPROCAL_MATH__ || defined __NO_SIGNED_ZEROS__
#error "pendula gives the same bits everywhere only by IEEE-754 arithmetic: compile without -funsafe-math-optimizations"
#endif

#if __FLT_EVAL_METHOD__ != 0
#error "pendula gives the same bits everywhere only where a double is computed as a double: compile with -msse2 -mfpmath=sse"
#endif
