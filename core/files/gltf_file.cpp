#include "files/gltf_file.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <new>

#include "base/json.h"
#include "base/text.h"
#include "base/whole_files.h"

namespace weftlight::files {

using base::arg, base::fill, base::is_text, base::kMaxJsonDepth, base::message, base::read_file, base::tr;

namespace {

using nlohmann::json;

constexpr size_t kMaxMeshValues = 2'000'000;  // about 100 bytes of memory each
constexpr size_t kMaxNodes = 100'000;
constexpr uint32_t kJsonChunk = 0x4E4F534A, kBinChunk = 0x004E4942;

std::string whole_file(const std::string& path) {
  base::Result<std::string> bytes = read_file(path);
  if (!bytes) refuse(bytes.error().text);
  return std::move(*bytes);
}

// A .gltf names other files. tinygltf would open pipes and devices, and expands names like a shell: these callbacks
// allow only regular files in the folder of the .gltf, by their literal names.
bool is_file_within(const std::string& path, void* folder) {
  std::error_code ec;
  const std::filesystem::path whole = std::filesystem::canonical(path, ec);
  if (ec || !std::filesystem::is_regular_file(whole, ec)) return false;
  const std::filesystem::path& root = *static_cast<const std::filesystem::path*>(folder);
  return std::mismatch(root.begin(), root.end(), whole.begin(), whole.end()).first == root.end();
}

bool read_within(std::vector<unsigned char>* out, std::string* error, const std::string& path, void* folder) {
  base::Result<std::string> bytes =
      base::failure(base::ErrorKind::kInput, tr("is not a file in the folder of the .gltf"), path);
  if (is_file_within(path, folder)) bytes = read_file(path);
  if (bytes) out->assign(bytes->begin(), bytes->end());
  else if (error) *error += message(bytes.error());
  return bytes.has_value();
}

std::string as_named(const std::string& path, void*) { return path; }

/// Callbacks for any version of tinygltf; newer ones ask for the size first.
template <class Callbacks>
Callbacks callbacks_for(std::filesystem::path& folder) {
  Callbacks calls{};
  calls.FileExists = &is_file_within;
  calls.ExpandFilePath = &as_named;
  calls.ReadWholeFile = &read_within;
  calls.WriteWholeFile = &tinygltf::WriteWholeFile;
  if constexpr (requires { calls.GetFileSizeInBytes; }) {
    calls.GetFileSizeInBytes = [](size_t* size, std::string*, const std::string& path, void*) {
      std::error_code ec;
      *size = static_cast<size_t>(std::filesystem::file_size(path, ec));
      return !ec;
    };
  }
  calls.user_data = &folder;
  return calls;
}

/// Decodes %XX.
std::string decoded(const std::string& uri) {
  std::string out;
  for (size_t i = 0; i < uri.size(); ++i) {
    unsigned code = 0;
    const char* at = uri.data() + i + 1;
    const bool coded = uri[i] == '%' && i + 2 < uri.size() && std::from_chars(at, at + 2, code, 16).ptr == at + 2;
    out.push_back(coded ? static_cast<char>(code) : uri[i]);
    if (coded) i += 2;
  }
  return out;
}

/// The file of a buffer must be in or below the folder; "data:" contains the bytes themselves.
void check_uri(const json& buffer) {
  const auto found = buffer.find("uri");
  if (found == buffer.end()) return;
  if (!found->is_string()) refuse(tr("a buffer's uri is not text; export it again as .glb"));
  const std::string plain = decoded(found->get<std::string>());
  if (plain.rfind("data:", 0) == 0) return;
  const std::filesystem::path path(plain);
  const bool up = std::find(path.begin(), path.end(), "..") != path.end();
  if (up || path.is_absolute() || plain.find(':') != std::string::npos)
    refuse(tr("a buffer's uri leaves the folder of the .gltf; export it again as .glb"));
}

uint32_t u32_at(const std::string& bytes, size_t at) {
  uint32_t v = 0;
  for (int k = 3; k >= 0; --k) v = (v << 8) | static_cast<unsigned char>(bytes[at + static_cast<size_t>(k)]);
  return v;
}

struct Chunks {
  std::string_view json, binary;
};

Chunks split(const std::string& bytes) {
  if (bytes.compare(0, 4, "glTF") != 0) return {bytes, {}};
  if (bytes.size() < 20) refuse(tr("the file ends within its header; export it again"));
  if (u32_at(bytes, 4) != 2)
    refuse(fill(tr("glTF version {version} is not supported; export as glTF 2.0"), arg("version", u32_at(bytes, 4))));
  if (u32_at(bytes, 8) > bytes.size()) refuse(tr("the file is cut short; export or copy it again"));
  Chunks chunks;
  const std::string_view all(bytes);
  for (size_t at = 12; at + 8 <= bytes.size();) {
    const uint64_t size = u32_at(bytes, at);
    const uint32_t kind = u32_at(bytes, at + 4);
    if (size > bytes.size() - at - 8) refuse(tr("the file is cut short; export or copy it again"));
    if (kind == kJsonChunk && chunks.json.empty()) chunks.json = all.substr(at + 8, size);
    if (kind == kBinChunk && chunks.binary.empty()) chunks.binary = all.substr(at + 8, size);
    at += 8 + size + (4 - size % 4) % 4;
  }
  return chunks;
}

/// Before a value of the JSON takes memory. nlohmann's own callback for this takes a time that grows with the square of
/// a list of objects.
void check_nesting(std::string_view text) {
  const base::JsonExtent extent = base::json_extent(text);
  if (extent.depth > kMaxJsonDepth)
    refuse(fill(tr("its JSON is nested deeper than {most}"), arg("most", int{kMaxJsonDepth})));
  if (extent.values > kMaxMeshValues)
    refuse(fill(tr("its JSON has {count} values; at most {most} are read; export a lighter mesh as .glb"),
                arg("count", extent.values), arg("most", kMaxMeshValues)));
}

json parse(std::string_view text) {
  check_nesting(text);
  json root = json::parse(text.begin(), text.end(), nullptr, false);
  if (root.is_discarded()) refuse(tr("this is not glTF (its JSON does not parse); export it again as .glb"));
  if (!root.is_object()) refuse(tr("this is not glTF: its JSON is not an object"));
  return root;
}

struct Needed {
  json root;
  bool uv_mm = false;
};

/// Keeps only what a mesh needs; each list is checked to be an array of objects.
Needed reduced(const json& root) {
  Needed out;
  const json asset = root.value("asset", json::object());
  if (!asset.is_object() || !is_text(asset.value("version", json()), "2.0"))
    refuse(tr("not glTF 2.0; export it as glTF 2.0"));
  const json extras = asset.value("extras", json());
  out.uv_mm = extras.is_object() && extras.value("weftlight_uv_mm", json()) == true;
  for (const json& extension : root.value("extensionsRequired", json::array())) {
    for (const char* packed : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
      if (is_text(extension, packed))
        refuse(fill(tr("compressed with {extension}; export it without compression"), arg("extension", packed)));
    }
  }
  out.root = {{"asset", {{"version", "2.0"}}}};
  if (root.contains("scene")) out.root["scene"] = root["scene"];
  for (const char* kind : {"buffers", "bufferViews", "accessors", "meshes", "nodes", "scenes"}) {
    const auto found = root.find(kind);
    if (found == root.end()) continue;
    if (!found->is_array()) refuse(fill(tr("its {list} are not a list"), arg("list", kind)));
    if (found->size() > kMaxNodes)
      refuse(fill(tr("it has {count} {list}; at most {most} are read; export a lighter mesh"),
                  arg("count", found->size()), arg("list", kind), arg("most", kMaxNodes)));
    json list = *found;
    for (json& item : list) {
      if (!item.is_object()) refuse(fill(tr("an entry of its {list} is not an object"), arg("list", kind)));
      for (const char* gone : {"extensions", "extras"}) item.erase(gone);
      if (kind == std::string_view("buffers")) check_uri(item);
    }
    out.root[kind] = std::move(list);
  }
  return out;
}

tinygltf::Model load(const Needed& needed, std::string_view binary, const std::string& folder) {
  tinygltf::TinyGLTF loader;
  loader.RemoveImageLoader();
  std::error_code ec;
  std::filesystem::path root = std::filesystem::canonical(folder.empty() ? "." : folder, ec);
  loader.SetFsCallbacks(callbacks_for<tinygltf::FsCallbacks>(root));
  tinygltf::Model model;
  std::string error, warning;
  std::string text = needed.root.dump();
  bool good = false;
  if (binary.empty()) {
    good =
        loader.LoadASCIIFromString(&model, &error, &warning, text.data(), static_cast<unsigned>(text.size()), folder);
  } else {
    text.append((4 - text.size() % 4) % 4, ' ');
    std::string body(binary);
    body.append((4 - body.size() % 4) % 4, '\0');
    std::string glb = "glTF";
    auto put = [&glb](uint64_t v) {
      for (int shift = 0; shift < 32; shift += 8) glb.push_back(static_cast<char>(v >> shift));
    };
    put(2), put(28 + text.size() + body.size()), put(text.size()), put(kJsonChunk);
    glb += text;
    put(body.size()), put(kBinChunk);
    glb += body;
    good = loader.LoadBinaryFromMemory(&model, &error, &warning, reinterpret_cast<const unsigned char*>(glb.data()),
                                       static_cast<unsigned>(glb.size()), folder);
  }
  if (!good) {
    // tinygltf takes every exception of its parser for a mistake in the text.
    if (error.find(std::bad_alloc().what()) != std::string::npos) throw std::bad_alloc();
    std::replace(error.begin(), error.end(), '\n', ' ');
    refuse(fill(tr("{problem}; export it again as .glb"),
                arg("problem", error.empty() ? tr("its parts do not fit together") : error)));
  }
  return model;
}

}  // namespace

void refuse(const std::string& why) { throw UnreadableMesh(why); }

GltfFile read_gltf(const std::string& path) {
  const std::string bytes = whole_file(path);
  const Chunks chunks = split(bytes);
  const Needed needed = reduced(parse(chunks.json));
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return {load(needed, chunks.binary, folder), needed.uv_mm};
}

}  // namespace weftlight::files
