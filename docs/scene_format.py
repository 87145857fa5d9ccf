#!/usr/bin/env python3
"""Writes the tables of docs/scene-format.md from scenes/fringe.schema.json.

The prose of the page is written by hand; what lies between the two marker lines comes from here.
`--check` writes nothing and fails, with the difference, if the page is out of date.
"""

import difflib
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "scene-format.md"
BEGIN = "<!-- The rest is written by docs/scene_format.py from scenes/fringe.schema.json. -->\n"
END = "<!-- End of what docs/scene_format.py writes. -->\n"

SCHEMA = json.loads((ROOT / "scenes" / "fringe.schema.json").read_text(encoding="utf-8"))

# What many keys share has a section of its own at the end of the page.
SHARED = {
    "spectrum": "Spectra",
    "simple_spectrum": "Spectra",
    "reflectance": "Curves",
    "efficiency_curve": "Curves",
    "efficiencies": "Efficiencies",
}


def resolved(schema):
    """The schema with its $ref followed; the keywords beside the $ref win."""
    if "$ref" not in schema:
        return schema
    target = SCHEMA
    for segment in schema["$ref"].removeprefix("#/").split("/"):
        target = target[segment]
    return {**resolved(target), **{key: value for key, value in schema.items() if key != "$ref"}}


def shared_heading(schema):
    """The heading of the section that describes what the schema refers to, if that is shared by many keys."""
    while "$ref" in schema:
        name = schema["$ref"].rsplit("/", 1)[1]
        if name in SHARED:
            return SHARED[name]
        schema = SCHEMA["$defs"].get(name, {})
    return None


def without_article(title):
    return title.split(" ", 1)[1] if title.split(" ", 1)[0] in ("a", "an") else title


def code(value):
    return f"`{json.dumps(value, ensure_ascii=False)}`"


def heading_anchor(title):
    return "#" + title.lower().replace(" ", "-")


def type_of(schema):
    shared = shared_heading(schema)
    schema = resolved(schema)
    if shared:
        return f"[{without_article(schema['title'])}]({heading_anchor(shared)})"
    if "const" in schema:
        return code(schema["const"])
    if "enum" in schema:
        return ", ".join(code(choice) for choice in schema["enum"])
    title = without_article(schema.get("title", ""))
    if schema.get("type") == "object" and title or "oneOf" in schema and is_section(schema):
        return f"[{title}]({heading_anchor(title)})"
    if schema.get("type") == "array" and is_section(resolved(schema["items"])):
        item = without_article(resolved(schema["items"])["title"])
        return f"array of [{item}s]({heading_anchor(item + 's')})"
    if isinstance(schema.get("additionalProperties"), dict):
        item = without_article(resolved(schema["additionalProperties"])["title"])
        return f"[{item}s]({heading_anchor(item + 's')}) by name"
    return title or {"integer": "whole number"}.get(schema["type"], schema["type"])


def is_section(schema):
    """Whether a schema has a section of its own: it is an object, or a choice with objects."""
    if "oneOf" in schema:
        return any(is_section(resolved(alternative)) for alternative in schema["oneOf"])
    return schema.get("type") == "object" and "properties" in schema


def range_of(schema):
    """The numbers or quantities that are allowed, also of each element of an array."""
    schema = resolved(schema)
    if schema.get("type") == "array":
        return range_of(schema["items"])
    plain = lambda value: f"{value:g}".replace("e+0", "e") if isinstance(value, float) else str(value)
    bounds = {}
    for prefix in ("", "quantity"):
        for sign, name in ((">", "exclusiveMinimum"), ("≥", "minimum"), ("<", "exclusiveMaximum"), ("≤", "maximum")):
            key = prefix + name[0].upper() + name[1:] if prefix else name
            if key in schema:
                bounds[sign] = plain(schema[key])
    if "≥" in bounds and "≤" in bounds:
        return f"{bounds['≥']} to {bounds['≤']}"
    return ", ".join(f"{sign} {bound}" for sign, bound in bounds.items())


def table(properties, required, entries=None):
    """The keys of an object; `entries` are the names and the values under any other key."""
    rows = ["| key | value | default | range | meaning |", "|---|---|---|---|---|"]
    if entries:
        names, values = entries
        rows.append(f"| {names['title']}, as {code(names['examples'][0])} | {type_of(values)} |  |  | {values['description']} |")
    for name, schema in properties.items():
        full = resolved(schema)
        if name in required:
            default = "**required**"
        elif "default" in full and full["default"] not in ({}, [], ""):
            default = code(full["default"])
        else:
            default = ""
        rows.append(f"| `{name}` | {type_of(schema)} | {default} | {range_of(schema)} | {full.get('description', '')} |")
    return "\n".join(rows) + "\n"


def sections_below(properties):
    """Of the values that are objects themselves, each described where it is first used."""
    for schema in properties.values():
        full = resolved(schema)
        if shared_heading(schema):
            continue
        if is_section(full):
            yield from section(full, level=4)
        elif full.get("type") == "array" and is_section(resolved(full["items"])):
            item = resolved(full["items"])
            yield from section(item, level=4, title=without_article(item["title"]) + "s")


def shared(alternatives):
    """The keys that all alternatives have and define alike, apart from those which tell them apart."""
    first, *others = (alternative["properties"] for alternative in alternatives)
    return {key: schema for key, schema in first.items()
            if "const" not in schema and all(other.get(key) == schema for other in others)}


def section(schema, level, title=None):
    if not is_section(schema):
        return
    title = title or without_article(schema["title"])
    yield f"{'#' * level} {title[0].upper()}{title[1:]}\n"
    if "description" in schema:
        yield schema["description"] + "\n"
    if "oneOf" in schema:
        yield from choice(schema, level)
    else:
        entries = (schema["propertyNames"], schema["additionalProperties"]) if schema["additionalProperties"] else None
        yield table(schema["properties"], schema.get("required", []), entries)
        yield from sections_below(schema["properties"])


def choice(schema, level):
    every = [resolved(alternative) for alternative in schema["oneOf"]]
    alternatives = [alternative for alternative in every if is_section(alternative)]
    key = next(name for name, value in alternatives[0]["properties"].items() if "const" in value)
    entries = [alternative["properties"][key] for alternative in alternatives]
    names = [code(entry["const"]) + (" (the default)" if "default" in entry else "") for entry in entries]
    one_of = f"{code(key)} is one of {', '.join(dict.fromkeys(names))}."
    if len(alternatives) < len(every):
        plain = "; or ".join(f"{type_of(alternative)}, {range_of(alternative)}".removesuffix(", ")
                             for alternative in every if not is_section(alternative))
        yield f"Either {plain}; or an object, whose {one_of}\n"
    else:
        yield one_of + "\n"
    common = shared(alternatives) if len(alternatives) > 1 else {}
    if common:
        yield "All have these keys:\n"
        yield table(common, alternatives[0].get("required", []))
    for alternative, entry in zip(alternatives, entries):
        own = {name: value for name, value in alternative["properties"].items() if name != key and name not in common}
        alike = [value["const"] for name, value in own.items() if "const" in value]
        heading = f"`{entry['const']}`" + "".join(f", model `{const}`" for const in alike)
        yield f"{'#' * (level + 1)} {heading}\n"
        if "description" in alternative:
            yield alternative["description"] + "\n"
        yield table(own, alternative.get("required", []))
        yield from sections_below(own)


def generated():
    yield "## Keys of a scene\n"
    yield table(SCHEMA["properties"], SCHEMA["required"])
    yield from section(resolved(SCHEMA["properties"]["image"]), level=2)
    yield from section(resolved(SCHEMA["properties"]["camera"]), level=2)
    yield from section(resolved(SCHEMA["properties"]["materials"]["additionalProperties"]), level=2, title="materials")
    yield from section(resolved(SCHEMA["properties"]["objects"]["items"]), level=2, title="objects")
    yield from section(resolved(SCHEMA["properties"]["lights"]["items"]), level=2, title="lights")
    yield from section(SCHEMA["$defs"]["spectrum"], level=2, title="spectra")
    yield from section(SCHEMA["$defs"]["reflectance"], level=2, title="curves")
    yield from section(SCHEMA["$defs"]["efficiencies"], level=2)


def main():
    old = PAGE.read_text(encoding="utf-8")
    head, rest = old.split(BEGIN)
    tail = rest.split(END)[1]
    new = head + BEGIN + "\n" + "\n".join(generated()) + "\n" + END + tail
    if "--check" not in sys.argv[1:]:
        PAGE.write_text(new, encoding="utf-8")
    elif new != old:
        sys.stdout.writelines(difflib.unified_diff(old.splitlines(True), new.splitlines(True), str(PAGE), "the schema"))
        sys.exit("docs/scene-format.md does not match the schema; run docs/scene_format.py")


main()
