#pragma once
// Files of the system: bytes in and out, what is known of a file without reading it, and the way to the disk. Errors
// are those of the system, and compare with std::errc.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace weftlight::platform {

enum class FileKind {
  kNone,  // there is none, or it cannot be asked
  kRegular,
  kFolder,
  kStream,  // a pipe, a device or the like: bytes in order only
};

/// What the system knows of a file. Volume and number together name one file among all of this machine while it exists.
struct FileFacts {
  FileKind kind = FileKind::kNone;
  uint64_t volume = 0, number = 0;
  uint64_t size = 0;        // bytes
  int64_t modified_ns = 0;  // since 1970
};
/// Follows symbolic links, and never reads the file.
FileFacts file_facts(const std::string& path);

/// An open file, unbuffered. Started programs do not inherit it.
class File {
 public:
  enum class Open {
    kRead,     // never waits, as for the writer of a pipe
    kWrite,    // an existing file, from its start; or a stream of this process (is_open_stream)
    kReplace,  // an existing file, emptied
    kAppend,   // an existing file, at its end
    kCreate,   // a new file, which its user alone can read; an error if there is one. Writes at its end
  };
  File(const std::string& path, Open how);
  ~File();
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  /// Why it was not opened; no error if it was.
  const std::error_code& error() const { return error_; }
  /// Of the open file, whatever stands at its path by now.
  FileFacts facts() const;
  /// Reads up to `size` bytes; 0 at the end, or with an error.
  size_t read(char* to, size_t size, std::error_code& error);
  /// Writes all bytes.
  std::error_code write(std::string_view bytes);
  /// Waits until what was written is on the disk. No error where nothing can be: pipes, terminals, some shares.
  std::error_code sync();
  /// A full disk may be reported only here. Closed once; the destructor drops the error.
  std::error_code close();

 private:
  std::intptr_t handle_ = -1;
  std::error_code error_;
};

/// As std::fopen, which reads names in another encoding than UTF-8 on some systems.
std::FILE* open_stream(const std::string& path, const char* mode);
/// True for names of the open streams of this process, such as /dev/stdout, which File continues at their position.
bool is_open_stream(const std::string& path);
/// Why this program may not write the existing file, or make files in the existing folder. Nothing is written.
std::error_code why_not_writable(const std::string& path);
/// The names of what a folder holds, in any order, without "." and "..". Without memory it throws std::bad_alloc;
/// libstdc++'s directory_iterator would end the program.
std::vector<std::string> names_in(const std::string& folder, std::error_code& error);
/// Gives a file or a folder another name on the same volume, in one step: a file replaces a file, a folder an empty
/// folder or none.
std::error_code rename(const std::string& from, const std::string& to);
/// Removes a file, or a folder with all that it holds; a link goes, and what it leads to stays. No error if there is
/// none. Under POSIX it needs no memory.
std::error_code remove_with_contents(const std::string& path);
/// Waits until the content of the file is on the disk, or which files the folder holds.
std::error_code sync(const std::string& path);
/// Whether the error says that the user's share of the disk is used up, for which std::errc has no name.
bool is_over_quota(const std::error_code& error);
/// From now on a write past the limit on the size of files is an error of that write. Otherwise it may end the program.
void survive_size_limit();

}  // namespace weftlight::platform
