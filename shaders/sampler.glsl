// Low-discrepancy samples: the first two dimensions of Sobol's sequence, Owen-scrambled by hashing and padded pair
// by pair (B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020). A pixel's sample i depends on the
// seed, the pixel and i alone, so tiles and batches cannot change a picture.

uint hashCombine(uint seed, uint value) { return seed ^ (value + (seed << 6) + (seed >> 2)); }

// Finaliser with low bias (C. Wellons, "Prospecting for hash functions": lowbias32).
uint hashMix(uint x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    return x ^ (x >> 16);
}

// Laine and Karras's permutation, with the constants of Burley's section 2.
uint laineKarras(uint x, uint seed) {
    x += seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return x;
}

uint owenScramble(uint x, uint seed) { return bitfieldReverse(laineKarras(bitfieldReverse(x), seed)); }

// Second Sobol dimension, bits reversed: the index times Pascal's triangle modulo 2, as a Taylor shift p(x) -> p(x + 1)
// of the polynomial over GF(2) whose coefficients are the bits.
uint sobolSecondReversed(uint index) {
    uint x = index ^ (index >> 16);
    x ^= (x & 0xff00ff00u) >> 8;
    x ^= (x & 0xf0f0f0f0u) >> 4;
    x ^= (x & 0xccccccccu) >> 2;
    x ^= (x & 0xaaaaaaaau) >> 1;
    return x;
}

// Pair `dimension` of sample `index`, in [0, 1)^2. The first dimension, van der Corput's, is the index reversed, and
// scrambling reverses again: both cancel, and what is permuted here are the reversed values.
vec2 samplePair(uint pixelSeed, uint index, uint dimension) {
    uint seed = hashMix(hashCombine(pixelSeed, dimension));
    uint shuffled = owenScramble(index, seed);
    uint first = bitfieldReverse(laineKarras(shuffled, hashMix(seed ^ 0x5bd1e995u)));
    uint second = bitfieldReverse(laineKarras(sobolSecondReversed(shuffled), hashMix(seed ^ 0x27d4eb2fu)));
    return vec2(first >> 8, second >> 8) * (1.0 / 16777216.0);
}
