#!/usr/bin/env python3
"""Case files against their schema: every shipped one conforms, each kind of mistake is refused, and the schema knows the names that
`cleave validate --list` tells.

    schema_test.py CASE_SCHEMA CASE_FOLDER CLEAVE_VALIDATE
"""
import copy
import json
import pathlib
import re
import subprocess
import sys
import tomllib

import jsonschema

schema_file, folder, program = sys.argv[1:]
schema = json.loads(pathlib.Path(schema_file).read_text())
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
problems = []


def conforms(case):
    return validator.is_valid(case)


cases = {path.stem: tomllib.loads(path.read_text()) for path in sorted(pathlib.Path(folder).glob("*.toml"))}
problems += [f"{name}: {jsonschema.exceptions.best_match(validator.iter_errors(case)).message}" for name, case in cases.items() if not conforms(case)]

# Must fail: a misspelt key, an unknown shape, solver and quantity, a number without its unit, a band without its reason.
hole = cases["hole_orthotropic"]


def damaged(change):
    case = copy.deepcopy(hole)
    change(case)
    return case


twins = {
    "misspelt key": damaged(lambda c: c["geometry"].update(hole_raduis=c["geometry"].pop("hole_radius"))),
    "unknown shape": damaged(lambda c: c["geometry"].update(shape="torus")),
    "unknown solver": damaged(lambda c: c["check"][0].update(solver=["fem.p9"])),
    "unknown quantity": damaged(lambda c: c["check"][0].update(quantity="colour")),
    "no unit": damaged(lambda c: c["geometry"].update(half_width=20)),
    "no basis": damaged(lambda c: c["check"][0].pop("basis")),
    "unknown tier": damaged(lambda c: c.update(tier="best")),
    "no check": damaged(lambda c: c.update(check=[])),
    "a study beside a body": damaged(lambda c: c.update(study={"name": "griffith"})),
    "unknown key of a study": {**copy.deepcopy(cases["griffith"]), "study": {**cases["griffith"]["study"], "colour": "red"}},
}
problems += [f"accepted: {name}" for name, case in twins.items() if conforms(case)]

# The names of the program and of the schema.
listing = subprocess.run([program, "--list"], check=True, capture_output=True, text=True).stdout
definitions = schema["$defs"]


def entries(title):
    block = listing.split(f"\n{title}", 1)[1].split("\n\n", 1)[0]
    keys = [re.sub(r" \([^)]*\)", "", text) for text in re.findall(r"^ +keys: ([^;\n]*)", block, re.M)]
    return re.findall(r"^  (\w+) ", block, re.M), [[] if text == "none" else text.split(", ") for text in keys]


def words(title):
    return [re.sub(r" \[[^]]*\]", "", text) for text in re.search(rf"^{title}: (.*)$", listing, re.M).group(1).replace("] ", "]\n").replace(", ", "\n").split("\n")]


def compare(what, program_names, schema_names):
    if sorted(program_names) != sorted(schema_names):
        problems.append(f"{what}: differ in {sorted(set(program_names) ^ set(schema_names))}")


shapes, shape_keys = entries("shapes")
bodies = {entry["properties"]["shape"]["const"]: entry["properties"] for entry in definitions["geometry"]["oneOf"] if "shape" in entry["properties"]}
compare("shapes", [name for name in shapes if name != "mesh"], bodies)
for name, keys in zip(shapes, shape_keys):
    if name in bodies:
        compare(f"keys of shape {name}", keys, set(bodies[name]) - {"shape"})
compare("solutions", entries("analytic solutions")[0], definitions["solution_name"]["enum"])
compare("solvers", words("solvers"), definitions["check"]["properties"]["solver"]["oneOf"][0]["enum"])
compare("quantities", words("quantities"), definitions["check"]["properties"]["quantity"]["enum"])
names, study_keys = entries("studies")
studies = {entry["properties"]["name"]["const"]: entry["properties"] for entry in definitions["study"]["oneOf"]}
compare("studies", names, studies)
for name, keys in zip(names, study_keys):
    compare(f"keys of study {name}", keys, set(studies.get(name, {})) - {"name"})

for problem in problems:
    print("FAILED", problem)
print(f"{len(cases)} cases, {len(twins)} twins, {len(shapes)} shapes, {len(studies)} studies: {len(problems)} problems")
sys.exit(bool(problems))
