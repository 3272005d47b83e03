"""python3 blender_script.py WEFTLIGHT DRAFT...: exports each draft for Cycles and EEVEE and runs the scripts of the sets without
Blender, against a stand-in for its modules, as version 3.4 and 4.2. Exits with 1 if a script fails, loads an image that the set
does not have, links nothing to the output, or is silent where the scene has the other renderer."""
import contextlib
import io
import os
import subprocess
import sys
import tempfile
from unittest import mock

# How many a script makes for both faces: nine highlights a face in EEVEE.
SHADERS = {"blender": {"ShaderNodeBsdfPrincipled": 2}, "eevee": {"ShaderNodeBsdfDiffuse": 2, "ShaderNodeBsdfGlossy|ShaderNodeBsdfAnisotropic": 18}}


def stand_in(version, engine, loaded, made, linked):
    bpy = mock.MagicMock()
    bpy.app.version = version
    bpy.context.scene.render.engine = engine
    bpy.data.texts, bpy.context.selected_objects = [], []
    bpy.types = mock.Mock(spec=["ShaderNodeBsdfAnisotropic"] if version >= (4, 0, 0) else ["ShaderNodeBsdfGlossy"])
    bpy.data.images.load.side_effect = lambda path: loaded.append(path) or mock.MagicMock()
    tree = bpy.data.materials.new.return_value.node_tree
    output = mock.MagicMock()
    tree.nodes.__getitem__.side_effect = lambda name: output
    tree.nodes.new.side_effect = lambda kind: made.append(kind) or mock.MagicMock()
    surface = output.inputs["Surface"]
    tree.links.new.side_effect = lambda start, end: linked.append(end is surface)
    return bpy


def problems_of(script, target, version, engine):
    loaded, made, linked, said = [], [], [], io.StringIO()
    modules = {"bpy": stand_in(version, engine, loaded, made, linked), "bmesh": mock.MagicMock()}
    with mock.patch.dict(sys.modules, modules), contextlib.redirect_stdout(said):
        exec(compile(open(script).read(), script, "exec"), {"__name__": "__main__", "__file__": script})
    missing = [path for path in loaded if not os.path.isfile(path)]
    yield from (f"has no {path}" for path in missing)
    if not loaded:
        yield "loads no image"
    if sum(linked) != 1:
        yield f"links {sum(linked)} shaders to the output"
    for kinds, wanted in SHADERS[target].items():
        count = sum(made.count(kind) for kind in kinds.split("|"))
        if count != wanted:
            yield f"makes {count} of {kinds}, not {wanted}"
    if ("EEVEE" in engine) == (target == "eevee") and said.getvalue():
        yield f"says {said.getvalue()!r} to its own renderer"
    if ("EEVEE" in engine) != (target == "eevee") and not said.getvalue():
        yield "does not say which set is for the renderer of the scene"


def main(weftlight, *drafts):
    wrong = 0
    for draft in drafts:
        name = os.path.splitext(os.path.basename(draft))[0]
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([weftlight, "export", draft, "--target", "blender,eevee", "--name", "{target}", "--mesh", "plane", "--size", "64", "-o", folder], check=True, stdout=subprocess.DEVNULL)
            for target in SHADERS:
                script = os.path.join(folder, target, name + ".py")
                for version in (3, 4, 1), (4, 2, 0):
                    for engine in "CYCLES", "BLENDER_EEVEE":
                        for problem in problems_of(script, target, version, engine):
                            print(f"{name} for {target}, Blender {version} with {engine}: the script {problem}")
                            wrong += 1
    return 1 if wrong else 0


sys.exit(main(*sys.argv[1:]))
