"""Every scene that ships satisfies the JSON Schema, and the schema is not so lax that bad scenes do, too."""
import json
import pathlib
import re
import sys

try:
    import jsonschema
    import yaml
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)


class Loader(yaml.SafeLoader):
    """Plain values as YAML 1.2 reads them: PyYAML takes 1e-3 for text, and yes and 1:30 for something else."""


Loader.yaml_implicit_resolvers = {}
for tag, pattern, first in (
    ("bool", r"true|false", "tf"),
    ("int", r"[-+]?[0-9]+", "-+0123456789"),
    ("float", r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?", "-+.0123456789"),
    ("null", r"~|null|", ["~", "n", ""]),
):
    Loader.add_implicit_resolver(f"tag:yaml.org,2002:{tag}", re.compile(f"^(?:{pattern})$"), list(first))

# PyYAML's own float wants a point; Python's reads every form that the pattern lets through.
Loader.add_constructor("tag:yaml.org,2002:float", lambda loader, node: float(loader.construct_scalar(node)))

# What the schema can see: keys, types, words, units and bounds of pure numbers.
REJECTED = (
    "unknown_key", "misspelt_key", "missing_sections", "missing_type", "unknown_type", "no_unit", "no_unit_in_list",
    "wrong_kind_of_unit", "unknown_unit", "spacing_in_cells", "unit_on_a_number", "quoted_number", "scalar_for_a_list",
    "scalar_for_a_map", "one_value_of_two", "misspelt_word", "yes_for_true", "scale_out_of_range", "order_three",
    "empty_list", "null_value", "map_without_unit", "object_unknown_shape", "object_two_sizes",
    "object_speed_in_metres", "object_unknown_motion",
)


def main(root):
    schema = json.loads((root / "scenes" / "scene.schema.json").read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    failures = 0
    scenes = sorted((root / "scenes").glob("*/scene*.yaml"))
    for path in scenes:
        for error in validator.iter_errors(yaml.load(path.read_text(), Loader)):
            print(f"{path}: {'.'.join(map(str, error.absolute_path))}: {error.message}")
            failures += 1
    for name in REJECTED:
        path = root / "tests" / "bad_scenes" / f"{name}.yaml"
        if validator.is_valid(yaml.load(path.read_text(), Loader)):
            print(f"{path}: the schema accepts this bad scene")
            failures += 1
    print(f"{len(scenes)} scenes, {len(REJECTED)} bad scenes, {failures} failures")
    return 1 if failures or not scenes else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
