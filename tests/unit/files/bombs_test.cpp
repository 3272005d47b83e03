// Small files that claim to be large are refused, with the figure, before memory is taken for it. Others than pictures,
// meshes and drafts: unit/base/json_test, and Bombs in unit/scene, unit/session and unit/texture_set.

#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>
#include <functional>
#include <string>

#include "../memory_taken.h"
#include "../scratch_fixture.h"
#include "files/environment.h"
#include "files/files.h"
#include "files/picture_draft.h"
#include "wif/other_formats.h"

namespace weftlight::files {
namespace {

std::string big_endian(uint32_t v) {
  std::string out;
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(v >> shift & 0xff);
  return out;
}
std::string little_endian(uint64_t v, int bytes) {
  std::string out;
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(v >> (8 * i) & 0xff);
  return out;
}

std::string png_chunk(const std::string& kind, const std::string& data) {
  const std::string body = kind + data;
  const auto sum =
      static_cast<uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size())));
  return big_endian(static_cast<uint32_t>(data.size())) + body + big_endian(sum);
}

std::string deflated(size_t zeros) {
  const std::string plain(zeros, '\0');
  uLongf size = compressBound(plain.size());
  std::string out(size, '\0');
  compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(plain.data()), plain.size(), 9);
  out.resize(size);
  return out;
}

/// `color`: 0 grey, 2 RGB, 6 RGBA; the data are those of a million bytes only.
std::string png(uint32_t width, uint32_t height, char bits, char color, bool interlaced) {
  const std::string head =
      big_endian(width) + big_endian(height) + std::string{bits, color, 0, 0, interlaced ? '\1' : '\0'};
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", head) + png_chunk("IDAT", deflated(1'000'000)) + png_chunk("IEND", "");
}

/// One strip without compression.
std::string tiff(uint32_t width, uint32_t height) {
  std::string out = std::string("II*\0", 4) + little_endian(8, 4) + little_endian(9, 2);
  for (const auto& [tag, value] : std::initializer_list<std::pair<int, uint32_t>>{
           {256, width}, {257, height}, {258, 8}, {259, 1}, {262, 1}, {273, 200}, {277, 1}, {278, height}, {279, 1000}})
    out += little_endian(static_cast<uint64_t>(tag), 2) + little_endian(4, 2) + little_endian(1, 4) +
           little_endian(value, 4);
  out.resize(2000, '\0');
  return out;
}

std::string exr_attribute(const std::string& name, const std::string& type, const std::string& value) {
  return name + '\0' + type + '\0' + little_endian(value.size(), 4) + value;
}

std::string exr(uint32_t width, uint32_t height, int layers) {
  std::string channels;
  for (int i = 0; i < layers; ++i)
    channels += "layer" + std::to_string(10000 + i) + ".R" + '\0' + little_endian(1, 4) + little_endian(0, 4) +
                little_endian(1, 4) + little_endian(1, 4);
  const std::string box = little_endian(0, 8) + little_endian(width - 1, 4) + little_endian(height - 1, 4);
  const std::string one = little_endian(0x3f800000, 4);
  std::string out = "\x76\x2f\x31\x01" + little_endian(2, 4);
  out += exr_attribute("channels", "chlist", channels + '\0') + exr_attribute("compression", "compression", "\x03") +
         exr_attribute("dataWindow", "box2i", box) + exr_attribute("displayWindow", "box2i", box) +
         exr_attribute("lineOrder", "lineOrder", std::string(1, '\0')) +
         exr_attribute("pixelAspectRatio", "float", one) +
         exr_attribute("screenWindowCenter", "v2f", std::string(8, '\0')) +
         exr_attribute("screenWindowWidth", "float", one);
  return out + std::string(20'000, '\0');
}

std::string said(const wif::WifRead& read) {
  std::string all;
  for (const wif::Diagnostic& d : read.diagnostics) all += d.text + "; ";
  return read.file ? "it was read" : all;
}

class Bombs : public ScratchTest {
 protected:
  /// Before the first fork: the memory of the library of pictures is not that of a file.
  static void SetUpTestSuite() { encode_png({1, 1, 1, {0}}); }
  std::string file(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }
  void expect_no_picture(const std::string& name, const std::string& bytes, const std::string& wanted) const {
    const std::string at = file(name, bytes);
    SCOPED_TRACE(name + ", " + std::to_string(bytes.size()) + " bytes");
    expect_harmless([&] { return said(read_picture_draft(at)); }, wanted);
    expect_harmless(
        [&] {
          const base::Result<Image> read = read_image(at);
          return read ? "it was read" : message(read.error());
        },
        wanted.substr(0, wanted.find(' ')));
  }
  void expect_no_mesh(const std::string& name, const std::string& bytes, const std::string& wanted) const {
    const std::string at = file(name, bytes);
    SCOPED_TRACE(name + ", " + std::to_string(bytes.size()) + " bytes");
    expect_harmless(
        [&] {
          const base::Result<drape::Mesh> read = read_mesh(at);
          return read ? "it was read" : message(read.error());
        },
        wanted);
  }
};

TEST_F(Bombs, PicturesOfSixtyThousandPixels) {
  expect_no_picture("huge.png", png(60000, 60000, 8, 2, false), "60000 by 60000");
  expect_no_picture("bits.png", png(60000, 60000, 1, 0, false), "60000 by 60000");
  expect_no_picture("huge.tif", tiff(60000, 60000), "60000 by 60000");
}

TEST_F(Bombs, PicturesThatWouldFitButAreTooShort) {
  expect_no_picture("wide.png", png(10000, 10000, 8, 2, false), "10000 by 10000");
  expect_no_picture("interlaced.png", png(10000, 10000, 8, 6, true), "10000 by 10000");
  expect_no_picture("tall.png", png(4000, 60000, 8, 2, false), "4000 x 60000");
  expect_no_picture("tall.tif", tiff(4000, 60000), "4000 x 60000");
}

TEST_F(Bombs, EnvironmentsOfAThousandLayersOrOfNoEnd) {
  const auto light = [](const std::string& at) {
    return [at] {
      const auto read = read_environment(at);
      return read ? std::string("it was read") : message(read.error());
    };
  };
  expect_harmless(light(file("layers.exr", exr(2048, 1024, 1000))), "1000 channels");
  expect_harmless(
      light(file("huge.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 30000 +X 60000\n" + std::string(400, '\2'))),
      "60000 x 30000");
  expect_harmless(light(file("short.exr", exr(8192, 4096, 3))), "short.exr");
}

const std::string kParts =
    R"("bufferViews":[{"buffer":0,"byteLength":36}],"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
    R"("buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)" +
    std::string(48, 'A') + R"("}])";

std::string repeated(const std::string& what, size_t times) {
  std::string out;
  for (size_t i = 0; i < times; ++i) out += what;
  return out;
}

TEST_F(Bombs, MeshesWithABillionElements) {
  expect_no_mesh("count.gltf",
                 R"({"asset":{"version":"2.0"},"accessors":[{"bufferView":0,"componentType":5126,"count":1000000000,)"
                 R"("type":"VEC3"}],)" +
                     kParts + "}",
                 "1000000000 elements");
}

TEST_F(Bombs, MeshesWithMillionsOfAccessors) {
  expect_no_mesh("many.gltf",
                 R"({"asset":{"version":"2.0"},"accessors":[)" + repeated("{},", 5'000'000) + "{}]," + kParts + "}",
                 "10000");
  expect_no_mesh("list.gltf",
                 R"({"asset":{"version":"2.0"},"accessors":[)" + repeated("{},", 500'000) + "{}]," + kParts + "}",
                 "500001 accessors");
}

TEST_F(Bombs, DeepJson) {
  expect_no_mesh("deep.gltf", R"({"asset":{"version":"2.0"},"extras":)" + repeated("[", 5'000'000), "deeper than 64");
  expect_no_mesh("text.gltf", R"({"asset":{"version":"2.0"},"extras":"[[[[\"[[)" + repeated("[", 1000) + "\"}", "");
}

TEST_F(Bombs, DraftsWithLyingCounts) {
  const auto draft = [](const std::string& bytes) { return [bytes] { return said(wif::read_draft(bytes)); }; };
  expect_harmless(draft("@@StartDTX\n@@Info\n%%ends 2000000000\n%%picks 2000000000\n%%shafts 2000000000\n@@Threading\n"
                        "1 2 3\n@@Tieup\n1\n@@Treadling\n1\n"),
                  "2000000000");
  const std::string head = std::string("\x7b\x07\x64\0\xff\xff\0\0\0\x0a\x0a", 11) + std::string(13, '\xff');
  expect_harmless(draft(head + "\xff\xff" + "\1"), "ends within its threading");
  expect_harmless(draft(head + std::string("\0\1\1\0\1\1\0\1\1\xff\xff\1", 12)), "ends within its liftplan");
  const std::string counts =
      "[WIF]\nVersion=1.1\n[WEAVING]\nShafts=2000000000\nTreadles=2000000000\n[WARP]\n"
      "Threads=2000000000\n[WEFT]\nThreads=2000000000\n[THREADING]\n2000000000=1\n"
      "[TIEUP]\n1=1\n[TREADLING]\n1=1\n";
  expect_harmless(draft(counts), "2000000000");
}

TEST_F(Bombs, DraftsOfMillionsOfLines) {
  const auto draft = [](const std::string& bytes) { return [&bytes] { return said(wif::read_draft(bytes)); }; };
  const std::string wif = "[WIF]\nVersion=1.1\n[WEAVING]\nShafts=4\nTreadles=4\n[WARP]\nThreads=8\n[WEFT]\nThreads=8\n";
  // The same key again and again, sections again and again, one line without end, lists without end.
  const std::string keys = wif + "[THREADING]\n" + repeated("1=1\n", 4'000'000);
  expect_harmless(draft(keys), "more than 4000000 lines");
  const std::string sections = wif + repeated("[A]\n", 4'000'000);
  expect_harmless(draft(sections), "more than 4000000 lines");
  const std::string brackets = wif + repeated("[", 16'000'000);
  expect_harmless(draft(brackets), "");
  const std::string list = wif + "[TIEUP]\n1=" + repeated("1,", 8'000'000);
  expect_harmless(draft(list), "");
  const std::string dtx = "@@StartDTX\n@@Info\n%%ends 4\n%%picks 4\n@@Threading\n" + repeated("1 ", 8'000'000);
  expect_harmless(draft(dtx), "too many ends");
  const std::string data = "@@StartDTX\n@@Threading\n" + repeated("1\n", 5'000'000);
  expect_harmless(draft(data), "more than 4000000 lines");
  const std::string names = "@@StartDTX\n" + repeated("@@A\n", 4'000'000);
  expect_harmless(draft(names), "more than 1000 sections");
}

}  // namespace
}  // namespace weftlight::files
