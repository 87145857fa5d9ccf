"""What a feature costs that a scene lacks: instructions of the specialised shader, counted.

For every feature the renderer's source is compiled twice, with the constants that a scene has: once as it is, and once
with the feature deleted from the source: the blocks that belong to it, its place among the shapes, its constant. Both
have their constants frozen and go through spirv-opt -O. The first may not have more instructions than the second. Of a
feature that the scene has it must have more, or the deletion deletes nothing.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

SHADERS = pathlib.Path(__file__).resolve().parent.parent.parent / "shaders"
CHECK_FAILED = 3

# What belongs to each feature: constants, and kinds of shapes.
FEATURES = {
    "mirrors": (["HAS_CONDUCTORS", "HAS_THESIS_DISCS"], []),
    "glass": (["HAS_DIELECTRICS"], []),
    "point lights": (["HAS_POINT_LIGHTS"], []),
    "thesis gratings": (["GRATING_COUNT"], []),
    "rectangles": (["RECTANGLE_COUNT"], ["RECTANGLE"]),
    "triangles": (["TRIANGLE_COUNT"], []),
    "glowing surfaces": (["HAS_EMITTERS"], []),
    "environment": (["HAS_ENVIRONMENT"], []),
    "area lights": (["HAS_RECTANGLE_LIGHTS", "HAS_DISC_LIGHTS", "HAS_SPHERE_LIGHTS"], []),
    "spot lights": (["HAS_SPOT_LIGHTS"], []),
    "directional lights": (["HAS_DIRECTIONAL_LIGHTS"], []),
    "slit gratings": (["SLIT_GRATING_COUNT"], []),
    "opening gratings": (["OPENING_GRATING_COUNT"], []),
    "near fields of openings": (["HAS_NEAR_OPENINGS"], []),
    "near fields that are looked up": (["HAS_NEAR_LAYERS"], []),
    "optical discs": (["OPTICAL_DISC_COUNT", "CASTING_DISC_COUNT", "HAS_HUBS"], []),
    "sums over wavelengths": (["HAS_DIRECT_EVALUATOR"], []),
    "evaluation by orders": (["HAS_ORDERS_EVALUATOR"], []),
    "small-angle approximation": (["HAS_SMALL_ANGLE_EVALUATOR"], []),
    "sums as printed": (["HAS_NAIVE_EVALUATOR"], []),
    "responses in bands": (["HAS_BAND_RESPONSES"], []),
    "coarse slits": (["HAS_PAIRS_EVALUATOR"], []),
    "lines through slits": (["HAS_SLIT_LINES"], []),
    "continuous spectra through slits": (["HAS_SLIT_CONTINUUM"], []),
    "wide gratings": (["HAS_WIDE_GRATINGS"], []),
    "Gaussian beams": (["HAS_GAUSSIAN_BEAMS"], []),
    "given efficiencies": (["HAS_ORDER_SHARES"], []),
    "Fresnel's ripples": (["HAS_RIPPLES"], []),
    "look-up in tables": (["HAS_TABLE_EVALUATOR"], []),
    "sources with a size": (["HAS_WIDE_SOURCES"], []),
    "rectangular openings": (["HAS_RECTANGULAR_OPENINGS"], []),
    "circular openings": (["HAS_CIRCULAR_OPENINGS"], []),
    "ring openings": (["HAS_RING_OPENINGS"], []),
    "polygonal openings": (["HAS_POLYGONAL_OPENINGS", "HAS_SYMMETRIC_OPENINGS"], []),
    "masks": (["HAS_MASK_OPENINGS"], []),
    "lattices": (["HAS_LATTICES"], []),
    "lattices in Gaussian beams": (["HAS_UNEVEN_LATTICES"], []),
    "Gaussian beams that pass whole": (["HAS_GAUSSIAN_OPENINGS"], []),
    "what pits scatter": (["HAS_SCATTERING"], []),
    "vinyl's grooves": (["HAS_GROOVES"], []),
    "continuous spectra on discs": (["HAS_DISC_CONTINUUM"], []),
    "lines on discs": (["HAS_DISC_LINES"], []),
    "matt surfaces": (["HAS_DIFFUSE"], []),
    "several samples": (["HAS_SEVERAL_SAMPLES"], []),
    "depth of field": (["HAS_LENS"], []),
    "0/0 as printed": (["HAS_PRINTED_FAULTS"], []),
    "tree of shapes": (["TREE_DEPTH"], []),
    "shadows": (["HAS_SHADOWS"], []),
    "texels in images": (["TEXELS_IN_IMAGES"], []),
    "discs": (["DISC_COUNT"], ["DISC"]),
    "spheres": (["SPHERE_COUNT"], ["SPHERE"]),
    "boxes": (["BOX_COUNT"], ["BOX"]),
    "cylinders": (["CYLINDER_COUNT"], ["CYLINDER"]),
    "cones": (["CONE_COUNT"], ["CONE"]),
    "planes": (["PLANE_COUNT"], ["PLANE"]),
}


# Numbers, of which none is a feature.
NO_FEATURES = {"LIGHT_COUNT", "MATERIAL_COUNT"}


def unknown_constants() -> set[str]:
    """What the shaders may be told and no feature here names."""
    named = {constant for constants, _ in FEATURES.values() for constant in constants}
    declared = re.findall(r"X\(\d+, ((?:HAS_\w+)|(?:\w+_COUNT))\)", (SHADERS / "specialisation.h").read_text())
    return set(declared) - named - NO_FEATURES


def run(*command: str) -> str:
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(command)[:200]}:\n{done.stdout}{done.stderr}")
    return done.stdout


def end_of(text: str, start: int) -> int:
    """Behind the bracket that closes the one at `start`."""
    closing = {"(": ")", "{": "}"}[text[start]]
    depth = 0
    for i in range(start, len(text)):
        depth += (text[i] == text[start]) - (text[i] == closing)
        if depth == 0:
            return i + 1
    raise ValueError("unbalanced brackets")


def end_of_statement(text: str, start: int) -> int:
    """Behind the statement that begins at `start`, an if with all of its elses."""
    at = start + len(re.match(r"\s*", text[start:]).group())
    if text[at] == "{":
        return end_of(text, at)
    if match := re.compile(r"(\[\[\w+\]\]\s*)?(if|for|while)\s*(?=\()").match(text, at):
        at = end_of_statement(text, end_of(text, match.end()))
        alternative = re.compile(r"\s*else\b").match(text, at)
        return end_of_statement(text, alternative.end()) if match.group(2) == "if" and alternative else at
    return text.index(";", at) + 1


def without_blocks(source: str, constant: str) -> str:
    """The source without the ifs that ask for the constant, alone or with other things."""
    asked = re.compile(rf"\bif \((?={constant} (?:!=|>) 0u(?:\)| &&))")
    while match := asked.search(source):
        condition = end_of(source, match.end() - 1)
        if "||" in source[match.end() : condition] and "(" not in source[match.end() : condition - 1]:
            raise ValueError(f"cannot delete: {source[match.start():condition]}")
        body = end_of_statement(source, condition)
        alternative = re.compile(r"\s*else\b").match(source, body)
        if alternative:
            source = source[: match.start()] + source[alternative.end() :]
        else:
            before = re.search(r"else\s*$", source[: match.start()])
            source = source[: before.start() if before else match.start()] + source[body:]
    return source


def without_constant(source: str, constant: str) -> str:
    """What is left of a constant is false, or 0."""
    source = without_blocks(source, constant)
    source = re.sub(rf"layout\(constant_id = \d+\) const uint {constant} = 1u;", "", source)
    source = re.sub(rf"\b{constant} (!=|>) 0u", "false", source)
    source = re.sub(rf"\b{constant} == 0u", "true", source)
    return re.sub(rf"\b{constant}\b", "0u", source)


class Compiler:
    """Renders' shaders with the constants of a scene."""

    def __init__(self, folder: pathlib.Path, values: dict[str, int]):
        self.folder = folder
        header = (SHADERS / "specialisation.h").read_text()
        numbers = {name: number for number, name in re.findall(r"X\((\d+), (\w+)\)", header)}
        self.values = [f"{numbers[name]}:{value}" for name, value in values.items()]

    def source(self, tree: int, kinds: list[str]) -> str:
        """The renderer's source in one piece, without these kinds of shapes."""
        parts = self.folder / "shaders"
        parts.mkdir(exist_ok=True)
        for file in SHADERS.iterdir():
            text = file.read_text()
            for kind in kinds:
                text = re.sub(rf"^ *DO\({kind},.*\n", "", text, flags=re.MULTILINE)
            (parts / file.name).write_text(text)
        defines = [f"-D{name}" for name in ("BANDED=1", "SLITS=1", "OPENINGS=1", "DISCS=1", f"TREE={tree}")]
        text = run("glslangValidator", "-E", f"-I{parts}", *defines, str(parts / "render.comp"))
        text = re.sub(r"^#line.*\n", "", text, flags=re.MULTILINE)
        return text.replace("if(", "if (").replace(")const", ") const")  # as people write it

    def instructions(self, source: str) -> int:
        glsl, spirv, optimised = (str(self.folder / name) for name in ("x.comp", "x.spv", "optimised.spv"))
        pathlib.Path(glsl).write_text(source)
        run("glslangValidator", "--quiet", "--target-env", "vulkan1.2", "-g0", "-o", spirv, glsl)
        run("spirv-opt", "--target-env=vulkan1.2", "--scalar-block-layout",
            f"--set-spec-const-default-value={' '.join(self.values)}", "--freeze-spec-const",
            "--fold-spec-const-op-composite", "-O", spirv, "-o", optimised)
        listing = run("spirv-dis", "--no-header", "--no-indent", optimised)
        return len(re.findall(r"^\s*(?:%\w+ = )?Op(?!Decorate|MemberDecorate|Name|MemberName|Type|Constant)\w+", listing,
                              flags=re.MULTILINE))


def specialisation_of(fringe: str, scene: str) -> dict[str, int]:
    return json.loads(run(fringe, "info", "--json", scene))["specialisation"]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("fringe", help="the program, which tells a scene's constants")
    parser.add_argument("scenes", nargs="+")
    parser.add_argument("--each", action="store_true", help="every feature on its own as well")
    options = parser.parse_args()
    failed = False
    if unknown := unknown_constants():
        print(f"of no feature in {pathlib.Path(__file__).name}: {', '.join(sorted(unknown))}")
        failed = True
    for scene in options.scenes:
        values = specialisation_of(options.fringe, scene)
        tree = int(values["TREE_DEPTH"] > 0)
        with tempfile.TemporaryDirectory(prefix="fringe-skipping-") as folder:
            compiler = Compiler(pathlib.Path(folder), values)
            whole = compiler.instructions(compiler.source(tree, []))
            print(f"{scene}: {whole} instructions")
            absent = {name: what for name, what in FEATURES.items() if not any(values[c] for c in what[0])}
            everything = [sum((what[i] for what in absent.values()), []) for i in range(2)]
            features = (FEATURES if options.each else {}) | {"all that it lacks": everything}
            for name, (constants, kinds) in features.items():
                source = compiler.source(tree, kinds)
                for constant in constants:
                    source = without_constant(source, constant)
                count = compiler.instructions(source)
                has = any(values[constant] for constant in constants)
                wrong = count >= whole if has else count < whole
                failed = failed or wrong
                print(f"  {name:<33}{'has' if has else 'lacks':<6} deleted: {count:6}{'  WRONG' if wrong else ''}", flush=True)
    return CHECK_FAILED if failed else 0


if __name__ == "__main__":
    sys.exit(main())
