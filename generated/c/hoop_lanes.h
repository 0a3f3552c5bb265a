/* Values of LANES_WIDTH shots abreast, and what is done to them.

   Generated from templates/c/lanes.h.j2, scene hoop, derivation be2a322387c8577d,
   with SymPy 1.14.0 and Jinja2 3.1.6. Do not edit: change derive/ or templates/
   and run `make generate`.
   Included by hoop.c once for every width. Above one lane a value is a struct of two native
   vectors: of two independent chains of operations one hides the other's latency. The processor's
   own comparisons, selections, roots, maxima and minima are asked for by name; the rest is operators,
   which GCC and Clang have for their vectors. */

#define V LANES(vector)
#define M LANES(mask)
#define lanes_all LANES(all)
#define lanes_add LANES(add)
#define lanes_sub LANES(sub)
#define lanes_mul LANES(mul)
#define lanes_div LANES(div)
#define lanes_neg LANES(neg)
#define lanes_sqrt LANES(sqrt)
#define lanes_abs LANES(abs)
#define lanes_max LANES(max)
#define lanes_min LANES(min)
#define lanes_less LANES(less)
#define lanes_at_most LANES(at_most)
#define lanes_equal LANES(equal)
#define lanes_both LANES(both)
#define lanes_either LANES(either)
#define lanes_not LANES(not)
#define lanes_nowhere LANES(nowhere)
#define lanes_select LANES(select)
#define lanes_choose LANES(choose)
#define lanes_any LANES(any)
#define lanes_load LANES(load)
#define lanes_store LANES(store)
#define lanes_gather LANES(gather)
#define K(c) lanes_all(c)

#if LANES_WIDTH == 1

typedef double V;
typedef int M;
LANES_INLINE V lanes_all(double c) { return c; }
LANES_INLINE V lanes_add(V a, V b) { return a + b; }
LANES_INLINE V lanes_sub(V a, V b) { return a - b; }
LANES_INLINE V lanes_mul(V a, V b) { return a * b; }
LANES_INLINE V lanes_div(V a, V b) { return a / b; }
LANES_INLINE V lanes_neg(V a) { return -a; }
LANES_INLINE V lanes_sqrt(V a) { return sqrt(a); }
LANES_INLINE V lanes_abs(V a) { return fabs(a); }
LANES_INLINE M lanes_less(V a, V b) { return a < b; }
LANES_INLINE M lanes_at_most(V a, V b) { return a <= b; }
LANES_INLINE M lanes_equal(V a, V b) { return a == b; }
LANES_INLINE M lanes_both(M a, M b) { return a & b; }
LANES_INLINE M lanes_either(M a, M b) { return a | b; }
LANES_INLINE M lanes_not(M a) { return !a; }
LANES_INLINE M lanes_nowhere(void) { return 0; }
LANES_INLINE V lanes_select(M m, V a, V b) { return m ? a : b; }
LANES_INLINE V lanes_max(V a, V b) { return a < b ? b : a; }
LANES_INLINE V lanes_min(V a, V b) { return a < b ? a : b; }
LANES_INLINE int lanes_any(M m) { return m; }
LANES_INLINE V lanes_load(const double *row) { return *row; }
LANES_INLINE void lanes_store(double *row, V a) { *row = a; }
LANES_INLINE V lanes_gather(const double *first, int64_t stride)
{
    (void)stride;
    return *first;
}

#else

#define N LANES(native)
#define B LANES(native_mask)
#define NATIVE (LANES_WIDTH / 2)
#define n_all LANES(n_all)
#define n_less LANES(n_less)
#define n_at_most LANES(n_at_most)
#define n_equal LANES(n_equal)
#define n_both LANES(n_both)
#define n_either LANES(n_either)
#define n_not LANES(n_not)
#define n_select LANES(n_select)
#define n_sqrt LANES(n_sqrt)
#define n_abs LANES(n_abs)
#define n_max LANES(n_max)
#define n_min LANES(n_min)
#define n_gather LANES(n_gather)

#if defined(__x86_64__) && NATIVE == 8

typedef __m512d N;
typedef __mmask8 B;
LANES_INLINE N n_all(double c) { return _mm512_set1_pd(c); }
LANES_INLINE B n_less(N a, N b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
LANES_INLINE B n_at_most(N a, N b) { return _mm512_cmp_pd_mask(a, b, _CMP_LE_OQ); }
LANES_INLINE B n_equal(N a, N b) { return _mm512_cmp_pd_mask(a, b, _CMP_EQ_OQ); }
LANES_INLINE B n_both(B a, B b) { return _kand_mask8(a, b); }
LANES_INLINE B n_either(B a, B b) { return _kor_mask8(a, b); }
LANES_INLINE B n_not(B a) { return _knot_mask8(a); }
LANES_INLINE N n_select(B m, N a, N b) { return _mm512_mask_blend_pd(m, b, a); }
LANES_INLINE N n_sqrt(N a) { return _mm512_sqrt_pd(a); }
LANES_INLINE N n_abs(N a) { return _mm512_abs_pd(a); }
LANES_INLINE N n_max(N a, N b) { return _mm512_max_pd(b, a); }
LANES_INLINE N n_min(N a, N b) { return _mm512_min_pd(a, b); }
LANES_INLINE N n_gather(const double *first, int64_t stride)
{
    return (N){first[0],          first[stride],     first[2 * stride], first[3 * stride],
               first[4 * stride], first[5 * stride], first[6 * stride], first[7 * stride]};
}

#elif defined(__x86_64__) && NATIVE == 4

typedef __m256d N;
typedef __m256d B;
LANES_INLINE N n_all(double c) { return _mm256_set1_pd(c); }
LANES_INLINE B n_less(N a, N b) { return _mm256_cmp_pd(a, b, _CMP_LT_OQ); }
LANES_INLINE B n_at_most(N a, N b) { return _mm256_cmp_pd(a, b, _CMP_LE_OQ); }
LANES_INLINE B n_equal(N a, N b) { return _mm256_cmp_pd(a, b, _CMP_EQ_OQ); }
LANES_INLINE B n_both(B a, B b) { return _mm256_and_pd(a, b); }
LANES_INLINE B n_either(B a, B b) { return _mm256_or_pd(a, b); }
LANES_INLINE B n_not(B a) { return _mm256_xor_pd(a, (N)(_mm256_set1_epi64x(-1))); }
LANES_INLINE N n_select(B m, N a, N b) { return _mm256_blendv_pd(b, a, m); }
LANES_INLINE N n_sqrt(N a) { return _mm256_sqrt_pd(a); }
LANES_INLINE N n_abs(N a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a); }
LANES_INLINE N n_max(N a, N b) { return _mm256_max_pd(b, a); }
LANES_INLINE N n_min(N a, N b) { return _mm256_min_pd(a, b); }
LANES_INLINE N n_gather(const double *first, int64_t stride)
{
    return (N){first[0], first[stride], first[2 * stride], first[3 * stride]};
}

#else

typedef double N __attribute__((vector_size(8 * NATIVE)));
typedef int64_t B __attribute__((vector_size(8 * NATIVE)));
LANES_INLINE N n_all(double c) { return c - (N){0}; }
LANES_INLINE B n_less(N a, N b) { return a < b; }
LANES_INLINE B n_at_most(N a, N b) { return a <= b; }
LANES_INLINE B n_equal(N a, N b) { return a == b; }
LANES_INLINE B n_both(B a, B b) { return a & b; }
LANES_INLINE B n_either(B a, B b) { return a | b; }
LANES_INLINE B n_not(B a) { return ~a; }
LANES_INLINE N n_select(B m, N a, N b) { return (N)(((B)a & m) | ((B)b & ~m)); }
LANES_INLINE N n_abs(N a) { return (N)((B)a & (INT64_MAX - (B){0})); }
LANES_INLINE N n_sqrt(N a)
{
    for (int lane = 0; lane < NATIVE; lane++)
        a[lane] = sqrt(a[lane]);
    return a;
}
LANES_INLINE N n_max(N a, N b) { return n_select(a < b, b, a); }
LANES_INLINE N n_min(N a, N b) { return n_select(a < b, a, b); }
LANES_INLINE N n_gather(const double *first, int64_t stride)
{
    N a;
    for (int lane = 0; lane < NATIVE; lane++)
        a[lane] = first[stride * lane];
    return a;
}

#endif

typedef struct {
    N lo, hi;
} V;
typedef struct {
    B lo, hi;
} M;

LANES_INLINE V lanes_all(double c)
{
    const N all = n_all(c);
    return (V){all, all};
}
LANES_INLINE V lanes_add(V a, V b) { return (V){a.lo + b.lo, a.hi + b.hi}; }
LANES_INLINE V lanes_sub(V a, V b) { return (V){a.lo - b.lo, a.hi - b.hi}; }
LANES_INLINE V lanes_mul(V a, V b) { return (V){a.lo * b.lo, a.hi * b.hi}; }
LANES_INLINE V lanes_div(V a, V b) { return (V){a.lo / b.lo, a.hi / b.hi}; }
LANES_INLINE V lanes_neg(V a) { return (V){-a.lo, -a.hi}; }
LANES_INLINE V lanes_sqrt(V a) { return (V){n_sqrt(a.lo), n_sqrt(a.hi)}; }
LANES_INLINE V lanes_abs(V a) { return (V){n_abs(a.lo), n_abs(a.hi)}; }
LANES_INLINE V lanes_max(V a, V b) { return (V){n_max(a.lo, b.lo), n_max(a.hi, b.hi)}; }
LANES_INLINE V lanes_min(V a, V b) { return (V){n_min(a.lo, b.lo), n_min(a.hi, b.hi)}; }
LANES_INLINE M lanes_less(V a, V b) { return (M){n_less(a.lo, b.lo), n_less(a.hi, b.hi)}; }
LANES_INLINE M lanes_at_most(V a, V b) { return (M){n_at_most(a.lo, b.lo), n_at_most(a.hi, b.hi)}; }
LANES_INLINE M lanes_equal(V a, V b) { return (M){n_equal(a.lo, b.lo), n_equal(a.hi, b.hi)}; }
LANES_INLINE M lanes_both(M a, M b) { return (M){n_both(a.lo, b.lo), n_both(a.hi, b.hi)}; }
LANES_INLINE M lanes_either(M a, M b) { return (M){n_either(a.lo, b.lo), n_either(a.hi, b.hi)}; }
LANES_INLINE M lanes_not(M a) { return (M){n_not(a.lo), n_not(a.hi)}; }
LANES_INLINE M lanes_nowhere(void)
{
    const N zero = n_all(0.0);
    return (M){n_less(zero, zero), n_less(zero, zero)};
}
LANES_INLINE V lanes_select(M m, V a, V b)
{
    return (V){n_select(m.lo, a.lo, b.lo), n_select(m.hi, a.hi, b.hi)};
}
LANES_INLINE V lanes_load(const double *row)
{
    V a;
    memcpy(&a, row, sizeof a);
    return a;
}
LANES_INLINE void lanes_store(double *row, V a) { memcpy(row, &a, sizeof a); }
LANES_INLINE V lanes_gather(const double *first, int64_t stride)
{
    return (V){n_gather(first, stride), n_gather(first + NATIVE * stride, stride)};
}
LANES_INLINE int lanes_any(M m)
{
    const B any = n_either(m.lo, m.hi);
#if defined(__x86_64__) && NATIVE == 8
    return any != 0;
#elif defined(__x86_64__) && NATIVE == 4
    return _mm256_movemask_pd(any) != 0;
#else
    int64_t found = 0;
    for (int lane = 0; lane < NATIVE; lane++)
        found |= any[lane];
    return found != 0;
#endif
}

#undef N
#undef B
#undef NATIVE
#undef n_all
#undef n_less
#undef n_at_most
#undef n_equal
#undef n_both
#undef n_either
#undef n_not
#undef n_select
#undef n_sqrt
#undef n_abs
#undef n_max
#undef n_min
#undef n_gather

#endif

/* Where one truth holds instead of another. */
LANES_INLINE M lanes_choose(M m, M a, M b)
{
    return lanes_either(lanes_both(a, m), lanes_both(b, lanes_not(m)));
}
