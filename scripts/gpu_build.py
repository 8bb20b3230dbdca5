"""How scripts/gpu_check comes by its programs: a build with CMake, a bundle of an earlier one, or a plain build."""

import os
import shutil
import subprocess
import tarfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PROGRAMS = ("sandsim", "test_cuda", "test_tiles")
# The machine that runs a bundle has its own of these, and its tools may need newer ones than are here.
SYSTEM_LIBRARIES = ("linux-vdso", "ld-linux", "libc.so", "libm.so", "libdl.so", "libpthread.so", "librt.so",
                    "libresolv.so", "libstdc++", "libgcc_s")
# As in CMakeLists.txt: no contraction, so that the processor and the device give the same bits.
HOST_FLAGS = ["-std=c++20", "-O3", "-DNDEBUG", "-fopenmp", "-ffp-contract=off", "-fno-math-errno", f"-I{ROOT}"]
CUDA_FLAGS = ["-std=c++20", "-O3", "-DNDEBUG", "--fmad=false", "-lineinfo", "-Xptxas=-v", f"-I{ROOT}",
              "-Xcompiler=-ffp-contract=off,-fno-math-errno,-fopenmp"]


class Build:
    """A folder with bin/, and lib/ where it came as a bundle."""

    def __init__(self, folder, how, log=None):
        self.folder, self.how, self.log = Path(folder).resolve(), how, log

    def program(self, name):
        """Its path, or None where it was not built."""
        path = self.folder / "bin" / name
        return path if path.is_file() else None

    def environment(self):
        libraries = self.folder / "lib"
        return {**os.environ, **({"LD_LIBRARY_PATH": str(libraries)} if libraries.is_dir() else {})}

    def compiler_log(self):
        """What the compiler said about registers, or None."""
        for log in filter(None, (self.log, self.folder / "ptxas.log")):
            if log.is_file() and "Compiling entry function" in log.read_text(errors="replace"):
                return log
        return None


def nvcc():
    found = shutil.which("nvcc") or "/usr/local/cuda/bin/nvcc"
    return found if Path(found).is_file() else None


def capability():
    """Compute capability of the first card, e.g. "90", which is also what is taken where there is none."""
    try:
        words = subprocess.run(["nvidia-smi", "--query-gpu=compute_cap", "--format=csv,noheader"], capture_output=True,
                               text=True, timeout=30, check=True).stdout.split()
        return words[0].replace(".", "")
    except (OSError, subprocess.SubprocessError, IndexError):
        return "90"


def given(check, path):
    """A build folder, or a bundle to unpack."""
    path = Path(path)
    if path.is_file():
        folder = check.work / "bundle"
        shutil.rmtree(folder, ignore_errors=True)
        with tarfile.open(path) as bundle:
            bundle.extractall(folder)
        return Build(folder, f"the bundle {path.name}")
    return Build(path, f"the folder {path.name}")


def build_with_cmake(check, folder, *options):
    """The release preset with tests. None where CMake or a package is missing."""
    compiler = nvcc()
    if compiler is None or shutil.which("cmake") is None:
        return None
    log = folder / "build.log"  # kept from build to build: only what is compiled again says so again
    folder.mkdir(parents=True, exist_ok=True)
    configure = ["cmake", "--preset", "release", "-B", str(folder), "-DSANDSIM_CUDA=ON", "-DSANDSIM_TESTS=ON",
                 f"-DCMAKE_CUDA_COMPILER={compiler}", f"-DCMAKE_CUDA_ARCHITECTURES={capability()}",
                 "-DCMAKE_CUDA_FLAGS=-Xptxas=-v", *options]
    if check.call(configure, log=log).code != 0:
        check.say(f"CMake cannot configure here (see {log})")
        return None
    done = check.call(["cmake", "--build", str(folder), "--target", *PROGRAMS], log=log)
    if done.code != 0:
        raise RuntimeError(f"the build failed: see {log}")
    return Build(folder, "CMake, release preset", log)


def build_plainly(check, folder):
    """The solver and its tests, by the compilers alone; a few words stand in for Catch2."""
    compiler = nvcc()
    if compiler is None:
        raise RuntimeError("there is no nvcc")
    solver = [*_files("solver", "*.cpp"), *_files("solver/backends/cuda", "*.cu")]
    solver = [path for path in solver if not path.name.endswith("not_built.cpp")]
    tiles = _files("tests/tiles", "*.cpp")
    device = [*_files("tests/cuda", "*.cpp"), *_files("tests/cuda", "*.cu")]
    host_main = [ROOT / "tests/support/main.cpp"]
    log = folder / "build.log"
    objects = _compile(check, compiler, folder, [*solver, *tiles, *device, *host_main], log)
    (folder / "bin").mkdir(exist_ok=True)
    shared = [path for path in tiles if not path.name.endswith("_test.cpp")]
    for name, sources in (("test_cuda", [*device, *shared]), ("test_tiles", [*tiles, *host_main])):
        command = [compiler, "-o", folder / "bin" / name, *[objects[path] for path in [*sources, *solver]],
                   "-Xcompiler=-fopenmp"]
        if check.call(list(map(str, command)), log=log).code != 0:
            raise RuntimeError(f"{name} does not link: see {log}")
    return Build(folder, "the compilers alone, without the packages that sandsim needs", log)


def compile_for_ptxas(check, folder):
    """The CUDA sources once more, for what ptxas says of them. Returns the log."""
    log = folder / "build.log"
    _compile(check, nvcc(), folder, _files("solver/backends/cuda", "*.cu"), log)
    return log


def _files(folder, pattern):
    return sorted((ROOT / folder).rglob(pattern))


def _compile(check, compiler, folder, sources, log):
    """Objects by their sources."""
    folder.mkdir(parents=True, exist_ok=True)
    log.write_text("")

    def compile_one(source):
        target = folder / (str(source.relative_to(ROOT)).replace("/", "_") + ".o")
        if source.suffix == ".cu":
            command = [compiler, f"-arch=sm_{capability()}", *CUDA_FLAGS]
        else:
            command = ["g++", "-march=native", *HOST_FLAGS]
        stand_in = [f"-I{ROOT}/tests/support/plain"] if source.is_relative_to(ROOT / "tests") else []
        done = check.call([*command, *stand_in, "-c", str(source), "-o", str(target)])
        return source, target, done

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        compiled = list(pool.map(compile_one, sources))
    with log.open("a") as file:
        file.writelines(done.text for _, _, done in compiled)
    failed = [source.name for source, _, done in compiled if done.code != 0]
    if failed:
        raise RuntimeError(f"{', '.join(failed)} failed to compile: see {log}")
    return {source: target for source, target, _ in compiled}


def write_bundle(check, build, file):
    """The programs with the libraries they need, for machines without compilers and packages."""
    libraries = set()
    for name in PROGRAMS:
        listing = subprocess.run(["ldd", build.program(name)], capture_output=True, text=True, check=True).stdout
        words = (line.split("=>")[1].split()[0] for line in listing.splitlines() if "=> /" in line)
        libraries |= {path for path in words if not Path(path).name.startswith(SYSTEM_LIBRARIES)}
    file = Path(file)
    file.parent.mkdir(parents=True, exist_ok=True)
    with tarfile.open(file, "w:xz") as bundle:
        for name in PROGRAMS:
            bundle.add(build.program(name), f"bin/{name}")
        for path in sorted(libraries):
            bundle.add(Path(path).resolve(), f"lib/{Path(path).name}")
        bundle.add(build.compiler_log(), "ptxas.log")
    check.say(f"{file}: {file.stat().st_size / 2**20:.1f} MiB")
