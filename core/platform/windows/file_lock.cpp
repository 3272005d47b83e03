#include "platform/file_lock.h"

#include <windows.h>

#include "platform/file.h"
#include "platform/windows/open_handle.h"
#include "platform/windows/wide.h"

namespace weftlight::platform {
namespace {

/// Of one byte that no file reaches: a locked byte can be neither read nor written by others.
BOOL lock_handle(HANDLE handle, bool wait) {
  constexpr uint64_t kByte = INT64_MAX / 2;
  OVERLAPPED place{};
  place.Offset = static_cast<DWORD>(kByte);
  place.OffsetHigh = static_cast<DWORD>(kByte >> 32);
  const DWORD how = LOCKFILE_EXCLUSIVE_LOCK | (wait ? 0 : LOCKFILE_FAIL_IMMEDIATELY);
  return ::LockFileEx(handle, how, 0, 1, 0, &place);
}

}  // namespace

FileLock::~FileLock() {
  if (handle_ >= 0) ::CloseHandle(reinterpret_cast<HANDLE>(handle_));
}

/// `flags`: OPEN_ALWAYS and the like; `mode`: flags of the file.
FileLock FileLock::open(const std::string& path, int flags, unsigned mode, bool wait) {
  FileLock lock;
  OpenHandle handle = open_shared(path, GENERIC_READ | GENERIC_WRITE, static_cast<DWORD>(flags), mode);
  if (!is_open(handle)) {
    lock.cause_ = last_error();
    return lock;
  }
  BY_HANDLE_FILE_INFORMATION info{};
  const bool known = ::GetFileInformationByHandle(handle.get(), &info) != 0;
  if (known && (info.dwFileAttributes & FILE_ATTRIBUTE_REPARSE_POINT) != 0 && mode != 0) {
    lock.cause_ = std::make_error_code(std::errc::too_many_symbolic_link_levels);
    return lock;
  }
  if (lock_handle(handle.get(), wait) != 0) {
    lock.answer_ = LockAnswer::kHeld;
  } else {
    const DWORD error = ::GetLastError();
    lock.cause_ = last_error();
    const bool taken = error == ERROR_LOCK_VIOLATION || error == ERROR_IO_PENDING;
    lock.answer_ = taken ? LockAnswer::kTaken : LockAnswer::kNoLocks;
  }
  lock.handle_ = reinterpret_cast<std::intptr_t>(handle.release());
  return lock;
}

FileLock FileLock::take(const std::string& path) { return open(path, OPEN_ALWAYS, 0, false); }
FileLock FileLock::wait_for(const std::string& path) { return open(path, OPEN_ALWAYS, 0, true); }
FileLock FileLock::take_existing(const std::string& path) {
  return open(path, OPEN_EXISTING, FILE_FLAG_OPEN_REPARSE_POINT, false);
}
FileLock FileLock::make(const std::string& path) { return open(path, CREATE_NEW, 0, false); }

bool FileLock::stands_at(const std::string& path) const {
  BY_HANDLE_FILE_INFORMATION held{};
  if (handle_ < 0 || ::GetFileInformationByHandle(reinterpret_cast<HANDLE>(handle_), &held) == 0) return false;
  const FileFacts there = file_facts(path);
  const uint64_t number = (uint64_t{held.nFileIndexHigh} << 32) | held.nFileIndexLow;
  return there.kind != FileKind::kNone && there.volume == held.dwVolumeSerialNumber && there.number == number;
}

}  // namespace weftlight::platform
