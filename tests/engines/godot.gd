# Lights a set for Godot flat, by one directional light, and tells the page the mean radiance of each view of query.json.
extends Node

const DISTANCE := 3.0  # of the camera, in metres: its rays are within 1.2 degrees of parallel
const MEAN := 0.2      # of the picture, so that highlights to five times that fit

var textures: Array[Texture2D] = []


func _ready() -> void:
	var query: Dictionary = JSON.parse_string(FileAccess.get_file_as_string("res://query.json"))
	import_images(query.images)
	var material: Material = load("res://set/" + query.material)
	if query.has("picture"):
		await picture(query.picture, material)
	elif query.has("layers"):
		await layers(query.layers)
	else:
		await measure(query, material)


func measure(query: Dictionary, material: Material) -> void:
	var results: Array = []
	var stage := new_stage()
	stage.transparent_bg = true
	var cloth := MeshInstance3D.new()
	cloth.mesh = square(2.0)
	cloth.material_override = material
	var light := DirectionalLight3D.new()
	var camera := Camera3D.new()
	camera.keep_aspect = Camera3D.KEEP_WIDTH
	camera.fov = rad_to_deg(2.0 * atan(0.5 * query.window_m / DISTANCE))
	camera.environment = Environment.new()
	camera.environment.background_mode = Environment.BG_COLOR
	camera.environment.background_color = Color(0, 0, 0)
	camera.environment.ambient_light_source = Environment.AMBIENT_SOURCE_DISABLED
	camera.environment.reflected_light_source = Environment.REFLECTION_SOURCE_DISABLED
	for node in [cloth, light, camera]:
		stage.add_child(node)
	for pair in query.pairs:
		var view := vector(pair.view)
		stage.size = Vector2i(pair.pixels, maxi(4, roundi(pair.pixels * absf(view.z))))
		camera.look_at_from_position(DISTANCE * view, Vector3.ZERO, upwards(view))
		light.look_at_from_position(vector(pair.light), Vector3.ZERO, upwards(vector(pair.light)))
		light.light_energy = MEAN / (PI * pair.expected)  # an energy of one is an irradiance of pi
		results.append(mean_radiance(await shown(stage), PI * light.light_energy))
	tell(results)


# The coverage of cloth.glb seen from above, of one layer and of two, one over the other as in a fold.
func layers(wanted: Dictionary) -> void:
	var stage := new_stage()
	stage.transparent_bg = true
	stage.size = Vector2i(wanted.pixels, wanted.pixels)
	var camera := Camera3D.new()
	camera.projection = Camera3D.PROJECTION_ORTHOGONAL
	camera.size = wanted.window_m
	stage.add_child(camera)
	var results: Array = []
	for layer in 2:
		var state := GLTFState.new()
		var document := GLTFDocument.new()
		document.append_from_buffer(FileAccess.get_file_as_bytes("res://cloth.glb"), "", state)
		var scene: Node3D = document.generate_scene(state)
		stage.add_child(scene)
		var mesh: MeshInstance3D = scene.find_children("*", "MeshInstance3D", true, false)[0]
		var bounds := mesh.global_transform * mesh.get_aabb()
		var up := Vector3.ZERO
		up[bounds.size.min_axis_index()] = 1.0
		var middle := bounds.get_center()
		if layer == 0:
			camera.look_at_from_position(middle + up, middle, Vector3.RIGHT)
		else:
			scene.position += wanted.gap_m * up + wanted.aside_m * Vector3.RIGHT  # so that gaps do not lie over gaps
		results.append(mean_radiance(await shown(stage), 1.0)[3])
	tell(results)


# Of cloth.glb with the camera of the editor, under one light and an even sky, as PNG (docs/make_engines.sh).
func picture(wanted: Dictionary, material: Material) -> void:
	var stage := new_stage()
	stage.size = Vector2i(2 * wanted.width, 2 * wanted.height)
	var document := GLTFDocument.new()
	var state := GLTFState.new()
	document.append_from_buffer(FileAccess.get_file_as_bytes("res://cloth.glb"), "", state)
	var scene := document.generate_scene(state)
	stage.add_child(scene)
	for mesh in scene.find_children("*", "MeshInstance3D", true, false):
		for surface in mesh.mesh.get_surface_count():  # the material has both sides: nothing is left of the back
			var back: bool = mesh.mesh.surface_get_material(surface).resource_name.ends_with("_back")
			mesh.set_surface_override_material(surface, hidden() if back else material)
	var light := DirectionalLight3D.new()
	light.light_energy = wanted.irradiance / PI
	light.shadow_enabled = false  # this renderer adds lights with shadows as encoded values
	var camera := Camera3D.new()
	camera.fov = wanted.fov
	camera.near = 0.05
	camera.environment = Environment.new()
	camera.environment.background_mode = Environment.BG_COLOR
	camera.environment.background_color = Color.from_hsv(0, 0, wanted.sky).linear_to_srgb()
	camera.environment.sky = even_sky(wanted.sky)
	camera.environment.ambient_light_source = Environment.AMBIENT_SOURCE_SKY
	camera.environment.reflected_light_source = Environment.REFLECTION_SOURCE_SKY
	stage.add_child(light)
	stage.add_child(camera)
	light.look_at_from_position(vector(wanted.towards), Vector3.ZERO)
	camera.look_at_from_position(vector(wanted.eye), vector(wanted.target))
	var image: Image = await shown(stage)
	image.resize(wanted.width, wanted.height, Image.INTERPOLATE_BILINEAR)
	for y in wanted.height:
		for x in wanted.width:
			image.set_pixel(x, y, toned(image.get_pixel(x, y).srgb_to_linear()).linear_to_srgb())
	tell({"png": Marshalls.raw_to_base64(image.save_png_to_buffer())})


# The tone curve of the other programs' pictures, Khronos' neutral one, which Godot does not have.
func toned(color: Color) -> Color:
	var least := minf(color.r, minf(color.g, color.b))
	var lower := least - 6.25 * least * least if least < 0.08 else 0.04
	color = Color(color.r - lower, color.g - lower, color.b - lower)
	var peak := maxf(color.r, maxf(color.g, color.b))
	if peak < 0.76:
		return color
	var lowered := 1.0 - 0.24 * 0.24 / (peak + 0.24 - 0.76)
	var white := 1.0 - 1.0 / (0.15 * (peak - lowered) + 1.0)
	return (color * (lowered / peak)).lerp(Color(lowered, lowered, lowered), white)


func vector(numbers: Array) -> Vector3:
	return Vector3(numbers[0], numbers[1], numbers[2])


func upwards(direction: Vector3) -> Vector3:
	return Vector3.UP if absf(direction.z) > 0.99 else Vector3.BACK


func new_stage() -> SubViewport:
	var stage := SubViewport.new()
	stage.own_world_3d = true
	stage.msaa_3d = Viewport.MSAA_4X
	stage.anisotropic_filtering_level = Viewport.ANISOTROPY_16X
	stage.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	add_child(stage)
	return stage


func even_sky(radiance: float) -> Sky:
	var sky := Sky.new()
	var shader := Shader.new()
	var encoded := Color(radiance, radiance, radiance).linear_to_srgb().r  # this renderer decodes it
	shader.code = "shader_type sky;\nvoid sky() { COLOR = vec3(%f); }\n" % encoded
	sky.sky_material = ShaderMaterial.new()
	sky.sky_material.shader = shader
	return sky


func hidden() -> Material:
	var shader := Shader.new()
	shader.code = "shader_type spatial;\nrender_mode shadows_disabled;\nvoid vertex() { POSITION = vec4(2.0, 2.0, 2.0, 1.0); }\n"
	var material := ShaderMaterial.new()
	material.shader = shader
	return material


func shown(stage: SubViewport) -> Image:
	for frame in 3:
		await RenderingServer.frame_post_draw
	return stage.get_texture().get_image()


func tell(result: Variant) -> void:
	JavaScriptBridge.eval("told(%s)" % JSON.stringify(JSON.stringify(result)))


# What the editor's importer does with an image: mipmaps, those of normals of unit length.
func import_images(names: Array) -> void:
	for file in names:
		var image := Image.new()
		image.load_png_from_buffer(FileAccess.get_file_as_bytes("res://set/" + file))
		image.generate_mipmaps("_normal" in file)
		var texture := ImageTexture.create_from_image(image)
		texture.take_over_path("res://set/" + file)
		textures.append(texture)


# Faces +z, with texture coordinates in millimetres: right, and down.
func square(side: float) -> ArrayMesh:
	var tool := SurfaceTool.new()
	tool.begin(Mesh.PRIMITIVE_TRIANGLES)
	for corner in [[-1, 1], [1, 1], [-1, -1], [1, 1], [1, -1], [-1, -1]]:
		var at := Vector2(corner[0], corner[1]) * 0.5 * side
		tool.set_normal(Vector3.BACK)
		tool.set_tangent(Plane(1, 0, 0, 1))
		tool.set_uv(1000.0 * Vector2(at.x, -at.y))
		tool.add_vertex(Vector3(at.x, at.y, 0))
	return tool.commit()


# Of the covered part for unit irradiance, and the coverage. Blending was of encoded values, over black.
func mean_radiance(image: Image, irradiance: float) -> Array:
	image.convert(Image.FORMAT_RGBA8)
	var data := image.get_data()
	var sum := [0.0, 0.0, 0.0, 0.0]
	for pixel in data.size() / 4:
		var alpha := data[4 * pixel + 3] / 255.0
		if alpha == 0.0:
			continue
		for channel in 3:
			var shown := data[4 * pixel + channel] / 255.0 / alpha
			sum[channel] += alpha * pow((shown + 0.055) / 1.055, 2.4) if shown > 0.04045 else alpha * shown / 12.92
		sum[3] += alpha
	var covered := maxf(sum[3], 1e-6)
	return [sum[0] / covered / irradiance, sum[1] / covered / irradiance, sum[2] / covered / irradiance, sum[3] / (data.size() / 4)]
