#include "gl/open_headless.h"

#include <string>
#include <utility>

#include "base/text.h"
#include "gl/egl_context.h"
#include "gl/hidden_window.h"
#include "platform/environment_variables.h"

namespace weftlight::gl {

using base::arg, base::fill, base::tr;

namespace {

using Opened = HeadlessContext::Opened;

constexpr const char* kVariable = "WEFTLIGHT_OFFSCREEN";

base::Failure none(std::string why) { return base::failure(base::ErrorKind::kGraphics, std::move(why)); }

Opened made_current(Opened opened) {
  if (!opened) return opened;
  if (const auto current = (*opened)->make_current(); !current) return base::failed(current);
  return opened;
}

Opened by_egl() {
  if constexpr (WEFTLIGHT_EGL) return made_current(open_egl());
  else return none(tr("this program was built without EGL"));
}

Opened by_window(const std::function<Opened()>& hidden_window) {
  Opened opened = made_current(hidden_window());
  if (opened) return opened;
  return none(fill(tr("no hidden window can be opened ({problem}): draw where there is a display"),
                   arg("problem", message(opened.error()))));
}

/// By EGL, else by a hidden window.
Opened by_either(const std::function<Opened()>& hidden_window) {
  Opened first = by_egl();
  if (first) return first;
  Opened second = made_current(hidden_window());
  if (second) return second;
  return none(fill(tr("{problem}, or draw where there is a display ({no_display})"),
                   arg("problem", message(first.error())), arg("no_display", message(second.error()))));
}

}  // namespace

Opened open_headless() { return open_headless(open_hidden_window); }

Opened open_headless(const std::function<Opened()>& hidden_window) {
  const std::string way = platform::variable(kVariable);
  if (way == "none") return none(fill(tr("drawing is turned off ({variable} is none)"), arg("variable", kVariable)));
  if (way == "egl") return by_egl();
  if (way == "window" || (way.empty() && !WEFTLIGHT_EGL)) return by_window(hidden_window);
  if (way.empty()) return by_either(hidden_window);
  return none(fill(tr("{variable} is '{value}': write egl, window or none, or leave it unset"),
                   arg("variable", kVariable), arg("value", way)));
}

}  // namespace weftlight::gl
