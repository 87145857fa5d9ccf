"""Measures a built Fringe and prints each ratio beside its goal.

Ratios of two measurements hold on any machine, which absolute times do not; the one time among them has a goal for two
cores. Whatever is compared runs alternately, so that a slow moment of the machine hits both, and the median of the
paired ratios is reported with their range. Times inside the program are its own clocks (render --stats), whole
processes are timed by hyperfine, and the driver's shader caches are off throughout, so that every run is a first run.
"""

import argparse
import dataclasses
import json
import os
import pathlib
import shlex
import statistics
import subprocess
import sys
import tempfile

from gratings import gratings_scene
from spheres import spheres_scene

HERE = pathlib.Path(__file__).resolve().parent
SCENE = HERE.parent.parent / "scenes/thesis/figure-24.json"
EMPTY_SCENE = HERE / "empty.json"
HEXAGON_SCENE = HERE.parent.parent / "scenes/apertures/hexagon.json"
POVRAY_SCENE = HERE / "cornell.pov"
ENVIRONMENT = os.environ | {"MESA_SHADER_CACHE_DISABLE": "true", "MESA_GLSL_CACHE_DISABLE": "true"}

CHECK_FAILED = 3  # the exit status that the program, too, uses for a failed check


@dataclasses.dataclass
class Result:
    what: str
    values: list[float]  # one per round
    goal: tuple[float, float]  # least and most that the median may be
    unit: str = ""

    @property
    def median(self) -> float:
        return statistics.median(self.values)

    @property
    def reached(self) -> bool:
        return self.goal[0] <= self.median <= self.goal[1]

    def row(self) -> str:
        least, most = self.goal
        goal = f"{least:g} to {most:g}" if least > 0 else f"at most {most:g}"
        spread = f"{min(self.values):.2f} to {max(self.values):.2f}"
        verdict = "reached" if self.reached else "MISSED"
        return f"{self.what:<58}{self.median:>8.2f} {self.unit:<4}{spread:>16}   {goal:<14}{verdict}"


class Fringe:
    """A Fringe executable, and the folder its pictures go to."""

    def __init__(self, executable: pathlib.Path, folder: pathlib.Path):
        self.executable = executable
        self.folder = folder

    def render_command(self, scene: pathlib.Path, size: int = 600) -> list[str]:
        sizing = ["--set", f"image.width={size}", "--set", f"image.height={size}"]
        return [str(self.executable), "render", str(scene), "-o", str(self.folder / "fringe.png"), "--quiet", *sizing]

    def clocks_ms(self, scene: pathlib.Path, size: int = 600, samples: int = 1) -> dict[str, float]:
        stats = self.folder / "stats.json"
        options = ["--set", f"image.samples={samples}", "--stats", str(stats)]
        subprocess.run([*self.render_command(scene, size), *options], env=ENVIRONMENT, check=True)
        return json.loads(stats.read_text())["clocks_ms"]

    def dispatch_ms(self, scene: pathlib.Path, size: int = 600, samples: int = 1) -> float:
        return self.clocks_ms(scene, size, samples)["dispatch"]

    def peak_memory_gib(self, scene: pathlib.Path, size: int) -> float:
        """Largest resident set of one run, in GiB; on a software driver that includes the device's memory."""
        process = subprocess.Popen(self.render_command(scene, size), env=ENVIRONMENT)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)  # tells Popen that the process has been waited for
        if process.returncode != 0:
            raise subprocess.CalledProcessError(process.returncode, process.args)
        return usage.ru_maxrss / 2**20  # Linux counts it in KiB


def physical_scene(folder: pathlib.Path) -> pathlib.Path:
    """Figure 24 with its gratings by physics: spectral, energy-conserving, in daylight."""
    scene = json.loads(SCENE.read_text())
    for light in scene["lights"]:
        if light["type"] != "grating":
            continue
        del light["attenuation"]
        light["model"] = "physical"
        light["efficiency"] = 1
        light["beam"] = {"profile": "rectangle", "width": "1 mm", "height": "200 mm", "power": "0.3 W", "spectrum": "D65"}
    path = folder / "physical.json"
    path.write_text(json.dumps(scene))
    return path


def hyperfine(fringe: Fringe, *commands: list[str]) -> list[float]:
    """Wall time of each command, one run each, one after the other."""
    report = fringe.folder / "hyperfine.json"
    subprocess.run(
        ["hyperfine", "--shell=none", "--style=none", "--runs=1", f"--export-json={report}", *map(shlex.join, commands)],
        cwd=fringe.folder, env=ENVIRONMENT, check=True, stdout=subprocess.DEVNULL)
    return [result["median"] for result in json.loads(report.read_text())["results"]]


def whole_process_ratio(fringe: Fringe) -> float:
    """Wall time of Fringe over that of POV-Ray on the same geometry with one point light and no diffraction."""
    povray = ["povray", "+W600", "+H600", "-A", "-D", "+WT2", f"+I{POVRAY_SCENE}", "+Opovray.png"]
    ours, theirs = hyperfine(fringe, fringe.render_command(SCENE), povray)
    return ours / theirs


# A dispatch of some ten milliseconds is at the mercy of where the scheduler puts its threads; a round takes the median of
# so many.
SHORT_RUNS = 7


def sphere_ratios(fringe: Fringe, rounds: int) -> dict[str, list[float]]:
    """Clocks of 100,000 spheres over those of 10 that fill as much of the picture, one after the other."""
    many, few = fringe.folder / "many.json", fringe.folder / "few.json"
    many.write_text(json.dumps(spheres_scene(100_000)))
    few.write_text(json.dumps(spheres_scene(10)))
    ratios = {"dispatch": [], "total": []}
    for _ in range(rounds):
        of_many, of_few = fringe.clocks_ms(many), fringe.clocks_ms(few)
        for clock, values in ratios.items():
            values.append(of_many[clock] / of_few[clock])
    return ratios


def missing_gratings_ratios(fringe: Fringe, rounds: int) -> list[float]:
    """Dispatch of a picture that 1,000 gratings do not light over that of the same room without any."""
    missing, none = fringe.folder / "missing.json", fringe.folder / "none.json"
    missing.write_text(json.dumps(gratings_scene(1000)))
    none.write_text(json.dumps(gratings_scene(0)))
    ratios = []
    for _ in range(rounds):
        pairs = [(fringe.dispatch_ms(missing, 2400), fringe.dispatch_ms(none, 2400)) for _ in range(SHORT_RUNS)]
        ratios.append(statistics.median(a for a, _ in pairs) / statistics.median(b for _, b in pairs))
    return ratios


def physics_ratios(fringe: Fringe, rounds: int, samples: int) -> list[float]:
    """Figure 24 by physics over the same as printed."""
    scenes = (physical_scene(fringe.folder), SCENE)
    ratios = []
    for _ in range(rounds):
        runs = [[fringe.dispatch_ms(scene, samples=samples) for scene in scenes] for _ in range(SHORT_RUNS)]
        physical, thesis = (statistics.median(times) for times in zip(*runs))
        ratios.append(physical / thesis)
    return ratios


def measure(fringe: Fringe, rounds: int) -> list[Result]:
    whole, hexagon, dispatch, growth = [], [], [], []
    # At two samples a pixel a Fresnel ripple may show, and the shader has Fresnel's integrals (src/compile/ripples.cpp).
    hidden, rippled = (physics_ratios(fringe, rounds, samples) for samples in (1, 2))
    for _ in range(rounds):
        whole.append(whole_process_ratio(fringe))
        hexagon += hyperfine(fringe, fringe.render_command(HEXAGON_SCENE, 1024))
        small = statistics.median(fringe.dispatch_ms(SCENE) for _ in range(SHORT_RUNS))
        dispatch.append(small / fringe.dispatch_ms(EMPTY_SCENE))
        growth.append(fringe.dispatch_ms(SCENE, 4800) / small / (4800 / 600) ** 2)
    spheres = sphere_ratios(fringe, rounds)
    missing = missing_gratings_ratios(fringe, rounds)
    memory = [fringe.peak_memory_gib(SCENE, 16384)]
    return [
        Result("whole process, figure 24: Fringe / POV-Ray", whole, (0, 0.5)),
        Result("whole process, hexagon at 1024x1024, on two cores", hexagon, (0, 0.5), "s"),
        Result("dispatch: figure 24 / smallest shader", dispatch, (0, 20)),
        Result("dispatch, figure 24: spectral and in watts / thesis", hidden, (0, 1.3)),
        Result("the same where ripples may show, at two samples", rippled, (0, 1.3)),
        Result("dispatch per pixel, figure 24: 4800x4800 / 600x600", growth, (0.85, 1.15)),
        Result("dispatch: 100,000 spheres / 10", spheres["dispatch"], (0, 20)),
        Result("whole render: 100,000 spheres / 10", spheres["total"], (0, 20)),
        Result("dispatch: 1,000 gratings that light none of it / none", missing, (0, 1.02)),
        Result("peak host memory, figure 24 at 16384x16384", memory, (0, 1.5), "GiB"),
    ]


def main() -> int:
    parser = argparse.ArgumentParser(prog="tests/performance/run", description=__doc__)
    parser.add_argument("executable", type=pathlib.Path, help=argparse.SUPPRESS)
    parser.add_argument("--rounds", type=int, default=7, help="measurements per ratio (default %(default)s)")
    parser.add_argument("--check", action="store_true", help=f"exit with {CHECK_FAILED} when a goal is missed")
    options = parser.parse_args()

    with tempfile.TemporaryDirectory(prefix="fringe-performance-") as folder:
        results = measure(Fringe(options.executable, pathlib.Path(folder)), options.rounds)
    print(f"{'ratio':<58}{'median':>8}     {'range':>16}   goal")
    for result in results:
        print(result.row())
    return CHECK_FAILED if options.check and not all(result.reached for result in results) else 0


if __name__ == "__main__":
    sys.exit(main())
