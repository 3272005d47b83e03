#include "session/user_files.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "session/user_folders.h"
#include "wif/wif.h"

namespace weftlight::session {
namespace {

namespace fs = std::filesystem;
constexpr size_t kMostRecent = 10;

fs::path settings_path() { return fs::path(config_folder()) / "settings.json"; }

template <class T>
void take(const nlohmann::json& json, const char* key, T& value) {
  const auto at = json.find(key);
  if (at == json.end()) return;
  if (at->type() == nlohmann::json(value).type() || (at->is_number() && nlohmann::json(value).is_number()))
    value = at->get<T>();
}

}  // namespace

Settings load_settings() {
  Settings s;
  const FileBytes file = read_file(settings_path().string());
  const nlohmann::json json = nlohmann::json::parse(file.bytes, nullptr, false);
  if (!json.is_object()) return s;
  take(json, "dark", s.dark);
  take(json, "end1_right", s.end1_right);
  take(json, "drawdown_style", s.drawdown_style);
  take(json, "per_inch", s.per_inch);
  take(json, "inspector", s.inspector);
  take(json, "split", s.split);
  take(json, "width", s.width);
  take(json, "height", s.height);
  if (const auto recent = json.find("recent"); recent != json.end() && recent->is_array())
    for (const auto& path : *recent)
      if (path.is_string() && s.recent.size() < kMostRecent) s.recent.push_back(path.get<std::string>());
  s.drawdown_style = std::clamp(s.drawdown_style, 0, 2);
  if (!(s.split >= 0.2f && s.split <= 0.8f)) s.split = 0;
  s.width = std::clamp(s.width, 320, 16384);
  s.height = std::clamp(s.height, 240, 16384);
  return s;
}

void save_settings(const Settings& s) {
  const nlohmann::json json = {
      {"dark", s.dark},         {"end1_right", s.end1_right}, {"drawdown_style", s.drawdown_style},
      {"per_inch", s.per_inch}, {"inspector", s.inspector},   {"split", s.split},
      {"width", s.width},       {"height", s.height},         {"recent", s.recent}};
  std::error_code ignored;  // a home that cannot be written to is no reason to stop
  fs::create_directories(settings_path().parent_path(), ignored);
  write_file_atomically(settings_path().string(), json.dump(1) + "\n");
}

void remember(Settings& settings, const std::string& path) {
  std::error_code error;
  const fs::path full = fs::absolute(path, error);
  const std::string text = error ? path : full.string();
  std::erase(settings.recent, text);
  settings.recent.insert(settings.recent.begin(), text);
  if (settings.recent.size() > kMostRecent) settings.recent.resize(kMostRecent);
}

}  // namespace weftlight::session
