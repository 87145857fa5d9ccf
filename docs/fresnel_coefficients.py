#!/usr/bin/env python3
"""Fits the rational functions of shaders/fresnel.glsl to the auxiliary functions of the Fresnel integrals.

C(x) = 1/2 + f(x) sin(pi x^2/2) - g(x) cos(pi x^2/2) and S(x) = 1/2 - f(x) cos(pi x^2/2) - g(x) sin(pi x^2/2)
(DLMF 7.5.3, 7.5.4); f and g are smooth and fall off as 1/(pi x) and 1/(pi^2 x^3), which the quotients are held to.
Needs numpy and scipy. Prints the coefficients from the constant upwards and the largest error.
"""
import numpy as np
from scipy.special import fresnel

DEGREE = 6          # of the denominator
x = np.concatenate([np.linspace(0, 3, 3000), np.geomspace(3, 60, 2000)])
S, C = fresnel(x)
c, s = np.cos(np.pi * x * x / 2), np.sin(np.pi * x * x / 2)
f = (0.5 - S) * c - (0.5 - C) * s
g = (0.5 - C) * c + (0.5 - S) * s
far = x > 6         # here the differences above cancel, and the asymptotic series is exact to double precision
z = np.pi * x[far] ** 2
f[far] = (1 - 3 / z**2 + 105 / z**4) / (np.pi * x[far])
g[far] = (1 / z - 15 / z**3 + 945 / z**5) / (np.pi * x[far])


def fit(y, decay, limit):
    """P/Q with P/Q -> limit / x^decay, by iteratively reweighted linear least squares."""
    top = DEGREE - decay
    weights = np.ones_like(x)
    best = (np.inf, None, None)
    for iteration in range(400):
        columns = [x**i for i in range(top)] + [x**top - y * x**DEGREE / limit]
        columns += [-y * x**j for j in range(1, DEGREE)]
        solution, *_ = np.linalg.lstsq(np.array(columns).T * weights[:, None], y * weights, rcond=None)
        numerator = solution[:top + 1]
        denominator = np.concatenate([[1], solution[top + 1:], [solution[top] / limit]])
        quotient = np.polyval(denominator[::-1], x)
        error = np.abs(np.polyval(numerator[::-1], x) / quotient - y)
        if error.max() < best[0]:
            best = (error.max(), numerator, denominator)
        if iteration < 3:
            weights = 1 / np.abs(quotient)
        else:
            weights = weights * (error / error.max() + 1e-2) ** 0.2
        weights /= weights.max()
    return best


for name, values, decay, limit in (("f", f, 1, 1 / np.pi), ("g", g, 3, 1 / np.pi**2)):
    error, numerator, denominator = fit(values, decay, limit)
    print(name, "error", error)
    print("  numerator  ", ", ".join(f"{v:.9g}" for v in numerator))
    print("  denominator", ", ".join(f"{v:.9g}" for v in denominator))
