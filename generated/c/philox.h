/* Random words by counter: Philox4x64 with ten rounds.

   Generated from templates/c/philox.h.j2, the same for every scene, with
   Jinja2 3.1.6. Do not edit: change templates/ and run `make generate`.
   Salmon, Moraes, Dror, Shaw, Parallel random numbers: as easy as 1, 2, 3 (2011). The constants are theirs. Like
   NumPy's generator, it counts before it draws: word i of a stream is in block i/4 + 1. */

/* Return the upper half of a product. */
static inline uint64_t upper_half(uint64_t a, uint64_t b)
{
#ifdef __SIZEOF_INT128__
    __extension__ typedef unsigned __int128 whole;
    return (uint64_t)((whole)a * b >> 64);
#else
    const uint64_t low = 0xffffffff;
    const uint64_t first = (a >> 32) * (b & low) + ((a & low) * (b & low) >> 32);
    const uint64_t second = (a & low) * (b >> 32) + (first & low);
    return (a >> 32) * (b >> 32) + (first >> 32) + (second >> 32);
#endif
}

/* Write the four words of a block. */
static inline void philox_block(uint64_t seed, uint64_t stream, uint64_t block, uint64_t *words)
{
    uint64_t a = block, b = 0, c = 0, d = 0;
    for (int round = 0; round < 10; round++) {
        const uint64_t of_a = upper_half(a, 0xd2e7470ee14c6c93), of_c = upper_half(c, 0xca5a826395121157);
        const uint64_t last = a * 0xd2e7470ee14c6c93;
        a = of_c ^ b ^ seed;
        b = c * 0xca5a826395121157;
        c = of_a ^ d ^ stream;
        d = last;
        seed += 0x9e3779b97f4a7c15;
        stream += 0xbb67ae8584caa73b;
    }
    words[0] = a;
    words[1] = b;
    words[2] = c;
    words[3] = d;
}

/* Write `count` words of a stream, from word `start` on. */
static void philox_words(uint64_t seed, uint64_t stream, uint64_t start, size_t count, uint64_t *words)
{
    size_t done = 0;
    while (done < count) {
        const uint64_t block = (start + done) / 4 + 1, skipped = (start + done) % 4;
        if (!skipped && count - done >= 4) {
            philox_block(seed, stream, block, words + done);
            done += 4;
            continue;
        }
        uint64_t own[4];
        philox_block(seed, stream, block, own);
        for (uint64_t k = skipped; k < 4 && done < count; k++)
            words[done++] = own[k];
    }
}
