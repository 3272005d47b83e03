#include "platform/without_gettext/system_language.h"

#include <windows.h>

#include "platform/windows/wide.h"

namespace weftlight::platform {

std::string system_language() {
  wchar_t name[LOCALE_NAME_MAX_LENGTH];
  const int size = ::GetUserDefaultLocaleName(name, LOCALE_NAME_MAX_LENGTH);  // with the zero at its end
  return size > 1 ? narrow({name, static_cast<size_t>(size) - 1}) : "";
}

}  // namespace weftlight::platform
