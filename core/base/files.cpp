#include "base/files.h"

#include <filesystem>
#include <utility>

#include "base/caught.h"
#include "base/text.h"
#include "platform/durable_file.h"
#include "platform/file.h"
#include "platform/unique_name.h"

namespace weftlight::base {

namespace fs = std::filesystem;

using platform::File, platform::FileKind;

namespace {

std::string not_read(const std::error_code& error) {
  return fill(tr("cannot be read: {cause}"), arg("cause", cause_of(error)));
}

std::string not_written(const std::string& path, const std::string& cause) {
  return fill(tr("{file}: cannot be written: {cause}"), arg("file", path), arg("cause", cause));
}
std::string not_written(const std::string& path, const std::error_code& error) {
  return error ? not_written(path, cause_of(error)) : std::string();
}

/// Why `path` names no file, or empty.
std::string not_a_file(const std::string& path, FileKind kind) {
  if (path.empty()) return tr("no file name is given");
  return kind == FileKind::kFolder ? fill(tr("{file}: is a folder; give the name of a file"), arg("file", path)) : "";
}

/// Devices, pipes and the standard streams take bytes in order; nothing can be put in their place.
bool is_stream(const std::string& path, FileKind kind) {
  return kind == FileKind::kStream || platform::is_open_stream(path);
}

std::error_code write_and_close(File& file, std::string_view bytes) {
  std::error_code error = file.error();
  if (!error) error = file.write(bytes);
  if (!error) error = file.sync();
  return error ? error : file.close();
}

std::string write_to_stream(const std::string& path, std::string_view bytes) {
  File file(path, File::Open::kWrite);
  return not_written(path, write_and_close(file, bytes));
}

std::string written_by(const WriteFile& write, const std::string& beside) {
  try {
    return write(beside);
  } catch (...) {
    return words_of_thrown();
  }
}

/// The library writes a temporary file, whose bytes then go to the stream in order.
std::string write_stream_through(const std::string& path, const WriteFile& write) {
  std::error_code error;
  const std::string made =
      platform::temporary_beside((fs::temp_directory_path(error) / fs::path(path).filename()).string());
  std::string problem = written_by(write, made);
  if (!problem.empty()) problem = not_written(path, problem);
  if (problem.empty()) {
    const FileBytes file = read_file(made);
    problem = file.error.empty() ? write_to_stream(path, file.bytes) : not_written(path, file.error);
  }
  fs::remove(made, error);
  return problem;
}

}  // namespace

std::string cause_of(const std::error_code& error) {
  static constexpr std::pair<std::errc, const char*> kTexts[] = {
      {std::errc::no_space_on_device, mark("the disk is full")},
      {std::errc::permission_denied, mark("it or its folder is read-only (permission denied)")},
      {std::errc::operation_not_permitted, mark("it or its folder is read-only (permission denied)")},
      {std::errc::read_only_file_system, mark("the disk is read-only")},
      {std::errc::no_such_file_or_directory, mark("its folder does not exist")},
      {std::errc::not_a_directory, mark("its folder is a file")},
      {std::errc::io_error, mark("the disk failed (input/output error)")},
      {std::errc::file_too_large, mark("it is larger than the system allows")},
      {std::errc::filename_too_long, mark("its name is too long")},
  };
  if (platform::is_over_quota(error)) return tr("your quota of the disk is full");
  for (const auto& [cause, text] : kTexts)
    if (error == cause) return tr(text);
  return error.message();
}

std::string cause_of(int error_number) { return cause_of(std::error_code(error_number, std::generic_category())); }

FileBytes read_file(const std::string& path, uint64_t max_bytes) {
  File file(path, File::Open::kRead);
  if (file.error() == std::errc::no_such_file_or_directory) return {{}, tr("there is no such file")};
  if (file.error()) return {{}, fill(tr("cannot be opened: {cause}"), arg("cause", cause_of(file.error())))};
  const platform::FileFacts facts = file.facts();
  if (facts.kind == FileKind::kFolder) return {{}, tr("is a folder")};
  if (facts.kind != FileKind::kRegular) return {{}, tr("is a pipe or a device, not a file")};
  const std::string too_large = fill(tr("is larger than {size} MiB"), arg("size", max_bytes >> 20));
  if (facts.size > max_bytes) return {{}, too_large};
  FileBytes result;
  result.bytes.reserve(static_cast<size_t>(facts.size));
  char buffer[65536];
  std::error_code error;
  while (const size_t got = file.read(buffer, sizeof buffer, error)) {
    result.bytes.append(buffer, got);
    if (result.bytes.size() > max_bytes) return {{}, too_large};
  }
  return error ? FileBytes{{}, not_read(error)} : result;
}

std::string why_not_writable(const std::string& path) {
  const FileKind kind = platform::file_facts(path).kind;
  if (platform::is_open_stream(path)) return {};
  if (kind == FileKind::kStream) return not_written(path, platform::why_not_writable(path));
  if (std::string problem = not_a_file(path, kind); !problem.empty()) return problem;
  return not_written(path, platform::why_not_replaced(path));
}

std::string write_through(const std::string& path, const WriteFile& write) {
  const FileKind kind = platform::file_facts(path).kind;
  if (is_stream(path, kind)) return write_stream_through(path, write);
  if (std::string problem = not_a_file(path, kind); !problem.empty()) return problem;
  platform::DurableFile file(path);
  if (file.error()) return not_written(path, file.error());
  if (const std::string problem = written_by(write, file.beside()); !problem.empty()) return not_written(path, problem);
  return not_written(path, file.put_in_place());
}

std::string write_file_atomically(const std::string& path, std::string_view bytes) {
  if (is_stream(path, platform::file_facts(path).kind)) return write_to_stream(path, bytes);
  return write_through(path, [bytes](const std::string& beside) -> std::string {
    File file(beside, File::Open::kReplace);
    std::error_code error = file.error() ? file.error() : file.write(bytes);
    if (!error) error = file.close();
    return error ? cause_of(error) : std::string();
  });
}

}  // namespace weftlight::base
