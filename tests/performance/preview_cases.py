"""Drives `fringe preview` in the display that is there, and prints how quick it was; tests/performance/preview sets it up.

Each case turns one value of the panel, or orbits. Before its time counts it is verified: the scene that the window saves
differs from the one before in that value alone, and the picture that it saves when the knob rests is that of `fringe render`
for the saved scene. The window's own clocks are reported, of 50 and more pictures each.
"""

import dataclasses
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

SCENES = pathlib.Path(__file__).resolve().parent.parent.parent / "scenes"
SIDE = 600  # of the picture
SAMPLES = 4
SIZE = ["--set", f"image.width={SIDE}", "--set", f"image.height={SIDE}"]


@dataclasses.dataclass
class Case:
    name: str
    scene: str
    knob: str  # the path of the value; empty: the camera is moved
    place: tuple[int, int]  # in the window
    options: tuple[str, ...] = ()
    steps: int = 60  # pixels to the right, or to the left; 0: held down, as the "+" of a count


VALUE = 130  # where a value stands in the panel, from the left
FIVE = "gratings/five-gratings.json"
BLACKBODY = '{"type": "blackbody", "temperature": "5000 K"}'


def gratings_cases() -> list[Case]:
    """Every knob of the first of five gratings."""
    cases = []
    for count in (1, 100, 1000, 10_000):
        options = ("--set", f"lights.1.aperture.count={count}")

        def add(what: str, knob: str, place: tuple[int, int], steps: int = 60, more: tuple[str, ...] = ()) -> None:
            cases.append(Case(f"{count} slits: {what}", FIVE, f"lights.1.{knob}", place, options + more, steps))

        add("orientation", "normal", (70, 293))
        if count > 1:  # the second would be of another kind, and need another pipeline
            add("count", "aperture.count", (198, 362), 0)
        add("width", "aperture.width", (VALUE, 385), -40)
        add("period", "aperture.period", (VALUE, 408))
        add("beam", "beam.width", (VALUE, 454))
        add("power", "beam.power", (VALUE, 517))
        add("temperature", "beam.spectrum.temperature", (VALUE, 563), 60, ("--set", f"lights.1.beam.spectrum={BLACKBODY}"))
    return cases


CASES = [
    Case("thesis: camera", "thesis/figure-24.json", "", (600, 300), steps=100),
    Case("thesis: period", "thesis/figure-24.json", "lights.1.aperture.period", (VALUE, 402)),
    Case("five gratings: camera", FIVE, "", (600, 300), steps=100),
    *gratings_cases(),
    Case("hexagon: diameter", "apertures/hexagon.json", "lights.0.aperture.diameter", (VALUE, 367)),
    Case("hexagon: power", "apertures/hexagon.json", "lights.0.beam.power", (VALUE, 494)),
    Case("polygon: vertex", "apertures/polygon.json", "lights.0.aperture.vertices.0.0", (VALUE, 436)),
    Case("lattice: diameter", "apertures/lattice.json", "lights.0.aperture.cell.diameter", (VALUE, 367), steps=-30),
    Case("lattice: first", "apertures/lattice.json", "lights.0.aperture.first.0", (VALUE, 407)),
    Case("mask: pixel", "apertures/mask.json", "lights.0.aperture.pixel", (VALUE, 367)),
    Case("mask: power", "apertures/mask.json", "lights.0.beam.power", (VALUE, 453)),
    Case("wall: power", "apertures/wall.json", "lights.1.beam.power", (VALUE, 470)),
    Case("CD: width of pits", "discs/cd-lights-the-wall.json", "materials.disc.pit_width", (VALUE, 327)),
    Case("CD: depth of pits", "discs/cd-lights-the-wall.json", "materials.disc.pit_depth", (VALUE, 350)),
]


def fail(case: Case, what: str) -> None:
    sys.exit(f"{case.name}: {what}")


def paths(value: object, path: str = "") -> dict[str, object]:
    """Every number and text of a scene, by its path."""
    if isinstance(value, dict):
        items = value.items()
    elif isinstance(value, list):
        items = [(str(i), entry) for i, entry in enumerate(value)]
    else:
        return {path: value}
    found = {}
    for key, entry in items:
        found.update(paths(entry, f"{path}.{key}" if path else key))
    return found


class Preview:
    """A running preview and its window."""

    def __init__(self, program: str, case: Case, folder: pathlib.Path):
        self.case = case
        self.folder = folder
        shutil.copytree((SCENES / case.scene).parent, folder / "scene")
        self.scene = folder / "scene" / pathlib.Path(case.scene).name
        self.stats = folder / "stats.json"
        command = [program, "preview", self.scene, "--samples", str(SAMPLES), *SIZE, *case.options, "--stats", self.stats]
        self.process = subprocess.Popen(command, cwd=folder)
        self.window = self.wait_for(lambda: self.tool("search", "--onlyvisible", "--name", ", complete"))
        self.tool("windowfocus", self.window)

    def tool(self, *arguments: str) -> str:
        done = subprocess.run(["xdotool", *arguments], capture_output=True, text=True, check=False)
        return done.stdout.strip()

    def wait_for(self, condition):
        for _ in range(600):
            if result := condition():
                return result
            if self.process.poll() is not None:
                fail(self.case, "the preview ended")
            time.sleep(0.1)
        fail(self.case, "the preview does not answer")

    def turn(self) -> None:
        x, y = self.case.place
        self.tool("mousemove", str(x), str(y), "mousedown", "1")
        for i in range(abs(self.case.steps)):
            self.tool("mousemove", str(x + (i + 1 if self.case.steps > 0 else -i - 1)), str(y))
            time.sleep(0.02)
        if self.case.steps == 0:
            time.sleep(2.0)
        self.tool("mouseup", "1")
        time.sleep(0.5)
        self.wait_for(lambda: "complete" in self.tool("getwindowname", self.window))

    def saved(self, key: str, file: pathlib.Path) -> pathlib.Path:
        """What the window writes for a key, when it is there."""
        file.unlink(missing_ok=True)
        self.tool("key", key)
        self.wait_for(file.exists)
        return file

    def saved_scene(self) -> dict[str, object]:
        file = self.saved("ctrl+s", self.scene.with_name(self.scene.stem + "-edited.json"))
        return paths(json.loads(file.read_text()))

    def quit(self) -> dict:
        self.tool("key", "ctrl+q")
        if self.process.wait(timeout=60) != 0:
            fail(self.case, "the preview failed")
        return json.loads(self.stats.read_text())


def verify_picture(program: str, preview: Preview) -> None:
    """As tests/preview/window_test.cpp: the silhouettes round otherwise; a code of 255 near white is 0.01."""
    name = preview.scene.stem
    picture = preview.saved("p", preview.folder / f"{name}-preview.exr").with_suffix(".png")
    scene = preview.scene.with_name(f"{name}-edited.json")
    rendered = preview.folder / "rendered.png"
    subprocess.run([program, "render", scene, "-o", rendered, "--set", f"image.samples={SAMPLES}", "--quiet"], check=True)
    compared = subprocess.run([program, "compare", picture, rendered, "--tolerance", "0.01", "--allow", "1e-3"],
                              capture_output=True, text=True, check=False)
    if compared.returncode != 0:
        fail(preview.case, f"the picture is not that of render: {compared.stdout}{compared.stderr}")


def measure(program: str, case: Case) -> dict:
    with tempfile.TemporaryDirectory() as folder:
        preview = Preview(program, case, pathlib.Path(folder))
        before = preview.saved_scene()
        preview.turn()
        after = preview.saved_scene()
        changed = {path for path in before.keys() | after.keys() if before.get(path) != after.get(path)}
        wanted = case.knob or "camera"
        if not changed or any(path != wanted and not path.startswith(wanted + ".") for path in changed):
            fail(case, f"{wanted} was to change, but what did is: {', '.join(sorted(changed)) or 'nothing'}")
        verify_picture(program, preview)
        return preview.quit()


def main() -> None:
    program, pattern = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else ""
    print("milliseconds: median (largest, of so many)        first picture | scene | to the picture | between pictures"
          " | not answered")
    for case in CASES:
        if pattern not in case.name:
            continue
        stats = measure(program, case)
        kind = "knob" if case.knob else "camera"

        def of(name: str) -> str:
            summary = stats[name]
            return f"{summary['median']:.3g} ({summary['largest']:.0f}, {summary['count']})"

        print(f"{case.name:<28} {stats['first_picture_ms']:6.0f} | {stats['first_scene_ms']:.3g}, then "
              f"{of('knob_scene_ms')} | {of(kind + '_latency_ms')} | {of('camera_interval_ms')} | "
              f"{stats['longest_busy_ms']:.0f}", flush=True)


if __name__ == "__main__":
    main()
