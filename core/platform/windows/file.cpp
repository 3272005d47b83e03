#include "platform/file.h"

#include <windows.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "platform/windows/open_handle.h"
#include "platform/windows/wide.h"

namespace weftlight::platform {
namespace {

constexpr DWORD kAppend = FILE_APPEND_DATA | SYNCHRONIZE;
constexpr DWORD kMaxPart = 1u << 30;  // of one read or write

uint64_t joined(DWORD high, DWORD low) { return (uint64_t{high} << 32) | low; }

FileFacts facts_of(HANDLE handle) {
  constexpr int64_t kTicksTo1970 = 116'444'736'000'000'000;  // of 100 ns since 1601
  FileFacts facts;
  const DWORD type = ::GetFileType(handle);
  if (type == FILE_TYPE_CHAR || type == FILE_TYPE_PIPE) facts.kind = FileKind::kStream;
  BY_HANDLE_FILE_INFORMATION info{};
  if (type != FILE_TYPE_DISK || ::GetFileInformationByHandle(handle, &info) == 0) return facts;
  const bool folder = (info.dwFileAttributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
  facts.kind = folder ? FileKind::kFolder : FileKind::kRegular;
  facts.volume = info.dwVolumeSerialNumber;
  facts.number = joined(info.nFileIndexHigh, info.nFileIndexLow);
  facts.size = joined(info.nFileSizeHigh, info.nFileSizeLow);
  const auto ticks =
      static_cast<int64_t>(joined(info.ftLastWriteTime.dwHighDateTime, info.ftLastWriteTime.dwLowDateTime));
  facts.modified_ns = (ticks - kTicksTo1970) * 100;
  return facts;
}

/// The names that the other systems have for the open streams.
std::optional<DWORD> stream_named(const std::string& path) {
  if (path == "/dev/stdout" || path == "/dev/fd/1") return STD_OUTPUT_HANDLE;
  if (path == "/dev/stderr" || path == "/dev/fd/2") return STD_ERROR_HANDLE;
  return std::nullopt;
}

HANDLE copy_of_stream(DWORD stream) {
  HANDLE copy = INVALID_HANDLE_VALUE;
  const HANDLE self = ::GetCurrentProcess();
  const BOOL copied = ::DuplicateHandle(self, ::GetStdHandle(stream), self, &copy, 0, FALSE, DUPLICATE_SAME_ACCESS);
  return copied != 0 ? copy : INVALID_HANDLE_VALUE;
}

OpenHandle open_file(const std::string& path, File::Open how) {
  switch (how) {
    case File::Open::kRead:  // a folder can be opened, and is then known as one
      return open_shared(path, GENERIC_READ, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS);
    case File::Open::kWrite:
      if (const std::optional<DWORD> stream = stream_named(path)) return OpenHandle(copy_of_stream(*stream));
      return open_shared(path, GENERIC_WRITE, OPEN_EXISTING);
    case File::Open::kReplace:
      return open_shared(path, GENERIC_WRITE, TRUNCATE_EXISTING);
    case File::Open::kAppend:
      return open_shared(path, kAppend, OPEN_EXISTING);
    case File::Open::kCreate:
      return open_shared(path, kAppend, CREATE_NEW);
  }
  return nullptr;
}

/// Only files on a disk can be synced, and not on every share.
std::error_code sync_handle(HANDLE handle) {
  if (::GetFileType(handle) != FILE_TYPE_DISK || ::FlushFileBuffers(handle) != 0) return {};
  const DWORD error = ::GetLastError();
  if (error == ERROR_INVALID_FUNCTION || error == ERROR_NOT_SUPPORTED) return {};
  return last_error();
}

HANDLE handle_of(std::intptr_t handle) { return reinterpret_cast<HANDLE>(handle); }

DWORD attributes_of(const std::string& path) { return ::GetFileAttributesW(wide(path).c_str()); }

std::error_code done(BOOL success) { return success != 0 ? std::error_code() : last_error(); }

}  // namespace

OpenHandle open_shared(const std::string& path, DWORD access, DWORD how, DWORD flags) {
  constexpr DWORD kAll = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
  return OpenHandle(
      ::CreateFileW(wide(path).c_str(), access, kAll, nullptr, how, flags | FILE_ATTRIBUTE_NORMAL, nullptr));
}

FileFacts file_facts(const std::string& path) {
  const OpenHandle handle = open_shared(path, FILE_READ_ATTRIBUTES, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS);
  return is_open(handle) ? facts_of(handle.get()) : FileFacts{};
}

File::File(const std::string& path, Open how) {
  OpenHandle handle = open_file(path, how);
  if (is_open(handle)) handle_ = reinterpret_cast<std::intptr_t>(handle.release());
  else error_ = last_error();
}

File::~File() { close(); }

FileFacts File::facts() const { return handle_ < 0 ? FileFacts{} : facts_of(handle_of(handle_)); }

size_t File::read(char* to, size_t size, std::error_code& error) {
  DWORD got = 0;
  if (::ReadFile(handle_of(handle_), to, static_cast<DWORD>(std::min<size_t>(size, kMaxPart)), &got, nullptr) != 0)
    return got;
  // The other end of a pipe that is closed is its end.
  if (::GetLastError() != ERROR_BROKEN_PIPE && ::GetLastError() != ERROR_HANDLE_EOF) error = last_error();
  return 0;
}

std::error_code File::write(std::string_view bytes) {
  while (!bytes.empty()) {
    DWORD written = 0;
    const auto part = static_cast<DWORD>(std::min<size_t>(bytes.size(), kMaxPart));
    if (::WriteFile(handle_of(handle_), bytes.data(), part, &written, nullptr) == 0) return last_error();
    bytes.remove_prefix(written);
  }
  return {};
}

std::error_code File::sync() { return sync_handle(handle_of(handle_)); }

std::error_code File::close() {
  const std::intptr_t handle = std::exchange(handle_, -1);
  return handle < 0 ? std::error_code() : done(::CloseHandle(handle_of(handle)));
}

std::FILE* open_stream(const std::string& path, const char* mode) {
  return ::_wfopen(wide(path).c_str(), wide(mode).c_str());
}

bool is_open_stream(const std::string& path) { return stream_named(path).has_value(); }

std::error_code why_not_writable(const std::string& path) {
  const DWORD attributes = attributes_of(path);
  if (attributes == INVALID_FILE_ATTRIBUTES) return last_error();
  const bool folder = (attributes & FILE_ATTRIBUTE_DIRECTORY) != 0;
  // Read-only on a folder means that it looks special in the file manager.
  if (!folder && (attributes & FILE_ATTRIBUTE_READONLY) != 0) return std::make_error_code(std::errc::permission_denied);
  const OpenHandle handle = folder ? open_shared(path, FILE_ADD_FILE, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS)
                                   : open_shared(path, GENERIC_WRITE, OPEN_EXISTING);
  return is_open(handle) ? std::error_code() : last_error();
}

std::vector<std::string> names_in(const std::string& folder, std::error_code& error) {
  error.clear();
  std::vector<std::string> names;
  WIN32_FIND_DATAW found{};
  const HANDLE search = ::FindFirstFileW((wide(folder) + L"\\*").c_str(), &found);
  if (search == INVALID_HANDLE_VALUE) {
    if (::GetLastError() != ERROR_FILE_NOT_FOUND) error = last_error();  // the root of an empty disk holds not even "."
    if (file_facts(folder).kind == FileKind::kRegular) error = std::make_error_code(std::errc::not_a_directory);
    return names;
  }
  const auto close = [](void* open) { ::FindClose(open); };
  const std::unique_ptr<void, decltype(close)> open(search, close);
  do {
    const std::wstring_view name = found.cFileName;
    if (name != L"." && name != L"..") names.push_back(narrow(name));
  } while (::FindNextFileW(search, &found) != 0);
  if (::GetLastError() != ERROR_NO_MORE_FILES) error = last_error();
  return names;
}

std::error_code rename(const std::string& from, const std::string& to) {
  constexpr int kTries = 20;
  constexpr DWORD kPauseMs = 15;
  const std::wstring old_name = wide(from), new_name = wide(to);
  const DWORD there = attributes_of(to), moved = attributes_of(from);
  const auto is_folder = [](DWORD of) { return of != INVALID_FILE_ATTRIBUTES && (of & FILE_ATTRIBUTE_DIRECTORY) != 0; };
  // Nothing takes the place of a folder by itself. Only an empty one goes.
  if (is_folder(there) && is_folder(moved) && ::RemoveDirectoryW(new_name.c_str()) == 0) return last_error();
  for (int i = 0;; ++i) {
    if (::MoveFileExW(old_name.c_str(), new_name.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) != 0)
      return {};
    // Programs that watch for viruses, or fill an index, hold a new file open for a moment.
    const DWORD error = ::GetLastError();
    if (i == kTries || (error != ERROR_SHARING_VIOLATION && error != ERROR_ACCESS_DENIED)) return last_error();
    ::Sleep(kPauseMs);
  }
}

std::error_code remove_with_contents(const std::string& path) {
  const DWORD attributes = attributes_of(path);
  if (attributes == INVALID_FILE_ATTRIBUTES) {
    const std::error_code error = last_error();
    return error == std::errc::no_such_file_or_directory ? std::error_code() : error;
  }
  const std::wstring name = wide(path);
  if ((attributes & FILE_ATTRIBUTE_READONLY) != 0) ::SetFileAttributesW(name.c_str(), FILE_ATTRIBUTE_NORMAL);
  if ((attributes & FILE_ATTRIBUTE_DIRECTORY) == 0) return done(::DeleteFileW(name.c_str()));
  // A link to a folder goes as a folder does, and what it leads to stays.
  if ((attributes & FILE_ATTRIBUTE_REPARSE_POINT) == 0) {
    std::error_code error;
    for (const std::string& inside : names_in(path, error))
      if (const std::error_code failed = remove_with_contents(path + "\\" + inside)) return failed;
    if (error) return error;
  }
  return done(::RemoveDirectoryW(name.c_str()));
}

std::error_code sync(const std::string& path) {
  const DWORD attributes = attributes_of(path);
  if (attributes == INVALID_FILE_ATTRIBUTES) return last_error();
  // Which files a folder holds is on the disk when rename() comes back.
  if ((attributes & FILE_ATTRIBUTE_DIRECTORY) != 0) return {};
  const OpenHandle handle = open_shared(path, GENERIC_WRITE, OPEN_EXISTING);
  return is_open(handle) ? sync_handle(handle.get()) : last_error();
}

bool is_over_quota(const std::error_code& error) {
  constexpr int kQuotaExceeded = 1295;  // ERROR_DISK_QUOTA_EXCEEDED, which not all headers have
  return error.category() == std::system_category() && error.value() == kQuotaExceeded;
}

void survive_size_limit() {}  // there is no such limit

}  // namespace weftlight::platform
