"""The examples of tools/python/examples, run as a user runs them."""

import csv
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import weftlight as wl
from common import SOURCE, renderer, twill

EXAMPLES = SOURCE / "tools" / "python" / "examples"


def run(name, *arguments):
    return subprocess.run([sys.executable, str(EXAMPLES / name), *map(str, arguments)], capture_output=True, text=True)


class Examples(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_every_example_is_run(self):
        self.assertEqual({p.name for p in EXAMPLES.glob("*.py")}, {"read_a_draft.py", "contact_sheet.py", "sett_sweep.py"})

    def test_read_a_draft(self):
        twill().replace(title="By hand").write(self.folder / "twill.wif")
        done = run("read_a_draft.py", self.folder / "twill.wif")
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = done.stdout.splitlines()
        self.assertEqual(lines[0], "By hand: 8 ends, 6 picks, 4 shafts, 4 treadles")
        self.assertEqual(lines[1:3], ["..##..##", ".##..##."])

    def test_contact_sheet(self):
        for i in range(7):
            wl.weave("twill", (16, 16)).write(self.folder / f"{i}.wif")
        (self.folder / "broken.wif").write_text("no draft")
        done = run("contact_sheet.py", self.folder, "-o", self.folder / "sheet.png", "--cell", 48)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("7 drafts", done.stdout)
        self.assertIn("broken.wif", done.stderr)
        self.assertGreater((self.folder / "sheet.png").stat().st_size, 1000)

    def test_sett_sweep(self):
        wl.weave("plain", (16, 16)).write(self.folder / "plain.wif")
        done = run("sett_sweep.py", self.folder / "plain.wif", "--setts", "6,12,18", "-o", self.folder / "sweep.csv")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.folder / "sweep.csv", newline="") as file:
            rows = [{k: float(v) for k, v in row.items()} for row in csv.DictReader(file)]
        self.assertEqual([row["threads_per_cm"] for row in rows], [6, 12, 18])
        for column in ("cover", "g_per_m2", "bending_n_m", "reflectance"):
            values = [row[column] for row in rows]
            self.assertEqual(values, sorted(values), column)


class Manual(unittest.TestCase):
    def test_what_the_manual_shows_runs(self):
        renderer(self)
        code = "\n".join(re.findall(r"```python\n(.*?)```", (SOURCE / "docs" / "python.md").read_text(), re.S))
        with tempfile.TemporaryDirectory() as folder:
            wl.weave("twill", (32, 32)).write(pathlib.Path(folder) / "twill.wif")
            done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("missing.wif", done.stdout)
            self.assertTrue((pathlib.Path(folder) / "cloth.png").exists())
