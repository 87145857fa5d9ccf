#!/usr/bin/env python3
"""Writes third_party/spectra/primaries.csv: three reflectances R, G, B that turn linear sRGB colours into spectra.

Mallett and Yuksel, "Spectral Primary Decomposition for Rendering with sRGB Reflectance", EGSR 2019: of all curves that
are 0 or more, have the sum 1 and look like the sRGB primaries under D65, the smoothest, which have the least sum of
squared differences between neighbours. Here they are linear between knots 5 nm apart, and colours are the exact
integrals of the project's tables. The least squares problem with its constraints is solved exactly, as a least distance
problem (Lawson and Hanson, "Solving Least Squares Problems", ch. 23). Needs numpy and scipy.
"""
import pathlib

import numpy as np
from scipy.linalg import null_space
from scipy.optimize import nnls

DECIMALS = 9
spectra = pathlib.Path(__file__).resolve().parent.parent / "third_party" / "spectra"


def table(name):
    lines = [line for line in (spectra / name).read_text().splitlines() if not line.startswith("#")]
    return np.array([[float(field) for field in line.split(",")] for line in lines[1:]])


def linear(knots, at):
    """The matrix that interpolates values at knots."""
    return np.stack([np.interp(at, knots, row) for row in np.eye(len(knots))], axis=1)


observer, daylight = table("cie1931.csv"), table("d65.csv")
knots = daylight[:, 0]

# Colour of a curve under D65, as a matrix: everything is linear within a nanometre, so that two Gauss points are exact.
whole = observer[:-1, 0]
nodes = np.sort(np.concatenate([whole + 0.5 - np.sqrt(1 / 12), whole + 0.5 + np.sqrt(1 / 12)]))
matching = linear(observer[:, 0], nodes) @ observer[:, 1:]
light = np.interp(nodes, knots, daylight[:, 1])
xyz_of_curve = (matching * light[:, None]).T @ linear(knots, nodes)
white = xyz_of_curve.sum(axis=1)
chromaticity = np.array([[0.64, 0.33, 0.03], [0.30, 0.60, 0.10], [0.15, 0.06, 0.79]]).T
xyz_of_rgb = chromaticity * np.linalg.solve(chromaticity, white)
rgb_of_curve = np.linalg.solve(xyz_of_rgb, xyz_of_curve)

# Unknown: R and G at the knots; B = 1 - R - G. Its colour is right when theirs are, because white's is.
count = len(knots)
zero, one = np.zeros((count, count)), np.eye(count)
colour = np.block([[rgb_of_curve, 0 * rgb_of_curve], [0 * rgb_of_curve, rgb_of_curve]])
wanted = np.array([1, 0, 0, 0, 1, 0.0])
difference = np.diff(one, axis=0)
roughness = np.block([[difference, 0 * difference], [0 * difference, difference], [difference, difference]])
bounds = np.block([[one, zero], [zero, one], [-one, -one]])  # bounds @ x >= least
least = np.concatenate([np.zeros(2 * count), -np.ones(count)])

# All x = start + free @ z have the right colours; in the coordinates y = factor @ z + offset the roughness is |y|^2.
start = np.linalg.lstsq(colour, wanted, rcond=None)[0]
free = null_space(colour)
q, factor = np.linalg.qr(roughness @ free)
offset = q.T @ (roughness @ start)
in_y = bounds @ free @ np.linalg.inv(factor)
least_in_y = least - bounds @ start + in_y @ offset
target = np.zeros(in_y.shape[1] + 1)
target[-1] = 1.0
dual, _ = nnls(np.vstack([in_y.T, least_in_y]), target, maxiter=100 * len(least))
residual = np.vstack([in_y.T, least_in_y]) @ dual - target
x = start + free @ np.linalg.solve(factor, -residual[:-1] / residual[-1] - offset)

# Whole multiples of the last decimal, so that the sum is exactly 1.
scale = 10**DECIMALS
red, green = (np.maximum(np.rint(part * scale), 0).astype(int) for part in (x[:count], x[count:]))
green = np.minimum(green, scale - red)
blue = scale - red - green
error = max(np.abs(rgb_of_curve @ np.stack([red, green, blue], axis=1) / scale - np.eye(3)).ravel())
assert error < 1e-8, f"colours are off by {error}"

rows = [
    f"{knot:.0f}," + ",".join(f"{value / scale:.{DECIMALS}f}" for value in values)
    for knot, values in zip(knots, zip(red, green, blue))
]
(spectra / "primaries.csv").write_text(
    """# Reflectances of the sRGB primaries under D65: linear sRGB (r, g, b) becomes r R + g G + b B.
# Source: made by docs/spectral_primaries.py after Mallett and Yuksel, "Spectral Primary Decomposition for Rendering with
# sRGB Reflectance", EGSR 2019, doi:10.2312/sr.20191216.
wavelength_nm,red,green,blue
"""
    + "\n".join(rows)
    + "\n"
)
print(f"colours to {error:.1e}, values from {min(red.min(), green.min(), blue.min())} to "
      f"{max(red.max(), green.max(), blue.max()) / scale}, roughness {np.sum((roughness @ x) ** 2):.6f}")
