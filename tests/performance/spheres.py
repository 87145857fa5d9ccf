#!/usr/bin/env python3
"""Writes a scene of many small spheres, or few large ones, that fill the same part of a room and of the picture."""

import argparse
import json
import random
import sys


def spheres_scene(count: int, size: int = 600) -> dict:
    """`count` matt spheres over a floor in the light of one lamp; their volumes add up to the same for every count."""
    place = random.Random(1)
    radius = 0.3 * (10 / count) ** (1 / 3)
    spheres = [
        {
            "type": "sphere",
            "center": [round(place.uniform(-1, 1), 6) for _ in range(3)],
            "radius": round(radius, 6),
            "material": "white",
        }
        for _ in range(count)
    ]
    return {
        "fringe": 1,
        "description": f"{count} spheres over a floor.",
        "image": {"width": size, "height": size},
        "camera": {"position": [0, 0.6, 4.5], "target": [0, -0.2, 0], "fov": "40 deg"},
        "materials": {"white": {"type": "diffuse", "reflectance": 0.7}},
        "objects": [
            {"type": "rectangle", "center": [0, -1.2, 0], "u": [4, 0, 0], "v": [0, 0, 4], "material": "white"},
            *spheres,
        ],
        "lights": [{"type": "point", "position": [1.5, 3, 2], "power": "120 W"}],
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("count", type=int)
    parser.add_argument("--size", type=int, default=600, help="width and height in pixels (default %(default)s)")
    options = parser.parse_args()
    json.dump(spheres_scene(options.count, options.size), sys.stdout)
    print()


if __name__ == "__main__":
    main()
