"""Long calls: progress, stopping, threads beside them; and that nothing is left behind."""

import _thread
import gc
import sys
import tempfile
import threading
import time
import unittest

import numpy as np

import weftlight as wl
from common import FIXTURES, twill

# A traced picture that takes minutes, in rows that take a fraction of a second: it can only end by being stopped.
LONG = {"width": 2048, "height": 2048, "spp": 64}


def flat() -> wl.Design:
    return wl.weave("twill", (16, 16)).replace(scene=wl.Scene(mesh="plane"))


class Progress(unittest.TestCase):
    def test_shares_grow_to_one(self):
        told = []
        flat().response([0, 30], [0, 30, 60], reference=True, spp=2, progress=lambda share, _: told.append(share))
        self.assertEqual(told[-1], 1)
        self.assertEqual(told, sorted(told))

    def test_it_is_called_on_the_callers_thread(self):
        threads = set()
        wl.reference(flat(), 32, 32, spp=4, progress=lambda *_: threads.add(threading.get_ident()))
        self.assertEqual(threads, {threading.get_ident()})

    def test_false_stops(self):
        with self.assertRaises(wl.Cancelled) as caught:
            wl.reference(flat(), **LONG, progress=lambda share, _: False)
        self.assertIsInstance(caught.exception, wl.Error)
        self.assertEqual(caught.exception.kind, "cancelled")

    def test_none_goes_on(self):
        self.assertEqual(wl.reference(flat(), 16, 16, spp=1, progress=lambda *_: None).shape, (16, 16, 4))

    def test_what_the_callback_raises_comes_out(self):
        def broken(share, sentence):
            raise KeyError("mine")

        with self.assertRaisesRegex(KeyError, "mine"):
            wl.reference(flat(), **LONG, progress=broken)

    def test_a_stopped_export_leaves_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaises(wl.Cancelled):
                wl.export(flat(), folder + "/set", "raw", size=1024, progress=lambda *_: False)
            with self.assertRaises(OSError):
                open(folder + "/set/texture_set.json")

    def test_ctrl_c(self):
        timer = threading.Timer(0.3, _thread.interrupt_main)
        timer.start()
        self.addCleanup(timer.join)
        with self.assertRaises(KeyboardInterrupt):
            wl.reference(flat(), **LONG)

    def test_what_is_no_function(self):
        with self.assertRaises(TypeError):
            wl.reference(flat(), 16, 16, spp=1, progress=3)


class Lock(unittest.TestCase):
    def test_other_threads_run_meanwhile(self):
        counted = 0
        done = threading.Event()

        def count():
            nonlocal counted
            while not done.is_set():
                counted += 1
                time.sleep(0.001)

        beside = threading.Thread(target=count)
        beside.start()
        try:
            flat().maps((2048, 2048), azimuths=4)
        finally:
            done.set()
            beside.join()
        self.assertGreater(counted, 20)

    def test_the_same_from_many_threads(self):
        design = wl.weave("overshot", (200, 200))
        expected = design.drawdown()
        failures = []

        def work():
            for _ in range(50):
                if not np.array_equal(design.drawdown(), expected) or design.longest_floats().warp_front < 1:
                    failures.append(1)

        threads = [threading.Thread(target=work) for _ in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(failures, [])


def resident() -> int:
    """Bytes of this process in memory."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * 4096


class NothingLeft(unittest.TestCase):
    def check(self, call):
        def once():
            try:
                call()
            except wl.Error:
                pass

        def objects():
            gc.collect()
            return len(gc.get_objects())

        for _ in range(50):
            once()
        memory, before, blocks = resident(), objects(), sys.getallocatedblocks()
        for _ in range(1000):
            once()
        self.assertLess(objects() - before, 50)
        self.assertLess(sys.getallocatedblocks() - blocks, 900)  # one a call would be a thousand
        self.assertLess(resident() - memory, 8 << 20)

    def test_reading_and_writing(self):
        data = (FIXTURES / "both_agree.wif").read_bytes()
        self.check(lambda: wl.read_bytes(data).to_bytes())

    def test_errors(self):
        self.check(lambda: wl.read_bytes(b"[WIF]\n", "x.wif"))

    def test_arrays_and_edits(self):
        design = wl.weave("twill", (128, 128))
        grid = design.threading
        references = sys.getrefcount(grid)

        def call():
            design.drawdown(), design.colors(), design.yarns, design.warp.color
            design.replace(threading=grid, title="x").with_threading(0, 1).with_thread_color("warp", [0, 1], 1)

        self.check(call)
        self.assertEqual(sys.getrefcount(grid), references)

    def test_maps_keep_their_arrays(self):
        def call():
            maps = twill().maps((16, 16))
            height, thread = maps.height_mm, maps.thread
            del maps
            height.sum(), thread.sum()

        self.check(call)

    def test_callbacks(self):
        design = twill()
        cells = ~design.drawdown()

        def broken(share, sentence):
            raise wl.Error(sentence)

        self.check(lambda: design.closest_drawdown(cells, progress=lambda *_: None))
        self.check(lambda: design.closest_drawdown(cells, progress=broken))
