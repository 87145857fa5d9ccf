#!/usr/bin/env python3
"""Fits the polynomials of shaders/apertures.glsl: the Airy pattern's amplitude and the rest of sinc.

2 J1(pi x)/(pi x) is a polynomial in x^2 up to x = SPLIT. Beyond it is modulus times cosine (DLMF 10.18): with
s = 1/x^2, x^-1.5 m(s) cos(pi (x - 3/4 + d(s)/x)). Needs numpy and scipy. Prints the coefficients from the constant
upwards, and the largest error of each fit.
"""
import numpy as np
from scipy.special import j1, y1

SPLIT = 1.25
x = np.cos(np.linspace(0, np.pi / 2, 4000))     # denser at 1


def fit(name, variable, values, degree, weight):
    """Minimax polynomial by Lawson's iteratively reweighted least squares."""
    powers = np.stack([variable**i for i in range(degree + 1)], axis=1)
    importance = np.ones_like(variable)
    best = (np.inf, None)
    for _ in range(300):
        root = np.sqrt(importance) * weight
        solution, *_ = np.linalg.lstsq(powers * root[:, None], values * root, rcond=None)
        error = np.abs(powers @ solution - values) * weight
        best = min(best, (error.max(), tuple(solution)))
        importance *= error / error.max() + 1e-3
        importance /= importance.max()
    print(f"{name}: error {best[0]:.1e}\n  " + ", ".join(f"{c:.9g}" for c in best[1]))


near = SPLIT * x
fit("2 J1(pi x)/(pi x), x <= SPLIT, in x^2", near**2, 2 * j1(np.pi * near) / (np.pi * near), 6, np.ones_like(near))

s = np.maximum(x / SPLIT**2, 1e-5)
far = 1 / np.sqrt(s)
modulus = np.hypot(j1(np.pi * far), y1(np.pi * far))
theta = np.arctan2(y1(np.pi * far), j1(np.pi * far)) / np.pi
rest = theta - (far - 0.75)
rest -= 2 * np.rint(rest / 2)
fit("m", s, 2 * modulus * far**0.5 / np.pi, 3, far**-1.5)
fit("d", s, rest * far, 3, far**-2.5)

half = np.maximum(0.5 * x, 1e-3)
fit("(sin(pi x)/(pi x) - 1)/x^2, |x| <= 1/2, in x^2", half**2, (np.sinc(half) - 1) / half**2, 4, np.ones_like(half))
