/* Whether doubles are computed here as IEEE 754 says, and as hoopgen's results need.

   Generated from templates/c/exact.h.j2, the same for every scene, with
   Jinja2 3.1.6. Do not edit: change templates/ and run `make generate`.
   Included by a scene's C file once for every width: compilers choose instructions by function. What
   it looks at: what compilers do to a*b + c, to sums, quotients, zeros, subnormals and NaN when their
   flags let them, not all of which they admit to in macros; and that the environment is the default. */

static int LANES(exact)(void)
{
    /* Volatile: no optimizer knows them before it runs. */
    volatile double given[] = {1.0, 0x1p-60, DBL_MIN, 1.0 + 0x1p-30, 5.0, 11.0, 49.0, -0.0, NAN};
    const double one = given[0], tiny = given[1], least = given[2], near = given[3];
    const double divisor = given[6], zero = given[7], nan = given[8];
    volatile double quotients[] = {given[4] / divisor, given[5] / divisor, one / divisor};
    volatile double subnormal = least * 0.5;
    int exact = one + tiny == one && one - tiny == one;
    exact &= (one + tiny) - one == 0.0;
    exact &= subnormal > 0.0 && subnormal + subnormal == least;
    exact &= near * near - (1.0 + 0x1p-29) == 0.0;
    /* 5 (1/49) and 11 (1/49) are other doubles. */
    exact &= quotients[0] == 0x1.a1f58d0fac688p-4 && quotients[1] == 0x1.cbc14e5e0a72fp-3;
    exact &= !signbit(zero + 0.0) && signbit(zero * one);
    exact &= nan != nan && !(nan <= one) && !(nan > one);
    return exact;
}
