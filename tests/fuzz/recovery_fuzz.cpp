// A recovery folder with any content: listing it never crashes, gives a reason for unreadable journals, and keeps files
// that no session made.

#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "require.h"
#include "session/recovery/recovery.h"

using weftlight::session::LeftWork, weftlight::session::Recovery, weftlight::session::journal_start,
    weftlight::session::read_left;
namespace fs = std::filesystem;

namespace {

std::string_view take(std::string_view& input, size_t size) {
  const std::string_view front = input.substr(0, size);
  input.remove_prefix(front.size());
  return front;
}

/// A file name without path separators.
std::string name_of(std::string_view bytes) {
  std::string name;
  for (const char c : bytes)
    if (c != '/' && c != 0) name += c;
  return name.empty() || name == "." || name == ".." ? "x" : name;
}

void put(const fs::path& at, char kind, std::string_view content) {
  std::error_code ignored;
  if (kind % 4 == 0) fs::create_directories(at, ignored);
  else if (kind % 4 == 1) fs::create_symlink(name_of(content), at, ignored);
  else std::ofstream(at, std::ios::binary) << content;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static const fs::path root = fs::temp_directory_path() / ("weftlight-fuzz-" + std::to_string(getpid()));
  std::string_view input(reinterpret_cast<const char*>(data), size);
  const fs::path session = root / "00112233445566ff";
  fs::create_directories(session);
  std::ofstream(root / "mine") << "kept";
  std::ofstream(session / "1.journal", std::ios::binary)
      << journal_start({{"/a.wif", "a.wif", {}}, std::string(input.substr(0, 40))});
  while (input.size() > 4) {
    const char where = input[0], kind = input[1];
    const auto length = static_cast<uint8_t>(input[2]);
    input.remove_prefix(3);
    const std::string name = name_of(take(input, static_cast<size_t>(where) % 24)) + (where & 1 ? ".journal" : "");
    put((where & 2 ? session : root) / name, kind, take(input, length));
  }
  {
    Recovery recovery(root.string());
    for (const LeftWork& left : recovery.left_behind()) {
      require(read_left(left).has_value() == left.note.has_value(), "an offered journal can be read or has a reason");
      recovery.discard(left);
      require(!fs::is_regular_file(left.journal), "a discarded journal is deleted");
    }
  }
  require(fs::exists(fs::symlink_status(root / "mine")), "other files are kept");
  std::error_code ignored;
  fs::remove_all(root, ignored);
  return 0;
}
