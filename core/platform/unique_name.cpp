#include "platform/unique_name.h"

#include <filesystem>
#include <random>
#include <string_view>
#include <utility>

namespace weftlight::platform {
namespace fs = std::filesystem;

namespace {

constexpr std::string_view kMark = ".part-";
constexpr size_t kMarkLetters = 16;                   // of unique_name()
constexpr size_t kMaxStem = 150, kMaxExtension = 50;  // bytes of a temporary name, which may have at most 255

/// What a temporary's name begins and ends with.
std::pair<std::string, std::string> around_mark(const fs::path& target) {
  return {target.stem().string().substr(0, kMaxStem) + std::string(kMark),
          target.extension().string().substr(0, kMaxExtension)};
}

}  // namespace

std::string unique_name() {
  std::random_device random;
  std::string name;
  for (int digit = 0; digit < static_cast<int>(kMarkLetters); ++digit) name += "0123456789abcdef"[random() % 16];
  return name;
}

bool is_unique_name(std::string_view name) {
  return name.size() == kMarkLetters && name.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

std::string temporary_beside(const std::string& path) {
  const auto [start, ending] = around_mark(path);
  return (fs::path(path).parent_path() / (start + unique_name() + ending)).string();
}

bool is_temporary_of(const std::string& path, const std::string& name) {
  const auto [start, ending] = around_mark(path);
  if (name.size() < start.size() + ending.size() || !name.starts_with(start) || !name.ends_with(ending)) return false;
  const std::string_view mark(name);
  return is_unique_name(mark.substr(start.size(), name.size() - start.size() - ending.size()));
}

bool is_temporary(const std::string& name) {
  const size_t mark = name.rfind(kMark);
  if (mark == std::string::npos || name.size() < mark + kMark.size() + kMarkLetters) return false;
  return is_temporary_of(std::string(name).erase(mark, kMark.size() + kMarkLetters), name);
}

}  // namespace weftlight::platform
