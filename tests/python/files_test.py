"""Drafts in files and in bytes."""

import os
import pathlib
import pickle
import tempfile
import unittest

import weftlight as wl
from common import FIXTURES, SOURCE, twill

DRAFTS = (".wif", ".dtx", ".wpo")


def below(folder):
    return sorted(p for p in pathlib.Path(folder).rglob("*") if p.suffix.lower() in DRAFTS)


class ByteTrue(unittest.TestCase):
    def check(self, paths):
        read = 0
        for path in paths:
            data = path.read_bytes()
            try:
                file = wl.read_bytes(data, path.name)
            except wl.Error as error:
                self.assertEqual(error.file, path.name)
                continue
            read += 1
            if file.format == "wif":
                self.assertEqual(file.to_bytes(), data, path)
                self.assertEqual(file.to_bytes(file.design), data, path)
            again = wl.read_bytes(file.to_bytes()).design
            self.assertEqual(again, file.design, path)
            self.assertTrue((again.drawdown() == file.design.drawdown()).all(), path)
        return read

    def test_fixtures_and_presets(self):
        paths = below(FIXTURES) + below(SOURCE / "presets" / "drafts")
        self.assertGreater(self.check(paths), 30)

    def test_corpus(self):
        corpus = os.environ.get("WEFTLIGHT_WIF_CORPUS")
        if not corpus:
            self.skipTest("WEFTLIGHT_WIF_CORPUS names no folder")
        self.assertGreater(self.check(below(corpus)), 100)

    def test_other_formats(self):
        formats = os.environ.get("WEFTLIGHT_OTHER_FORMATS")
        if not formats:
            self.skipTest("WEFTLIGHT_OTHER_FORMATS names no folder")
        self.assertGreater(self.check(p for p in below(formats) if p.suffix.lower() != ".wif"), 0)

    def test_an_edit_changes_its_own_lines_alone(self):
        file = wl.read(FIXTURES / "both_agree.wif")
        edited = file.design.with_threading(0, file.design.shafts - 1)
        before, after = file.to_bytes().splitlines(), file.to_bytes(edited).splitlines()
        self.assertEqual(len(before), len(after))
        self.assertLessEqual(sum(a != b for a, b in zip(before, after)), 1)
        self.assertTrue(wl.read_bytes(file.to_bytes(edited)).design.threading[0, -1])


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_paths_of_every_kind(self):
        design = twill().replace(title="Köper", author="Ada")
        for path in (self.folder / "a.wif", str(self.folder / "ä.wif")):
            design.write(path)
            self.assertEqual(wl.read(path).design, design)

    def test_an_opened_file_is_written_as_it_was(self):
        source = FIXTURES / "latin1.wif"
        wl.read(source).write(self.folder / "copy.wif")
        self.assertEqual((self.folder / "copy.wif").read_bytes(), source.read_bytes())

    def test_plain_is_ascii(self):
        plain = twill().replace(title="Köper").to_wif(plain=True)
        plain.decode("ascii")
        self.assertNotIn(b"PRIVATE", plain)

    def test_a_design_survives_pickle(self):
        design = twill().replace(title="x", notes=["a", "b"]).with_new_yarn(wl.Yarn(name="Silk", tex=12))
        self.assertEqual(pickle.loads(pickle.dumps(design)), design)
        for value in (design.warp, design.yarns[1], design.scene, design.finish, design.plan, design.look, design.loom):
            self.assertEqual(pickle.loads(pickle.dumps(value)), value)


class Errors(unittest.TestCase):
    def test_a_missing_file(self):
        with self.assertRaises(wl.Error) as caught:
            wl.read("/nowhere/at/all.wif")
        self.assertEqual(caught.exception.file, "/nowhere/at/all.wif")
        self.assertIsNone(caught.exception.line)
        self.assertEqual(caught.exception.kind, "input")

    def test_the_file_and_the_line(self):
        data = b"[WIF]\nVersion=1.1\n[CONTENTS]\nWEAVING=true\nWARP=true\nWEFT=true\n[WEAVING]\nShafts=4\nTreadles=4\n" \
               b"[WARP]\nThreads=900000000\n[WEFT]\nThreads=4\n"
        with self.assertRaises(wl.Error) as caught:
            wl.read_bytes(data, "big.wif")
        self.assertEqual((caught.exception.file, caught.exception.line), ("big.wif", 11))
        self.assertTrue(str(caught.exception).startswith("big.wif:11: "), caught.exception)

    def test_remarks_have_lines(self):
        remarks = wl.read(FIXTURES / "gaps.wif").diagnostics
        self.assertTrue(remarks)
        self.assertTrue(all(r.text and r.severity in ("note", "warning") for r in remarks))

    def test_what_cannot_be_written(self):
        with self.assertRaises(wl.Error) as caught:
            twill().write("/nowhere/at/all.wif")
        self.assertEqual(caught.exception.kind, "output")
        self.assertEqual(caught.exception.file, "/nowhere/at/all.wif")

    def test_no_draft(self):
        for data in (b"", b"\0" * 100, b"@@", bytes(range(256)) * 10):
            with self.assertRaises(wl.Error):
                wl.read_bytes(data)

    def test_wrong_types(self):
        with self.assertRaises(TypeError):
            wl.read_bytes("text")
        with self.assertRaises(TypeError):
            wl.read(3)
