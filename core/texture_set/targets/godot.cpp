// Godot 4: one ShaderMaterial for both faces and its shader, which lights cloth as it was fitted.
// Based on: Godot's manual of spatial shaders.

#include <cmath>

#include "base/mark.h"
#include "base/whole_files.h"
#include "texture_set/material_files.h"
#include "texture_set/targets.h"

namespace weftlight::texture_set {

using base::write_file_atomically;
using draft::Face;
using files::MipFormat;

namespace {

using enum Channel;
using enum PixelType;

constexpr ImageRow kImages[] = {
    {"", "_albedo", ".png", kU8, true, kBaseCoverage},
    {"", "_orm", ".png", kU8, false, {kOcclusion, kRoughnessNarrow, kMetal, kNone}},
    {"", "_normal", ".png", kU8, false, kNormalUp},
    {"", "_flowmap", ".png", kU8, false, {kWideX, kWideY, kGltfAnisotropy, kNone}},
};

// Godot's own materials have one colour for all views and no reflectance at grazing angles.
constexpr const char* kShader =
    R"(// The cloth {NAME}, front and back. Its numbers are fitted to the cloth and stand in {NAME}.tres.
shader_type spatial;
render_mode cull_disabled{BLENDED};

uniform vec2 uv_scale = vec2(1.0);  // repeats in a unit of UV
uniform vec2 uv_offset = vec2(0.0);
uniform float transmitted : hint_range(0.0, 1.0) = 0.0;  // of a light behind the cloth, as a fraction of diffuse light

group_uniforms front;
{FRONT}
group_uniforms back;
{BACK}
// The cloth at this pixel, for light().
varying vec3 along_weft;
varying vec3 outwards;
varying vec3 wide_axis;  // of the highlight
varying vec2 alpha_of_axes;
varying vec3 normal_reflectance;
varying float grazing_reflectance;
varying vec3 tint_weft;
varying vec3 tint_warp;
varying vec3 late_tint_weft;
varying vec3 late_tint_warp;
varying vec2 shine_growth;

// Slant of a direction to the viewer or to a light along weft and warp; together 1 - cosine, which is z.
vec3 slant(vec3 towards) {
	float x = dot(towards, along_weft);
	float z = clamp(dot(towards, outwards), 0.0, 1.0);
	return vec3(vec2(x * x, max(1.0 - z * z - x * x, 0.0)) / (1.0 + z), 1.0 - z);
}

// Factor of the colour for a slant: along one system of threads, more is seen and lit of the other.
vec3 tint(vec3 s) {
	return exp((tint_weft + late_tint_weft * s.z) * s.x + (tint_warp + late_tint_warp * s.z) * s.y);
}

// The Compatibility renderer has encoded colours here, and decodes ALBEDO afterwards.
vec3 decoded(vec3 color) {
	return mix(pow((color + 0.055) / 1.055, vec3(2.4)), color / 12.92, lessThanEqual(color, vec3(0.04045)));
}

vec3 encoded(vec3 color) {
	return mix(1.055 * pow(color, vec3(1.0 / 2.4)) - 0.055, 12.92 * color, lessThanEqual(color, vec3(0.0031308)));
}

{HASH}void fragment() {
	vec2 at = UV * uv_scale + uv_offset;
	vec4 albedo;
	vec3 orm;
	vec3 slope;
	vec3 flow;
	if (FRONT_FACING) {
{FETCH_FRONT}	} else {
{FETCH_BACK}	}
	along_weft = normalize(TANGENT - dot(TANGENT, NORMAL) * NORMAL);
	outwards = NORMAL;
	vec3 up = normalize(BINORMAL);
	slope = slope * 2.0 - 1.0;
	slope.z = sqrt(max(1.0 - dot(slope.xy, slope.xy), 0.0));
	vec3 normal = normalize(along_weft * slope.x + up * slope.y + outwards * slope.z);
	vec2 axis = flow.xy * 2.0 - 1.0;
	wide_axis = along_weft * axis.x + up * axis.y + outwards * 1e-4;
	wide_axis = normalize(wide_axis - dot(wide_axis, normal) * normal);
	float narrow = max(orm.g * orm.g, 0.002);
	alpha_of_axes = vec2(mix(narrow, 1.0, flow.b * flow.b), narrow);

	NORMAL = normal;
	vec3 seen = tint(slant(VIEW));
	ALBEDO = OUTPUT_IS_SRGB ? encoded(min(decoded(albedo.rgb) * seen, vec3(1.0))) : min(albedo.rgb * seen, vec3(1.0));
	AO = orm.r;
	ROUGHNESS = sqrt(sqrt(alpha_of_axes.x * alpha_of_axes.y));
	METALLIC = orm.b;
	SPECULAR = sqrt(min(normal_reflectance.g / 0.16, 1.0));
	ANISOTROPY = min((1.0 - alpha_of_axes.y / alpha_of_axes.x) / 0.9, 1.0);
	ANISOTROPY_FLOW = axis;
{COVERAGE}}

void light() {
	float nl = dot(NORMAL, LIGHT);
	float behind = max(-dot(outwards, LIGHT), 0.0);
	vec3 arriving = LIGHT_COLOR * ATTENUATION / PI;
	DIFFUSE_LIGHT += arriving * transmitted * behind;
	if (nl > 0.0) {
		float nv = clamp(dot(NORMAL, VIEW), 1e-3, 1.0);
		vec3 middle = normalize(LIGHT + VIEW);
		vec3 narrow_axis = cross(NORMAL, wide_axis);
		vec2 wide_narrow = alpha_of_axes;
		vec3 h = vec3(dot(middle, wide_axis), dot(middle, narrow_axis), dot(middle, NORMAL));
		vec3 l = vec3(wide_narrow * vec2(dot(LIGHT, wide_axis), dot(LIGHT, narrow_axis)), nl);
		vec3 v = vec3(wide_narrow * vec2(dot(VIEW, wide_axis), dot(VIEW, narrow_axis)), nv);
		// Anisotropic GGX with the masking of heights (Heitz 2014).
		float q = dot(h.xy / wide_narrow, h.xy / wide_narrow) + h.z * h.z;
		float shine = 0.5 / (wide_narrow.x * wide_narrow.y * q * q * max(nl * length(v) + nv * length(l), 1e-6));
		float k = pow(1.0 - clamp(dot(VIEW, middle), 0.0, 1.0), 5.0);
		vec3 lit_slant = slant(LIGHT);
		vec3 lit = tint(lit_slant);
		vec3 seen_slant = slant(VIEW);
		float shone = exp(dot(shine_growth, seen_slant.xy * seen_slant.z + lit_slant.xy * lit_slant.z));
		vec3 reflectance = mix(normal_reflectance, vec3(grazing_reflectance), k) * shone;
		vec3 metal = mix(ALBEDO, vec3(1.0), k) * lit;
		DIFFUSE_LIGHT += arriving * nl * lit * max(1.0 - reflectance, 0.0);
		SPECULAR_LIGHT += arriving * nl * shine * mix(reflectance, metal, METALLIC) * SPECULAR_AMOUNT;
	}
}
)";

// Godot's own hashed transparency is opaque in its Compatibility renderer.
constexpr const char* kHash =
    R"(// 0 to 1, evenly distributed: a pixel is there where more is covered. The pattern stays on the cloth and is as fine as the
// pixels, as in Wyman and McGuire 2017, "Hashed alpha testing". Interleaved gradient noise (Jimenez 2014) has less grain than
// white noise.
float threshold(vec2 at) {
	vec2 right = dFdx(at);
	vec2 down = dFdy(at);
	float pixel = sqrt(max(abs(right.x * down.y - right.y * down.x), 1e-12));
	vec2 cell = floor(at * exp2(round(-log2(pixel))));
	return fract(52.9829189 * fract(dot(cell, vec2(0.06711056, 0.00583715))));
}

)";

constexpr const char* kUniforms =
    R"(uniform sampler2D {SIDE}_albedo : source_color, filter_linear_mipmap_anisotropic, repeat_enable;
uniform sampler2D {SIDE}_orm : filter_linear_mipmap_anisotropic, repeat_enable;
uniform sampler2D {SIDE}_normal : hint_normal, filter_linear_mipmap_anisotropic, repeat_enable;
uniform sampler2D {SIDE}_flowmap : filter_linear_mipmap_anisotropic, repeat_enable;
uniform vec3 {SIDE}_normal_reflectance = vec3(0.04);
uniform float {SIDE}_grazing_reflectance = 1.0;
uniform vec3 {SIDE}_tint_weft = vec3(0.0);  // logarithms, for a flat direction along the weft; by 1 - cosine
uniform vec3 {SIDE}_tint_warp = vec3(0.0);
uniform vec3 {SIDE}_late_tint_weft = vec3(0.0);  // by its square
uniform vec3 {SIDE}_late_tint_warp = vec3(0.0);
uniform vec2 {SIDE}_shine_growth = vec2(0.0);  // of the reflectance, along weft and warp, by that square
)";

constexpr const char* kFetch = R"(		albedo = texture({SIDE}_albedo, at);
		orm = texture({SIDE}_orm, at).rgb;
		slope = texture({SIDE}_normal, at).rgb;
		flow = texture({SIDE}_flowmap, at).rgb;
		normal_reflectance = {SIDE}_normal_reflectance;
		grazing_reflectance = {SIDE}_grazing_reflectance;
		tint_weft = {SIDE}_tint_weft;
		tint_warp = {SIDE}_tint_warp;
		late_tint_weft = {SIDE}_late_tint_weft;
		late_tint_warp = {SIDE}_late_tint_warp;
		shine_growth = {SIDE}_shine_growth;
)";

constexpr const char* kMaterial = R"([gd_resource type="ShaderMaterial" load_steps=10 format=3]

[ext_resource type="Shader" path="{NAME}.gdshader" id="shader"]
{FILES}
[resource]
resource_name = "{NAME}"
shader = ExtResource("shader")
shader_parameter/uv_scale = Vector2({SCALE_U}, {SCALE_V})
shader_parameter/uv_offset = Vector2({OFFSET_U}, {OFFSET_V})
shader_parameter/transmitted = {TRANSMITTED}
{PARAMETERS})";

const char* side_of(Face face) { return face == Face::kFront ? "front" : "back"; }

std::string of_side(const char* text, Face face) { return fill_template(text, {{"SIDE", side_of(face)}}); }

/// What the pixel does with coverage. Blended cloth has a depth pass of its opaque parts (render_mode).
std::string coverage_lines(Alpha alpha) {
  if (alpha == Alpha::kOpaque) return {};
  if (alpha == Alpha::kHashed) return "\tif (albedo.a < threshold(UV)) {\n\t\tdiscard;\n\t}\n";
  const std::string covered = "\tALPHA = albedo.a;\n";
  return alpha == Alpha::kMask ? covered + "\tALPHA_SCISSOR_THRESHOLD = 0.5;\n" : covered;
}

base::Result<void> write_shader(const SetFacts& set) {
  return write_file_atomically(
      set.folder + "/" + set.name + ".gdshader",
      fill_template(kShader, {{"NAME", set.name},
                              {"BLENDED", set.alpha == Alpha::kBlend ? ", depth_prepass_alpha" : ""},
                              {"FRONT", of_side(kUniforms, Face::kFront)},
                              {"BACK", of_side(kUniforms, Face::kBack)},
                              {"FETCH_FRONT", of_side(kFetch, Face::kFront)},
                              {"FETCH_BACK", of_side(kFetch, Face::kBack)},
                              {"HASH", set.alpha == Alpha::kHashed ? kHash : ""},
                              {"COVERAGE", coverage_lines(set.alpha)}}));
}

std::string vector3(const glm::vec3& v) {
  const auto text = [](float x) { return number(static_cast<double>(x)); };
  return "Vector3(" + text(v.x) + ", " + text(v.y) + ", " + text(v.z) + ")";
}

std::string files_of(const SetFacts& set, Face face) {
  std::string out;
  for (const ImageRow& row : kImages)
    out += "[ext_resource type=\"Texture2D\" path=\"" + mipped_image_named(set, row.suffix, face) + "\" id=\"" +
           side_of(face) + row.suffix + "\"]\n";
  return out;
}

std::string parameters_of(const SetFacts& set, Face face) {
  const light::EngineFit& fit = set.of(face).fit();
  const std::string first = std::string("shader_parameter/") + side_of(face);
  std::string out;
  for (const ImageRow& row : kImages)
    out += first + row.suffix + " = ExtResource(\"" + side_of(face) + row.suffix + "\")\n";
  return out + first + "_normal_reflectance = " + vector3(fit.f0) + "\n" + first +
         "_grazing_reflectance = " + number(static_cast<double>(fit.f90)) + "\n" + first +
         "_tint_weft = " + vector3(fit.tint.weft) + "\n" + first + "_tint_warp = " + vector3(fit.tint.warp) + "\n" +
         first + "_late_tint_weft = " + vector3(fit.tint.late_weft) + "\n" + first +
         "_late_tint_warp = " + vector3(fit.tint.late_warp) + "\n" + first + "_shine_growth = Vector2(" +
         number(static_cast<double>(fit.tint.shine.x)) + ", " + number(static_cast<double>(fit.tint.shine.y)) + ")\n";
}

base::Result<void> write_material(const SetFacts& set) {
  const UvTransform uv = uv_transform(set);
  if (base::Result<void> done = write_shader(set); !done) return done;
  base::Result<void> done = write_file_atomically(
      set.folder + "/" + set.name + ".tres",
      fill_template(kMaterial, {{"NAME", set.name},
                                {"FILES", files_of(set, Face::kFront) + files_of(set, Face::kBack)},
                                {"SCALE_U", number(uv.scale_u)},
                                {"SCALE_V", number(uv.scale_v)},
                                {"OFFSET_U", number(uv.offset_u)},
                                {"OFFSET_V", number(0 - uv.offset_v)},
                                {"TRANSMITTED", number(static_cast<double>(mean_transmission(set)))},
                                {"PARAMETERS", parameters_of(set, Face::kFront) + parameters_of(set, Face::kBack)}}));
  return done ? write_scale_quad(set) : done;
}

}  // namespace

const ExportTarget targets::kGodot{
    .id = "godot",
    .title = "Godot",
    .images = kImages,
    .model = {.sheen = formulas::kSheenNone,
              .most_f0 = 1,
              .grazing = true,
              .anisotropic = true,
              .tinted = true,
              .planes = 40,
              .view_tinted = true,
              .light_tinted = true},
    .highlight = "anisotropic GGX, its own shader",
    .sheen = "none",
    .open = Alpha::kHashed,
    .color_mips = MipFormat::kDds,
    .names_dds = true,
    .material = ".tres",
    .write_material = write_material,
    .note = base::mark("Copy this folder into your Godot project and drag {name}.tres onto a mesh; it shows both "
                       "faces, and needs the shader and the images beside it. {name}_quad.glb is a flat piece of 100 "
                       "mm to try it on."),
};

}  // namespace weftlight::texture_set
