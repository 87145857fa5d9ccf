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
