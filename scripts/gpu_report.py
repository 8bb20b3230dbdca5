"""What scripts/gpu_check writes: gpu_check.json for programs, gpu_check.md for people; and the reading of ptxas."""

import json
import platform
import re
import subprocess
from datetime import date, datetime, timezone

ENTRY = re.compile(r"Compiling entry function '([^']+)' for '(\w+)'")
SPILLS = re.compile(r"(\d+) bytes stack frame, (\d+) bytes spill stores, (\d+) bytes spill loads")
USED = re.compile(r"Used (\d+) registers")
TILE = re.compile(r"(Balanced|Paper)Tile<(float|double), (?:(\d), )?(true|false), (true|false), (true|false)>")


def kernels(log):
    """One entry for each kernel that steps in what nvcc printed with -Xptxas -v."""
    found, name = [], None
    for line in log.splitlines():
        if entry := ENTRY.search(line):
            name, machine = entry.groups()
        elif name and (spills := SPILLS.search(line)):
            stack, stores, loads = map(int, spills.groups())
        elif name and (used := USED.search(line)):
            found.append({"symbol": name, "machine": machine, "registers": int(used[1]), "stack": stack,
                          "spill_stores": stores, "spill_loads": loads})
            name = None
    found = {row["symbol"]: row for row in found if re.search("(Step|Ensemble)Kernel", row["symbol"])}
    for row, text in zip(found.values(), _demangled(list(found))):
        row.update(_described(text))
    return sorted((row for row in found.values() if row["kernel"]), key=lambda row: row["kernel"])


def _demangled(symbols):
    if not symbols:
        return []
    try:
        return subprocess.run(["c++filt"], input="\n".join(symbols), capture_output=True, text=True,
                              check=True).stdout.splitlines()
    except (OSError, subprocess.SubprocessError):
        return symbols


def _described(text):
    """E.g. "balanced order 2, float32, flat, uniform, 2-D"."""
    tile = TILE.search(text)
    if not tile:
        return {"kernel": text}
    scheme, real, order, flat, uniform, one_d = tile.groups()
    what = "ensemble, " if "Ensemble" in text else ""
    return {"kernel": what + ", ".join([
        f"balanced order {order}" if scheme == "Balanced" else "paper", "float32" if real == "float" else "float64",
        "flat" if flat == "true" else "terrain", "uniform" if uniform == "true" else "maps",
        "1-D" if one_d == "true" else "2-D"])}


def write(check, build):
    """Both reports; returns the path of the Markdown one."""
    head = _head(build)
    body = {**head, "passed": check.passed(), "parts": check.parts}
    (check.output / "gpu_check.json").write_text(json.dumps(body, indent=2) + "\n")
    lines = [f"# gpu_check, {date.today()}", "", *(f"- {key}: {value}" for key, value in head.items()), "",
             *_table(("part", "status", "note", "s"),
                     [(part["name"], part["status"], part["note"], part["seconds"]) for part in check.parts])]
    details = {part["name"]: part["details"] for part in check.parts if part["details"]}
    for name, write_part in (("scenes on processor and device", _scenes), ("compute-sanitizer", _sanitizer),
                             ("bench", _bench), ("ptxas", ptxas_table)):
        if name in details:
            lines += ["", f"## {name}", "", *write_part(details[name])]
    path = check.output / "gpu_check.md"
    path.write_text("\n".join(lines) + "\n")
    return path


def _head(build):
    def first(*command, environment=None):
        try:
            return subprocess.run(command, capture_output=True, text=True, check=True, timeout=30,
                                  env=environment).stdout.strip().splitlines()[0]
        except (OSError, subprocess.SubprocessError, IndexError):
            return "unknown"

    card = first("nvidia-smi", "--query-gpu=name,driver_version", "--format=csv,noheader").split(", ")
    sandsim = build.program("sandsim") if build else None
    return {"date": datetime.now(timezone.utc).isoformat(timespec="seconds"), "card": card[0], "driver": card[-1],
            "commit": first("git", "describe", "--always", "--dirty", "--abbrev=12"),
            "sandsim": first(str(sandsim), "--version", environment=build.environment()) if sandsim else "not built",
            "build": build.how if build else "none", "system": platform.platform()}


def _table(head, rows):
    return ["| " + " | ".join(head) + " |", "|" + "---|" * len(head),
            *("| " + " | ".join(str(value).replace("|", "/").replace("\n", " ") for value in row) + " |"
              for row in rows)]


def _scenes(rows):
    return _table(("scene", "cpu s", "cuda s", "bits"),
                  [(row["scene"], row["cpu_seconds"], row["cuda_seconds"],
                    "the same" if row["same"] else "; ".join(row["differences"])) for row in rows])


def _sanitizer(rows):
    return _table(("tool", "run", "exit", "summary", "s"),
                  [(row["tool"], row["run"], row["code"], row["summary"], row["seconds"]) for row in rows])


def ptxas_table(rows):
    """Registers and spills, as Markdown."""
    return _table(("step kernel", "registers", "stack B", "spill stores B", "spill loads B"),
                  [(row["kernel"], row["registers"], row["stack"], row["spill_stores"], row["spill_loads"])
                   for row in rows])


def _bench(report):
    terabytes = report["copy_bytes_per_second"]["median"] / 1e12
    lines = [f"Copy {terabytes:.2f} TB/s (read + written). " + " ".join(
        f"{rate['precision']}: {rate['simple_operations_per_second']['median'] / 1e12:.2f} T additions and "
        f"multiplications/s, {rate['divisions_and_roots_per_second']['median'] / 1e12:.3f} T divisions and roots/s."
        for rate in report["arithmetic"]), ""]
    lines += _table(("size", "scheme", "precision", "bed", "M cell-steps/s", "min to max", "steps/s", "% of bytes",
                     "% of arithmetic"), [_step_row(row) for row in report["steps"]])
    lines += ["", *_table(("frame", "precision", "overhead us", "step us"), [
        (row["size"], row["precision"], f"{1e6 * row['overhead_seconds']:.1f}",
         f"{1e6 * row['step_seconds']['median']:.1f}") for row in report["frames"]])]
    return lines


def _step_row(row):
    head = (row["size"], f"{row['scheme']} {row['order']}", row["precision"], row["terrain"])
    if "skipped" in row:
        return (*head, row["skipped"], "", "", "", "")
    speed = row["cell_steps_per_second"]
    return (*head, f"{speed['median'] / 1e6:.0f}", f"{speed['min'] / 1e6:.0f} to {speed['max'] / 1e6:.0f}",
            f"{row['steps_per_second']:.0f}", f"{row['percent_of_floor']:.1f}",
            f"{row['percent_of_arithmetic_floor']:.1f}")
