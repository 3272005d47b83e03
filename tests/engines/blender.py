"""blender -b -P blender.py -- QUERY: renders the mesh of a set, flat, under one sun, and writes the mean radiance for each pair
of directions (RGBA). QUERY (.json): glb, script ("" for the material of the importer), engine (CYCLES or BLENDER_EEVEE, which
needs a display), window_m, pixels (a pair may have its own), samples, pairs, out; or picture instead of pairs, and out (.png)."""
import json
import os
import sys

import bpy
import numpy
from mathutils import Matrix, Vector

numpy.bool = bool  # the importer of 3.4 uses it, but numpy 1.24 has removed it
query = json.load(open(sys.argv[sys.argv.index("--") + 1]))
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=query["glb"])
cloth = [thing for thing in bpy.context.scene.objects if thing.type == "MESH"]
if query["script"]:
    for thing in cloth:
        thing.select_set(True)
    bpy.context.scene.render.engine = query.get("engine", "CYCLES")
    text = bpy.data.texts.load(query["script"])  # like the Scripting tab, with a file name that does not exist
    shown = os.path.join(bpy.data.filepath or "untitled.blend", text.name)
    exec(compile(text.as_string(), shown, "exec"), {"__name__": "__main__", "__file__": shown})
scene = bpy.context.scene
scene.render.engine = query.get("engine", "CYCLES")
scene.eevee.taa_render_samples = query["samples"]
scene.cycles.samples = query["samples"]
scene.cycles.use_denoising = False
scene.cycles.max_bounces = 0
scene.cycles.transparent_max_bounces = 64
scene.cycles.pixel_filter_type = "BOX"
scene.view_settings.view_transform = "Raw"
scene.render.film_transparent = True
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.image_settings.color_depth = "32"
scene.render.resolution_percentage = 100
scene.world = None
corners = [thing.matrix_world @ Vector(corner) for thing in cloth for corner in thing.bound_box]
middle = sum(corners, Vector()) / len(corners)
sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
sun.data.energy, sun.data.angle = 1, 0
sun.data.use_shadow = scene.render.engine == "CYCLES"  # maps of shadows darken flat cloth at a slant
eye = bpy.data.objects.new("eye", bpy.data.cameras.new("eye"))
eye.data.type, eye.data.clip_start, eye.data.clip_end = "ORTHO", 0.001, 10
scene.collection.objects.link(sun)
scene.collection.objects.link(eye)
scene.camera = eye


def of_gltf(v):
    """Frame of the cloth (x right, y up, z out of its front) in Blender's axes."""
    return Vector((v[0], -v[2], v[1]))


def look_along(thing, towards, up):
    """Points -z away from `towards`, and y as close to `up` as possible."""
    z = towards.normalized()
    x = up.cross(z).normalized()
    thing.matrix_world = Matrix.Translation(middle + z) @ Matrix((x, z.cross(x), z)).transposed().to_4x4()


def mean_of(pair):
    view = pair["view"]
    up = of_gltf((0, 1, 0)) if abs(view[2]) > 0.99 else of_gltf((0, 0, 1))
    look_along(sun, of_gltf(pair["light"]), Vector((0.3, 0.2, 0.9)))
    look_along(eye, of_gltf(view), up)
    wide = pair.get("pixels", query["pixels"])
    tall = max(4, round(wide * abs(view[2])))
    eye.data.ortho_scale = query["window_m"]  # of the longer side
    scene.render.resolution_x, scene.render.resolution_y = wide, tall
    path = query["out"] + ".exr"
    scene.render.filepath = path
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(path, check_existing=False)
    pixels = numpy.array(image.pixels[:]).reshape(-1, 4)
    bpy.data.images.remove(image)
    os.remove(path)
    return [float(x) for x in pixels.mean(axis=0)]


def tone(c):
    """Khronos PBR Neutral and sRGB, the tone mapping of the editor."""
    least = c.min(axis=1, keepdims=True)
    c = c - numpy.where(least < 0.08, least - 6.25 * least * least, 0.04)
    peak = numpy.maximum(c.max(axis=1, keepdims=True), 1e-6)
    start, rest = 0.76, 0.24
    lower = 1 - rest * rest / (peak + rest - start)
    share = 1 - 1 / (0.15 * (peak - lower) + 1)
    c = numpy.where(peak < start, c, c * lower / peak * (1 - share) + lower * share)
    return numpy.clip(numpy.where(c <= 0.0031308, 12.92 * c, 1.055 * numpy.maximum(c, 0) ** (1 / 2.4) - 0.055), 0, 1)


def picture(of):
    """Renders a .png with the camera of the editor under one distant light and a uniform sky."""
    world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs["Color"].default_value = (of["sky"], of["sky"], of["sky"], 1)
    scene.world = world
    scene.render.film_transparent = False
    scene.cycles.max_bounces = 1
    sun.data.use_shadow = scene.eevee.use_gtao = True
    scene.eevee.gtao_distance = 0.5  # metres
    look_along(sun, of_gltf(of["towards"]), Vector((0.3, 0.2, 0.9)))
    sun.data.energy = of["irradiance"]
    where, back = of_gltf(of["eye"]), of_gltf(of["eye"]) - of_gltf(of["target"])
    look_along(eye, back, of_gltf(of["up"]))
    eye.matrix_world.translation = where
    eye.data.type, eye.data.sensor_fit, eye.data.angle_y = "PERSP", "VERTICAL", numpy.radians(of["fov"])
    scene.render.resolution_x, scene.render.resolution_y = of["width"], of["height"]
    scene.render.filepath = query["out"] + ".exr"
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(scene.render.filepath)
    pixels = numpy.array(image.pixels[:]).reshape(-1, 4)
    pixels[:, :3], pixels[:, 3] = tone(pixels[:, :3]), 1
    shown = bpy.data.images.new("shown", of["width"], of["height"])
    shown.colorspace_settings.name = "Non-Color"
    shown.pixels = pixels.ravel()
    shown.filepath_raw, shown.file_format = query["out"], "PNG"
    shown.save()


if "picture" in query:
    picture(query["picture"])
    sys.exit()
with open(query["out"], "w") as file:
    json.dump([mean_of(pair) for pair in query["pairs"]], file)
