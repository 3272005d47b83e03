#pragma once
// A folder of a test's own, removed at its end.

#include <filesystem>
#include <random>
#include <string>

namespace weftlight {

class Scratch {
 public:
  explicit Scratch(const std::string& name = "test") {
    std::random_device random;
    do {
      folder = std::filesystem::temp_directory_path() / ("weftlight-" + name + "-" + std::to_string(random()));
    } while (!std::filesystem::create_directory(folder));
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  std::string operator/(const std::string& name) const { return (folder / name).string(); }

  std::filesystem::path folder;
};

}  // namespace weftlight
