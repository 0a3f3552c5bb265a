/* Values of LANES_WIDTH shots abreast, and what is done to them.

   Generated from templates/c/lanes.h.j2, the same for every scene, with
   Jinja2 3.1.6. Do not edit: change templates/ and run `make generate`.
   Included by a scene's engine once for every width. Above one lane a value is LANES_VECTORS native
   vectors: a struct of two, since of two independent chains of operations one hides the other's
   latency; or one, of which long kernels take 0.37 to 0.6 of the time to compile. The processor's
   own comparisons, selections, roots, maxima and minima are asked for by name; the rest is
   operators, which GCC and Clang have for their vectors. */

#ifndef LANES_POPULATION
/* How many bits are set; without GCC or Clang there is one lane. */
#if defined(__GNUC__)
#define LANES_POPULATION(bits) __builtin_popcount(bits)
#define LANES_SELDOM(asked) __builtin_expect((asked) != 0, 0)
#define LANES_APART static __attribute__((noinline))
#else
#define LANES_POPULATION(bits) ((bits) & 1U)
#define LANES_SELDOM(asked) (asked)
#define LANES_APART static
#endif
/* A loop of at most eight rounds without its loop, so that the vectors of an array stay in registers. */
#if defined(__GNUC__) && !defined(__clang__)
#define LANES_UNROLL _Pragma("GCC unroll 8")
#else
#define LANES_UNROLL
#endif

/* EACH(what, of, x, y) is what(of, x) what(of, y), for up to 32 variables. */
#define EACH_1(what, of, x) what(of, x)
#define EACH_2(what, of, x, ...) what(of, x) EACH_1(what, of, __VA_ARGS__)
#define EACH_3(what, of, x, ...) what(of, x) EACH_2(what, of, __VA_ARGS__)
#define EACH_4(what, of, x, ...) what(of, x) EACH_3(what, of, __VA_ARGS__)
#define EACH_5(what, of, x, ...) what(of, x) EACH_4(what, of, __VA_ARGS__)
#define EACH_6(what, of, x, ...) what(of, x) EACH_5(what, of, __VA_ARGS__)
#define EACH_7(what, of, x, ...) what(of, x) EACH_6(what, of, __VA_ARGS__)
#define EACH_8(what, of, x, ...) what(of, x) EACH_7(what, of, __VA_ARGS__)
#define EACH_9(what, of, x, ...) what(of, x) EACH_8(what, of, __VA_ARGS__)
#define EACH_10(what, of, x, ...) what(of, x) EACH_9(what, of, __VA_ARGS__)
#define EACH_11(what, of, x, ...) what(of, x) EACH_10(what, of, __VA_ARGS__)
#define EACH_12(what, of, x, ...) what(of, x) EACH_11(what, of, __VA_ARGS__)
#define EACH_13(what, of, x, ...) what(of, x) EACH_12(what, of, __VA_ARGS__)
#define EACH_14(what, of, x, ...) what(of, x) EACH_13(what, of, __VA_ARGS__)
#define EACH_15(what, of, x, ...) what(of, x) EACH_14(what, of, __VA_ARGS__)
#define EACH_16(what, of, x, ...) what(of, x) EACH_15(what, of, __VA_ARGS__)
#define EACH_17(what, of, x, ...) what(of, x) EACH_16(what, of, __VA_ARGS__)
#define EACH_18(what, of, x, ...) what(of, x) EACH_17(what, of, __VA_ARGS__)
#define EACH_19(what, of, x, ...) what(of, x) EACH_18(what, of, __VA_ARGS__)
#define EACH_20(what, of, x, ...) what(of, x) EACH_19(what, of, __VA_ARGS__)
#define EACH_21(what, of, x, ...) what(of, x) EACH_20(what, of, __VA_ARGS__)
#define EACH_22(what, of, x, ...) what(of, x) EACH_21(what, of, __VA_ARGS__)
#define EACH_23(what, of, x, ...) what(of, x) EACH_22(what, of, __VA_ARGS__)
#define EACH_24(what, of, x, ...) what(of, x) EACH_23(what, of, __VA_ARGS__)
#define EACH_25(what, of, x, ...) what(of, x) EACH_24(what, of, __VA_ARGS__)
#define EACH_26(what, of, x, ...) what(of, x) EACH_25(what, of, __VA_ARGS__)
#define EACH_27(what, of, x, ...) what(of, x) EACH_26(what, of, __VA_ARGS__)
#define EACH_28(what, of, x, ...) what(of, x) EACH_27(what, of, __VA_ARGS__)
#define EACH_29(what, of, x, ...) what(of, x) EACH_28(what, of, __VA_ARGS__)
#define EACH_30(what, of, x, ...) what(of, x) EACH_29(what, of, __VA_ARGS__)
#define EACH_31(what, of, x, ...) what(of, x) EACH_30(what, of, __VA_ARGS__)
#define EACH_32(what, of, x, ...) what(of, x) EACH_31(what, of, __VA_ARGS__)
#define EACH_OF(_1, _2, _3, _4, _5, _6, _7, _8, _9, _10, _11, _12, _13, _14, _15, _16, _17, _18, _19, _20, _21, _22, _23, _24, _25, _26, _27, _28, _29, _30, _31, _32, each, ...) each
#define EACH(what, of, ...) \
    EACH_OF(__VA_ARGS__, EACH_32, EACH_31, EACH_30, EACH_29, EACH_28, EACH_27, EACH_26, EACH_25, EACH_24, EACH_23, EACH_22, EACH_21, EACH_20, EACH_19, EACH_18, EACH_17, EACH_16, EACH_15, EACH_14, EACH_13, EACH_12, EACH_11, EACH_10, EACH_9, EACH_8, EACH_7, EACH_6, EACH_5, EACH_4, EACH_3, EACH_2, EACH_1, 0)(what, of, __VA_ARGS__)

/* What is said of each variable x: `of` is the prefix of the list that has its column, or the result
   of a kernel; where it is two of them in brackets, BOTH takes these away. */
#define BOTH(...) __VA_ARGS__
#define START(of, x) V x = K(0.0);
#define LOAD(of, x) V x = lanes_load(worklist->of##x + i);
#define STORE(of, x) lanes_store(worklist->of##x + i, x);
#define PACK(of, x) lanes_pack(worklist->of##x + of##shots, packed, x);
#define CLEAR(of, x) lanes_store(worklist->of##x + of##shots, K(0.0));
#define EXPAND(of, x) x = lanes_expand(worklist->of##x + taken, idle, x);
#define GET(of, x) V x = of.x;
#define SELECT_IN(x, one, two) x = lanes_select(one, two.x, x);
#define SELECT_OF(x, ...) SELECT_IN(x, __VA_ARGS__)
#define SELECT(of, x) SELECT_OF(x, BOTH of)
#define START_MASK(of, x) M x = mask_none();
#define LOAD_MASK(of, x) M x = lanes_less(K(0.0), lanes_load(worklist->of##x + i));
#define STORE_MASK(of, x) lanes_store(worklist->of##x + i, lanes_select(x, K(1.0), K(0.0)));
#define PACK_MASK(of, x) lanes_pack(worklist->of##x + of##shots, packed, lanes_select(x, K(1.0), K(0.0)));
#define EXPAND_MASK(of, x) x = lanes_less(K(0.0), lanes_expand(worklist->of##x + taken, idle, lanes_select(x, K(1.0), K(0.0))));
#define GET_MASK(of, x) M x = of.x;
#define SELECT_MASK_IN(x, one, two) x = lanes_choose(one, two.x, x);
#define SELECT_MASK_OF(x, ...) SELECT_MASK_IN(x, __VA_ARGS__)
#define SELECT_MASK(of, x) SELECT_MASK_OF(x, BOTH of)
#define START_SINGLE(of, x) S x = KS(0.0);
#define LOAD_SINGLE(of, x) S x = singles_load(worklist->of##x + i);
#define STORE_SINGLE(of, x) singles_store(worklist->of##x + i, x);
#define PACK_SINGLE(of, x) singles_pack(worklist->of##x + of##shots, packed, x);
#define CLEAR_SINGLE(of, x) singles_store(worklist->of##x + of##shots, KS(0.0));
#define EXPAND_SINGLE(of, x) x = singles_expand(worklist->of##x + taken, idle, x);
#define GET_SINGLE(of, x) S x = of.x;
#define SELECT_SINGLE_IN(x, one, two) x = singles_select(singles_of(one), two.x, x);
#define SELECT_SINGLE_OF(x, ...) SELECT_SINGLE_IN(x, __VA_ARGS__)
#define SELECT_SINGLE(of, x) SELECT_SINGLE_OF(x, BOTH of)
#define SET(of, x) x = of.x;
#define RETURN_IN(x, one, two) worklist->one##x[row] = worklist->two##x[k];
#define RETURN_OF(x, ...) RETURN_IN(x, __VA_ARGS__)
#define RETURN(of, x) RETURN_OF(x, BOTH of)
#define PARAMETER(of, x) const V x = lanes_load(worklist->of##parameters.x + i);
#define PARAMETER_TAKEN(of, x) const V x = lanes_expand(worklist->of##parameters.x + taken, idle, lanes_load(worklist->turning_##x));
#define TURNING(of, x) lanes_store(worklist->of##x, x);

/* The same between rows, and those of shots that wait. */
#define FILL(of, x) lanes_store(worklist->of##x + row, K(0.0));
#define FILL_SINGLE(of, x) singles_store(worklist->of##x + row, KS(0.0));
#define BEGIN(of, x) lanes_store(worklist->x + row + k, of);
#define BEGIN_SINGLE(of, x) singles_store(worklist->x + row + k, of);
#define KEEP(of, x) lanes_pack(worklist->of##x + kept, going, lanes_load(worklist->of##x + i));
#define KEEP_SINGLE(of, x) singles_pack(worklist->of##x + kept, going, singles_load(worklist->of##x + i));
#define WAIT(of, x) lanes_pack(worklist->of##x + worklist->waiting, who, lanes_load(worklist->x + row));
#define WAIT_SINGLE(of, x) \
    singles_pack(worklist->of##x + worklist->waiting, who, singles_load(worklist->x + row));
#define RESUME(of, x) memcpy(worklist->x + row, worklist->of##x + from, shots * sizeof *worklist->x);

/* The result of a kernel, and what kernels are given ready made. */
#define CALL(kernel, result) const LANES(kernel##_out) result = LANES(kernel)
#define FIXED(row) lanes_load(worklist->fixed[row])
#define FIXED_SINGLE(row) singles_load(worklist->fixed_single[row])
#define FIX(row, value) lanes_store(worklist->fixed[row], value)
#define FIX_SINGLE(row, value) singles_store(worklist->fixed_single[row], value)

/* Whether to do what mostly some lane needs: many lanes do not ask, as a branch would keep
   operations before it from being mixed with those behind it. */
#define LANES_USUAL(mask) (LANES_WIDTH > 1 || lanes_any(mask))

#if defined(__GNUC__) && defined(__x86_64__)
/* Which halves of four doubles go where, by the mask of those that are packed, or are filled. */
static const uint8_t PACKED[16][8] = {
    {0, 1, 0, 1, 0, 1, 0, 1},
    {0, 1, 0, 1, 0, 1, 0, 1},
    {2, 3, 0, 1, 0, 1, 0, 1},
    {0, 1, 2, 3, 0, 1, 0, 1},
    {4, 5, 0, 1, 0, 1, 0, 1},
    {0, 1, 4, 5, 0, 1, 0, 1},
    {2, 3, 4, 5, 0, 1, 0, 1},
    {0, 1, 2, 3, 4, 5, 0, 1},
    {6, 7, 0, 1, 0, 1, 0, 1},
    {0, 1, 6, 7, 0, 1, 0, 1},
    {2, 3, 6, 7, 0, 1, 0, 1},
    {0, 1, 2, 3, 6, 7, 0, 1},
    {4, 5, 6, 7, 0, 1, 0, 1},
    {0, 1, 4, 5, 6, 7, 0, 1},
    {2, 3, 4, 5, 6, 7, 0, 1},
    {0, 1, 2, 3, 4, 5, 6, 7},
};
static const uint8_t EXPANDED[16][8] = {
    {0, 1, 0, 1, 0, 1, 0, 1},
    {0, 1, 0, 1, 0, 1, 0, 1},
    {0, 1, 0, 1, 0, 1, 0, 1},
    {0, 1, 2, 3, 0, 1, 0, 1},
    {0, 1, 0, 1, 0, 1, 0, 1},
    {0, 1, 0, 1, 2, 3, 0, 1},
    {0, 1, 0, 1, 2, 3, 0, 1},
    {0, 1, 2, 3, 4, 5, 0, 1},
    {0, 1, 0, 1, 0, 1, 0, 1},
    {0, 1, 0, 1, 0, 1, 2, 3},
    {0, 1, 0, 1, 0, 1, 2, 3},
    {0, 1, 2, 3, 0, 1, 4, 5},
    {0, 1, 0, 1, 0, 1, 2, 3},
    {0, 1, 0, 1, 2, 3, 4, 5},
    {0, 1, 0, 1, 2, 3, 4, 5},
    {0, 1, 2, 3, 4, 5, 6, 7},
};
#endif
#endif

/* Names that mean another thing for each width, by the same words: they need no #undef. */
#define V LANES(vector)
#define M LANES(mask)
#define K(c) lanes_all(c)
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
#define lanes_select LANES(select)
#define lanes_load LANES(load)
#define lanes_store LANES(store)
#define lanes_pack LANES(pack)
#define lanes_expand LANES(expand)
#define lanes_choose LANES(choose)
#define lanes_any LANES(any)
#define lanes_columns LANES(columns)
#define lanes_size LANES(size)
#define lanes_rows LANES(rows)
#define lanes_stream LANES(stream)
#define lanes_bits LANES(bits)
#define lanes_of LANES(of)
#define lanes_leading LANES(leading)
#define lanes_narrow LANES(narrow)
#define lanes_wide LANES(wide)
#define mask_none LANES(mask_none)
#define mask_first_n LANES(mask_first_n)
#define popcount LANES(popcount)
#define iota LANES(iota)
#define S LANES(single)
#define Q LANES(single_mask)
#define KS(c) singles_all((float)(c))
#define singles_all LANES(singles_all)
#define singles_add LANES(singles_add)
#define singles_sub LANES(singles_sub)
#define singles_mul LANES(singles_mul)
#define singles_div LANES(singles_div)
#define singles_neg LANES(singles_neg)
#define singles_sqrt LANES(singles_sqrt)
#define singles_abs LANES(singles_abs)
#define singles_max LANES(singles_max)
#define singles_min LANES(singles_min)
#define singles_less LANES(singles_less)
#define singles_at_most LANES(singles_at_most)
#define singles_equal LANES(singles_equal)
#define singles_both LANES(singles_both)
#define singles_either LANES(singles_either)
#define singles_not LANES(singles_not)
#define singles_select LANES(singles_select)
#define singles_load LANES(singles_load)
#define singles_store LANES(singles_store)
#define singles_pack LANES(singles_pack)
#define singles_expand LANES(singles_expand)
#define singles_mask_none LANES(singles_mask_none)
#define singles_truth LANES(singles_truth)
#define singles_of LANES(singles_of)

#if LANES_WIDTH == 1

typedef double V;
typedef int M;
typedef float S;
typedef int Q;
LANES_INLINE V lanes_all(double c) { return c; }
LANES_INLINE M lanes_less(V a, V b) { return a < b; }
LANES_INLINE M lanes_at_most(V a, V b) { return a <= b; }
LANES_INLINE M lanes_equal(V a, V b) { return a == b; }
LANES_INLINE M lanes_both(M a, M b) { return a & b; }
LANES_INLINE M lanes_either(M a, M b) { return a | b; }
LANES_INLINE M lanes_not(M a) { return !a; }
LANES_INLINE V lanes_select(M m, V a, V b) { return m ? a : b; }
LANES_INLINE V lanes_sqrt(V a) { return sqrt(a); }
LANES_INLINE V lanes_abs(V a) { return fabs(a); }
LANES_INLINE V lanes_max(V a, V b) { return a < b ? b : a; }
LANES_INLINE V lanes_min(V a, V b) { return a < b ? a : b; }
LANES_INLINE S singles_all(float c) { return c; }
LANES_INLINE Q singles_less(S a, S b) { return a < b; }
LANES_INLINE Q singles_at_most(S a, S b) { return a <= b; }
LANES_INLINE Q singles_equal(S a, S b) { return a == b; }
LANES_INLINE Q singles_both(Q a, Q b) { return a & b; }
LANES_INLINE Q singles_either(Q a, Q b) { return a | b; }
LANES_INLINE Q singles_not(Q a) { return !a; }
LANES_INLINE S singles_select(Q m, S a, S b) { return m ? a : b; }
LANES_INLINE S singles_sqrt(S a) { return sqrtf(a); }
LANES_INLINE S singles_abs(S a) { return fabsf(a); }
LANES_INLINE S singles_max(S a, S b) { return a < b ? b : a; }
LANES_INLINE S singles_min(S a, S b) { return a < b ? a : b; }
LANES_INLINE V lanes_add(V a, V b) { return a + b; }
LANES_INLINE V lanes_sub(V a, V b) { return a - b; }
LANES_INLINE V lanes_mul(V a, V b) { return a * b; }
LANES_INLINE V lanes_div(V a, V b) { return a / b; }
LANES_INLINE V lanes_neg(V a) { return -a; }
LANES_INLINE M mask_none(void) { return 0; }
LANES_INLINE int lanes_any(M m) { return m; }
LANES_INLINE V lanes_load(const double *row) { return *row; }
LANES_INLINE void lanes_store(double *row, V a) { *row = a; }
LANES_INLINE void lanes_columns(double *const *to, const double *rows, int count, int wanted)
{
    (void)count;
    for (int column = 0; column < wanted; column++)
        *to[column] = rows[column];
}
LANES_INLINE void lanes_rows(double *rows, const double *const *from, int count)
{
    for (int column = 0; column < count; column++)
        rows[column] = *from[column];
}
LANES_INLINE int lanes_stream(double *rows, const double *const *from, int count)
{
    (void)rows, (void)from, (void)count;
    return 0;
}
LANES_INLINE unsigned lanes_bits(M m) { return (unsigned)m; }
LANES_INLINE M lanes_of(unsigned bits) { return (M)bits; }
LANES_INLINE V iota(void) { return 0.0; }
LANES_INLINE void lanes_pack(double *to, M m, V a)
{
    if (m)
        *to = a;
}
LANES_INLINE V lanes_expand(const double *from, M m, V old) { return m ? *from : old; }

LANES_INLINE S singles_load(const float *row) { return *row; }
LANES_INLINE void singles_store(float *row, S a) { *row = a; }
LANES_INLINE S lanes_narrow(V a) { return (float)a; }
LANES_INLINE V lanes_wide(S a) { return a; }
LANES_INLINE M singles_truth(Q m) { return m; }
LANES_INLINE Q singles_of(M m) { return m; }
LANES_INLINE void singles_pack(float *to, M m, S a)
{
    if (m)
        *to = a;
}
LANES_INLINE S singles_expand(const float *from, M m, S old) { return m ? *from : old; }

#else

#define N LANES(native)
#define B LANES(native_mask)
#define NATIVE (LANES_WIDTH / LANES_VECTORS)
#define n_load LANES(n_load)
#define n_store LANES(n_store)
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
#define n_square LANES(n_square)
#define n_bits LANES(n_bits)
#define n_of LANES(n_of)
#define n_pack LANES(n_pack)
#define n_expand LANES(n_expand)

#if defined(__x86_64__) && NATIVE == 8

typedef __m512d N;
typedef __mmask8 B;
LANES_INLINE N n_all(double c) { return _mm512_set1_pd(c); }
LANES_INLINE B n_less(N a, N b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
LANES_INLINE B n_at_most(N a, N b) { return _mm512_cmp_pd_mask(a, b, _CMP_LE_OQ); }
LANES_INLINE B n_equal(N a, N b) { return _mm512_cmp_pd_mask(a, b, _CMP_EQ_OQ); }
LANES_INLINE B n_both(B a, B b) { return (B)(a & b); }
LANES_INLINE B n_either(B a, B b) { return (B)(a | b); }
LANES_INLINE B n_not(B a) { return (B)~a; }
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
LANES_INLINE void n_square(N *a)
{
    N b[8], c[8];
    LANES_UNROLL
    for (int k = 0; k < 8; k += 2) {
        b[k] = _mm512_unpacklo_pd(a[k], a[k + 1]);
        b[k + 1] = _mm512_unpackhi_pd(a[k], a[k + 1]);
    }
    LANES_UNROLL
    for (int k = 0; k < 2; k++) {
        c[k] = _mm512_shuffle_f64x2(b[k], b[k + 2], 0x88);
        c[k + 2] = _mm512_shuffle_f64x2(b[k], b[k + 2], 0xdd);
        c[k + 4] = _mm512_shuffle_f64x2(b[k + 4], b[k + 6], 0x88);
        c[k + 6] = _mm512_shuffle_f64x2(b[k + 4], b[k + 6], 0xdd);
    }
    LANES_UNROLL
    for (int k = 0; k < 4; k++) {
        a[k] = _mm512_shuffle_f64x2(c[k], c[k + 4], 0x88);
        a[k + 4] = _mm512_shuffle_f64x2(c[k], c[k + 4], 0xdd);
    }
}
LANES_INLINE unsigned n_bits(B m) { return m; }
LANES_INLINE B n_of(unsigned bits) { return (B)bits; }
LANES_INLINE void n_pack(double *to, B m, N a)
{
    _mm512_storeu_pd(to, _mm512_maskz_compress_pd(m, a));
}
LANES_INLINE N n_expand(const double *from, B m, N old)
{
    return _mm512_mask_expand_pd(old, m, _mm512_loadu_pd(from));
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
LANES_INLINE B n_not(B a) { return _mm256_xor_pd(a, (N)_mm256_set1_epi64x(-1)); }
LANES_INLINE N n_select(B m, N a, N b) { return _mm256_blendv_pd(b, a, m); }
LANES_INLINE N n_sqrt(N a) { return _mm256_sqrt_pd(a); }
LANES_INLINE N n_abs(N a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a); }
LANES_INLINE N n_max(N a, N b) { return _mm256_max_pd(b, a); }
LANES_INLINE N n_min(N a, N b) { return _mm256_min_pd(a, b); }
LANES_INLINE N n_gather(const double *first, int64_t stride)
{
    return (N){first[0], first[stride], first[2 * stride], first[3 * stride]};
}
LANES_INLINE void n_square(N *a)
{
    const N even = _mm256_unpacklo_pd(a[0], a[1]), odd = _mm256_unpackhi_pd(a[0], a[1]);
    const N next = _mm256_unpacklo_pd(a[2], a[3]), last = _mm256_unpackhi_pd(a[2], a[3]);
    a[0] = _mm256_permute2f128_pd(even, next, 0x20);
    a[1] = _mm256_permute2f128_pd(odd, last, 0x20);
    a[2] = _mm256_permute2f128_pd(even, next, 0x31);
    a[3] = _mm256_permute2f128_pd(odd, last, 0x31);
}
LANES_INLINE unsigned n_bits(B m) { return (unsigned)_mm256_movemask_pd(m); }
LANES_INLINE B n_of(unsigned bits)
{
    const __m256i each = _mm256_set_epi64x(8, 4, 2, 1);
    const __m256i own = _mm256_and_si256(_mm256_set1_epi64x((int64_t)bits), each);
    return (B)_mm256_cmpeq_epi64(own, each);
}
LANES_INLINE N LANES(n_permute)(const uint8_t *order, N a)
{
    const __m256i pairs = _mm256_cvtepu8_epi32(_mm_loadl_epi64((const __m128i *)order));
    return (N)_mm256_permutevar8x32_epi32((__m256i)a, pairs);
}
LANES_INLINE void n_pack(double *to, B m, N a)
{
    _mm256_storeu_pd(to, LANES(n_permute)(PACKED[n_bits(m)], a));
}
LANES_INLINE N n_expand(const double *from, B m, N old)
{
    return n_select(m, LANES(n_permute)(EXPANDED[n_bits(m)], _mm256_loadu_pd(from)), old);
}

#elif defined(__x86_64__)

typedef __m128d N;
typedef __m128d B;
LANES_INLINE N n_all(double c) { return _mm_set1_pd(c); }
LANES_INLINE B n_less(N a, N b) { return _mm_cmplt_pd(a, b); }
LANES_INLINE B n_at_most(N a, N b) { return _mm_cmple_pd(a, b); }
LANES_INLINE B n_equal(N a, N b) { return _mm_cmpeq_pd(a, b); }
LANES_INLINE B n_both(B a, B b) { return _mm_and_pd(a, b); }
LANES_INLINE B n_either(B a, B b) { return _mm_or_pd(a, b); }
LANES_INLINE B n_not(B a) { return _mm_xor_pd(a, (N)_mm_set1_epi64x(-1)); }
LANES_INLINE N n_select(B m, N a, N b) { return _mm_or_pd(_mm_and_pd(m, a), _mm_andnot_pd(m, b)); }
LANES_INLINE N n_sqrt(N a) { return _mm_sqrt_pd(a); }
LANES_INLINE N n_abs(N a) { return _mm_andnot_pd(_mm_set1_pd(-0.0), a); }
LANES_INLINE N n_max(N a, N b) { return _mm_max_pd(b, a); }
LANES_INLINE N n_min(N a, N b) { return _mm_min_pd(a, b); }
LANES_INLINE N n_gather(const double *first, int64_t stride)
{
    return _mm_set_pd(first[stride], first[0]);
}
LANES_INLINE void n_square(N *a)
{
    const N odd = _mm_unpackhi_pd(a[0], a[1]);
    a[0] = _mm_unpacklo_pd(a[0], a[1]);
    a[1] = odd;
}
LANES_INLINE unsigned n_bits(B m) { return (unsigned)_mm_movemask_pd(m); }
LANES_INLINE B n_of(unsigned bits)
{
    return (B)_mm_set_epi64x(-(int64_t)(bits >> 1 & 1), -(int64_t)(bits & 1));
}
LANES_INLINE void n_pack(double *to, B m, N a)
{
    const unsigned bits = n_bits(m);
    _mm_storel_pd(to, a);
    _mm_storeh_pd(to + (bits & 1), a);
}
LANES_INLINE N n_expand(const double *from, B m, N old)
{
    return n_select(m, _mm_set_pd(from[n_bits(m) & 1], from[0]), old);
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
LANES_INLINE N n_max(N a, N b) { return n_select(a < b, b, a); }
LANES_INLINE N n_min(N a, N b) { return n_select(a < b, a, b); }
LANES_INLINE N n_sqrt(N a)
{
    for (int lane = 0; lane < NATIVE; lane++)
        a[lane] = sqrt(a[lane]);
    return a;
}
LANES_INLINE N n_gather(const double *first, int64_t stride)
{
    N a;
    for (int lane = 0; lane < NATIVE; lane++)
        a[lane] = first[stride * lane];
    return a;
}
LANES_INLINE void n_square(N *a)
{
    N b[NATIVE];
    memcpy(b, a, sizeof b);
    LANES_UNROLL
    for (int k = 0; k < NATIVE; k++)
        for (int lane = 0; lane < NATIVE; lane++)
            a[k][lane] = b[lane][k];
}
LANES_INLINE unsigned n_bits(B m)
{
    unsigned bits = 0;
    for (int lane = 0; lane < NATIVE; lane++)
        bits |= (unsigned)(m[lane] & 1) << lane;
    return bits;
}
LANES_INLINE B n_of(unsigned bits)
{
    B m;
    for (int lane = 0; lane < NATIVE; lane++)
        m[lane] = -(int64_t)(bits >> lane & 1);
    return m;
}
LANES_INLINE void n_pack(double *to, B m, N a)
{
    for (int lane = 0; lane < NATIVE; lane++) {
        *to = a[lane];
        to += m[lane] & 1;
    }
}
LANES_INLINE N n_expand(const double *from, B m, N old)
{
    for (int lane = 0; lane < NATIVE; lane++) {
        old[lane] = m[lane] ? *from : old[lane];
        from += m[lane] & 1;
    }
    return old;
}

#endif

/* A vector wherever a double may be. */
typedef N LANES(native_anywhere) __attribute__((aligned(8), may_alias));
LANES_INLINE N n_load(const double *from) { return *(const LANES(native_anywhere) *)from; }
LANES_INLINE void n_store(double *to, N a) { *(LANES(native_anywhere) *)to = a; }

#if LANES_VECTORS == 1
typedef N V;
typedef B M;

LANES_INLINE V lanes_all(double c) { return n_all(c); }
LANES_INLINE V lanes_add(V a, V b) { return a + b; }
LANES_INLINE V lanes_sub(V a, V b) { return a - b; }
LANES_INLINE V lanes_mul(V a, V b) { return a * b; }
LANES_INLINE V lanes_div(V a, V b) { return a / b; }
LANES_INLINE V lanes_neg(V a) { return -a; }
LANES_INLINE M lanes_less(V a, V b) { return n_less(a, b); }
LANES_INLINE M lanes_at_most(V a, V b) { return n_at_most(a, b); }
LANES_INLINE M lanes_equal(V a, V b) { return n_equal(a, b); }
LANES_INLINE M lanes_both(M a, M b) { return n_both(a, b); }
LANES_INLINE M lanes_either(M a, M b) { return n_either(a, b); }
LANES_INLINE M lanes_not(M a) { return n_not(a); }
LANES_INLINE V lanes_select(M m, V a, V b) { return n_select(m, a, b); }
LANES_INLINE V lanes_sqrt(V a) { return n_sqrt(a); }
LANES_INLINE V lanes_abs(V a) { return n_abs(a); }
LANES_INLINE V lanes_max(V a, V b) { return n_max(a, b); }
LANES_INLINE V lanes_min(V a, V b) { return n_min(a, b); }
LANES_INLINE M mask_none(void)
{
    const N zero = n_all(0.0);
    return n_less(zero, zero);
}
LANES_INLINE V lanes_load(const double *row) { return n_load(row); }
LANES_INLINE void lanes_store(double *row, V a) { n_store(row, a); }
LANES_INLINE unsigned lanes_bits(M m) { return n_bits(m); }
LANES_INLINE M lanes_of(unsigned bits) { return n_of(bits); }
LANES_INLINE int lanes_any(M m) { return n_bits(m) != 0; }
LANES_INLINE V iota(void)
{
    V up;
    for (int lane = 0; lane < NATIVE; lane++)
        up[lane] = lane;
    return up;
}
LANES_INLINE void lanes_pack(double *to, M m, V a) { n_pack(to, m, a); }
LANES_INLINE V lanes_expand(const double *from, M m, V old) { return n_expand(from, m, old); }
#else
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
LANES_INLINE V lanes_add(V a, V b)
{
    return (V){a.lo + b.lo, a.hi + b.hi};
}
LANES_INLINE V lanes_sub(V a, V b)
{
    return (V){a.lo - b.lo, a.hi - b.hi};
}
LANES_INLINE V lanes_mul(V a, V b)
{
    return (V){a.lo * b.lo, a.hi * b.hi};
}
LANES_INLINE V lanes_div(V a, V b)
{
    return (V){a.lo / b.lo, a.hi / b.hi};
}
LANES_INLINE V lanes_neg(V a)
{
    return (V){-a.lo, -a.hi};
}
LANES_INLINE V lanes_sqrt(V a)
{
    return (V){n_sqrt(a.lo), n_sqrt(a.hi)};
}
LANES_INLINE V lanes_abs(V a)
{
    return (V){n_abs(a.lo), n_abs(a.hi)};
}
LANES_INLINE V lanes_max(V a, V b)
{
    return (V){n_max(a.lo, b.lo), n_max(a.hi, b.hi)};
}
LANES_INLINE V lanes_min(V a, V b)
{
    return (V){n_min(a.lo, b.lo), n_min(a.hi, b.hi)};
}
LANES_INLINE M lanes_less(V a, V b)
{
    return (M){n_less(a.lo, b.lo), n_less(a.hi, b.hi)};
}
LANES_INLINE M lanes_at_most(V a, V b)
{
    return (M){n_at_most(a.lo, b.lo), n_at_most(a.hi, b.hi)};
}
LANES_INLINE M lanes_equal(V a, V b)
{
    return (M){n_equal(a.lo, b.lo), n_equal(a.hi, b.hi)};
}
LANES_INLINE M lanes_both(M a, M b)
{
    return (M){n_both(a.lo, b.lo), n_both(a.hi, b.hi)};
}
LANES_INLINE M lanes_either(M a, M b)
{
    return (M){n_either(a.lo, b.lo), n_either(a.hi, b.hi)};
}
LANES_INLINE M lanes_not(M a)
{
    return (M){n_not(a.lo), n_not(a.hi)};
}
LANES_INLINE V lanes_select(M m, V a, V b)
{
    return (V){n_select(m.lo, a.lo, b.lo), n_select(m.hi, a.hi, b.hi)};
}
LANES_INLINE M mask_none(void)
{
    const N zero = n_all(0.0);
    return (M){n_less(zero, zero), n_less(zero, zero)};
}
/* A value of two vectors that is copied as a whole stays in memory: each has a place on the stack of
   its own, and the loop a hundred kilobytes of it. */
LANES_INLINE V lanes_load(const double *row) { return (V){n_load(row), n_load(row + NATIVE)}; }
LANES_INLINE void lanes_store(double *row, V a)
{
    n_store(row, a.lo);
    n_store(row + NATIVE, a.hi);
}
LANES_INLINE unsigned lanes_bits(M m) { return n_bits(m.lo) | n_bits(m.hi) << NATIVE; }
LANES_INLINE M lanes_of(unsigned bits)
{
    return (M){n_of(bits & ((1U << NATIVE) - 1)), n_of(bits >> NATIVE)};
}
LANES_INLINE int lanes_any(M m) { return n_bits(n_either(m.lo, m.hi)) != 0; }
LANES_INLINE V iota(void)
{
    V up;
    for (int lane = 0; lane < NATIVE; lane++) {
        up.lo[lane] = lane;
        up.hi[lane] = NATIVE + lane;
    }
    return up;
}
LANES_INLINE void lanes_pack(double *to, M m, V a)
{
    n_pack(to, m.lo, a.lo);
    n_pack(to + LANES_POPULATION(n_bits(m.lo)), m.hi, a.hi);
}
LANES_INLINE V lanes_expand(const double *from, M m, V old)
{
    return (V){n_expand(from, m.lo, old.lo),
               n_expand(from + LANES_POPULATION(n_bits(m.lo)), m.hi, old.hi)};
}
#endif

/* Rows of so many numbers into columns, of which the first are wanted: squares of rows and columns
   are turned at once. */
LANES_INLINE void lanes_columns(double *const *to, const double *rows, int count, int wanted)
{
    for (int part = 0; part < LANES_VECTORS; part++, rows += NATIVE * count) {
        int column = 0;
        for (; column < wanted && column + NATIVE <= count; column += NATIVE) {
            N square[NATIVE];
            LANES_UNROLL
            for (int k = 0; k < NATIVE; k++)
                square[k] = n_load(rows + k * count + column);
            n_square(square);
            LANES_UNROLL
            for (int k = 0; k < NATIVE; k++)
                n_store(to[column + k] + NATIVE * part, square[k]);
        }
        for (; column < wanted; column++)
            n_store(to[column] + NATIVE * part, n_gather(rows + column, count));
    }
}
/* The other way: columns into rows. */
LANES_INLINE void lanes_rows(double *rows, const double *const *from, int count)
{
    for (int part = 0; part < LANES_VECTORS; part++, rows += NATIVE * count) {
        int column = 0;
        for (; column + NATIVE <= count; column += NATIVE) {
            N square[NATIVE];
            LANES_UNROLL
            for (int k = 0; k < NATIVE; k++)
                square[k] = n_load(from[column + k] + NATIVE * part);
            n_square(square);
            LANES_UNROLL
            for (int k = 0; k < NATIVE; k++)
                n_store(rows + k * count + column, square[k]);
        }
        for (; column < count; column++)
            LANES_UNROLL
            for (int k = 0; k < NATIVE; k++)
                rows[k * count + column] = from[column][NATIVE * part + k];
    }
}
/* The same past the caches, where a row has one number more than a native vector, and begins with a
   line of the caches. Return whether it is done. Each line is put together in registers: from a copy
   in memory it would be read in parts that several stores wrote, and each waits for all stores before. */
LANES_INLINE int lanes_stream(double *rows, const double *const *from, int count)
{
#if defined(__x86_64__) && NATIVE == 8
    /* What follows the end of a row is of the next row, from 8 on; the end itself is blended in. */
    static const int64_t order[NATIVE][NATIVE] = {
        {0, 8, 9, 10, 11, 12, 13, 14}, {7, 0, 8, 9, 10, 11, 12, 13}, {6, 7, 0, 8, 9, 10, 11, 12},
        {5, 6, 7, 0, 8, 9, 10, 11},    {4, 5, 6, 7, 0, 8, 9, 10},    {3, 4, 5, 6, 7, 0, 8, 9},
        {2, 3, 4, 5, 6, 7, 0, 8},      {1, 2, 3, 4, 5, 6, 7, 0},
    };
    if (count != NATIVE + 1 || (uintptr_t)rows % sizeof(N) != 0)
        return 0;
    for (int part = 0; part < LANES_VECTORS; part++, rows += NATIVE * count) {
        const N ends = n_load(from[NATIVE] + NATIVE * part);
        N square[NATIVE];
        LANES_UNROLL
        for (int k = 0; k < NATIVE; k++)
            square[k] = n_load(from[k] + NATIVE * part);
        n_square(square);
        _mm512_stream_pd(rows, square[0]);
        LANES_UNROLL
        for (int k = 0; k < NATIVE; k++) {
            const N next = square[(k + 1) % NATIVE];
            const N line = _mm512_permutex2var_pd(square[k], _mm512_loadu_si512(order[k]), next);
            _mm512_stream_pd(rows + NATIVE * (k + 1), n_select(n_of(1U << k), ends, line));
        }
    }
    return 1;
#else
    (void)rows, (void)from, (void)count;
    return 0;
#endif
}
/* One native vector of single precision for all lanes. */
#if defined(__x86_64__) && LANES_WIDTH == 16

typedef __m512 S;
typedef __mmask16 Q;
LANES_INLINE S singles_all(float c) { return _mm512_set1_ps(c); }
LANES_INLINE Q singles_less(S a, S b) { return _mm512_cmp_ps_mask(a, b, _CMP_LT_OQ); }
LANES_INLINE Q singles_at_most(S a, S b) { return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ); }
LANES_INLINE Q singles_equal(S a, S b) { return _mm512_cmp_ps_mask(a, b, _CMP_EQ_OQ); }
LANES_INLINE Q singles_both(Q a, Q b) { return (Q)(a & b); }
LANES_INLINE Q singles_either(Q a, Q b) { return (Q)(a | b); }
LANES_INLINE Q singles_not(Q a) { return (Q)~a; }
LANES_INLINE S singles_select(Q m, S a, S b) { return _mm512_mask_blend_ps(m, b, a); }
LANES_INLINE S singles_sqrt(S a) { return _mm512_sqrt_ps(a); }
LANES_INLINE S singles_abs(S a) { return _mm512_abs_ps(a); }
LANES_INLINE S singles_max(S a, S b) { return _mm512_max_ps(b, a); }
LANES_INLINE S singles_min(S a, S b) { return _mm512_min_ps(a, b); }
LANES_INLINE S lanes_narrow(V a)
{
    const __m512 lo = _mm512_castps256_ps512(_mm512_cvtpd_ps(a.lo));
    return _mm512_insertf32x8(lo, _mm512_cvtpd_ps(a.hi), 1);
}
LANES_INLINE V lanes_wide(S a)
{
    return (V){_mm512_cvtps_pd(_mm512_castps512_ps256(a)),
               _mm512_cvtps_pd(_mm512_extractf32x8_ps(a, 1))};
}
LANES_INLINE M singles_truth(Q m) { return (M){(B)m, (B)(m >> 8)}; }
LANES_INLINE Q singles_of(M m) { return (Q)(m.lo | (unsigned)m.hi << 8); }
/* One mask packs many columns: the order is computed once, and takes longer than to permute by it. */
LANES_INLINE void singles_pack(float *to, M m, S a)
{
    const __m512i own = _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
    const __m512i from = _mm512_maskz_compress_epi32(singles_of(m), own);
    _mm512_storeu_ps(to, _mm512_permutexvar_ps(from, a));
}
LANES_INLINE S singles_expand(const float *from, M m, S old)
{
    return _mm512_mask_expand_ps(old, singles_of(m), _mm512_loadu_ps(from));
}

#elif defined(__x86_64__) && NATIVE == 8

typedef __m256 S;
typedef __mmask8 Q;
LANES_INLINE S singles_all(float c) { return _mm256_set1_ps(c); }
LANES_INLINE Q singles_less(S a, S b) { return _mm256_cmp_ps_mask(a, b, _CMP_LT_OQ); }
LANES_INLINE Q singles_at_most(S a, S b) { return _mm256_cmp_ps_mask(a, b, _CMP_LE_OQ); }
LANES_INLINE Q singles_equal(S a, S b) { return _mm256_cmp_ps_mask(a, b, _CMP_EQ_OQ); }
LANES_INLINE Q singles_both(Q a, Q b) { return (Q)(a & b); }
LANES_INLINE Q singles_either(Q a, Q b) { return (Q)(a | b); }
LANES_INLINE Q singles_not(Q a) { return (Q)~a; }
LANES_INLINE S singles_select(Q m, S a, S b) { return _mm256_mask_blend_ps(m, b, a); }
LANES_INLINE S singles_sqrt(S a) { return _mm256_sqrt_ps(a); }
LANES_INLINE S singles_abs(S a) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0), a); }
LANES_INLINE S singles_max(S a, S b) { return _mm256_max_ps(b, a); }
LANES_INLINE S singles_min(S a, S b) { return _mm256_min_ps(a, b); }
LANES_INLINE S lanes_narrow(V a) { return _mm512_cvtpd_ps(a); }
LANES_INLINE V lanes_wide(S a) { return _mm512_cvtps_pd(a); }
LANES_INLINE M singles_truth(Q m) { return m; }
LANES_INLINE Q singles_of(M m) { return m; }
LANES_INLINE void singles_pack(float *to, M m, S a)
{
    const __m256i own = _mm256_set_epi32(7, 6, 5, 4, 3, 2, 1, 0);
    const __m256i from = _mm256_maskz_compress_epi32(m, own);
    _mm256_storeu_ps(to, _mm256_permutexvar_ps(from, a));
}
LANES_INLINE S singles_expand(const float *from, M m, S old)
{
    return _mm256_mask_expand_ps(old, m, _mm256_loadu_ps(from));
}

#else

#if defined(__x86_64__) && LANES_WIDTH == 8

typedef __m256 S;
typedef __m256 Q;
LANES_INLINE S singles_all(float c) { return _mm256_set1_ps(c); }
LANES_INLINE Q singles_less(S a, S b) { return _mm256_cmp_ps(a, b, _CMP_LT_OQ); }
LANES_INLINE Q singles_at_most(S a, S b) { return _mm256_cmp_ps(a, b, _CMP_LE_OQ); }
LANES_INLINE Q singles_equal(S a, S b) { return _mm256_cmp_ps(a, b, _CMP_EQ_OQ); }
LANES_INLINE Q singles_both(Q a, Q b) { return _mm256_and_ps(a, b); }
LANES_INLINE Q singles_either(Q a, Q b) { return _mm256_or_ps(a, b); }
LANES_INLINE Q singles_not(Q a) { return _mm256_xor_ps(a, (S)_mm256_set1_epi64x(-1)); }
LANES_INLINE S singles_select(Q m, S a, S b) { return _mm256_blendv_ps(b, a, m); }
LANES_INLINE S singles_sqrt(S a) { return _mm256_sqrt_ps(a); }
LANES_INLINE S singles_abs(S a) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0), a); }
LANES_INLINE S singles_max(S a, S b) { return _mm256_max_ps(b, a); }
LANES_INLINE S singles_min(S a, S b) { return _mm256_min_ps(a, b); }
LANES_INLINE S lanes_narrow(V a)
{
    return _mm256_set_m128(_mm256_cvtpd_ps(a.hi), _mm256_cvtpd_ps(a.lo));
}
LANES_INLINE V lanes_wide(S a)
{
    return (V){_mm256_cvtps_pd(_mm256_castps256_ps128(a)),
               _mm256_cvtps_pd(_mm256_extractf128_ps(a, 1))};
}
LANES_INLINE M singles_truth(Q m)
{
    const __m256i all = (__m256i)m;
    return (M){(B)_mm256_cvtepi32_epi64(_mm256_castsi256_si128(all)),
               (B)_mm256_cvtepi32_epi64(_mm256_extracti128_si256(all, 1))};
}
LANES_INLINE Q singles_of(M m)
{
    const __m256 pairs = _mm256_shuffle_ps((S)m.lo, (S)m.hi, 0x88);
    return (Q)_mm256_permute4x64_epi64((__m256i)pairs, 0xd8);
}

#elif defined(__x86_64__)

typedef __m128 S;
typedef __m128 Q;
LANES_INLINE S singles_all(float c) { return _mm_set1_ps(c); }
LANES_INLINE Q singles_less(S a, S b) { return _mm_cmplt_ps(a, b); }
LANES_INLINE Q singles_at_most(S a, S b) { return _mm_cmple_ps(a, b); }
LANES_INLINE Q singles_equal(S a, S b) { return _mm_cmpeq_ps(a, b); }
LANES_INLINE Q singles_both(Q a, Q b) { return _mm_and_ps(a, b); }
LANES_INLINE Q singles_either(Q a, Q b) { return _mm_or_ps(a, b); }
LANES_INLINE Q singles_not(Q a) { return _mm_xor_ps(a, (S)_mm_set1_epi64x(-1)); }
LANES_INLINE S singles_select(Q m, S a, S b) { return _mm_or_ps(_mm_and_ps(m, a), _mm_andnot_ps(m, b)); }
LANES_INLINE S singles_sqrt(S a) { return _mm_sqrt_ps(a); }
LANES_INLINE S singles_abs(S a) { return _mm_andnot_ps(_mm_set1_ps(-0.0), a); }
LANES_INLINE S singles_max(S a, S b) { return _mm_max_ps(b, a); }
LANES_INLINE S singles_min(S a, S b) { return _mm_min_ps(a, b); }
#if LANES_VECTORS == 1
LANES_INLINE S lanes_narrow(V a) { return _mm256_cvtpd_ps(a); }
LANES_INLINE V lanes_wide(S a) { return _mm256_cvtps_pd(a); }
LANES_INLINE M singles_truth(Q m) { return (M)_mm256_cvtepi32_epi64(_mm_castps_si128(m)); }
LANES_INLINE Q singles_of(M m)
{
    const __m256 pairs = _mm256_castpd_ps(m);
    return _mm_shuffle_ps(_mm256_castps256_ps128(pairs), _mm256_extractf128_ps(pairs, 1), 0x88);
}
#else
LANES_INLINE S lanes_narrow(V a) { return _mm_movelh_ps(_mm_cvtpd_ps(a.lo), _mm_cvtpd_ps(a.hi)); }
LANES_INLINE V lanes_wide(S a)
{
    return (V){_mm_cvtps_pd(a), _mm_cvtps_pd(_mm_movehl_ps(a, a))};
}
LANES_INLINE M singles_truth(Q m)
{
    return (M){(B)_mm_unpacklo_ps(m, m), (B)_mm_unpackhi_ps(m, m)};
}
LANES_INLINE Q singles_of(M m) { return _mm_shuffle_ps((S)m.lo, (S)m.hi, 0x88); }
#endif

#else

typedef float S __attribute__((vector_size(4 * LANES_WIDTH)));
typedef int32_t Q __attribute__((vector_size(4 * LANES_WIDTH)));
LANES_INLINE S singles_all(float c) { return c - (S){0}; }
LANES_INLINE Q singles_less(S a, S b) { return a < b; }
LANES_INLINE Q singles_at_most(S a, S b) { return a <= b; }
LANES_INLINE Q singles_equal(S a, S b) { return a == b; }
LANES_INLINE Q singles_both(Q a, Q b) { return a & b; }
LANES_INLINE Q singles_either(Q a, Q b) { return a | b; }
LANES_INLINE Q singles_not(Q a) { return ~a; }
LANES_INLINE S singles_select(Q m, S a, S b) { return (S)(((Q)a & m) | ((Q)b & ~m)); }
LANES_INLINE S singles_abs(S a) { return (S)((Q)a & (INT32_MAX - (Q){0})); }
LANES_INLINE S singles_max(S a, S b) { return singles_select(a < b, b, a); }
LANES_INLINE S singles_min(S a, S b) { return singles_select(a < b, a, b); }
LANES_INLINE S singles_sqrt(S a)
{
    for (int lane = 0; lane < LANES_WIDTH; lane++)
        a[lane] = sqrtf(a[lane]);
    return a;
}
LANES_INLINE S lanes_narrow(V a)
{
    S b;
    for (int lane = 0; lane < NATIVE; lane++) {
        b[lane] = (float)a.lo[lane];
        b[NATIVE + lane] = (float)a.hi[lane];
    }
    return b;
}
LANES_INLINE V lanes_wide(S a)
{
    V b;
    for (int lane = 0; lane < NATIVE; lane++) {
        b.lo[lane] = a[lane];
        b.hi[lane] = a[NATIVE + lane];
    }
    return b;
}
LANES_INLINE M singles_truth(Q m)
{
    M b;
    for (int lane = 0; lane < NATIVE; lane++) {
        b.lo[lane] = m[lane];
        b.hi[lane] = m[NATIVE + lane];
    }
    return b;
}
LANES_INLINE Q singles_of(M m)
{
    Q b;
    for (int lane = 0; lane < NATIVE; lane++) {
        b[lane] = (int32_t)m.lo[lane];
        b[NATIVE + lane] = (int32_t)m.hi[lane];
    }
    return b;
}

#endif

LANES_INLINE void singles_pack(float *to, M m, S a)
{
    const unsigned bits = lanes_bits(m);
    float all[LANES_WIDTH];
    memcpy(all, &a, sizeof all);
    for (int lane = 0; lane < LANES_WIDTH; lane++) {
        *to = all[lane];
        to += bits >> lane & 1;
    }
}
LANES_INLINE S singles_expand(const float *from, M m, S old)
{
    const unsigned bits = lanes_bits(m);
    float all[LANES_WIDTH];
    for (int lane = 0; lane < LANES_WIDTH; lane++) {
        all[lane] = *from;
        from += bits >> lane & 1;
    }
    S next;
    memcpy(&next, all, sizeof next);
    return singles_select(singles_of(m), next, old);
}

#endif

typedef S LANES(singles_anywhere) __attribute__((aligned(4), may_alias));
LANES_INLINE S singles_load(const float *row) { return *(const LANES(singles_anywhere) *)row; }
LANES_INLINE void singles_store(float *row, S a) { *(LANES(singles_anywhere) *)row = a; }

#endif

LANES_INLINE S singles_add(S a, S b) { return a + b; }
LANES_INLINE S singles_sub(S a, S b) { return a - b; }
LANES_INLINE S singles_mul(S a, S b) { return a * b; }
LANES_INLINE S singles_div(S a, S b) { return a / b; }
LANES_INLINE S singles_neg(S a) { return -a; }
LANES_INLINE Q singles_mask_none(void)
{
    const S zero = singles_all(0.0f);
    return singles_less(zero, zero);
}

/* Where one truth holds instead of another. */
LANES_INLINE M lanes_choose(M m, M a, M b)
{
    return lanes_either(lanes_both(a, m), lanes_both(b, lanes_not(m)));
}

/* Numbers of which each of the rows' numbers is no larger than one. */
LANES_INLINE V lanes_size(const double *rows, int count)
{
    V size = lanes_abs(lanes_load(rows));
    for (int k = 1; k < count; k++)
        size = lanes_add(size, lanes_abs(lanes_load(rows + k * LANES_WIDTH)));
    return size;
}

/* How many lanes are in a mask. */
LANES_INLINE size_t popcount(M m) { return (size_t)LANES_POPULATION(lanes_bits(m)); }

/* The first lanes, as many as there are shots. */
LANES_INLINE M mask_first_n(size_t shots)
{
    return lanes_of(shots < LANES_WIDTH ? (1U << shots) - 1 : (1U << (LANES_WIDTH - 1) << 1) - 1);
}

/* Those lanes, and of the idle ones the first, as many as there are shots. */
LANES_INLINE M lanes_leading(M idle, size_t shots, M lanes)
{
    unsigned bits = lanes_bits(idle);
    if ((size_t)LANES_POPULATION(bits) > shots) {
        unsigned taken = 0;
        for (; shots > 0; shots--, bits &= bits - 1)
            taken |= bits & (0U - bits);
        bits = taken;
    }
    return lanes_either(lanes, lanes_of(bits));
}
