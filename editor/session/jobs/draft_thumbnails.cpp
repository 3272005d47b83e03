#include "session/jobs/draft_thumbnails.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "base/user_folders.h"
#include "files/files.h"
#include "files/picture_draft.h"
#include "session/files/file_identity.h"
#include "wif/other_formats.h"

namespace weftlight::session {

using base::content_hash, base::keep_newest, base::read_file;
using wif::read_draft, wif::WifFile;

namespace {

namespace fs = std::filesystem;
constexpr uint64_t kMaxBytes = uint64_t{1} << 26;  // larger files have no thumbnail
constexpr int kVersion = 2;                        // of the thumbnails; a new version makes them again

/// A file name that depends on the path, its size and its time.
std::string name_in_cache(const std::string& path, const FileIdentity& facts) {
  uint64_t hash = content_hash(path);
  for (const uint64_t number : {facts.size, static_cast<uint64_t>(facts.modified_ns), uint64_t{kVersion}})
    hash = content_hash(std::string(" ").append(std::to_string(number)), hash);
  char name[24];
  std::snprintf(name, sizeof name, "%016llx.png", static_cast<unsigned long long>(hash));
  return name;
}

Thumbnail kept_picture(const std::string& file) {
  const base::Result<files::Image> read = files::read_image(file);
  if (!read || read->width != kThumbnailWidth || read->height != kThumbnailHeight || read->channels < 3) return {};
  Thumbnail out{kThumbnailWidth, kThumbnailHeight, {}};
  const auto channels = static_cast<size_t>(read->channels);
  for (size_t at = 0; at + channels <= read->texels.size(); at += channels) {
    const auto byte = [&](size_t i) {
      return static_cast<uint32_t>(std::lround(std::clamp(read->texels[at + i], 0.0f, 1.0f) * 255));
    };
    out.pixels.push_back(byte(0) | byte(1) << 8 | byte(2) << 16 | 0xFF000000u);
  }
  return out;
}

void keep_picture(const std::string& folder, const std::string& file, const Thumbnail& picture) {
  std::error_code ignored;  // without a cache the thumbnail is made again next time
  fs::create_directories(folder, ignored);
  files::Image image{picture.width, picture.height, 3, {}};
  for (const uint32_t pixel : picture.pixels)
    for (const int shift : {0, 8, 16}) image.texels.push_back(static_cast<float>((pixel >> shift) & 255) / 255);
  files::write_image(file, image, files::PixelType::kU8);
  keep_newest(folder, ".png", kMaxThumbnails, file);
}

}  // namespace

DraftThumbnail look_of_file(const std::string& path, const std::string& cache_folder, const std::stop_token& stop) {
  DraftThumbnail look;
  const FileIdentity facts = facts_of(path);
  if (!facts.there) return look;
  look.modified_ns = facts.modified_ns;
  const std::string kept = cache_folder.empty() ? "" : cache_folder + "/" + name_in_cache(path, facts);
  if (std::error_code error; !kept.empty() && fs::exists(kept, error)) look.picture = kept_picture(kept);
  if (look.picture.pixels.empty()) {
    const base::Result<WifFile> file = read_file(path, kMaxBytes, stop).and_then([&path](const std::string& bytes) {
      return (files::is_picture(path) ? files::read_picture_draft(path) : read_draft(bytes)).file;
    });
    if (file) look.picture = thumbnail_of(file->design, kThumbnailWidth, kThumbnailHeight);
    if (!kept.empty() && !look.picture.pixels.empty()) keep_picture(cache_folder, kept, look.picture);
  }
  look.state = look.picture.pixels.empty() ? DraftThumbnail::State::kUnreadable : DraftThumbnail::State::kThere;
  return look;
}

DraftThumbnails::DraftThumbnails(std::string cache_folder, std::function<void()> wake)
    : cache_folder_(std::move(cache_folder)), runner_(std::move(wake)) {}

void DraftThumbnails::ask(const std::string& path) {
  base::Task task = base::task_with_result(
      [path, folder = cache_folder_](const base::RunningTask& running) {
        return look_of_file(path, folder, running.stop());
      },
      [this, path](base::Result<DraftThumbnail> look) {
        DraftThumbnail unreadable{DraftThumbnail::State::kUnreadable, 0, {}};
        made_.emplace_back(path, std::move(look).value_or(std::move(unreadable)));
      });
  task.kind = path;
  task.may_be_left = true;
  runner_.start(std::move(task));
}

std::vector<std::pair<std::string, DraftThumbnail>> DraftThumbnails::take() {
  runner_.take();
  return std::exchange(made_, {});
}

}  // namespace weftlight::session
