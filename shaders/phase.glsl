// Slit and array factors in turns (1 turn = 2 pi), without the built-in sin and cos: those are wrong by up to
// 2^-11 on some drivers, and the quotient sin(N x)/sin(x) is noise near every order however good the sine is.

// sin(pi x)/x as a polynomial in z = x^2 for |x| <= 1/2; minimax, error 2e-7 (docs/thesis-algorithm.md).
float sinPiOverX(float z) {
    return 3.14159265 + z * (-5.16771276 + z * (2.55016324 + z * (-0.59925132 + z * (0.08204643 - 0.00702208 * z))));
}

// sin(pi x) for |x| <= 1/2.
float sinPi(float x) { return x * sinPiOverX(x * x); }

// Rounding error of the float product p = a b, exact (Dekker 1971). `fma` would be shorter, but is not fused on
// lavapipe nor on SwiftShader and Vulkan does not promise it; `precise` keeps a driver from simplifying this away.
float productError(float a, float b, float p) {
    precise float ca = 4097.0 * a;   // 2^12 + 1 splits 24 bits into two halves
    precise float cb = 4097.0 * b;
    precise float aHigh = ca - (ca - a);
    precise float bHigh = cb - (cb - b);
    precise float aLow = a - aHigh;
    precise float bLow = b - bHigh;
    precise float error = ((aHigh * bHigh - p) + aHigh * bLow + aLow * bHigh) + aLow * bLow;
    return error;
}

// Single slit, (sin(pi x)/(pi x))^2 with x = a sin(theta)/lambda in turns; 1 at x = 0.
float slitFactor(float x) {
    if (abs(x) <= 0.5) {
        float limited = sinPiOverX(x * x) * 0.318309886;   // 1/pi
        return limited * limited;
    }
    float quotient = sinPi(x - roundEven(x)) * 0.318309886 / x;
    return quotient * quotient;
}

// N slits, (sin(N pi t)/sin(pi t))^2 with t = b sin(theta)/lambda in turns: N^2 at every order (whole t).
// t - roundEven(t) is exact, and N r is carried as product plus error, so the result errs by 4e-7 of the peak for
// every N up to 10^6, at the t given.
float arrayFactor(float t, float count) {
    float r = t - roundEven(t);
    precise float p = count * r;
    float limited = sinPiOverX(r * r);
    float quotient;
    if (abs(p) <= 0.5) {
        quotient = count * sinPiOverX(p * p) / limited;    // r cancels: no 0/0 at an order
    } else {
        precise float reduced = (p - roundEven(p)) + productError(count, r, p);
        quotient = sinPi(reduced) / (r * limited);
    }
    return quotient * quotient;
}
