#!/usr/bin/env python3
"""Irradiance behind openings by free propagation of the angular spectrum, for openings_test.cpp.

The field just behind the opening is 1 inside and 0 outside; its spectrum (a fast Fourier transform, zero-padded) times
exp(2 pi i z sqrt(1/wavelength^2 - f^2)) is the field's spectrum at the distance z, exactly in scalar theory (J. W. Goodman,
"Introduction to Fourier Optics", 3.10). Nothing here is a far field. Two openings are small, and two 20 times as large,
which are seen in their near field. Needs numpy; 40 s, 3 GB. Prints x, y in metres and the irradiance over that of the
light that falls on the opening: redirect it to angular_spectrum.csv.
"""
import numpy as np

WAVELENGTH = 532e-9
DISTANCE = 20e-3        # a Fresnel number of 0.01 for an opening of 20 um, of 3.8 for one of 400 um
STEP = 0.5e-6           # of the field's samples
SAMPLES = 8192          # 4.1 mm: 2.0 mm to either side hold the pattern up to a sine of 0.1


def coverage(inside, extent, points):
    """Share of each sample that is open, by so many points squared."""
    n = int(extent / STEP) // 2 + 2
    fine = (np.arange(-n * points, n * points) + 0.5) * STEP / points
    # Samples are at whole multiples of STEP: a sample's cell begins half a step before it.
    x, y = np.meshgrid(fine - 0.5 * STEP, fine - 0.5 * STEP)
    return inside(x, y).reshape(2 * n, points, 2 * n, points).mean(axis=(1, 3)), n


def propagated(inside, extent, points):
    small, n = coverage(inside, extent, points)
    field = np.zeros((SAMPLES, SAMPLES), np.complex64)
    middle = SAMPLES // 2
    field[middle - n:middle + n, middle - n:middle + n] = small
    spectrum = np.fft.fft2(np.fft.ifftshift(field)).astype(np.complex64)
    f = np.fft.fftfreq(SAMPLES, STEP)
    # What would leave the picture and come in again on the other side fades out (K. Matsushima, T. Shimobaba,
    # "Band-limited angular spectrum method", Optics Express 17, 19662, 2009): sines from 0.06 (1.2 mm) to 0.095.
    fade = np.cos(0.5 * np.pi * np.clip((np.abs(f) * WAVELENGTH - 0.06) / 0.035, 0, 1))**2
    square = 1 / WAVELENGTH**2 - f[:, None]**2 - f[None, :]**2
    spectrum *= np.where(square > 0, np.exp(2j * np.pi * (DISTANCE * np.sqrt(np.maximum(square, 0)) % 1)), 0) * fade[:, None] * fade[None, :]
    return np.abs(np.fft.fftshift(np.fft.ifft2(spectrum)))**2


def hexagon(x, y):
    """20 um from corner to corner, a corner on +x."""
    apothem = 10e-6 * np.sqrt(0.75)
    return np.all([np.abs(x * np.cos(a) + y * np.sin(a)) <= apothem
                   for a in np.radians([30, 90, 150])], axis=0)


LETTER = np.array([[(2 <= c < 5) or (r < 3 and c >= 2) or (6 <= r < 9 and 2 <= c < 9) or 0.3 * (r > 12)
                    for c in range(12)] for r in range(16)], float)


def letter(x, y):
    """The mask of openings_test.cpp with pixels of 1 um."""
    column = np.floor(x / 1e-6 + 6).astype(int)
    row = np.floor(8 - y / 1e-6).astype(int)
    there = (column >= 0) & (column < 12) & (row >= 0) & (row < 16)
    return np.where(there, LETTER[np.clip(row, 0, 15), np.clip(column, 0, 11)], 0)


print("# Irradiance 20 mm behind openings at 532 nm, by tests/render/angular_spectrum.py.")
print("opening,x_m,y_m,relative_irradiance")
for name, inside, extent, points, step in (("hexagon", hexagon, 22e-6, 16, 128), ("letter", letter, 20e-6, 16, 128),
                                           ("near_hexagon", lambda x, y: hexagon(x / 20, y / 20), 440e-6, 4, 32),
                                           ("near_letter", lambda x, y: letter(x / 20, y / 20), 400e-6, 4, 32)):
    irradiance = propagated(inside, extent, points)
    for j in range(-16 * step, 16 * step + 1, 2 * step):
        for i in range(-16 * step, 16 * step + 1, step):
            value = irradiance[SAMPLES // 2 + j, SAMPLES // 2 + i]
            print(f"{name},{i * STEP:.6g},{j * STEP:.6g},{value:.6e}")
