#!/usr/bin/env python3
"""How far scalar theory is off for the tracks of optical discs: vector_theory.py (needs numpy).

Order efficiencies of a continuous groove under its cover, by rigorous coupled-wave analysis: M. G. Moharam, E. B. Grann,
D. A. Pommet, T. K. Gaylord, J. Opt. Soc. Am. A 12, 1068 (1995), with the convergent form of TM polarisation of P. Lalanne,
G. M. Morris, J. Opt. Soc. Am. A 13, 779 (1996). Against them the binary phase grating that Fringe takes (docs/theory.md,
"Discs"). Both are shares of what a flat mirror of the metal reflects.
"""
import pathlib

import numpy as np

MEDIA = {  # pitch, pit width, depth in um; index of the cover; metal
    "cd": (1.6, 0.5, 0.12, 1.55, "aluminium"),
    "dvd": (0.74, 0.32, 0.105, 1.58, "aluminium"),
    "blu-ray": (0.32, 0.13, 0.066, 1.53, "silver"),
}


def metal_index(metal, wavelength_nm):
    path = next((pathlib.Path(__file__).resolve().parent.parent / "third_party" / "metals").glob(f"{metal}*"))
    rows = [line.split(",") for line in path.read_text().splitlines() if line[:1].isdigit()]
    table = np.array(rows, float)
    return np.interp(wavelength_nm, table[:, 0], table[:, 1]) - 1j * np.interp(wavelength_nm, table[:, 0], table[:, 2])


def coupled_waves(pitch, width, depth, cover, metal, wavelength, sine, is_tm, harmonics=60):
    """Reflected share of each order, and the orders; a ridge of metal `width` wide on metal. exp(+j omega t)."""
    orders = np.arange(-harmonics, harmonics + 1)
    count, k0 = orders.size, 2 * np.pi / wavelength
    kx = sine + orders * wavelength / pitch  # in units of k0; the cover leaves it as it is
    fill = width / pitch

    def toeplitz(ridge, groove):
        m = np.arange(-2 * harmonics, 2 * harmonics + 1)
        series = (ridge - groove) * fill * np.sinc(m * fill) + groove * (m == 0)
        return series[orders[:, None] - orders[None, :] + 2 * harmonics]

    def normal_part(permittivity):
        root = np.sqrt(permittivity - kx.astype(complex) ** 2)
        return np.where(root.imag > 0, -root, root)

    eps_cover, eps_metal = cover**2, metal**2
    eps, inverse = toeplitz(eps_metal, eps_cover), toeplitz(1 / eps_metal, 1 / eps_cover)
    identity = np.eye(count)
    above, below = normal_part(eps_cover), normal_part(eps_metal)
    if is_tm:
        matrix = np.linalg.solve(inverse, kx[:, None] * np.linalg.solve(eps, np.diag(kx)) - identity)
        above_y, below_y = above / eps_cover, below / eps_metal
    else:
        matrix = np.diag(kx**2) - eps
        above_y, below_y = above, below
    squares, w = np.linalg.eig(matrix)
    q = np.sqrt(squares.astype(complex))
    q = np.where(q.real < 0, -q, q)
    v = (inverse @ w if is_tm else w) * q
    x = np.exp(-k0 * depth * q)
    incident = (orders == 0).astype(complex)
    # Unknown: R, c+, c-, T.
    zero = np.zeros((count, count))
    system = np.block([
        [-identity, w, w * x, zero],
        [1j * np.diag(above_y), v, -v * x, zero],
        [zero, w * x, w, -identity],
        [zero, v * x, -v, -1j * np.diag(below_y)],
    ])
    right = np.concatenate([incident, 1j * above_y * incident, np.zeros(2 * count)])
    reflected = np.linalg.solve(system, right)[:count]
    centre = above[harmonics].real
    return orders, np.abs(reflected) ** 2 * above.real / centre


def flat_mirror(cover, metal, sine, is_tm):
    inside, within = np.sqrt(cover**2 - sine**2), np.sqrt(metal**2 - sine**2)
    a, b = (metal**2 * inside, cover**2 * within) if is_tm else (inside, within)
    return abs((a - b) / (a + b)) ** 2


def scalar(pitch, width, depth, cover, wavelength, sine, orders):
    fill = width / pitch
    alpha = sine + orders * wavelength / pitch
    # As Fringe has it: orders that propagate in air, and evanescent ones' power given back to them.
    lit = np.abs(alpha) < 1
    cosines = np.sqrt(1 - (sine / cover) ** 2) + np.sqrt(np.maximum(1 - (alpha / cover) ** 2, 0))
    contrast = 4 * np.sin(np.pi * cover * depth * cosines / wavelength) ** 2
    shares = np.where(orders == 0, 1 - contrast * fill * (1 - fill), contrast * fill**2 * np.sinc(orders * fill) ** 2)
    shares = np.where(lit, shares, 0)
    return shares / shares.sum()


def main():
    print("medium    nm  sine  order    TE     TM   mean  scalar")
    for name, (pitch, width, depth, cover, metal) in MEDIA.items():
        polarised, unpolarised = [], []
        for wavelength in (0.45, 0.55, 0.65):
            index = metal_index(metal, 1e3 * wavelength)
            for sine in (0.0, 0.5):
                vector = []
                for is_tm in (False, True):
                    orders, shares = coupled_waves(pitch, width, depth, cover, index, wavelength, sine, is_tm)
                    vector.append(shares / flat_mirror(cover, index, sine, is_tm))
                te, tm = vector
                expected = scalar(pitch, width, depth, cover, wavelength, sine, orders)
                for at in np.flatnonzero(np.abs(sine + orders * wavelength / pitch) < 1):
                    mean = (te[at] + tm[at]) / 2
                    print(f"{name:8} {1e3 * wavelength:.0f}  {sine:4.1f}  {orders[at]:5d}  {te[at]:.3f}  {tm[at]:.3f}  {mean:.3f}"
                          f"  {expected[at]:.3f}")
                    polarised.append(max(abs(te[at] - expected[at]), abs(tm[at] - expected[at])))
                    unpolarised.append(abs(mean - expected[at]))
        print(f"{name}: off by up to {max(polarised):.2f} in polarised light, {max(unpolarised):.2f} in unpolarised light")


main()
