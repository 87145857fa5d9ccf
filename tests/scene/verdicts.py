"""Asks python3-jsonschema for its verdict on every document of verdicts.json.

The C++ test compares parseScene with the same list, so that the schema means the same to editors and to Fringe.
The list holds only what a schema can judge: not the ranges of quantities, nor what values mean together.
"""

import json
import pathlib
import sys

import jsonschema

HERE = pathlib.Path(__file__).resolve().parent
schema = json.loads((HERE.parent.parent / "scenes" / "fringe.schema.json").read_text(encoding="utf-8"))
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)

wrong = []
entries = json.loads((HERE / "verdicts.json").read_text(encoding="utf-8"))
for entry in entries:
    if validator.is_valid(entry["scene"]) != entry["valid"]:
        wrong.append(entry["case"])
if wrong or not entries:
    sys.exit("jsonschema judges otherwise: " + "; ".join(wrong))
print(f"{len(entries)} verdicts agree")
