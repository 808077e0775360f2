#!/usr/bin/env python3
"""docs/face.schema.json takes the sample faces, docs/part.schema.json every part; both refuse what the readers refuse.

Exit 77 (skipped) without python3-jsonschema.
"""
import copy
import json
import pathlib
import re
import sys

try:
    from jsonschema import Draft202012Validator
except ImportError:
    print("python3-jsonschema is not installed")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parents[4]
SCHEMA = json.loads((ROOT / "docs/face.schema.json").read_text())
SAMPLES = sorted((ROOT / "faces/compat").glob("*.face.json"))
RECIPES = [*sorted((ROOT / "faces").glob("*.face.json")), *sorted((ROOT / "examples").glob("*/*.face.json"))]


def feature(face, name):
    return next(f for f in face["features"] if f["name"] == name)


def primitives():
    """The features of tests/support/faces/primitive_features.h."""
    text = (ROOT / "tests/support/faces/primitive_features.h").read_text()
    return json.loads("[" + ",".join(re.findall(r'R"\((\{.*?\})\)"', text, re.S)[:-1]) + "]")


def primitive(name):
    return copy.deepcopy(next(f for f in primitives() if f["name"] == name))


# Each breaks a sound copy of faces/compat/toon.face.json.
BREAKS = {
    "a missing canvas": lambda f: f.pop("canvas"),
    "another format": lambda f: f.update(format="svg"),
    "another version": lambda f: f.update(format_version=2),
    "an unknown key": lambda f: f.update(nmae="x"),
    "an unknown key of a feature": lambda f: feature(f, "iris").update(pant="skin"),
    "an unknown key of a side": lambda f: feature(f, "iris").update(right={"pant": "skin"}),
    "an unknown gradient": lambda f: feature(f, "iris").update(paint={"gradient": "conic", "stops": [[0, "skin"], [1, "skin"]]}),
    "a gradient without a place": lambda f: feature(f, "iris").update(paint={"gradient": "linear", "stops": [[0, "skin"], [1, "skin"]]}),
    "an opacity above 1": lambda f: feature(f, "iris").update(opacity=2),
    "a profile that is unknown": lambda f: feature(f, "iris").update(relief={"profile": "steep"}),
    "a lamp from behind": lambda f: f.update(light={"direction": [0, 0, -1]}),
    "a mix that is unknown": lambda f: f.update(groups={"glasses": {"mix": "darken"}}),
    "an unknown kind": lambda f: feature(f, "iris").update(kind="elipse"),
    "a radius that is negative": lambda f: feature(f, "iris").update(radii=[1, -1]),
    "a width that is negative": lambda f: feature(f, "brow").update(half_width=-1),
    "a number that is too large": lambda f: feature(f, "glint").update(center=[2e9, 0]),
    "a point of one number": lambda f: feature(f, "glint").update(center=[0]),
    "a spine of two points": lambda f: feature(f, "brow").update(spine=[[0, 0], [1, 1]]),
    "a stroke of two widths": lambda f: feature(f, "brow").update(half_width=[0.1, 0.2]),
    "a path of two points": lambda f: feature(f, "head").update(points=[[0, 0], [1, 1]]),
    "an ellipse without radii": lambda f: feature(f, "iris").pop("radii"),
    "a mirror without a side": lambda f: feature(f, "head").update(mirror=True),
    "a colour that is none": lambda f: f["palette"].update(skin="#12345"),
    "a name with a slash": lambda f: feature(f, "head").update(name="a/b"),
    "a curve without keys": lambda f: f["clips"]["idle"].update(blink={}),
    "an unknown ease": lambda f: f["clips"]["idle"]["blink"].update(ease="smoth"),
    "a table of one key": lambda f: f["controls"][3].update(key_shapes={"slices": {"opening/upper": ["rest"]}}),
    "an eye without a radius": lambda f: f["eyes"][0].pop("radius"),
    "an unknown law of the bulge": lambda f: f["eyes"][0].update(bulge_law="magic"),
    "lids that meet beyond": lambda f: f["eyes"][0]["lids"].update(meet=2),
    "an unknown key of a pose": lambda f: f["poses"]["brow.sad"].update(slice={}),
    "a life of nothing": lambda f: f["clips"].update(alive={"life": []}),
    "a life of feet": lambda f: f["clips"].update(alive={"life": ["head", "feet"]}),
    "no curves": lambda f: f["clips"]["idle"].update(blink=[]),
    "a seed that is a fraction": lambda f: f["clips"]["idle"]["blink"].update(seed=0.5),
    "a head without radii": lambda f: f["turn"].pop("radii"),
    "a clip of nothing": lambda f: feature(f, "iris").update(clip=[]),
    "a clip that is beside": lambda f: feature(f, "iris").update(clip={"beside": "head"}),
    "an area of nothing": lambda f: f["features"].append({"name": "a", "kind": "area", "minus": ["head"]}),
    "a pattern of a billion": lambda f: f["features"].append(primitive("dots") | {"count": 10**9}),
    "a pattern of one row": lambda f: f["features"].append(primitive("dots") | {"patch": [[[0, 0], [1, 1]]]}),
    "a pattern of nothing": lambda f: f["features"].append({k: v for k, v in primitive("dots").items() if k != "radius"}),
    "a jitter beyond a step": lambda f: f["features"].append(primitive("dots") | {"jitter": 2}),
    "stripes in a lattice": lambda f: f["features"].append(primitive("hatching") | {"count": [2, 2]}),
    "a text of nothing": lambda f: f["features"].append({"name": "a", "kind": "text", "text": "", "center": [0, 0], "height": 1}),
    "a text without a height": lambda f: f["features"].append({"name": "a", "kind": "text", "text": "A", "center": [0, 0]}),
    "a rectangle without corners": lambda f: f["features"].append({"name": "a", "kind": "rounded", "center": [0, 0], "radii": [1, 1]}),
    "a contour that varies by nothing": lambda f: feature(f, "iris").update(contour={"color": "skin", "widths": [0, 1]}),
    "a contour twice as wide": lambda f: feature(f, "iris").update(contour={"color": "skin", "half_width": 1, "widths": [0, 1], "by": "angle"}),
    "tracks beside a curve": lambda f: f["clips"]["restless"].update(blink={"keys": [[0, 0]]}),
}


# Each breaks a sound copy of examples/own_part/fez.part.json.
PART_BREAKS = {
    "another format": lambda p: p.update(format="mien-face"),
    "an unknown key": lambda p: p.update(nmae="x"),
    "a name with a space": lambda p: p.update(name="red fez"),
    "a feature without a role": lambda p: p["features"][0].pop("role"),
    "an unknown key of a feature": lambda p: p["features"][0].update(pionts=[]),
    "a point of one number": lambda p: p["features"][0]["points"].append([1]),
    "a point of three numbers": lambda p: p["features"][0]["points"].append([1, 2, 3]),
    "a point that is nowhere": lambda p: p["features"][0]["points"].append({"plus": [0, 0]}),
    "an unknown key of a point": lambda p: p["features"][0]["points"].append({"at": "head.chin", "puls": [0, 0]}),
    "a group that mixes by nothing": lambda p: p.update(groups={"wool": {"mix": "dark"}}),
    "a named point of text": lambda p: p["points"].update(hairline="high"),
}


def part_failures():
    validator = Draft202012Validator(json.loads((ROOT / "docs/part.schema.json").read_text()))
    own = ROOT / "examples/own_part/fez.part.json"
    parts = sorted((ROOT / "parts").glob("*/*.part.json")) + sorted((ROOT / "examples").glob("*/*.part.json"))
    assert len(parts) > 100, "where are the parts?"
    failures = []
    for part in parts:
        failures += [f"{part.name}: {error.json_path}: {error.message}" for error in validator.iter_errors(json.loads(part.read_text()))]
    for what, break_it in PART_BREAKS.items():
        broken = json.loads(own.read_text())
        break_it(broken)
        if validator.is_valid(broken):
            failures.append(f"the schema of parts takes {what}")
    return failures


def main():
    Draft202012Validator.check_schema(SCHEMA)
    validator = Draft202012Validator(SCHEMA)
    failures = []
    assert len(SAMPLES) >= 3, "where are the samples?"
    for sample in SAMPLES:
        for error in validator.iter_errors(json.loads(sample.read_text())):
            failures.append(f"{sample.name}: {error.json_path}: {error.message}")
    toon = json.loads((ROOT / "faces/compat/toon.face.json").read_text())
    badge = {"name": "badge", "kind": "text", "text": "Nº 10", "center": [0, 0], "height": 0.1, "tilt": 5, "paint": "skin"}
    known = toon | {"features": [*toon["features"], *primitives(), badge]}
    assert len(primitives()) >= 14, "where are the primitives?"
    failures += [f"primitives: {error.json_path}: {error.message}" for error in validator.iter_errors(known)]
    for what, break_it in BREAKS.items():
        broken = copy.deepcopy(toon)
        break_it(broken)
        if validator.is_valid(broken):
            failures.append(f"the schema takes {what}")
    recipe = Draft202012Validator(json.loads((ROOT / "docs/recipe.schema.json").read_text()))
    page = (ROOT / "docs/parts.md").read_text()
    otto = json.loads(page.split("```json\n")[1].split("```")[0])
    failures += [f"docs/parts.md: {error.message}" for error in recipe.iter_errors(otto)]
    assert len(RECIPES) >= 4, "where are the recipes?"
    for path in RECIPES:
        failures += [f"{path.name}: {error.json_path}: {error.message}" for error in recipe.iter_errors(json.loads(path.read_text()))]
    for what, change in {"an unknown key": {"prats": {}}, "a number that is none": {"numbers": {"age": "old"}}, "a face in full": {"features": []}}.items():
        if recipe.is_valid(otto | change):
            failures.append(f"the recipe's schema takes {what}")
    failures += part_failures()
    print("\n".join(failures) or f"{len(SAMPLES)} samples and {len(RECIPES)} recipes valid, {len(BREAKS)} broken ones refused")
    return bool(failures)


if __name__ == "__main__":
    sys.exit(main())
