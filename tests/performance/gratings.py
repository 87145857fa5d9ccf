#!/usr/bin/env python3
"""Writes a scene of many gratings in a room, whose beams light what the picture shows, or only what lies above it."""

import argparse
import json
import random
import sys


def wall(center: list[float], u: list[float], v: list[float]) -> dict:
    return {"type": "rectangle", "center": center, "u": u, "v": v, "material": "white"}


def gratings_scene(count: int, seen: int = 0, size: int = 600, model: str = "physical", samples: int = 1) -> dict:
    """`count` gratings that light horizontal lines on the walls of a room; `seen` of them in the picture, spread over its
    lower half, the others under the ceiling, which it does not show."""
    place = random.Random(1)

    def grating(i: int) -> dict:
        height = place.uniform(-0.35, -0.05) if i < seen else place.uniform(0.8, 0.95)
        light = {
            "type": "grating",
            "model": model,
            "position": [round(place.uniform(-0.5, 0.5), 6), round(height, 6), round(place.uniform(0.7, 0.9), 6)],
            "normal": [0, 0, -1],
            "slit_direction": [0, 1, 0],
            "aperture": {"type": "slits", "count": 2 + i % 4, "width": "1 um", "period": "2 um"},
        }
        if model == "thesis":
            return light | {"beam": {"diameter": "5 mm"}, "power": "0.3 W"}
        beam = {"profile": "rectangle", "width": "1 mm", "height": "5 mm", "power": "5 mW", "spectrum": "D65"}
        return light | {"beam": beam, "efficiency": 1}

    return {
        "fringe": 1,
        "description": f"{count} gratings in a room, {seen} of them lighting what the picture shows.",
        "image": {"width": size, "height": size, "samples": samples},
        "camera": {"position": [0, -0.2, 0.95], "target": [0, -0.2, -1], "fov": "40 deg"},
        "materials": {"white": {"type": "diffuse", "reflectance": 0.7}},
        "objects": [
            wall([0, 0, -1], [1, 0, 0], [0, 1, 0]),
            wall([0, 0, 1], [0, 1, 0], [1, 0, 0]),
            wall([-1, 0, 0], [0, 1, 0], [0, 0, 1]),
            wall([1, 0, 0], [0, 0, 1], [0, 1, 0]),
            wall([0, -1, 0], [0, 0, 1], [1, 0, 0]),
            wall([0, 1, 0], [1, 0, 0], [0, 0, 1]),
        ],
        "lights": [
            {"type": "point", "position": [0, 0.9, 0], "power": "4 W"},
            *(grating(i) for i in range(count)),
        ],
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("count", type=int)
    parser.add_argument("--seen", type=int, default=0, help="gratings that light what the picture shows (default %(default)s)")
    parser.add_argument("--size", type=int, default=600, help="width and height in pixels (default %(default)s)")
    parser.add_argument("--samples", type=int, default=1, help="of a pixel (default %(default)s)")
    parser.add_argument("--model", choices=["physical", "thesis"], default="physical")
    options = parser.parse_args()
    json.dump(gratings_scene(options.count, options.seen, options.size, options.model, options.samples), sys.stdout)
    print()


if __name__ == "__main__":
    main()
