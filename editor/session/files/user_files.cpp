#include "session/files/user_files.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <type_traits>
#include <utility>

#include "base/json.h"
#include "base/languages.h"
#include "base/user_folders.h"
#include "base/utf8.h"
#include "base/whole_files.h"

namespace weftlight::session {

using base::config_folder, base::is_language_name, base::is_utf8, base::read_file, base::write_file_atomically;
using design::kMaxClothMm, design::kMaxSpare;

namespace {

namespace fs = std::filesystem;
constexpr size_t kMaxRecent = 40;
constexpr size_t kMaxPrices = 2000, kMaxScreens = 100;
constexpr size_t kMaxKeys = 1000, kLongestKey = 64;
constexpr uint64_t kMaxBytes = uint64_t{1} << 20;

fs::path settings_path() { return fs::path(config_folder()) / "settings.json"; }

template <class T>
void take(const nlohmann::json& json, const char* key, T& value) {
  const auto at = json.find(key);
  if (at == json.end()) return;
  if constexpr (std::is_same_v<T, bool>) {
    if (at->is_boolean()) value = at->get<bool>();
  } else if (at->is_number()) {
    constexpr double kLargest = 1e6;  // converting a number beyond the range of T is undefined
    value = static_cast<T>(std::clamp(at->get<double>(), -kLargest, kLargest));
  }
}

/// A path as text, or as an array of bytes if it is not UTF-8.
nlohmann::json path_json(const std::string& path) {
  if (is_utf8(path)) return path;
  return std::vector<uint8_t>(path.begin(), path.end());
}

std::string path_from(const nlohmann::json& json) {
  if (json.is_string()) return json.get<std::string>();
  std::string path;
  if (!json.is_array()) return path;
  for (const nlohmann::json& byte : json) {
    if (!byte.is_number_unsigned() || byte.get<uint64_t>() > 255) return {};
    path.push_back(static_cast<char>(byte.get<uint64_t>()));
  }
  return path;
}

void take_prices(const nlohmann::json& json, std::map<std::string, float>& prices) {
  const auto found = json.find("yarn_prices");
  if (found == json.end() || !found->is_object()) return;
  for (const auto& [yarn, price] : found->items())
    if (price.is_number() && price.get<double>() >= 0 && price.get<double>() <= 1e6 && prices.size() < kMaxPrices)
      prices[yarn] = price.get<float>();
}

void take_true_distance(const nlohmann::json& json, Settings& s) {
  take(json, "seen_from_m", s.seen_from_m);
  take(json, "eye_to_screen_cm", s.eye_to_screen_cm);
  const Settings usual;
  if (!(s.seen_from_m >= kNearestSeen_m && s.seen_from_m <= kFurthestSeen_m)) s.seen_from_m = usual.seen_from_m;
  if (!(s.eye_to_screen_cm >= kNearestEye_cm && s.eye_to_screen_cm <= kFurthestEye_cm))
    s.eye_to_screen_cm = usual.eye_to_screen_cm;
  const auto found = json.find("screens");
  if (found == json.end() || !found->is_object()) return;
  for (const auto& [screen, px_a_mm] : found->items())
    if (px_a_mm.is_number() && px_a_mm.get<float>() >= kMinPx_a_mm && px_a_mm.get<float>() <= kMaxPx_a_mm &&
        s.screens.size() < kMaxScreens)
      s.screens[screen] = px_a_mm.get<float>();
}

/// Actions whose id was another word in earlier files.
constexpr std::pair<std::string_view, const char*> kRenamedActions[] = {{"nearest", "closest_weave"}};

/// A shortcut under an action's earlier id counts unless there is one under its present id.
void take_keys(const nlohmann::json& json, std::map<std::string, std::string>& keys) {
  const auto found = json.find("keys");
  if (found == json.end() || !found->is_object()) return;
  for (const auto& [action, key] : found->items())
    if (key.is_string() && key.get_ref<const std::string&>().size() <= kLongestKey && keys.size() < kMaxKeys)
      keys[action] = key.get<std::string>();
  for (const auto& [earlier, present] : kRenamedActions)
    if (auto key = keys.extract(std::string(earlier))) keys.try_emplace(present, std::move(key.mapped()));
}

/// Only names in UTF-8: JSON cannot hold others.
std::map<std::string, float> writable(const std::map<std::string, float>& by_name) {
  std::map<std::string, float> out;
  for (const auto& [name, number] : by_name)
    if (is_utf8(name)) out[name] = number;
  return out;
}

}  // namespace

Settings load_settings() { return settings_from(read_file(settings_path().string(), kMaxBytes).value_or("")); }

Settings settings_from(std::string_view text) {
  Settings s;
  const nlohmann::json json = base::read_json(text);
  if (!json.is_object()) return s;
  take(json, "dark", s.dark);
  take(json, "end1_right", s.end1_right);
  take(json, "pick1_bottom", s.pick1_bottom);
  take(json, "threading_below", s.threading_below);
  take(json, "minimap", s.minimap);
  take(json, "tiled", s.tiled);
  take(json, "show_repeat", s.show_repeat);
  take(json, "rulers", s.rulers);
  take_true_distance(json, s);
  int style = 0;
  take(json, "drawdown_style", style);
  s.drawdown_style = static_cast<DrawdownStyle>(std::clamp(style, 0, 2));
  take(json, "heavy_lines", s.heavy_lines);
  s.heavy_lines = std::clamp(s.heavy_lines, 0, 64);
  take(json, "per_inch", s.imperial);  // of earlier versions
  take(json, "imperial", s.imperial);
  take(json, "cloth", s.cloth);
  take(json, "inspector", s.inspector);
  take(json, "toured", s.toured);
  take(json, "start_page", s.start_page);
  take(json, "say_steps", s.say_steps);
  take(json, "by_time", s.by_time);
  take(json, "picture_ms", s.picture_ms);
  if (!(s.picture_ms >= kMinPictureMs && s.picture_ms <= kMaxPictureMs)) s.picture_ms = Settings{}.picture_ms;
  take(json, "loom_waste_cm", s.loom_waste_cm);
  take(json, "spare_yarn", s.spare_yarn);
  take_prices(json, s.yarn_prices);
  const Settings usual;
  if (!(s.loom_waste_cm >= 0 && s.loom_waste_cm <= kMaxClothMm / 10)) s.loom_waste_cm = usual.loom_waste_cm;
  if (!(s.spare_yarn >= 0 && s.spare_yarn <= kMaxSpare)) s.spare_yarn = usual.spare_yarn;
  take(json, "split", s.split);
  take(json, "width", s.width);
  take(json, "height", s.height);
  if (const auto recent = json.find("recent"); recent != json.end() && recent->is_array())
    for (const auto& path : *recent)
      if (std::string one = path_from(path); !one.empty() && s.recent.size() < kMaxRecent)
        s.recent.push_back(std::move(one));
  if (const auto folder = json.find("drafts_folder"); folder != json.end()) s.drafts_folder = path_from(*folder);
  if (const auto loom = json.find("loom"); loom != json.end() && loom->is_string()) s.loom_address = *loom;
  if (const auto own = json.find("language"); own != json.end() && own->is_string())
    if (const std::string name = *own; is_language_name(name)) s.language = name;
  take_keys(json, s.keys);
  if (!(s.split >= 0.2f && s.split <= 0.8f)) s.split = 0;
  take(json, "interface_percent", s.interface_percent);
  s.interface_percent = std::clamp(s.interface_percent, kInterfaceSizes[0], *std::rbegin(kInterfaceSizes));
  s.width = std::clamp(s.width, 320, 16384);
  s.height = std::clamp(s.height, 240, 16384);
  return s;
}

std::string settings_text(const Settings& s) {
  nlohmann::json recent = nlohmann::json::array();
  for (const std::string& path : s.recent) recent.push_back(path_json(path));
  const nlohmann::json json = {{"dark", s.dark},
                               {"end1_right", s.end1_right},
                               {"pick1_bottom", s.pick1_bottom},
                               {"threading_below", s.threading_below},
                               {"minimap", s.minimap},
                               {"tiled", s.tiled},
                               {"show_repeat", s.show_repeat},
                               {"rulers", s.rulers},
                               {"seen_from_m", s.seen_from_m},
                               {"eye_to_screen_cm", s.eye_to_screen_cm},
                               {"screens", writable(s.screens)},
                               {"drawdown_style", static_cast<int>(s.drawdown_style)},
                               {"imperial", s.imperial},
                               {"cloth", s.cloth},
                               {"inspector", s.inspector},
                               {"toured", s.toured},
                               {"start_page", s.start_page},
                               {"say_steps", s.say_steps},
                               {"by_time", s.by_time},
                               {"picture_ms", s.picture_ms},
                               {"loom_waste_cm", s.loom_waste_cm},
                               {"spare_yarn", s.spare_yarn},
                               {"yarn_prices", writable(s.yarn_prices)},
                               {"split", s.split},
                               {"width", s.width},
                               {"height", s.height},
                               {"interface_percent", s.interface_percent},
                               {"language", s.language},
                               {"recent", recent},
                               {"drafts_folder", path_json(s.drafts_folder)},
                               {"keys", s.keys},
                               {"heavy_lines", s.heavy_lines},
                               {"loom", is_utf8(s.loom_address) ? s.loom_address : std::string()}};
  return json.dump(1) + "\n";
}

void save_settings(const Settings& s) {
  std::error_code ignored;  // a home that cannot be written to is no reason to stop
  fs::create_directories(settings_path().parent_path(), ignored);
  write_file_atomically(settings_path().string(), settings_text(s));
}

void remember(Settings& settings, const std::string& path) {
  std::error_code error;
  const fs::path full = fs::absolute(path, error);
  const std::string text = error ? path : full.string();
  std::erase(settings.recent, text);
  settings.recent.insert(settings.recent.begin(), text);
  if (settings.recent.size() > kMaxRecent) settings.recent.resize(kMaxRecent);
}

void forget(Settings& settings, const std::string& path) { std::erase(settings.recent, path); }

}  // namespace weftlight::session
