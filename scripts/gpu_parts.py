"""The parts of scripts/gpu_check. Each returns its status, a note and details for the report."""

import json
import os
import shutil
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import gpu_build
import gpu_report

ROOT = gpu_build.ROOT
NO_DEVICE = 77
STEP_TEST = "A step on the device gives the bits of the CPU backend"
SIZES = tuple(64 * 2**k for k in range(9))  # 64 to 16384 cells along a side
# Scenes of minutes on a processor, made shorter.
SHORTER = {"poured_pile/scene.yaml": ["time.end=4 s"]}
# A collapse of some dozens of steps, for tools that make everything slow.
TINY = ["grid.cells=[40, 40]", "grid.spacing=3.2 cm", "time.end=60 ms", "time.frame_interval=20 ms"]


def run_all(check, build):
    """Runs the parts; returns the exit code of the check."""
    check.part("ptxas", lambda: ptxas(check, build))
    check.part("tests of the tiles", lambda: host_tests(check, build))
    asked = check.call([build.program("test_cuda"), "--list-tests"], 60, build.environment())
    if asked.code == NO_DEVICE:
        check.say(f"no device: {asked.text.strip()}")
        check.parts.append({"name": "device", "status": "skipped", "note": asked.text.strip(), "seconds": 0.0,
                            "details": None})
        built = all(part["status"] == "passed" for part in check.parts if part["name"] not in ("device", "ptxas"))
        return NO_DEVICE if built else 1
    check.part("tests of the device", lambda: device_tests(check, build))
    check.part("scenes on processor and device", lambda: scenes(check, build))
    check.part("bench", lambda: bench(check, build))
    check.part("compute-sanitizer", lambda: sanitizer(check, build))
    return 0 if check.passed() else 1


def ptxas(check, build):
    log = build.compiler_log()
    if log is None:
        if gpu_build.nvcc() is None:
            return "skipped", "no compiler log and no nvcc", None
        log = gpu_build.compile_for_ptxas(check, check.work / "ptxas")
    kernels = gpu_report.kernels(log.read_text(errors="replace"))
    spilling = [kernel["kernel"] for kernel in kernels if kernel["spill_stores"] + kernel["spill_loads"] > 0]
    return ("passed" if kernels else "failed",
            f"{len(kernels)} step kernels, {len(spilling)} of them spill registers", kernels)


def host_tests(check, build):
    if build.program("test_tiles") is None:
        return "skipped", "test_tiles was not built", None
    done = check.call([build.program("test_tiles")], 180, build.environment())
    return judge(done)


def device_tests(check, build):
    """Through ctest where the build has it, so that every test with the label is run."""
    if (build.folder / "CTestTestfile.cmake").is_file() and shutil.which("ctest"):
        done = check.call(["ctest", "--test-dir", build.folder, "-L", "gpu", "--output-on-failure"], 240,
                          build.environment())
        if done.code == 0 and any(word in done.text for word in ("Skipped", "Not Run", "No tests were found")):
            return "failed", "ctest has skipped a test of the device", None
        return judge(done)
    return judge(check.call([build.program("test_cuda")], 240, build.environment()))


def judge(done):
    last = [line for line in done.text.splitlines() if line.strip()][-1:] or [""]
    return ("passed" if done.code == 0 else "failed"), f"exit {done.code}: {last[0].strip()}", None


def scenes(check, build):
    """Every dataset of every shipped scene's series, but wall_time, has the same bits."""
    sandsim = build.program("sandsim")
    if sandsim is None:
        return "skipped", "sandsim was not built: its packages are missing", None
    pythons = [path for path in (sys.executable, "/usr/bin/python3") if check.call([path, "-c", "import h5py"]).code == 0]
    if not pythons:
        return "skipped", "no Python here has h5py", None
    files = sorted(ROOT.glob("scenes/*/scene*.yaml"))
    cores = os.cpu_count() or 1
    with tempfile.TemporaryDirectory() as scratch:
        def run(scene, device, threads):
            name = f"{scene.parent.name}/{scene.name}"
            folder = Path(scratch) / device / name
            settings = [word for setting in SHORTER.get(name, []) for word in ("--set", setting)]
            folder.parent.mkdir(parents=True, exist_ok=True)
            return folder, check.call([sandsim, "run", scene, "-o", folder, "--device", device, "--threads", threads,
                                       "-q", *settings], 120, build.environment())

        at_once = max(1, cores // 4)
        with ThreadPoolExecutor(at_once) as pool:
            on_cpu = list(pool.map(lambda scene: run(scene, "cpu", max(1, cores // at_once)), files))
        rows = []
        for scene, (cpu_folder, cpu) in zip(files, on_cpu):
            folder, cuda = run(scene, "cuda", cores)
            failed = next((f"the {device} run failed: {done.text.strip()}"
                           for device, done in (("cpu", cpu), ("cuda", cuda)) if done.code != 0), None)
            unequal = [failed] if failed else differences(check, pythons[0], cpu_folder, folder)
            rows.append({"scene": str(scene.relative_to(ROOT)), "same": not unequal, "differences": unequal,
                         "cpu_seconds": round(cpu.seconds, 2), "cuda_seconds": round(cuda.seconds, 2)})
            check.say(f"{rows[-1]['scene']}: {'; '.join(unequal) or 'the same bits'}")
    same = sum(row["same"] for row in rows)
    return ("passed" if same == len(rows) else "failed"), f"{same} of {len(rows)} scenes have the same bits", rows


def differences(check, python, first, second):
    done = check.call([python, ROOT / "scripts/compare_runs.py", first, second], 60)
    return done.text.strip().splitlines() if done.code != 0 else []


def bench(check, build):
    """Size by size, so that what was measured is kept if the time runs out."""
    if build.program("sandsim") is None:
        return "skipped", "sandsim was not built: its packages are missing", None
    merged = None
    for size in SIZES:
        done = check.call([build.program("sandsim"), "bench", "--device", "cuda", "--json", "--size", size], None,
                          build.environment())
        if done.code != 0:
            return "failed", f"{size} x {size}: exit {done.code} (124: no time was left)", merged
        report = json.loads(done.text)
        if merged is None:
            merged = report
        else:
            merged["steps"] += report["steps"]
        check.say(f"{size} x {size}: {done.seconds:.1f} s")
    return "passed", f"{len(SIZES)} sizes", merged


def sanitizer(check, build):
    """Out-of-bounds accesses and races in single steps and in a loop of steps."""
    tool = shutil.which("compute-sanitizer") or "/usr/local/cuda/bin/compute-sanitizer"
    if not Path(tool).is_file():
        return "skipped", "compute-sanitizer is not installed", None
    runs = {"steps": [build.program("test_cuda"), STEP_TEST]}
    with tempfile.TemporaryDirectory() as scratch:
        if build.program("sandsim"):
            settings = [word for setting in TINY for word in ("--set", setting)]
            runs["loop"] = [build.program("sandsim"), "run", ROOT / "scenes/column_collapse/scene.yaml", "--device",
                            "cuda", "-q", "-o", Path(scratch) / "loop", "--overwrite", *settings]
        details = []
        for kind in ("memcheck", "racecheck"):
            for name, command in runs.items():
                done = check.call([tool, "--tool", kind, "--error-exitcode", "9", *command], 100, build.environment())
                summary = [line.strip("= ") for line in done.text.splitlines() if "SUMMARY" in line]
                details.append({"tool": kind, "run": name, "code": done.code, "summary": (summary or ["none"])[-1],
                                "seconds": round(done.seconds, 1)})
    failed = [f"{row['tool']} of {row['run']} (exit {row['code']})" for row in details if row["code"] != 0]
    return ("failed" if failed else "passed"), ", ".join(failed) or "no findings", details
