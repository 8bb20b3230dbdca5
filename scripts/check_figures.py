"""The page of the paper's figures: its names, what is kept, and that no figure is missing from it."""

import os
import shutil
import subprocess
import tempfile
import unittest
from html.parser import HTMLParser
from pathlib import Path

from PIL import Image

from paper_figures import page, piles, table1
from paper_figures.catalogue import FIGURES
from paper_figures.model import Claim, Figure, Outcome, Run, verdict
from paper_figures.publish import shrink
from paper_figures.runs import RunFailed, Runs
from paper_figures.studio import Studio
from paper_figures.workshop import Workshop, sources
from plotting import ROOT, plt, sandsim

PYTHON = "/usr/bin/python3"
COARSE = Run("flume", "flume/scene.yaml", ("grid.cells=[40, 1]", "grid.spacing=4 cm"))
HEAP = Run("heap", "piles/scene_30deg_dropped.yaml", ("grid.cells=[16, 16]", "grid.spacing=4 cm", "time.end=0.1 s"))


def draw_front(studio):
    with studio.series("flume") as series:
        figure, axes = plt.subplots()
        axes.plot(series.x, series.depth(-1)[0])
        front = float(series.fronts[-1, 0])
    return Outcome([(studio.save(figure, "front.png"), "a deposit")],
                   [Claim("it runs `out`", f"{front:.2f} m", "beyond 0.4 m", front > 0.4)])


def figures(*options):
    return subprocess.run([PYTHON, str(ROOT / "scripts/make_figures.py"), *options], capture_output=True, text=True)


class Tags(HTMLParser):
    """Counts what opens and closes."""

    def __init__(self, text):
        super().__init__()
        self.open, self.pictures, self.links = [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag == "img":
            self.pictures.append(attributes["src"])
        elif tag != "meta":
            self.open.append(tag)
        if tag == "a":
            self.links.append(attributes["href"])

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


class Names(unittest.TestCase):
    def test_all_figures_of_the_paper_are_listed(self):
        done = figures("--list")
        self.assertEqual(done.returncode, 0, done.stderr)
        names = [line.split()[0] for line in done.stdout.splitlines()]
        self.assertEqual(names, ["1a", "1b", "5", "6", "7", "8", "9", "10", "11a", "11b", "12", "13", "14", "15", "16",
                                 "17",
                                 "table1"])

    def test_an_unknown_name_is_an_error_that_names_the_nearest_and_all(self):
        for name, nearest in (("fig12", "12"), ("11c", "11"), ("tabel1", "table1")):
            with self.subTest(name=name):
                done = figures("--check", name)
                self.assertEqual(done.returncode, 1)
                self.assertIn(f"there is no figure '{name}'", done.stderr)
                self.assertIn(f"Did you mean '{nearest}", done.stderr)
                for figure in FIGURES:
                    self.assertIn(figure.title, done.stderr)

    def test_an_unknown_option_is_a_usage_error(self):
        self.assertEqual(figures("--lits").returncode, 1)

    def test_the_runs_of_a_figure_have_different_names_and_scenes_that_exist(self):
        for figure in FIGURES:
            with self.subTest(figure=figure.name):
                names = [run.name for run in figure.planned]
                self.assertEqual(len(names), len(set(names)))
                for run in figure.planned:
                    self.assertTrue((ROOT / "scenes" / run.scene).is_file(), run.scene)


class Kept(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)
        self.figure = Figure("front", "Fig. 0: a front", "it moves", draw_front, (COARSE,))

    def workshop(self):
        return Workshop(self.folder, Runs(self.folder / "runs", sandsim(), lambda text: None), lambda text: None)

    def test_a_second_call_makes_nothing(self):
        first = self.workshop()
        first.make(self.figure)
        self.assertEqual((first.made, first.runs.made), (["front"], 1))
        second = self.workshop()
        second.make(self.figure)
        self.assertEqual((second.made, second.found, second.runs.made), ([], ["front"], 0))
        self.assertEqual(vars(second.record(self.figure)["outcome"].claims[0]),
                         vars(first.record(self.figure)["outcome"].claims[0]))

    def test_what_changed_is_made_anew_and_the_old_result_goes(self):
        self.workshop().make(self.figure)
        (self.folder / "front/front.png").unlink()
        again = self.workshop()
        again.make(self.figure)
        self.assertEqual((again.made, again.runs.made), (["front"], 0))
        changed = Figure("front", self.figure.title, "", draw_front,
                         (Run("flume", COARSE.scene, (*COARSE.settings, "sand.friction_angle=25 deg")),))
        other = self.workshop()
        self.assertTrue(other.stale(changed))
        self.assertFalse(other.stale(self.figure))
        other.make(changed)
        self.assertEqual((other.made, other.runs.made), (["front"], 1))
        self.assertEqual(len(list((self.folder / "runs").iterdir())), 1)

    def test_of_a_timed_run_only_the_report_is_kept_and_how_busy_the_machine_was(self):
        runs = Runs(self.folder, sandsim(), lambda text: None)
        folder = runs.result(Run("flume", COARSE.scene, COARSE.settings, timed=True))
        self.assertEqual(sorted(path.name for path in folder.iterdir()), ["busy.txt", "run.json"])
        self.assertTrue(0 <= float((folder / "busy.txt").read_text()) <= os.cpu_count())

    def test_timed_runs_are_made_again_on_request_others_are_kept(self):
        timed = Run("timed", COARSE.scene, COARSE.settings, timed=True)
        for retime, made in ((False, 2), (False, 0), (True, 1)):
            runs = Runs(self.folder, sandsim(), lambda text: None, retime)
            for run in (timed, COARSE, timed):
                runs.result(run)
            self.assertEqual(runs.made, made)

    def test_a_run_that_fails_says_why_and_leaves_no_result(self):
        runs = Runs(self.folder, sandsim(), lambda text: None)
        bad = Run("bad", COARSE.scene, ("sand.friction_angle=200 deg",))
        with self.assertRaisesRegex(RunFailed, "friction_angle"):
            runs.result(bad)
        self.assertEqual(list(self.folder.glob("bad-*")), [])

    def test_without_a_ray_tracer_a_relief_is_drawn_and_that_is_said(self):
        tools = self.folder / "tools"
        tools.mkdir()
        studio = Studio(Figure("heap", "Fig. 0: a heap", "", None, (HEAP,)), self.workshop().runs, self.folder / "heap")
        path = os.environ["PATH"]
        self.addCleanup(os.environ.__setitem__, "PATH", path)
        os.environ["PATH"] = str(tools)
        self.assertIsNone(shutil.which("povray"))
        name = studio.trace("heap", "heap", "--sand", "snow", times=[0.05])
        self.assertGreater((self.folder / "heap" / name).stat().st_size, 5000)
        self.assertEqual(len(studio.missing), 1)
        self.assertIn("povray", studio.missing[0])

    def test_the_scripts_of_a_figure_belong_to_its_key(self):
        names = {path.name for path in sources(piles)}
        self.assertLessEqual({"piles.py", "plot_piles.py", "plotting.py", "model.py"}, names)
        self.assertNotIn("page.py", names)


class Page(unittest.TestCase):
    def setUp(self):
        outcome = Outcome([("a.png", "a < b")], [Claim("s & t", "`1`", "c", True),
                                                 Claim("p", "2", "c", False, "w", True)],
                          [("", ["x"], [["1 < 2"]])], ["a note"])
        self.sections = [page.Section(figure, {"outcome": outcome} if figure.name == "5" else None)
                         for figure in FIGURES]

    def text(self, form):
        return page.write(form, self.sections, "Machine: one.", "scripts/figures", lambda figure: figure.name, "..")

    def test_every_figure_has_a_row_and_a_section(self):
        for form in (page.Markdown(), page.Html()):
            text = self.text(form)
            for section in self.sections:
                with self.subTest(form=type(form).__name__, figure=section.figure.name):
                    self.assertIn(f"#{section.anchor}", text)
                    self.assertIn(f'id="{section.anchor}"', text)

    def test_the_html_is_well_formed_and_its_links_lead_somewhere(self):
        text = self.text(page.Html())
        tags = Tags(text)
        self.assertEqual(tags.open, [])
        self.assertEqual(tags.pictures, ["5/a.png"])
        for link in tags.links:
            target = f'id="{link[1:]}"' in text if link.startswith("#") else (ROOT / "scenes" / link).is_file()
            self.assertTrue(target, link)
        self.assertIn("1 &lt; 2", text)

    def test_published_pictures_are_of_modest_width(self):
        with tempfile.TemporaryDirectory() as folder:
            source = Path(folder) / "wide.png"
            Image.new("RGB", (2000, 1000), "red").save(source)
            (Path(folder) / "out").mkdir()
            name = shrink(source, Path(folder) / "out")
            with Image.open(Path(folder) / "out" / name) as picture:
                self.assertEqual(picture.size, (880, 440))

    def test_a_verdict_is_on_the_claims_and_apart_on_the_print(self):
        section = next(section for section in self.sections if section.record)
        self.assertEqual((section.verdict, section.verdict_as_printed), ("agrees", "does not agree"))
        self.assertEqual(verdict([Claim("", "", "", None)]), "not comparable")
        self.assertEqual(verdict([Claim("", "", "", True), Claim("", "", "", False)]), "agrees in part")

    def test_cuda_is_timed_only_where_a_device_is_listed(self):
        self.assertFalse(table1.shows_cuda("cpu   x, compute\ncuda  this sandsim was built without CUDA."))
        self.assertTrue(table1.shows_cuda("cpu   x\ncuda  NVIDIA H, compute capability 9.0, 132 multiprocessors"))


if __name__ == "__main__":
    unittest.main()
