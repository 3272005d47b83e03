#pragma once
// Font Awesome 4.7 glyphs (fonts-font-awesome), UTF-8. Used if Fonts::icons is true.

namespace weftlight::icon {

inline constexpr const char* kNew = "\xEF\x80\x96";       // f016 file-o
inline constexpr const char* kOpen = "\xEF\x84\x95";      // f115 folder-open-o
inline constexpr const char* kSave = "\xEF\x83\x87";      // f0c7 floppy-o
inline constexpr const char* kUndo = "\xEF\x83\xA2";      // f0e2 undo
inline constexpr const char* kRedo = "\xEF\x80\x9E";      // f01e repeat
inline constexpr const char* kSearch = "\xEF\x80\x82";    // f002 search
inline constexpr const char* kWarning = "\xEF\x81\xB1";   // f071 exclamation-triangle
inline constexpr const char* kInfo = "\xEF\x81\x9A";      // f05a info-circle
inline constexpr const char* kPlus = "\xEF\x81\xA7";      // f067 plus
inline constexpr const char* kMinus = "\xEF\x81\xA8";     // f068 minus
inline constexpr const char* kDown = "\xEF\x84\x87";      // f107 angle-down
inline constexpr const char* kRight = "\xEF\x84\x85";     // f105 angle-right
inline constexpr const char* kLeft = "\xEF\x84\x84";      // f104 angle-left
inline constexpr const char* kTheme = "\xEF\x81\x82";     // f042 adjust
inline constexpr const char* kFit = "\xEF\x81\xA6";       // f066 compress
inline constexpr const char* kReset = "\xEF\x80\x95";     // f015 home
inline constexpr const char* kLinked = "\xEF\x83\x81";    // f0c1 link
inline constexpr const char* kUnlinked = "\xEF\x84\xA7";  // f127 unlink
inline constexpr const char* kClear = "\xEF\x80\x8D";     // f00d times

}  // namespace weftlight::icon
