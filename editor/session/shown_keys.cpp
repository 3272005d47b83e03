#include "session/shown_keys.h"

#include <string_view>

#include "base/text.h"

namespace weftlight::session {

using base::tr_in;

namespace {

std::string label_of(std::string_view key) {
  if (key == "Ctrl") return tr_in("key", "Ctrl");
  if (key == "Shift") return tr_in("key", "Shift");
  if (key == "Alt") return tr_in("key", "Alt");
  if (key == "Left") return tr_in("key", "Left");
  if (key == "Right") return tr_in("key", "Right");
  if (key == "Up") return tr_in("key", "Up");
  if (key == "Down") return tr_in("key", "Down");
  if (key == "Delete") return tr_in("key", "Delete");
  if (key == "Insert") return tr_in("key", "Insert");
  if (key == "Home") return tr_in("key", "Home");
  if (key == "End") return tr_in("key", "End");
  if (key == "PageUp") return tr_in("key", "PageUp");
  if (key == "PageDown") return tr_in("key", "PageDown");
  if (key == "Enter") return tr_in("key", "Enter");
  if (key == "Escape") return tr_in("key", "Escape");
  if (key == "Space") return tr_in("key", "Space");
  if (key == "Tab") return tr_in("key", "Tab");
  return std::string(key);
}

}  // namespace

std::string shown_keys(const std::string& shortcut) {
  std::string shown;
  size_t from = 0;
  // A + at the end is a key itself.
  for (size_t at = shortcut.find('+'); at != std::string::npos && at + 1 < shortcut.size();
       at = shortcut.find('+', from)) {
    shown += label_of(std::string_view(shortcut).substr(from, at - from)) + '+';
    from = at + 1;
  }
  return shown + label_of(std::string_view(shortcut).substr(from));
}

}  // namespace weftlight::session
