// Slit and array factors in turns (1 turn = 2 pi), without the built-in sin and cos: those are wrong by up to
// 2^-11 on some drivers, and the quotient sin(N x)/sin(x) is noise near every order however good the sine is.

// sin(pi x)/x as a polynomial in z = x^2 for |x| <= 1/2; minimax, error 2e-7 (docs/thesis-algorithm.md).
float sinPiOverX(float z) {
    return 3.14159265 + z * (-5.16771276 + z * (2.55016324 + z * (-0.59925132 + z * (0.08204643 - 0.00702208 * z))));
}

// Single slit, (sin(pi x)/(pi x))^2 with x = a sin(theta)/lambda in turns; 1 at x = 0.
float slitFactor(float x) {
    float reduced = x - roundEven(x);                      // exact
    float ratio = abs(x) <= 0.5 ? 1.0 : reduced / x;       // x cancels in the central half: no 0/0
    float quotient = ratio * sinPiOverX(reduced * reduced) * 0.318309886;   // 1/pi
    return quotient * quotient;
}

// N slits, (sin(N pi t)/sin(pi t))^2 with t = b sin(theta)/lambda in turns: N^2 at every order (whole t).
// The reduction of t is exact, so the result errs by less than 1e-6 of the peak for every N, at the t given; the naive
// quotient of two sines is off by many times the peak next to an order, from N = 3 on (docs/thesis-algorithm.md).
float arrayFactor(float t, float count) {
    float r = t - roundEven(t);                            // exact; distance to the nearest order
    float p = count * r;
    float reduced = p - roundEven(p);
    float ratio = abs(p) <= 0.5 ? count : reduced / r;     // r cancels near an order: no 0/0
    float quotient = ratio * sinPiOverX(reduced * reduced) / sinPiOverX(r * r);
    return quotient * quotient;
}

// sin(pi x)/(pi x); error 2e-7.
float sincOf(float x) {
    float reduced = x - roundEven(x);
    float sign_ = (int(roundEven(x)) & 1) == 0 ? 1.0 : -1.0;
    float ratio = abs(x) <= 0.5 ? 1.0 : sign_ * reduced / x;
    return ratio * sinPiOverX(reduced * reduced) * 0.318309886;
}

// ---- two floats for one number --------------------------------------------------------------------------------------
// At 10^4 slits and more, t = u * period/wavelength in one float is off by whole side lobes. Numbers here are vec2(high,
// low), low below half a unit in the last place of high. Every step is `precise`: none may be merged or reordered. There
// is no fma(), which drivers need not fuse.

// a * b less `product`, its rounded value, exactly (T. J. Dekker, "A floating-point technique for extending the available
// precision", Numerische Mathematik 18, 224, 1971). For |a|, |b| below 2^115, and products above 2^-102.
float productError(float a, float b, float product) {
    precise float scaled = 4097.0 * a;                     // splits off the upper 12 of 24 bits
    precise float aHigh = scaled - (scaled - a);
    precise float aLow = a - aHigh;
    scaled = 4097.0 * b;
    precise float bHigh = scaled - (scaled - b);
    precise float bLow = b - bHigh;
    precise float error = ((aHigh * bHigh - product) + aHigh * bLow + aLow * bHigh) + aLow * bLow;
    return error;
}

// What u * perUnit turns are past the nearest whole number: |high| <= 1/2.
vec2 turnsPastOrder(float u, vec2 perUnit) {
    precise float turns = u * perUnit.x;
    precise float low = productError(u, perUnit.x, turns) + u * perUnit.y;
    precise float high = turns - roundEven(turns);         // exact
    return vec2(high, low);
}

// The sum of two such numbers (D. E. Knuth, "The Art of Computer Programming", vol. 2, 4.2.2).
vec2 sumOfTwo(vec2 a, vec2 b) {
    precise float high = a.x + b.x;
    precise float rounded = high - a.x;
    precise float low = ((a.x - (high - rounded)) + (b.x - rounded)) + (a.y + b.y);
    return vec2(high, low);
}

// N slits relative to their peak, (sin(N pi t)/(N sin(pi t)))^2, at `past` turns past an order; below 1e-6 off for N up
// to 10^6.
float fejer(vec2 past, float count) {
    precise float r = past.x + past.y;                     // its rounding is a share of r, as harmless as in the quotient
    precise float p = count * r;
    precise float reduced = (p - roundEven(p)) + productError(count, r, p);
    float quotient = abs(p) <= 0.5 ? 1.0 : reduced / p;    // r cancels near an order: no 0/0
    quotient *= sinPiOverX(reduced * reduced) / sinPiOverX(r * r);
    return quotient * quotient;
}
