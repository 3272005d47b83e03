"""unreal.py WEFTLIGHT DRAFT...: runs the import script of a set against a mock of Unreal's module, which only records
calls. Runs it twice, since artists export again. Not a test of Unreal."""
import json
import os
import runpy
import subprocess
import sys
import tempfile
from unittest.mock import MagicMock


class Editor:
    """Content that is kept between the two runs."""

    def __init__(self):
        self.assets, self.imported, self.flags, self.slots = {}, [], {}, set()

    def asset(self, path):
        if path not in self.assets:
            made = MagicMock(name=path)
            made.set_editor_property.side_effect = lambda key, value: self.flags.__setitem__((path, key), value)
            self.assets[path] = made
        return self.assets[path]

    def create(self, name, into, *_):
        path = into + "/" + name
        assert path not in self.assets, path + " exists already: Unreal would return None"
        return self.asset(path)

    def take(self, tasks):
        for task in tasks:
            assert os.path.isfile(task.filename), task.filename
            self.imported.append(os.path.basename(task.filename))
            self.asset(task.destination_path + "/" + os.path.splitext(os.path.basename(task.filename))[0])

    def module(self):
        unreal = MagicMock(name="unreal")
        tools = unreal.AssetToolsHelpers.get_asset_tools.return_value
        tools.create_asset.side_effect = self.create
        tools.import_asset_tasks.side_effect = self.take
        unreal.AssetImportTask.side_effect = lambda: MagicMock()
        unreal.load_asset.side_effect = lambda path: self.assets[path]
        unreal.EditorAssetLibrary.does_asset_exist.side_effect = lambda path: path in self.assets
        for name in ("BASE_COLOR", "NORMAL", "AMBIENT_OCCLUSION", "ROUGHNESS", "METALLIC", "OPACITY", "OPACITY_MASK",
                     "SUBSURFACE_COLOR", "CUSTOM_DATA0", "SPECULAR"):
            setattr(unreal.MaterialProperty, "MP_" + name, name)
        unreal.MaterialEditingLibrary.connect_material_property.side_effect = lambda *of: self.slots.add(of[2])
        return unreal


def check(weftlight, draft, folder):
    name = os.path.splitext(os.path.basename(draft))[0]
    subprocess.run([weftlight, "export", draft, "--target", "unreal", "--size", "32", "--masks", "-o", folder], check=True, stdout=subprocess.DEVNULL)
    place = os.path.join(folder, name)
    with open(os.path.join(place, "texture_set.json")) as file:
        listed = json.load(file)
    editor = Editor()
    for _ in range(2):
        sys.modules["unreal"] = editor.module()
        runpy.run_path(os.path.join(place, name + "_import.py"), run_name="__main__")
    for image in listed["maps"]:
        closed = listed["alpha"] == "opaque" and image["file"].endswith("_OM.png")
        assert closed or image["file"] in editor.imported, image["file"] + " is not imported"
        if not closed:
            path = "/Game/Weftlight/" + name + "/" + image["file"][:-4]
            assert editor.flags[path, "srgb"] == (image["color_space"] == "sRGB"), path
    wanted = {"BASE_COLOR", "NORMAL", "AMBIENT_OCCLUSION", "ROUGHNESS", "METALLIC", "SUBSURFACE_COLOR", "CUSTOM_DATA0", "SPECULAR"}
    wanted |= set() if listed["alpha"] == "opaque" else {"OPACITY_MASK"}
    assert editor.slots == wanted, editor.slots ^ wanted


for each in sys.argv[2:]:
    with tempfile.TemporaryDirectory() as scratch:
        check(sys.argv[1], each, scratch)
