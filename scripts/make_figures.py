#!/usr/bin/python3
"""Makes the figures and Table 1 of the paper anew and writes one page of them. scripts/figures builds first."""

import argparse
import difflib
import os
import platform
import subprocess
import sys
import time
from pathlib import Path

from paper_figures import page
from paper_figures.catalogue import FIGURES
from paper_figures.publish import publish
from paper_figures.runs import RunFailed, Runs
from paper_figures.studio import DrawingFailed
from paper_figures.workshop import Workshop
from plotting import ROOT, sandsim


def say(text):
    print(text, file=sys.stderr, flush=True)


def chosen(names):
    """The figures of these names, in the order of the paper. Exits with 1 on a name that does not exist."""
    known = {figure.name: figure for figure in FIGURES}
    for name in names:
        if name not in known:
            near = difflib.get_close_matches(name.lower().removeprefix("fig").lstrip(".ure "), known, 1, 0.5)
            hint = f" Did you mean '{near[0]}'?" if near else ""
            say(f"error: there is no figure '{name}'.{hint} The figures are:\n{listing()}")
            sys.exit(1)
    return [figure for figure in FIGURES if not names or figure.name in names]


def listing():
    width = max(len(figure.name) for figure in FIGURES)
    return "\n".join(f"  {figure.name:{width}}  {figure.title}" for figure in FIGURES)


def processor():
    """The processor's name, as Linux has it."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor() or "unknown processor"
    return next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), "unknown processor")


def machine():
    """What the runs were made with and on."""
    version = subprocess.run([sandsim(), "--version"], capture_output=True, text=True, check=True).stdout.strip()
    return f"Made with {version} on {processor()}, {len(os.sched_getaffinity(0))} threads."


def write_pages(workshop, folder, made_on):
    """index.html and FIGURES.md in the folder of the figures."""
    sections = [page.Section(figure, workshop.record(figure), workshop.stale(figure)) for figure in FIGURES]
    for form, name in ((page.Html(), "index.html"), (page.Markdown(), "FIGURES.md")):
        text = page.write(form, sections, made_on, "scripts/figures", lambda figure: figure.name,
                          page.relative_root(folder))
        (folder / name).write_text(text)
    return sections


def options():
    parser = argparse.ArgumentParser(prog="scripts/figures", description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", metavar="NAME", help="figures to make (default: all)")
    parser.add_argument("--list", action="store_true", help="name the figures and end")
    parser.add_argument("--check", action="store_true", help="check the names and end")
    parser.add_argument("--anew", action="store_true", help="draw again what has not changed, and time again what is "
                                                            "timed; other runs are kept")
    parser.add_argument("--publish", action="store_true", help="write scenes/FIGURES.md with pictures of modest size")
    parser.add_argument("-o", "--output", type=Path, default=ROOT / "results/figures", help="folder of the page")
    try:
        return parser.parse_args()
    except SystemExit as end:
        sys.exit(1 if end.code else 0)       # argparse ends with 2, which here is an invalid scene


def main():
    given = options()
    figures = chosen(given.names)
    if given.check:
        return 0
    if given.list:
        print(listing())
        return 0
    start = time.monotonic()
    folder = given.output.resolve()
    runs = Runs(folder / "runs", sandsim(), say, retime=given.anew)
    workshop = Workshop(folder, runs, say)
    failed = []
    for figure in figures:
        try:
            workshop.make(figure, given.anew)
        except (RunFailed, DrawingFailed) as error:
            failed.append(figure.name)
            say(f"error: figure {figure.name} was not made: {error}")
    made_on = machine()
    sections = write_pages(workshop, folder, made_on)
    for section in sections:
        say(f"  {section.figure.name:8} {section.verdict}")
    for text in workshop.missing:
        say(f"missing: {text}")
    say(f"{len(workshop.made)} made, {len(workshop.found)} unchanged, {len(failed)} failed; {runs.made} runs made, "
        f"{runs.found} kept; {time.monotonic() - start:.0f} s")
    if given.publish:
        publish(workshop, sections, made_on)
    print(folder / "index.html")
    return 5 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
