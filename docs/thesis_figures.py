#!/usr/bin/env python3
"""Writes thesis-figures.md and renders its pictures: thesis_figures.py PROGRAM (the path of the fringe binary).

The captions are the descriptions of the scenes, so page, pictures and scenes cannot drift apart.
"""
import json
import pathlib
import re
import subprocess
import sys

docs = pathlib.Path(__file__).resolve().parent
root = docs.parent

page = """# The figures of the thesis

Every picture of A. J. Watson, "Diffraction Gratings in Ray Tracing" (MSc thesis, UC San Diego, 2009) that its algorithm
made, rendered by Fringe from the scenes in `scenes/thesis/`. The thesis states the sizes of slits, spacings and discs, and
the 600 x 600 pixels; it does not state where gratings, lamps and cameras stood, so those are ours. Figure 19 is missing: the
thesis calls it an erroneous output. [The algorithm](thesis-algorithm.md) and its faults have a page of their own.
`tests/render/figures_test.cpp` checks what the captions say. This page is made by `docs/thesis_figures.py`, with pictures
of 300 x 300 pixels.
"""
for scene in sorted((root / "scenes" / "thesis").glob("*.json")):
    text = re.sub(r"^\s*//.*$", "", scene.read_text(), flags=re.MULTILINE)
    name = scene.stem
    relative = scene.relative_to(root)
    picture = docs / "images" / f"{name}.png"
    smaller = ["--set", "image.width=300", "--set", "image.height=300"]
    subprocess.run([sys.argv[1], "render", str(relative), "-o", str(picture), "--quiet", *smaller], cwd=root, check=True)
    page += f"""
## {name.replace("-", " ").capitalize()}

{json.loads(text)["description"]}

![{name}](images/{name}.png)

`./fringe render {relative} -o {name}.png`
"""
(docs / "thesis-figures.md").write_text(page)
