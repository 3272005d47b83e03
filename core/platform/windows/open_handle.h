#pragma once
// A handle of Windows, which is closed with its owner.

#include <windows.h>

#include <memory>
#include <string>

namespace weftlight::platform {

struct CloseHandleOf {
  void operator()(void* handle) const {
    if (handle != INVALID_HANDLE_VALUE) ::CloseHandle(handle);
  }
};
using OpenHandle = std::unique_ptr<void, CloseHandleOf>;
inline bool is_open(const OpenHandle& handle) { return handle && handle.get() != INVALID_HANDLE_VALUE; }

/// Opens a file or a folder so that others may read, write, rename and remove it meanwhile, as everywhere else.
/// `how`: OPEN_EXISTING and the like.
OpenHandle open_shared(const std::string& path, DWORD access, DWORD how, DWORD flags = 0);

}  // namespace weftlight::platform
