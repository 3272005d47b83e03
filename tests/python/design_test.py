"""The design: its arrays and its edits."""

import unittest

import numpy as np

import weftlight as wl
from common import twill


class Arrays(unittest.TestCase):
    def test_a_drawdown_known_by_hand(self):
        by_hand = """
            11001100
            01100110
            00110011
            10011001
            11001100
            01100110"""
        cells = np.array([[c == "1" for c in row] for row in by_hand.split()])
        design = twill()
        self.assertEqual(design.drawdown().dtype, bool)
        np.testing.assert_array_equal(design.drawdown(), cells)
        np.testing.assert_array_equal(design.drawdown("back"), ~cells)
        np.testing.assert_array_equal(design.with_rising(False).drawdown(), ~cells)
        self.assertEqual(design.repeat(), (4, 6))

    def test_shapes(self):
        d = wl.Design.blank(5, 7, 3, 2)
        self.assertEqual((d.ends, d.picks, d.shafts, d.treadles), (5, 7, 3, 2))
        shapes = [d.threading.shape, d.tieup.shape, d.treadling.shape, d.liftplan.shape, d.drawdown().shape]
        self.assertEqual(shapes, [(5, 3), (2, 3), (7, 2), (7, 3), (7, 5)])
        self.assertEqual((d.lifts().shape, d.colors().shape, d.palette.shape), ((7, 3), (7, 5, 3), (2, 3)))
        self.assertEqual((len(d.warp), d.warp.color.shape, d.weft.spacing_mm.shape), (5, (5,), (7,)))

    def test_the_drawdown_follows_from_the_arrays(self):
        random = np.random.default_rng(1)
        for ends, picks, shafts, treadles in ((1, 1, 1, 1), (65, 3, 4, 6), (130, 70, 66, 5)):
            threading = random.random((ends, shafts)) < 0.3
            tieup = random.random((treadles, shafts)) < 0.5
            treadling = random.random((picks, treadles)) < 0.3
            d = wl.Design(threading=threading, tieup=tieup, treadling=treadling)
            lifts = (treadling.astype(int) @ tieup) > 0
            np.testing.assert_array_equal(d.lifts(), lifts)
            np.testing.assert_array_equal(d.drawdown(), (lifts.astype(int) @ threading.T) > 0)
            np.testing.assert_array_equal(d.threading, threading)

    def test_colors_are_those_on_top(self):
        design = twill().with_palette_color(0, "#FF0000").with_palette_color(1, (0, 0.5, 1))
        up = design.drawdown()
        np.testing.assert_allclose(design.colors()[up], [[1, 0, 0]] * up.sum())
        np.testing.assert_allclose(design.colors()[~up], [[0, 0.5, 1]] * (~up).sum())

    def test_arrays_that_are_given_out_are_copies(self):
        design = twill()
        for name in ("threading", "tieup", "treadling", "liftplan", "palette"):
            array = getattr(design, name)
            array[:] = 0
            self.assertEqual(design, twill(), name)

    def test_other_types_of_arrays(self):
        design = twill()
        for threading in (design.threading.astype(int), design.threading.tolist(), np.asfortranarray(design.threading),
                          design.threading[::-1][::-1]):
            self.assertEqual(design.replace(threading=threading), design)


class Replace(unittest.TestCase):
    def test_every_field(self):
        fields = {"title": "T", "author": "A", "notes": ("n",), "yarns": wl.yarn_presets(), "rising": False,
                  "finish": wl.Finish(raised=0.5), "plan": wl.ClothPlan(pieces=2, floating_selvedges=True), "look": wl.Look(method="yarn"), "scene": wl.Scene(mesh="plane"),
                  "loom": wl.Loom(shafts=8), "shed_control": "liftplan"}
        design = twill().replace(**fields)
        for name, value in fields.items():
            got = getattr(design, name)
            self.assertEqual(list(got) if name == "yarns" else got, value, name)

    def test_a_liftplan_takes_over(self):
        plan = np.ones((6, 4), bool)
        design = twill().replace(liftplan=plan)
        self.assertEqual(design.shed_control, "liftplan")
        self.assertTrue(design.drawdown().all())

    def test_another_shape_changes_the_counts(self):
        wide = twill().replace(threading=np.tile(np.eye(4), (4, 1)))
        self.assertEqual((wide.ends, wide.picks, len(wide.warp)), (16, 6, 16))
        self.assertEqual(wide.treadling.tolist(), twill().treadling.tolist())

    def test_threads(self):
        warp = wl.Threads([0, 1] * 4, spacing_mm=[0.5, np.nan] * 4, thickness_mm=0.25)
        design = twill().replace(warp=warp)
        np.testing.assert_array_equal(design.warp.color, [0, 1] * 4)
        np.testing.assert_array_equal(design.warp.spacing_mm, np.float32([0.5, np.nan] * 4))
        np.testing.assert_array_equal(design.warp.thickness_mm, np.float32([0.25] * 8))
        self.assertEqual(warp.replace(yarn=0), warp)

    def test_colours_along_a_thread(self):
        dye = wl.Dye(stretches=[wl.DyedStretch(threads=12, color=(0, 0, 1), fades=True), wl.DyedStretch(threads=8)], shift=1)
        design = twill().replace(yarns=[wl.Yarn(dye=dye)])
        self.assertIn(b"1 Dye=12 #0000FF fades, 8 own", design.to_wif())
        self.assertIsNone(design.yarns[0].dye.stretches[1].color)
        for wrong in ({"scatter": -1}, {"stretches": [wl.DyedStretch(threads=0)]}, {"stretches": [wl.DyedStretch()] * 65},
                      {"stretches": [wl.DyedStretch(color=(0.123, 0, 0))]}):
            with self.assertRaises(ValueError, msg=wrong):
                wl.Dye(**wrong)

    def test_what_does_not_fit(self):
        design = twill()
        wrong = [{"threading": np.eye(3), "tieup": np.eye(4)}, {"threading": np.zeros(4)}, {"warp": wl.Threads([9] * 8)},
                 {"warp": wl.Threads([0] * 8, yarn=1)}, {"yarns": []}, {"palette": [(0, 0, 0)]}, {"palette": ["red"]},
                 {"shed_control": "dobby"}, {"threading": np.zeros((0, 4))}, {"tieup": np.zeros((2, 5000))}]
        for fields in wrong:
            with self.assertRaises(ValueError, msg=fields):
                design.replace(**fields)
        for fields in ({"colour": 1}, {"title": 3}, {"scene": "plane"}, {"yarns": 3}):
            with self.assertRaises(TypeError, msg=fields):
                design.replace(**fields)
        for make in (lambda: wl.Yarn(diameter_mm=-1), lambda: wl.Yarn(plies=9), lambda: wl.Lobes(ior=float("nan")),
                     lambda: wl.Finish(raised=2), lambda: wl.Look(method="best"), lambda: wl.Loom(shafts=-1),
                     lambda: wl.Threads([]), lambda: wl.Threads([0, 1], yarn=[0]), lambda: wl.Threads([0], spacing_mm=-1),
                     lambda: wl.Design.blank(0, 1, 1, 1), lambda: wl.Design.blank(10**5, 10**5, 4, 4)):
            with self.assertRaises(ValueError):
                make()
        self.assertEqual(design, twill())


class Edits(unittest.TestCase):
    def edits(self):
        """Every method that edits, with arguments that change the twill."""
        d = twill()
        cells = ~d.drawdown()
        return {
            "with_threading": (0, 3), "with_tieup": (0, 3), "with_treadling": (0, 3), "with_liftplan": (0, 3),
            "with_crossing": (2, 0), "with_drawdown": (cells,), "with_thread_color": ("warp", 1, 1),
            "with_thread_yarn": ("weft", [1, 2], 0), "with_thread_thickness": ("warp", range(3), 0.3),
            "with_thread_spacing": ("weft", np.arange(2), 0.4), "with_palette_color": (0, "#102030"),
            "with_new_palette_color": ((0, 0, 1),), "with_yarn": (0, wl.Yarn(name="Silk")),
            "with_new_yarn": (wl.Yarn(),), "with_thread_order": ("warp", [3, 3, 0]), "with_bare_threads": ("warp", 8, 2),
            "without_threads": ("weft", 0, 2), "with_doubled_threads": ("warp", 0, 3),
            "with_mirrored_threads": ("weft", 0, 3), "with_reversed_threads": ("warp", 0, 3),
            "with_repeated_threads": ("warp", 0, 3), "with_point_repeat": ("warp", 0, 3), "with_rising": (False,),
            "with_leading": ("drawdown",), "to_liftplan": (), "with_weave": ("plain",), "to_treadling": (),
            "to_skeleton": (),
        }

    def test_edits_leave_the_original(self):
        before = twill()
        same = {"with_thread_yarn", "to_treadling", "to_skeleton"}  # of a design that is so already
        for name, arguments in self.edits().items():
            after = getattr(before, name)(*arguments)
            self.assertEqual(before, twill(), name)
            if name not in same:
                self.assertNotEqual(after, before, name)
            self.assertIsInstance(after, wl.Design)

    def test_every_edit_is_tested(self):
        methods = {n for n in dir(wl.Design) if n.startswith(("with", "to_"))} - {"to_wif", "with_size"}
        self.assertEqual(methods, set(self.edits()))

    def test_what_edits_do(self):
        d = twill()
        np.testing.assert_array_equal(d.with_threading(0, 3).threading[0], [0, 0, 0, 1])
        np.testing.assert_array_equal(d.with_threading(0, 3, only=False).threading[0], [1, 0, 0, 1])
        np.testing.assert_array_equal(d.with_thread_order("warp", [3, 0]).threading, d.threading[[3, 0]])
        np.testing.assert_array_equal(d.with_reversed_threads("warp", 0, 8).drawdown(), d.drawdown()[:, ::-1])
        np.testing.assert_array_equal(d.to_liftplan().drawdown(), d.drawdown())
        self.assertEqual(d.with_size(ends=12, picks=4).drawdown().shape, (4, 12))
        self.assertTrue(np.isnan(d.with_thread_spacing("warp", 0, 0.5).with_thread_spacing("warp", 0, None)
                                 .warp.spacing_mm[0]))
        random = np.random.default_rng(2).random((6, 8)) < 0.5
        np.testing.assert_array_equal(d.with_drawdown(random).drawdown(), random)

    def test_a_loom_that_is_too_small(self):
        random = np.random.default_rng(3).random((6, 8)) < 0.5
        with self.assertRaisesRegex(wl.Error, "shafts"):
            twill().with_drawdown(random, shafts=2)
        closest, wrong = twill().closest_drawdown(random, shafts=4, treadles=4)
        self.assertEqual((closest.drawdown() != random).sum(), wrong)
        self.assertLessEqual(closest.shafts, 4)

    def test_out_of_range(self):
        d = twill()
        for call in (lambda: d.with_threading(8, 0), lambda: d.with_threading(0, 4), lambda: d.with_threading(-1, 0),
                     lambda: d.with_tieup(4, 0), lambda: d.with_treadling(6, 0), lambda: d.with_liftplan(0, 4),
                     lambda: d.with_crossing(8, 0), lambda: d.with_thread_color("warp", 0, 2),
                     lambda: d.with_thread_color("weft", 6, 0), lambda: d.with_thread_color("weft", [0, -1], 0),
                     lambda: d.with_thread_yarn("warp", 0, 1), lambda: d.with_palette_color(2, (0, 0, 0)),
                     lambda: d.with_yarn(1, wl.Yarn()), lambda: d.with_thread_order("warp", [0, 8]),
                     lambda: d.with_bare_threads("warp", 9), lambda: d.without_threads("warp", 0, 9),
                     lambda: d.with_reversed_threads("weft", 5, 7), lambda: d.with_weave("plain", first_end=8)):
            with self.assertRaises(IndexError):
                call()
        with self.assertRaises(ValueError):
            d.without_threads("warp", 0, 8)
        with self.assertRaises(ValueError):
            d.with_thread_color("across", 0, 0)
        with self.assertRaises(TypeError):
            d.with_thread_color("warp", [0.5], 0)
        with self.assertRaises(ValueError):
            d.with_drawdown(np.zeros((2, 2)))

    def test_a_locked_grid(self):
        locked = twill().replace(loom=wl.Loom(leading="drawdown", locked=True))
        with self.assertRaises(wl.Error):
            locked.with_threading(0, 3)


class Weaves(unittest.TestCase):
    def test_every_weave(self):
        kinds = wl.weaves()
        self.assertGreater(len(kinds), 20)
        for kind in kinds:
            design = wl.weave(kind.id, (24, 20), **{p.id: p.default for p in kind.parameters})
            self.assertEqual((design.ends, design.picks, design.title), (24, 20, kind.name))

    def test_parameters(self):
        self.assertEqual(wl.weave("twill", ratio="3/1").longest_floats().warp_front, 3)
        with self.assertRaisesRegex(ValueError, "plain"):
            wl.weave("cloak")
        with self.assertRaisesRegex(TypeError, "ratio"):
            wl.weave("twill", shafts=4)
        with self.assertRaises(ValueError):
            wl.weave("twill", ratio="3/x")
        with self.assertRaises(ValueError):
            wl.weave("plain", (0, 4))
        for kind in wl.weaves():
            for p in kind.parameters:
                if p.kind != "text":
                    with self.assertRaises(ValueError, msg=(kind.id, p.id)):
                        wl.weave(kind.id, **{p.id: p.high + 1 if p.kind == "count" else "no such choice"})


class Analysis(unittest.TestCase):
    def test_twill(self):
        d = twill().with_size(picks=8)  # two empty picks
        self.assertEqual(d.loom_use().heddles.tolist(), [2, 2, 2, 2])
        self.assertEqual(d.loom_use().empty_picks, 2)
        d = wl.weave("twill", (16, 16))
        floats = d.longest_floats()
        self.assertEqual((floats.warp_front, floats.weft_back), (2, 2))
        self.assertAlmostEqual(d.interlacing().warp, 0.5)
        self.assertEqual(len(d.layers()), 1)
        count, listed = d.long_floats(1, most=5)
        self.assertEqual((len(listed), listed[0].length, listed[0].system), (5, 2, "warp"))
        self.assertGreater(count, 5)
        self.assertEqual(wl.compare(d, d).differences, ())
        self.assertTrue(wl.compare(d, d.replace(title="other")).same_cloth)

    def test_yarn(self):
        d = wl.weave("plain", (100, 100))
        plan = wl.ClothPlan(length_mm=2000, width_mm=500, reed=wl.Reed(dents=40), sleying=[2],
                            purchases=[wl.YarnPurchase(yarn=y.name, price=20) for y in d.yarns[:1]])
        planned = d.replace(plan=plan)
        self.assertEqual(planned.measures().loom_ends_per_cm, 8)
        self.assertAlmostEqual(planned.measures().length_mm, 2000, delta=5)
        report = planned.yarn_report()
        self.assertAlmostEqual(sum(n.weight_g for n in report.needs), report.weight_g, places=6)
        self.assertAlmostEqual(report.cost, report.weight_g * 0.02, places=6)
        self.assertIsNone(d.yarn_report().cost)
        self.assertGreater(d.handle().kg_per_m2, 0)
        self.assertGreater(d.firm_sett_per_cm(20), 5)
        for wrong in ({"spare": 2}, {"length_mm": -1}, {"width_mm": float("nan")}, {"sleying": [0]}):
            with self.assertRaises(ValueError):
                wl.ClothPlan(**wrong)

    def test_layers_of_a_double_cloth(self):
        self.assertEqual(len(wl.weave("double", (16, 16)).layers()), 2)
