#include "platform/installed_fonts.h"

#include <fontconfig/fontconfig.h>

#include <memory>

namespace weftlight::platform {
namespace {

template <class T, void (*Destroy)(T*)>
struct Destroys {
  void operator()(T* it) const { Destroy(it); }
};
using Config = std::unique_ptr<FcConfig, Destroys<FcConfig, FcConfigDestroy>>;
using Pattern = std::unique_ptr<FcPattern, Destroys<FcPattern, FcPatternDestroy>>;

int weight_of(FontWeight weight) {
  return weight == FontWeight::kSemiBold ? FC_WEIGHT_DEMIBOLD
         : weight == FontWeight::kMedium ? FC_WEIGHT_MEDIUM
                                         : FC_WEIGHT_REGULAR;
}

const FcChar8* text(const char* words) { return reinterpret_cast<const FcChar8*>(words); }

/// fontconfig returns the closest font of any family, so the family name must be compared.
std::string file_of(FcConfig* config, const char* family, FontWeight weight) {
  const Pattern wanted(FcPatternCreate());
  FcPatternAddString(wanted.get(), FC_FAMILY, text(family));
  FcPatternAddInteger(wanted.get(), FC_WEIGHT, weight_of(weight));
  FcPatternAddInteger(wanted.get(), FC_SLANT, FC_SLANT_ROMAN);
  FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
  FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  const Pattern found(FcFontMatch(config, wanted.get(), &result));
  if (!found) return {};
  FcChar8* name = nullptr;
  for (int i = 0; FcPatternGetString(found.get(), FC_FAMILY, i, &name) == FcResultMatch; ++i) {
    FcChar8* file = nullptr;
    if (FcStrCmpIgnoreCase(name, text(family)) != 0) continue;
    if (FcPatternGetString(found.get(), FC_FILE, 0, &file) != FcResultMatch) return {};
    return reinterpret_cast<const char*>(file);
  }
  return {};
}

}  // namespace

std::string font_file(std::span<const char* const> families, FontWeight weight) {
  const Config config(FcInitLoadConfigAndFonts());
  if (!config) return {};
  for (const char* family : families)
    if (std::string file = file_of(config.get(), family, weight); !file.empty()) return file;
  return {};
}

FontFace font_face_of_language(const std::string& language, FontWeight weight) {
  const Config config(FcInitLoadConfigAndFonts());
  if (!config) return {};
  const Pattern wanted(FcPatternCreate());
  FcPatternAddString(wanted.get(), FC_FAMILY, text("sans-serif"));
  FcPatternAddString(wanted.get(), FC_LANG, text(language.c_str()));
  FcPatternAddInteger(wanted.get(), FC_WEIGHT, weight_of(weight));
  FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
  FcConfigSubstitute(config.get(), wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  const Pattern found(FcFontMatch(config.get(), wanted.get(), &result));
  FcLangSet* languages = nullptr;
  FcChar8* file = nullptr;
  int index = 0;
  if (!found || FcPatternGetLangSet(found.get(), FC_LANG, 0, &languages) != FcResultMatch ||
      FcLangSetHasLang(languages, text(language.c_str())) == FcLangDifferentLang ||
      FcPatternGetString(found.get(), FC_FILE, 0, &file) != FcResultMatch)
    return {};
  FcPatternGetInteger(found.get(), FC_INDEX, 0, &index);
  return {reinterpret_cast<const char*>(file), index & 0xFFFF};  // above it the number of a variable font's instance
}

}  // namespace weftlight::platform
