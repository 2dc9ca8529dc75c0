// Refuses to compile under flags that change results. The build takes back -ffast-math; this is for what it cannot take back,
// and for those who compile these sources by a build of their own. Macros tell only a part: of -funsafe-math-optimizations
// clang says nothing, and of -ffp-contract neither compiler does.
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
