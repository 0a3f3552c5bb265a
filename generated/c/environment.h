/* The floating-point environment of a thread: the default one, in which doubles are as IEEE 754 says.

   Generated from templates/c/environment.h.j2, the same for every scene, with
   Jinja2 3.1.6. Do not edit: change templates/ and run `make generate`.
   In it results are rounded to nearest, subnormals are kept, and exceptions are masked. A caller, or
   another library of the process, may have set any other: what computes here sets the default one,
   and puts back what was there, flags of exceptions too. */

#ifndef ENVIRONMENT_WORDS
#define ENVIRONMENT_WORDS 8

#if defined(__SSE2__) || defined(_M_X64)
#include <xmmintrin.h>
#elif !(defined(__GNUC__) && defined(__aarch64__))
#include <fenv.h>
#include <string.h>
_Static_assert(sizeof(fenv_t) <= ENVIRONMENT_WORDS * sizeof(uint64_t), "an environment has more room elsewhere");
#endif

static void environment_enter(uint64_t *before)
{
#if defined(__SSE2__) || defined(_M_X64)
    before[0] = _mm_getcsr();
    _mm_setcsr(0x1f80);
#elif defined(__GNUC__) && defined(__aarch64__)
    __asm__ volatile("mrs %0, fpcr" : "=r"(before[0]));
    __asm__ volatile("mrs %0, fpsr" : "=r"(before[1]));
    __asm__ volatile("msr fpcr, %0" : : "r"((uint64_t)0));
#else
    fenv_t own;
    fegetenv(&own);
    memcpy(before, &own, sizeof own);
    fesetenv(FE_DFL_ENV);
#endif
}

static void environment_leave(const uint64_t *before)
{
#if defined(__SSE2__) || defined(_M_X64)
    _mm_setcsr((unsigned)before[0]);
#elif defined(__GNUC__) && defined(__aarch64__)
    __asm__ volatile("msr fpcr, %0" : : "r"(before[0]));
    __asm__ volatile("msr fpsr, %0" : : "r"(before[1]));
#else
    fenv_t own;
    memcpy(&own, before, sizeof own);
    fesetenv(&own);
#endif
}
#endif
