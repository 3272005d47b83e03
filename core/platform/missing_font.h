#pragma once
// Whether texts in a language can be shown with the fonts that are installed.

#include <string>

namespace weftlight::platform {

/// True for languages whose letters the window's own fonts lack, as "ja" or "ja_JP".
bool needs_own_font(const std::string& language);
/// The font to install before texts in the language can be read, as "Noto Sans CJK (fonts-noto-cjk)": its family and
/// the package that has it. Empty if they can be read already.
std::string missing_font(const std::string& language);

}  // namespace weftlight::platform
