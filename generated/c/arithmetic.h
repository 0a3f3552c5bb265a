/* What flags must not do: results are the same bits everywhere because every operation is done as it is written.

   Generated from templates/c/arithmetic.h.j2, the same for every scene, with
   Jinja2 3.1.6. Do not edit: change templates/ and run `make generate`.
   Most of what flags can do to that the compiler admits to here; what it does not, exact.h finds. */

#include <float.h>

#if FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD == 2 || FLT_EVAL_METHOD > 64
#error "doubles must be evaluated in double precision (on 32-bit x86: -msse2 -mfpmath=sse)"
#endif
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "fast-math changes results: compile without it"
#endif
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "NaN must be told from numbers: compile without -ffinite-math-only"
#endif
#if defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "operations must not be rearranged: compile without -funsafe-math-optimizations"
#endif
#ifdef __NO_SIGNED_ZEROS__
#error "zeros have a sign: compile without -fno-signed-zeros"
#endif
_Static_assert(sizeof 0.1 == sizeof(double), "compile without -fsingle-precision-constant");

/* a*b + c is two operations. -ffp-contract=off says so to GCC and Clang; without it, this does, but
   for Clang under -ffp-contract=fast. */
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif
