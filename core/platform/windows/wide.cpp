#include "platform/windows/wide.h"

#include <windows.h>

#include <cwchar>
#include <utility>

namespace weftlight::platform {

std::wstring wide(std::string_view text) {
  const int length = static_cast<int>(text.size());
  std::wstring out(static_cast<size_t>(::MultiByteToWideChar(CP_UTF8, 0, text.data(), length, nullptr, 0)), L'\0');
  ::MultiByteToWideChar(CP_UTF8, 0, text.data(), length, out.data(), static_cast<int>(out.size()));
  return out;
}

std::string narrow(std::wstring_view text) {
  const int length = static_cast<int>(text.size());
  const int size = ::WideCharToMultiByte(CP_UTF8, 0, text.data(), length, nullptr, 0, nullptr, nullptr);
  std::string out(static_cast<size_t>(size), '\0');
  ::WideCharToMultiByte(CP_UTF8, 0, text.data(), length, out.data(), size, nullptr, nullptr);
  return out;
}

std::error_code last_error() {
  // Those that a user may meet, in the words of the C++ library; some the library itself takes for others or for none.
  static constexpr std::pair<DWORD, std::errc> kKnown[] = {
      {ERROR_FILE_NOT_FOUND, std::errc::no_such_file_or_directory},
      {ERROR_PATH_NOT_FOUND, std::errc::no_such_file_or_directory},
      {ERROR_INVALID_NAME, std::errc::no_such_file_or_directory},
      {ERROR_BAD_NETPATH, std::errc::no_such_file_or_directory},
      {ERROR_ACCESS_DENIED, std::errc::permission_denied},
      {ERROR_SHARING_VIOLATION, std::errc::device_or_resource_busy},
      {ERROR_LOCK_VIOLATION, std::errc::resource_unavailable_try_again},
      {ERROR_FILE_EXISTS, std::errc::file_exists},
      {ERROR_ALREADY_EXISTS, std::errc::file_exists},
      {ERROR_DISK_FULL, std::errc::no_space_on_device},
      {ERROR_HANDLE_DISK_FULL, std::errc::no_space_on_device},
      {ERROR_FILE_TOO_LARGE, std::errc::file_too_large},
      {ERROR_FILENAME_EXCED_RANGE, std::errc::filename_too_long},
      {ERROR_WRITE_PROTECT, std::errc::read_only_file_system},
      {ERROR_DIR_NOT_EMPTY, std::errc::directory_not_empty},
      {ERROR_DIRECTORY, std::errc::not_a_directory},
      {ERROR_CRC, std::errc::io_error},
      {ERROR_IO_DEVICE, std::errc::io_error},
      {ERROR_NOT_ENOUGH_MEMORY, std::errc::not_enough_memory},
      {ERROR_BROKEN_PIPE, std::errc::broken_pipe},
      {ERROR_NO_DATA, std::errc::broken_pipe},
  };
  const DWORD last = ::GetLastError();
  for (const auto& [ours, theirs] : kKnown)
    if (last == ours) return std::make_error_code(theirs);
  return {static_cast<int>(last), std::system_category()};
}

}  // namespace weftlight::platform

#if defined(__MINGW32__) && !defined(_UCRT)

// Texts are UTF-8 in this program, names of files included. The C++ library of GCC 12 turns them into the UTF-16 of
// Windows (std::filesystem::path) letter by letter with mbrtowc(), whose letters are those of the C library's locale,
// and the C library of mingw-w64 (msvcrt) has no locale with UTF-8. So this function takes the place of its own.
// It stands in this file because a linker takes it from a library only with something else that is needed.

namespace {

constexpr size_t kError = static_cast<size_t>(-1), kMore = static_cast<size_t>(-2);

/// How many bytes a letter has that begins with this one; 0 if none does.
int length_of(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

}  // namespace

/// A letter beyond U+FFFF gives two halves: the second is kept in `state`, as all that is kept there.
extern "C" size_t mbrtowc(wchar_t* to, const char* from, size_t size, mbstate_t* state) {
  constexpr size_t kBeforeSecondHalf = 3;
  static mbstate_t unnamed = 0;
  if (state == nullptr) state = &unnamed;
  if (from == nullptr) return 0;
  if (size == 0) return kMore;
  if (*state != 0) {
    if (to != nullptr) *to = static_cast<wchar_t>(*state);
    *state = 0;
    return 1;
  }
  const int length = length_of(static_cast<unsigned char>(*from));
  if (length == 0) return kError;
  if (size < static_cast<size_t>(length)) return kMore;
  unsigned letter = static_cast<unsigned char>(*from) & (length == 1 ? 0x7Fu : 0x7Fu >> length);
  for (int i = 1; i < length; ++i) {
    const auto next = static_cast<unsigned char>(from[i]);
    if ((next & 0xC0u) != 0x80u) return kError;
    letter = (letter << 6) | (next & 0x3Fu);
  }
  const bool halves = letter > 0xFFFF;
  if (halves) *state = static_cast<mbstate_t>(0xDC00u + (letter & 0x3FFu));
  if (to != nullptr) *to = static_cast<wchar_t>(halves ? 0xD800u + ((letter - 0x10000u) >> 10) : letter);
  if (letter == 0) return 0;
  return halves ? kBeforeSecondHalf : static_cast<size_t>(length);
}

/// Stands in the C library beside that one, so whoever asked for this one would get that one twice.
extern "C" size_t mbrlen(const char* from, size_t size, mbstate_t* state) {
  static mbstate_t unnamed = 0;
  return mbrtowc(nullptr, from, size, state == nullptr ? &unnamed : state);
}

#endif
