// Any bytes as settings.json: parsing never crashes, values are in range, and survive writing and reading.

#include <cstdint>
#include <string_view>

#include "require.h"
#include "session/files/user_files.h"

using weftlight::session::Settings, weftlight::session::settings_from, weftlight::session::settings_text;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  Settings s = settings_from(bytes);
  require(s.width >= 320 && s.width <= 16384 && s.height >= 240 && s.height <= 16384, "the window has a size");
  require(s.split == 0 || (s.split >= 0.2f && s.split <= 0.8f), "the split is in range");
  require(static_cast<int>(s.drawdown_style) >= 0 && static_cast<int>(s.drawdown_style) <= 2, "the style exists");
  s.recent.insert(s.recent.begin(), std::string(bytes.substr(0, 40)));  // a path may be any bytes
  const std::string text = settings_text(s);
  const Settings again = settings_from(text);
  require(settings_text(again) == text || s.recent.size() > again.recent.size(),
          "settings survive writing and reading");
  require(again.recent.empty() || again.recent.front() == s.recent.front(), "a path survives byte for byte");
  return 0;
}
