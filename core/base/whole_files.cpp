#include "base/whole_files.h"

#include <filesystem>
#include <utility>

#include "base/text.h"
#include "platform/durable_file.h"
#include "platform/file.h"
#include "platform/unique_name.h"

namespace weftlight::base {

namespace fs = std::filesystem;

using platform::File, platform::FileKind;

namespace {

Failure not_read(const std::string& path, std::string text) {
  return failure(ErrorKind::kInput, std::move(text), path);
}

Failure not_written(const std::string& path, const std::string& cause, ErrorKind kind = ErrorKind::kOutput) {
  return failure(kind, fill(tr("cannot be written: {cause}"), arg("cause", cause)), path);
}
Result<void> written(const std::string& path, const std::error_code& error) {
  if (!error) return {};
  // Some folders, such as /proc, say that there is no such file where they take none.
  std::error_code ignored;
  const fs::path folder = fs::path(path).parent_path();
  const bool takes_none = error == std::errc::no_such_file_or_directory &&
                          fs::is_directory(folder.empty() ? fs::path(".") : folder, ignored);
  return not_written(path, takes_none ? tr("its folder cannot be written to") : cause_of(error));
}
Result<void> written(const std::string& path, const Result<void>& by_library) {
  if (by_library) return {};
  return not_written(path, message(by_library.error()), by_library.error().kind);
}

/// Whether `path` names a file.
Result<void> check_name(const std::string& path, FileKind kind) {
  if (path.empty()) return failure(ErrorKind::kOutput, tr("no file name is given"));
  if (kind == FileKind::kFolder) return failure(ErrorKind::kOutput, tr("is a folder; give the name of a file"), path);
  return {};
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

Result<void> write_to_stream(const std::string& path, std::string_view bytes) {
  File file(path, File::Open::kWrite);
  return written(path, write_and_close(file, bytes));
}

Result<void> written_by(const WriteFile& write, const std::string& beside) {
  try {
    return write(beside);
  } catch (...) {
    return thrown(ErrorKind::kOutput);
  }
}

/// The library writes a temporary file, whose bytes then go to the stream in order.
Result<void> write_stream_through(const std::string& path, const WriteFile& write) {
  std::error_code error;
  const std::string made =
      platform::temporary_beside((fs::temp_directory_path(error) / fs::path(path).filename()).string());
  Result<void> done = written(path, written_by(write, made));
  if (done) {
    const Result<std::string> bytes = read_file(made);
    done = bytes ? write_to_stream(path, *bytes) : not_written(path, bytes.error().text);
  }
  fs::remove(made, error);
  return done;
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
  if (platform::is_over_quota(error)) return tr("your disk quota is full");
  for (const auto& [cause, text] : kTexts)
    if (error == cause) return tr(text);
  return error.message();
}

std::string cause_of(int error_number) { return cause_of(std::error_code(error_number, std::generic_category())); }

Result<std::string> read_file(const std::string& path, uint64_t max_bytes, const std::stop_token& stop) {
  File file(path, File::Open::kRead);
  if (file.error() == std::errc::no_such_file_or_directory) return not_read(path, tr("there is no such file"));
  if (file.error()) return not_read(path, fill(tr("cannot be opened: {cause}"), arg("cause", cause_of(file.error()))));
  const platform::FileFacts facts = file.facts();
  if (facts.kind == FileKind::kFolder) return not_read(path, tr("is a folder"));
  if (facts.kind != FileKind::kRegular) return not_read(path, tr("is a pipe or a device, not a file"));
  const std::string too_large = fill(tr("is larger than {size} MiB"), arg("size", max_bytes >> 20));
  if (facts.size > max_bytes) return not_read(path, too_large);
  std::string bytes;
  bytes.reserve(static_cast<size_t>(facts.size));
  char buffer[65536];
  std::error_code error;
  while (const size_t got = file.read(buffer, sizeof buffer, error)) {
    if (stop.stop_requested()) return not_read(path, tr("could not be read completely"));
    bytes.append(buffer, got);
    if (bytes.size() > max_bytes) return not_read(path, too_large);
  }
  if (error) return not_read(path, fill(tr("cannot be read: {cause}"), arg("cause", cause_of(error))));
  return bytes;
}

Result<void> written_unless(std::string problem) {
  if (problem.empty()) return {};
  return failure(ErrorKind::kOutput, std::move(problem));
}

Result<void> check_writable(const std::string& path) {
  const FileKind kind = platform::file_facts(path).kind;
  if (platform::is_open_stream(path)) return {};
  if (kind == FileKind::kStream) return written(path, platform::why_not_writable(path));
  if (Result<void> name = check_name(path, kind); !name) return name;
  return written(path, platform::why_not_replaced(path));
}

Result<void> write_through(const std::string& path, const WriteFile& write) {
  const FileKind kind = platform::file_facts(path).kind;
  if (is_stream(path, kind)) return write_stream_through(path, write);
  if (Result<void> name = check_name(path, kind); !name) return name;
  platform::DurableFile file(path);
  if (file.error()) return written(path, file.error());
  if (const Result<void> made = written_by(write, file.beside()); !made) return written(path, made);
  return written(path, file.put_in_place());
}

Result<void> write_file_atomically(const std::string& path, std::string_view bytes) {
  if (is_stream(path, platform::file_facts(path).kind)) return write_to_stream(path, bytes);
  return write_through(path, [bytes](const std::string& beside) {
    File file(beside, File::Open::kReplace);
    std::error_code error = file.error() ? file.error() : file.write(bytes);
    if (!error) error = file.close();
    return written_unless(error ? cause_of(error) : std::string());
  });
}

}  // namespace weftlight::base
