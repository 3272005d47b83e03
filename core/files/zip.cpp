// Based on: PKWARE, APPNOTE.TXT 6.3 (local headers, central directory, end record); the U3M 1.1 specification of .u3ma;
//   Pixar, Usdz File Format Specification (stored, 64-byte alignment by an extra field).

#include "files/zip.h"

#include <zlib.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>

#include "base/text.h"
#include "base/whole_files.h"
#include "platform/file.h"

namespace weftlight::files {

using base::cause_of, base::ErrorKind, base::failure, base::Result, base::tr, base::write_through;

namespace {

constexpr uint16_t kVersion = 20, kMadeBy = 63;  // FAT in the upper byte
constexpr uint16_t kUtf8Names = 1u << 11;
constexpr uint16_t kDate = 0x21;  // 1 January 1980 for every file, so that the bytes do not depend on the time
constexpr size_t kAlignment = 64, kPaddingHead = 4;
constexpr uint16_t kPaddingId = 0x1986;
constexpr size_t kHead = 30, kDirectoryHead = 46, kEndRecord = 22;  // bytes before a name, and of the last record

struct Bytes {
  std::vector<unsigned char> all;
  void u16(size_t v) {
    all.push_back(static_cast<unsigned char>(v)), all.push_back(static_cast<unsigned char>(v >> 8));
  }
  void u32(size_t v) { u16(v & 0xFFFFu), u16(v >> 16); }
  void text(const std::string& t) { all.insert(all.end(), t.begin(), t.end()); }
};

struct Stored {
  std::string name;
  size_t offset = 0, size = 0;
  uint32_t crc = 0;
  size_t extra = 0;  // bytes of the padding
};

void common(Bytes& out, const Stored& file) {
  out.u16(kVersion), out.u16(kUtf8Names), out.u16(0), out.u16(0), out.u16(kDate);
  out.u32(file.crc), out.u32(file.size), out.u32(file.size);
  out.u16(file.name.size()), out.u16(file.extra);
}

void padding(Bytes& out, size_t size) {
  if (size == 0) return;
  out.u16(kPaddingId), out.u16(size - kPaddingHead);
  out.all.insert(out.all.end(), size - kPaddingHead, 0);
}

/// Size of the extra field that aligns the data.
size_t padding_for(size_t data_at) {
  const size_t over = data_at % kAlignment;
  if (over == 0) return 0;
  const size_t need = kAlignment - over;
  return need >= kPaddingHead ? need : need + kAlignment;
}

/// Computes checksum and size of a file. False: it cannot be read.
bool measure(const std::string& path, Stored& out) {
  std::FILE* file = platform::open_stream(path, "rb");
  if (!file) return false;
  std::vector<unsigned char> block(size_t{1} << 20);
  uLong crc = crc32(0, nullptr, 0);
  for (size_t n = 0; (n = std::fread(block.data(), 1, block.size(), file)) > 0; out.size += n)
    crc = crc32(crc, block.data(), static_cast<uInt>(n));
  out.crc = static_cast<uint32_t>(crc);
  const bool read = std::ferror(file) == 0;
  std::fclose(file);
  return read;
}

bool append(std::FILE* to, const Bytes& bytes) {
  return std::fwrite(bytes.all.data(), 1, bytes.all.size(), to) == bytes.all.size();
}

bool append_file(std::FILE* to, const std::string& path, size_t size) {
  std::FILE* from = platform::open_stream(path, "rb");
  if (!from) return false;
  std::vector<unsigned char> block(size_t{1} << 20);
  size_t done = 0;
  for (size_t n = 0; (n = std::fread(block.data(), 1, block.size(), from)) > 0; done += n) {
    if (std::fwrite(block.data(), 1, n, to) != n) break;
  }
  std::fclose(from);
  return done == size;
}

Bytes directory(const std::vector<Stored>& files, size_t at) {
  Bytes out;
  for (const Stored& file : files) {
    out.u32(0x02014b50), out.u16(kMadeBy);
    common(out, file);
    out.u16(0), out.u16(0), out.u16(0), out.u32(0), out.u32(file.offset);
    out.text(file.name);
    padding(out, file.extra);
  }
  const size_t size = out.all.size();
  out.u32(0x06054b50), out.u16(0), out.u16(0), out.u16(files.size()), out.u16(files.size());
  out.u32(size), out.u32(at), out.u16(0);
  return out;
}

Result<void> write_entries(std::FILE* to, const std::vector<ZipEntry>& entries, ZipKind kind) {
  constexpr size_t kEnd = std::numeric_limits<uint32_t>::max();
  std::vector<Stored> files;
  size_t at = 0;
  for (const ZipEntry& entry : entries) {
    Stored file;
    file.name = entry.name, file.offset = at;
    if (!measure(entry.path, file)) return failure(ErrorKind::kOutput, tr("cannot be read"), entry.path);
    if (kind == ZipKind::kUsdz) file.extra = padding_for(at + kHead + file.name.size());
    Bytes head;
    head.u32(0x04034b50);
    common(head, file);
    head.text(file.name);
    padding(head, file.extra);
    at += head.all.size() + file.size;
    if (at > kEnd)
      return failure(ErrorKind::kOutput, tr("an archive cannot be larger than 4 GB; export smaller textures"));
    if (!append(to, head) || !append_file(to, entry.path, file.size)) return base::written_unless(cause_of(errno));
    files.push_back(file);
  }
  return base::written_unless(append(to, directory(files, at)) ? "" : cause_of(errno));
}

}  // namespace

uint64_t plain_zip_size(const std::vector<ZipEntry>& entries) {
  uint64_t size = kEndRecord;
  for (const ZipEntry& entry : entries) {
    std::error_code ec;
    const uintmax_t bytes = std::filesystem::file_size(entry.path, ec);
    size += kHead + kDirectoryHead + 2 * entry.name.size() + (ec ? 0 : bytes);
  }
  return size;
}

Result<void> write_zip(const std::string& path, const std::vector<ZipEntry>& entries, ZipKind kind) {
  if (entries.size() > 0xFFFF) return failure(ErrorKind::kOutput, tr("an archive holds at most 65535 files"), path);
  return write_through(path, [&](const std::string& beside) {
    std::FILE* file = platform::open_stream(beside, "wb");
    if (!file) return base::written_unless(cause_of(errno));
    Result<void> done = write_entries(file, entries, kind);
    if (std::fclose(file) != 0 && done) done = base::written_unless(cause_of(errno));
    return done;
  });
}

}  // namespace weftlight::files
