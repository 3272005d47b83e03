// The images of texture sets, what is shown of them, and meshes that wear them.

#include <cmath>
#include <cstring>
#include <regex>

#include "base/json.h"
#include "base/whole_files.h"
#include "command.h"
#include "texture_set/contact_sheet.h"
#include "texture_set/material_files.h"
#include "texture_set/set_preview.h"
#include "texture_set/texture_set.h"

namespace weftlight::orientation {

using draft::Face;
using drape::Mesh, drape::Vec2, drape::Vec3;
using files::Image, files::PixelType;
using texture_set::Channel, texture_set::ExportTarget, texture_set::ImageRow, texture_set::SetPreview,
    texture_set::TextureSetOptions, texture_set::image_file, texture_set::kTargets, texture_set::preview_set;

namespace {

using nlohmann::json;

constexpr int kSize = 64;  // texels

std::string exported(const Workplace& at, const std::string& target, std::vector<std::string> more = {}) {
  const std::string sets = at.scratch / "sets";
  std::vector<std::string> args{"export", at.draft(), "--target", target,   "-o",
                                sets,     "--name",   "{target}", "--size", std::to_string(kSize),
                                "--force"};
  args.insert(args.end(), more.begin(), more.end());
  run(args);
  return sets + "/" + target + "/";
}

/// All images are packed by one loop: those that tell where a crossing is stand for the rest.
std::optional<Shows> shown_by(const ImageRow& row) {
  switch (row.channels[0]) {
    case Channel::kBaseR:
      return Shows::kColors;
    case Channel::kNormalX:
      return row.channels[1] == Channel::kNormalYDown ? Shows::kNormalsDown : Shows::kNormals;
    case Channel::kFibreX:
      return Shows::kFibres;
    case Channel::kThreadLow:
      return Shows::kThreads;
    case Channel::kHeightMm:
    case Channel::kHeightNormalized:
      return Shows::kHeights;
    default:
      return {};
  }
}

const char* word(Face face) { return face == Face::kFront ? " front" : " back"; }

/// The finest level of an uncompressed .ktx2 of four bytes a texel.
Image finest_of_ktx2(const std::string& path) {
  const std::string bytes = base::read_file(path).value_or("");
  const auto number = [&](size_t at, size_t size) {
    uint64_t v = 0;
    if (at + size <= bytes.size()) std::memcpy(&v, bytes.data() + at, size);
    return v;
  };
  Image out{static_cast<int>(number(20, 4)), static_cast<int>(number(24, 4)), 4, {}};
  const uint64_t from = number(80, 8), length = number(88, 8);
  EXPECT_EQ(length, static_cast<uint64_t>(out.width) * static_cast<uint64_t>(out.height) * 4) << path;
  EXPECT_LE(from + length, bytes.size()) << path;
  if (testing::Test::HasFailure()) return {};
  for (uint64_t i = 0; i < length; ++i)
    out.texels.push_back(static_cast<float>(static_cast<unsigned char>(bytes[from + i])) / 255);
  return out;
}

}  // namespace

std::vector<Seen> texture_images(const Workplace& at, std::string&) {
  std::vector<Seen> out;
  for (const ExportTarget* target : kTargets) {
    const bool mips = target == &texture_set::targets::kUnityHdrp || target == &texture_set::targets::kGodot;
    const std::string container = target == &texture_set::targets::kGodot ? "ktx2" : "dds";
    const std::string folder =
        exported(at, target->id, mips ? std::vector<std::string>{"--mips", container} : std::vector<std::string>{});
    for (const Face face : {Face::kFront, Face::kBack})
      for (const ImageRow& row : target->images) {
        const std::optional<Shows> shows = shown_by(row);
        if (!shows) continue;
        const std::string file = image_file(*target, row, "marked", face);
        const std::string name = std::string(target->id) + " " + file;
        out.push_back(Seen::whole(name, picture(folder + file), face, *shows));
        if (!mips || row.type != PixelType::kU8) continue;
        const std::string mipped = folder + file.substr(0, file.rfind('.')) + "." + container;
        out.push_back(Seen::whole(name + " as ." + container,
                                  container == "dds" ? picture(mipped) : finest_of_ktx2(mipped), face, *shows));
      }
  }
  return out;
}

namespace {

/// Repeats in a lit swatch; the corner at the right and the top is the face's.
Seen in_swatch(std::string name, Image image, double x, double y, double width, double repeats, Face face) {
  Seen s{std::move(name), std::move(image)};
  s.width = width / repeats, s.height = s.width * kPicks / kEnds;
  s.x = x + width - s.width, s.y = y, s.face = face;
  return s;
}

}  // namespace

std::vector<Seen> texture_previews(const Workplace& at, std::string&) {
  std::vector<Seen> out;
  TextureSetOptions options;
  options.name = "marked", options.size = kSize;
  constexpr int kSwatch = 280;
  for (const Face face : {Face::kFront, Face::kBack}) {
    SetPreview p = preview_set(marked_design(), face, options, kSize, kSwatch, kSwatch, 2 * kEnds);
    out.push_back(
        in_swatch(std::string("swatch of the preview") + word(face), std::move(p.swatch), 0, 0, kSwatch, 2, face));
    out.push_back(Seen::whole("first image of the preview", std::move(p.images.at(0).image), face));
  }
  constexpr int kX = 40, kY = 136, kWidth = 624, kRepeats = 4;  // of the swatch on a contact sheet: 24 mm at the least
  Image sheet = picture(exported(at, "gltf") + "contact_sheet.png");
  out.push_back(in_swatch("contact sheet", std::move(sheet), kX, kY, kWidth, kRepeats, Face::kFront));
  return out;
}

namespace {

/// A flat mesh with its image, as programs draw it: u right and v down the image, in repeats.
struct Textured {
  std::vector<Vec3> position;  // in metres
  std::vector<Vec2> uv;
  std::vector<uint32_t> index;
  Image image;
};

json glb_document(const std::string& bytes) {
  uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, 4);
  return json::parse(bytes.substr(20, length));
}

/// The primitive of a face, by the .glb alone; its image by `image` where it has none.
Textured read_glb(const std::string& path, size_t material, Image image) {
  const std::string bytes = base::read_file(path).value_or("");
  const json doc = glb_document(bytes);
  uint32_t head = 0;
  std::memcpy(&head, bytes.data() + 12, 4);
  const char* const binary = bytes.data() + 20 + head + 8;
  const auto numbers = [&](int accessor, auto kind) {
    const json& a = doc["accessors"][static_cast<size_t>(accessor)];
    const json& view = doc["bufferViews"][a["bufferView"].get<size_t>()];
    std::vector<decltype(kind)> out(a["count"].get<size_t>());
    std::memcpy(out.data(), binary + view["byteOffset"].get<size_t>(), out.size() * sizeof kind);
    return out;
  };
  Textured out;
  for (const json& p : doc["meshes"][0]["primitives"]) {
    if (p.value("material", size_t{0}) != material) continue;
    out.position = numbers(p["attributes"]["POSITION"], Vec3{});
    out.uv = numbers(p["attributes"]["TEXCOORD_0"], Vec2{});
    out.index = numbers(p["indices"], uint32_t{});
  }
  Vec2 scale{1.0f / kEnds, 1.0f / kPicks};
  if (doc.contains("materials")) {
    const json& base = doc["materials"][material]["pbrMetallicRoughness"]["baseColorTexture"];
    const json& by = base["extensions"]["KHR_texture_transform"]["scale"];
    scale = {by[0].get<float>(), by[1].get<float>()};
    const json& source = doc["images"][doc["textures"][base["index"].get<size_t>()]["source"].get<size_t>()];
    const json& view = doc["bufferViews"][source["bufferView"].get<size_t>()];
    const std::string png = path + ".png";
    EXPECT_EQ(problem_of(base::write_file_atomically(
                  png, {binary + view["byteOffset"].get<size_t>(), view["byteLength"].get<size_t>()})),
              "");
    image = picture(png);
  }
  for (Vec2& t : out.uv) t *= scale;
  out.image = std::move(image);
  return out;
}

std::vector<float> numbers_in(const std::string& text) {
  const std::regex number(R"re(-?[\d.]+(e-?\d+)?)re");
  std::vector<float> out;
  for (std::sregex_iterator at(text.begin(), text.end(), number), end; at != end; ++at)
    out.push_back(std::stof(at->str()));
  return out;
}

/// Four corners, and texture coordinates in millimetres that run up the image.
Textured quad(const std::vector<float>& points, const std::vector<float>& st, float metres, Image image) {
  Textured out;
  for (size_t i = 0; i < 4; ++i) {
    out.position.push_back(Vec3{points[3 * i], points[3 * i + 1], points[3 * i + 2]} * metres);
    out.uv.push_back({st[2 * i] / kEnds, 1 - st[2 * i + 1] / kPicks});
  }
  out.index = {0, 1, 2, 0, 2, 3};
  out.image = std::move(image);
  return out;
}

Textured read_obj(const std::string& path, Image image) {
  const std::string text = base::read_file(path).value_or("");
  std::vector<float> points, st;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("v ") && !line.starts_with("vt ")) continue;
    std::vector<float>& to = line.starts_with("v ") ? points : st;
    for (const float v : numbers_in(line.substr(2))) to.push_back(v);
  }
  return quad(points, st, 1, std::move(image));
}

Textured read_usd(const std::string& path, Image image) {
  const std::string text = base::read_file(path).value_or("");
  const auto list = [&](const std::string& after) {
    const size_t from = text.find('[', text.find(after) + after.size());
    return numbers_in(text.substr(from, text.find(']', from) - from));
  };
  return quad(list("point3f[] points ="), list("primvars:st ="), 0.001f, std::move(image));
}

/// The colour at a place of the plane z = 0; `side`: 1 from before, -1 from behind.
std::array<float, 3> color_at(const Textured& t, Vec2 at) {
  for (size_t i = 0; i + 2 < t.index.size(); i += 3) {
    const uint32_t a = t.index[i], b = t.index[i + 1], c = t.index[i + 2];
    const Vec2 ab = Vec2(t.position[b]) - Vec2(t.position[a]), ac = Vec2(t.position[c]) - Vec2(t.position[a]);
    const Vec2 to = at - Vec2(t.position[a]);
    const float area = ab.x * ac.y - ab.y * ac.x;
    const float s = (to.x * ac.y - to.y * ac.x) / area, r = (ab.x * to.y - ab.y * to.x) / area;
    if (s < 0 || r < 0 || s + r > 1) continue;
    const Vec2 uv = t.uv[a] * (1 - s - r) + t.uv[b] * s + t.uv[c] * r;
    const auto texel = [](float x, int n) {
      return std::min(static_cast<int>((x - std::floor(x)) * static_cast<float>(n)), n - 1);
    };
    const size_t from = static_cast<size_t>(texel(uv.y, t.image.height) * t.image.width + texel(uv.x, t.image.width)) *
                        static_cast<size_t>(t.image.channels);
    return {t.image.texels[from], t.image.texels[from + 1], t.image.texels[from + 2]};
  }
  return {1, 1, 1};
}

/// One repeat of the mesh, seen straight on, whose corner of end 1 and pick 1 is there, in millimetres.
Seen worn(std::string name, const Textured& t, double right_mm, double top_mm, Face face) {
  constexpr int kPixels = 20;  // a millimetre
  Image out{kEnds * kPixels, kPicks * kPixels, 3, {}};
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      // From behind, what lies at the right is seen at the left.
      const double across = face == Face::kFront ? out.width - 0.5 - x : x + 0.5;
      const Vec2 at{(right_mm - across / kPixels) / 1000, (top_mm - (y + 0.5) / kPixels) / 1000};
      for (const float v : color_at(t, at)) out.texels.push_back(v);
    }
  return Seen::whole(std::move(name), std::move(out), face).from(face == Face::kBack, false);
}

}  // namespace

std::vector<Seen> textured_meshes(const Workplace& at, std::string&) {
  std::vector<Seen> out;
  // The plane as core has it says where u = v = 0 lies, the corner of end 1 and pick 1; the repeat is one well within.
  const Mesh plane = *files::load_drape("plane");
  const Vec2 corner = Vec2(plane.position_mm[0]) + plane.uv_mm[0];
  for (size_t i = 0; i < plane.position_mm.size(); ++i) {
    EXPECT_NEAR(plane.position_mm[i].x + plane.uv_mm[i].x, corner.x, 1e-3f) << "u runs to the left";
    EXPECT_NEAR(plane.position_mm[i].y + plane.uv_mm[i].y, corner.y, 1e-3f) << "v runs down";
  }
  const double mesh_right = static_cast<double>(corner.x) + 21 * kEnds;
  const double mesh_top = static_cast<double>(corner.y) + 17 * kPicks;
  const std::string gltf = exported(at, "gltf"), blender = exported(at, "blender"), godot = exported(at, "godot"),
                    unity = exported(at, "unity-urp"), usd = exported(at, "materialx");
  for (const Face face : {Face::kFront, Face::kBack}) {
    const size_t material = face == Face::kFront ? 0 : 1;
    out.push_back(worn(std::string("glTF") + word(face), read_glb(gltf + "marked.glb", material, {}), mesh_right,
                       mesh_top, face));
    out.push_back(worn(std::string("Blender's glTF") + word(face), read_glb(blender + "marked.glb", material, {}),
                       mesh_right, mesh_top, face));
  }
  // The square of 100 mm begins with its corner of u = v = 0.
  constexpr double kSquare = 100;
  const auto image = [](const std::string& path) { return picture(path); };
  out.push_back(worn("square", read_glb(godot + "marked_quad.glb", 0, image(godot + "marked_albedo.png")), kSquare,
                     kSquare, Face::kFront));
  out.push_back(worn("square of Unity", read_obj(unity + "marked_quad.obj", image(unity + "marked_BaseMap.png")),
                     kSquare, kSquare, Face::kFront));
  out.push_back(worn("square of USD", read_usd(usd + "marked.usda", image(usd + "marked_basecolor.png")), kSquare,
                     kSquare, Face::kFront));
  return out;
}

}  // namespace weftlight::orientation
