#!/usr/bin/env python3
"""Writes gallery.md and renders its pictures: gallery.py PROGRAM [SCENE...] (the path of the fringe binary).

The captions are the descriptions of the scenes, so page, pictures and scenes cannot drift apart. With scenes, such as
scenes/gratings/lamps.json, only their pictures are rendered; the page is written anew in any case.
"""
import json
import pathlib
import re
import subprocess
import sys

docs = pathlib.Path(__file__).resolve().parent
root = docs.parent

SECTIONS = {  # folder: title, largest width of a picture in pixels, introduction, what comes first
    "gratings": (
        "Gratings",
        600,
        "Slits in beams: one, few and many. The scenes that begin with \"edges\" belong to"
        " [the elliptical edges of the thesis](theory.md#the-elliptical-edges-of-the-thesis).",
        ["five-gratings", "one-slit", "few-slits", "lamps", "oblique", "reflection", "red-card-gold-mirror", "gaussian",
         "near-to-far"],
    ),
    "apertures": ("Apertures", 240, "Openings of any shape, rows of them, and some in their near field.", ["wall", "near-to-far", "shapes-near-to-far", "near-field"]),
    "discs": ("Discs", 320, "Optical discs and a record, lit by the lamps of the scene; how, is in [optical-discs.md](optical-discs.md).", ["cd-on-desk", "cd"]),
    "laboratory": ("Laboratory", 420, "Experiments, to be measured with [`fringe profile`](profile.md).", []),
}
WIDER = {"apertures-wall.png": 440, "apertures-gaussian.png": 800, "apertures-near-to-far.png": 800, "apertures-shapes-near-to-far.png": 800}  # than the others of their section


def scenes(folder, first):
    found = sorted((root / "scenes" / folder).glob("*.json"), key=lambda p: p.stem)
    return sorted(found, key=lambda p: first.index(p.stem) if p.stem in first else len(first))


def size(image, widest):
    width, height = image.get("width", 600), image.get("height", 600)
    scale = min(1.0, widest / width)
    return round(width * scale), round(height * scale)


page = """# Gallery

Every picture is one command away. The captions are the descriptions in the scenes; what is computed, and how exactly, is in
[theory.md](theory.md). Pictures of the thesis's own algorithm are in [thesis-figures.md](thesis-figures.md). This page is
made by `docs/gallery.py`.
"""
for folder, (title, widest, text, first) in SECTIONS.items():
    listed = scenes(folder, first)
    if not listed:
        continue
    page += f"\n## {title}\n\n{text}\n"
    for scene in listed:
        content = json.loads(re.sub(r"^\s*//.*$", "", scene.read_text(), flags=re.MULTILINE))
        relative = scene.relative_to(root).as_posix()
        picture = f"{scene.stem}.png" if folder in ("discs", "laboratory") else f"{folder}-{scene.stem}.png"
        width, height = size(content["image"], WIDER.get(picture, widest))
        command = ["render", relative, "-o", picture]
        if (width, height) != (content["image"].get("width", 600), content["image"].get("height", 600)):
            command += ["--set", f"image.width={width}", "--set", f"image.height={height}"]
        if len(sys.argv) < 3 or relative in sys.argv[2:]:
            arguments = [argument.replace(picture, str(docs / "images" / picture)) for argument in command]
            subprocess.run([sys.argv[1], *arguments, "--quiet"], cwd=root, check=True)
        page += f"""
### {scene.stem.replace("-", " ").capitalize()}

{content["description"]}

![{scene.stem}](images/{picture})

`./fringe {" ".join(command)}`
"""
(docs / "gallery.md").write_text(page)
