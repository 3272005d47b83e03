"""Maps, response, pictures and texture sets as arrays and files."""

import json
import pathlib
import tempfile
import unittest

import numpy as np

import weftlight as wl
from common import renderer, twill


class Maps(unittest.TestCase):
    def test_shapes_and_types(self):
        maps = wl.weave("twill", (16, 16)).maps((48, 32), azimuths=4)
        shapes = {"height_mm": (32, 48), "coverage": (32, 48), "color": (32, 48, 3), "groove": (32, 48),
                  "slope": (32, 48, 2), "normal": (32, 48, 3), "tangent": (32, 48, 3), "system": (32, 48),
                  "thread": (32, 48), "occlusion": (32, 48), "horizon": (4, 32, 48)}
        for name, shape in shapes.items():
            self.assertEqual(getattr(maps, name).shape, shape, name)
        self.assertEqual((maps.height_mm.dtype, maps.thread.dtype, maps.system.dtype), ("float32", "uint32", "uint8"))
        self.assertGreater(maps.width_mm, 0)

    def test_the_thread_on_top_is_that_of_the_drawdown(self):
        design = twill().with_size(picks=8)
        design = design.replace(treadling=np.tile(np.eye(4), (2, 1)))
        maps = design.maps((8 * 32, 8 * 32), period="draft")
        system, thread = maps.system[16::32, 16::32], maps.thread[16::32, 16::32]
        np.testing.assert_array_equal(system == 0, design.drawdown())
        picks, ends = np.indices((8, 8))
        np.testing.assert_array_equal(thread, np.where(system == 0, ends, picks))

    def test_directions_are_units(self):
        maps = twill().maps((64, 64))
        for directions in (maps.normal, maps.tangent):
            np.testing.assert_allclose(np.linalg.norm(directions, axis=2), 1, atol=1e-4)
        self.assertGreater(maps.normal[..., 2].min(), 0)

    def test_views_cannot_be_written_and_outlive_their_maps(self):
        maps = twill().maps((64, 64))
        height, mean = maps.height_mm, float(maps.height_mm.mean())
        with self.assertRaises(ValueError):
            height[0, 0] = 1
        del maps
        self.assertEqual(float(height.mean()), mean)

    def test_sizes(self):
        for arguments in ({"size": (0, 4)}, {"size": (4, 20000)}, {"azimuths": 65}, {"period": "year"}):
            with self.assertRaises(ValueError):
                twill().maps(**arguments)


class Response(unittest.TestCase):
    def test_a_white_cloth_is_nearly_lambertian(self):
        white = wl.weave("plain", (8, 8)).replace(palette=[(1, 1, 1)] * 2)
        response = white.response([0], [0, 60, 120])
        self.assertEqual(response.shape, (1, 3, 3))
        self.assertTrue(0.4 / np.pi < response[0, 0].mean() < 1.1 / np.pi, response)
        self.assertTrue(0 < response[0, 1].mean() < response[0, 0].mean())

    def test_the_method_is_near_the_truth(self):
        cloth = wl.weave("twill", (8, 8))
        method = cloth.response([0, 40], [20], plane="weft")
        truth = cloth.response([0, 40], [20], plane="weft", reference=True, spp=32)
        np.testing.assert_allclose(method.mean(), truth.mean(), rtol=0.3)

    def test_angles(self):
        for views, lights in (([90], [0]), ([0], [200]), ([float("nan")], [0])):
            with self.assertRaises(ValueError):
                twill().response(views, lights)


class Reference(unittest.TestCase):
    def test_a_plane_seen_head_on_is_covered(self):
        design = wl.weave("plain", (16, 16))
        design = design.replace(scene=wl.view(design, "head_on", 48, 48))
        picture = wl.reference(design, 48, 48, spp=4)
        self.assertEqual((picture.shape, picture.dtype), ((48, 48, 4), "float32"))
        self.assertGreater(picture[16:32, 16:32, 3].mean(), 0.8)
        self.assertGreater(picture[16:32, 16:32, :3].mean(), 0)

    def test_a_mesh_that_is_not_there(self):
        with self.assertRaises(wl.Error) as caught:
            wl.reference(twill().replace(scene=wl.Scene(mesh="/no/where.glb")), 8, 8)
        self.assertIn("/no/where.glb", str(caught.exception))

    def test_views(self):
        with self.assertRaisesRegex(ValueError, "Head on"):
            wl.view(twill(), "from the moon")


class Render(unittest.TestCase):
    def test_pictures(self):
        draw = renderer(self)
        red = wl.weave("plain", (16, 16)).replace(palette=[(0.8, 0.1, 0.1)] * 2)
        red = red.replace(scene=wl.view(red, "head_on", 96, 64))
        picture = draw.render(red, 96, 64)
        self.assertEqual((picture.shape, picture.dtype), ((64, 96, 3), "uint8"))
        r, g, b = picture[24:40, 36:60].mean(axis=(0, 1))
        self.assertGreater(r, 1.5 * max(g, b))
        np.testing.assert_array_equal(picture, draw.render(red, 96, 64))
        blue = draw.render(red.replace(palette=[(0.1, 0.1, 0.8)] * 2), 96, 64)
        self.assertGreater(blue[24:40, 36:60, 2].mean(), blue[24:40, 36:60, 0].mean())

    def test_forms(self):
        draw = renderer(self)
        design = wl.weave("twill", (16, 16))
        linear = draw.render(design, 40, 30, linear=True)
        self.assertEqual((linear.shape, linear.dtype), ((30, 40, 3), "float32"))
        clear = draw.render(design, 40, 30, transparent=True)
        self.assertEqual(clear.shape, (30, 40, 4))
        self.assertEqual(clear[0, 0, 3], 0)
        self.assertTrue(draw.device)

    def test_progress(self):
        draw = renderer(self)
        with self.assertRaises(wl.Cancelled):
            draw.render(wl.weave("overshot", (400, 400)), 40, 30, progress=lambda *_: False)
        told = []
        draw.render(wl.weave("overshot", (400, 400)), 40, 30, progress=lambda share, _: told.append(share))
        self.assertEqual(told[-1], 1)

    def test_sizes(self):
        for size in ((0, 8), (8, 20000)):
            with self.assertRaises(ValueError):
                wl.render(twill(), *size)


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_images(self):
        cells = twill().drawdown()
        wl.write_image(self.folder / "cells.png", cells)
        again = wl.read(self.folder / "cells.png").design  # black is the warp
        self.assertEqual((again.ends, again.picks), (8, 6))
        self.assertEqual(int(again.drawdown().sum()), 24)
        for name, depth in (("a.png", "16"), ("a.exr", "half"), ("b.exr", "float"), ("a.jpg", "8"), ("a.tif", "8")):
            wl.write_image(self.folder / name, twill().colors(), depth)
            self.assertGreater((self.folder / name).stat().st_size, 0)
        for pixels in (np.zeros((2, 2, 5)), np.zeros(4), np.zeros((0, 4))):
            with self.assertRaises(ValueError):
                wl.write_image(self.folder / "x.png", pixels)
        with self.assertRaises(wl.Error):
            wl.write_image(self.folder / "no" / "x.png", cells)

    def test_a_texture_set(self):
        for target in ("gltf", "raw"):
            wl.export(wl.weave("twill", (16, 16)), self.folder / target, target, size=64)
            facts = json.loads((self.folder / target / "texture_set.json").read_text())
            self.assertTrue(facts)
        wl.export(twill(), self.folder / "far", size=256, name="far", lod=2)
        self.assertEqual(json.loads((self.folder / "far" / "texture_set.json").read_text())["name"], "far-lod2")
        with self.assertRaises(wl.Error) as caught:
            wl.export(twill(), "/proc/nowhere/set", size=64)
        self.assertEqual(caught.exception.kind, "output")
        for wrong in ({"target": "abacus"}, {"size": 100}, {"alpha": "maybe"}, {"mips": "gif"}, {"tile_mm": -1}, {"lod": 3}):
            with self.assertRaises(ValueError):
                wl.export(twill(), self.folder / "x", **wrong)
