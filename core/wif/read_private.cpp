// Reads [PRIVATE WEFTLIGHT ...]. An exact value that repeats a public line (a colour between two steps of Range, a
// title of two lines) is used only while the public line still agrees with it, so that changes by other programs are
// kept.

#include <algorithm>
#include <charconv>

#include "base/text.h"
#include "design/dye.h"
#include "design/fibre.h"
#include "design/lights.h"
#include "wif/private.h"
#include "wif/section_rows.h"

namespace weftlight::wif {

using base::next_word, base::tr;
using design::Assembly, design::ClothPlan, design::Design, design::Dye, design::Finish, design::Leading, design::Loom,
    design::Method, design::MethodFacts, design::NamedView, design::Scene, design::ThreadSection, design::Twist,
    design::WeaveUse, design::Yarn, design::YarnField, design::YarnPurchase, design::clamped, design::dye_from_text,
    design::fibre_from_name, design::is_environment, design::kFinishFields, design::kLobeFields, design::kMethods,
    design::kPliesFacts, design::kTwistNames, design::kYarnFields, design::lighting_preset, design::section_from_name,
    design::sleying_from_text, design::with_recognised_fibre, design::with_recognised_section;
using draft::BitMatrix, draft::Draft, draft::Rgb, draft::ShedControl, draft::Threads, draft::kFromYarn,
    draft::kMaxColors, draft::kMaxShafts, draft::kMaxThreads;

namespace {

const WifSection* private_section(const WifText& text, std::string_view name) {
  return text.find(std::string(kPrivate) + std::string(name));
}

std::optional<float> as_float(std::string_view value) {
  float result = 0;
  const auto read = std::from_chars(value.data(), value.data() + value.size(), result);
  return read.ec == std::errc{} ? std::optional(result) : std::nullopt;
}

std::vector<float> as_floats(std::string_view value) {
  std::vector<float> result;
  while (!value.empty()) {
    const size_t comma = std::min(value.find(','), value.size());
    const std::optional<float> number = as_float(trimmed(value.substr(0, comma)));
    if (!number) return {};
    result.push_back(*number);
    value.remove_prefix(std::min(comma + 1, value.size()));
  }
  return result;
}

struct Source {
  const WifText& text;
  Diagnostics& diagnostics;

  void unusable(const WifKey& key) const {
    diagnostics.warn(key.line, "private", tr("a value in one of Weftlight's own sections is invalid"),
                     tr("the default was used"));
  }
};

void read_float(const Source& s, const WifSection& section, const std::string& name, float low, float high,
                float& out) {
  const WifKey* key = section.find(name);
  if (!key) return;
  const std::optional<float> value = as_float(key->value);
  if (value && std::isfinite(*value)) out = std::clamp(*value, low, high);
  else s.unusable(*key);
}

template <class T, size_t N>
void read_fields(const Source& s, const WifSection& section, const FloatField<T> (&fields)[N], T& out) {
  for (const FloatField<T>& f : fields) read_float(s, section, f.key, f.low, f.high, out.*f.member);
}

template <class T, size_t N>
void read_fields(const Source& s, const WifSection& section, const std::string& prefix,
                 const std::array<YarnField<T>, N>& fields, T& out) {
  for (const YarnField<T>& f : fields)
    read_float(s, section, prefix + f.facts.key, f.facts.low, f.facts.high, out.*f.member);
}

void read_color(const Source& s, const WifSection& section, const std::string& name, Rgb& out) {
  const WifKey* key = section.find(name);
  if (!key) return;
  const std::vector<float> c = as_floats(key->value);
  if (c.size() != 3 || !std::all_of(c.begin(), c.end(), [](float v) { return std::isfinite(v); }))
    return s.unusable(*key);
  out = {c[0], c[1], c[2]};
}

Twist as_twist(std::string_view value, Twist otherwise) {
  for (size_t i = 0; i < kTwistNames.size(); ++i) {
    if (same_word(kTwistNames[i], value)) return static_cast<Twist>(i);
  }
  return otherwise;
}

Method as_method(std::string_view value) {
  for (const MethodFacts& m : kMethods) {
    if (same_word(m.name, value)) return m.method;
  }
  return Method::kAuto;
}

std::string text_of(const Source& s, const WifKey& key) { return unescaped(to_utf8(key.value, s.text.encoding)); }

/// False if there is no such key, or no such name.
template <class T>
bool read_name(const Source& s, const WifSection& section, const std::string& name,
               std::optional<T> (*from_name)(std::string_view), T& out) {
  const WifKey* key = section.find(name);
  if (!key) return false;
  const std::optional<T> named = from_name(key->value);
  if (!named) return s.unusable(*key), false;
  out = *named;
  return true;
}

void read_dye(const Source& s, const WifSection& section, const std::string& prefix, Dye& dye) {
  if (const WifKey* key = section.find(prefix + "Dye")) {
    if (auto stretches = dye_from_text(key->value)) dye.stretches = std::move(*stretches);
    else s.unusable(*key);
  }
  if (const WifKey* key = section.find(prefix + "Dye Shift")) dye.shift = leading_int(key->value).value_or(0);
  if (const WifKey* key = section.find(prefix + "Dye Scatter")) dye.scatter = leading_int(key->value).value_or(0);
}

Yarn read_yarn(const Source& s, const WifSection& section, const std::string& prefix) {
  Yarn yarn;
  if (const WifKey* key = section.find(prefix + "Name")) yarn.name = text_of(s, *key);
  else yarn.name.clear();
  if (const WifKey* key = section.find(prefix + "Twist")) {
    yarn.twist = as_twist(key->value, yarn.twist);
  }
  if (const WifKey* key = section.find(prefix + kPliesFacts.key)) {
    yarn.plies = leading_int(key->value).value_or(yarn.plies);
  }
  if (const WifKey* key = section.find(prefix + "Metallic"))
    yarn.lobes.metallic = word_as_bool(key->value).value_or(false);
  read_fields(s, section, prefix, kYarnFields, yarn);
  read_fields(s, section, prefix, kLobeFields, yarn.lobes);
  read_color(s, section, prefix + "Tint", yarn.lobes.specular_tint);
  read_dye(s, section, prefix, yarn.dye);
  yarn = clamped(std::move(yarn));
  const bool has_fibre = read_name(s, section, prefix + std::string(kMadeOf), fibre_from_name, yarn.fibre);
  const bool has_section = read_name(s, section, prefix + std::string(kSection), section_from_name, yarn.section);
  if (!has_fibre) return with_recognised_fibre(std::move(yarn));
  return has_section ? yarn : with_recognised_section(std::move(yarn));
}

void read_yarns(const Source& s, Design& design) {
  const WifSection* section = private_section(s.text, "YARNS");
  if (!section) return;
  const WifKey* count = section->find("Yarns");
  const int yarns = count ? std::clamp(leading_int(count->value).value_or(1), 1, kMaxColors) : 1;
  design.yarns.clear();
  for (int i = 0; i < yarns; ++i) design.yarns.push_back(read_yarn(s, *section, std::to_string(i + 1) + " "));
}

void read_finish(const Source& s, Finish& finish) {
  const WifSection* section = private_section(s.text, "FINISH");
  if (!section) return;
  read_fields(s, *section, "", kFinishFields, finish);
  finish = clamped(finish);
}

int count_of(const WifSection& section, const char* name, int most) {
  const WifKey* key = section.find(name);
  return key ? std::clamp(leading_int(key->value).value_or(0), 0, most) : 0;
}

std::vector<YarnPurchase> read_purchases(const Source& s, const WifSection& section) {
  std::vector<YarnPurchase> all(static_cast<size_t>(count_of(section, "Purchases", kMaxPurchases)));
  for (size_t i = 0; i < all.size(); ++i) {
    const std::string prefix = std::to_string(i + 1) + " ";
    if (const WifKey* yarn = section.find(prefix + "Yarn")) all[i].yarn = text_of(s, *yarn);
    read_float(s, section, prefix + "Cone Weight", 0, design::kMaxCone, all[i].cone_g);
    read_float(s, section, prefix + "Cone Length", 0, design::kMaxCone, all[i].cone_m);
    read_float(s, section, prefix + "Price", 0, design::kMaxPrice, all[i].price);
  }
  return all;
}

void read_plan(const Source& s, ClothPlan& plan) {
  const WifSection* section = private_section(s.text, "PLAN");
  if (!section) return;
  read_fields(s, *section, kPlanFloats, plan);
  if (section->find("Pieces")) plan.pieces = count_of(*section, "Pieces", design::kMaxPieces);
  read_float(s, *section, "Reed", 0, design::kMaxDents, plan.reed.dents);
  if (const WifKey* key = section->find("Reed Per Inch")) plan.reed.per_inch = word_as_bool(key->value).value_or(false);
  if (const WifKey* key = section->find("Sleying")) {
    plan.sleying = sleying_from_text(key->value);
    if (plan.sleying.empty()) s.unusable(*key);
  }
  if (const WifKey* key = section->find("Floating Selvedges"))
    plan.floating_selvedges = word_as_bool(key->value).value_or(false);
  plan.purchases = read_purchases(s, *section);
  plan = clamped(std::move(plan));
}

void read_thread_yarns(const Source& s, const char* name, size_t yarns, Threads& threads) {
  const WifSection* section = private_section(s.text, name);
  if (!section) return;
  each_row(*section, threads.size(), 1, s.diagnostics, [&](int thread, const WifKey& key) {
    const int yarn = leading_int(key.value).value_or(0);
    if (yarn >= 1 && static_cast<size_t>(yarn) <= yarns) {
      threads.yarn[static_cast<size_t>(thread)] = yarn - 1;
    } else {
      s.unusable(key);
    }
  });
}

void read_scene(const Source& s, const WifSection& section, Scene& scene) {
  read_fields(s, section, kSceneFloats, scene);
  read_color(s, section, "Background", scene.background);
  const WifKey* mesh = section.find("Mesh");
  scene.mesh = mesh ? text_of(s, *mesh) : std::string{};
  if (const WifKey* own = section.find("Own Drape")) scene.simulated_drape = word_as_bool(own->value).value_or(false);
  if (const WifKey* lights = section.find("Lights")) {
    const std::string name = text_of(s, *lights);
    scene.lights = is_environment(name) ? name : lighting_preset(name).id;
    if (name != scene.lights) s.unusable(*lights);
  }
  if (const WifKey* shown = section.find("Surroundings"))
    scene.surroundings = word_as_bool(shown->value).value_or(false);
}

void read_views(const Source& s, std::vector<NamedView>& views) {
  for (int i = 1; i <= kMaxViews; ++i) {
    const WifSection* section = private_section(s.text, "VIEW " + std::to_string(i));
    if (!section) return;
    NamedView& view = views.emplace_back();
    if (const WifKey* name = section->find("Name")) view.name = text_of(s, *name);
    if (const WifKey* flat = section->find("Flat")) view.flat = word_as_bool(flat->value).value_or(false);
    // Without these keys: the scene of a new draft.
    if (section->find(kSceneFloats[0].key)) read_scene(s, *section, view.scene);
  }
}

void read_look_and_scene(const Source& s, Design& design) {
  if (const WifSection* look = private_section(s.text, "LOOK")) {
    read_fields(s, *look, kLookFloats, design.look);
    if (const WifKey* key = look->find("Automatic Exposure"))
      design.look.automatic_exposure = word_as_bool(key->value).value_or(true);
    if (const WifKey* key = look->find("Method")) design.look.method = as_method(key->value);
  }
  if (const WifSection* scene = private_section(s.text, "SCENE")) read_scene(s, *scene, design.scene);
}

void read_bool(const WifSection& section, const char* name, bool& out) {
  if (const WifKey* key = section.find(name)) out = word_as_bool(key->value).value_or(false);
}

void read_loom(const Source& s, Loom& loom) {
  const WifSection* section = private_section(s.text, "LOOM");
  if (!section) return;
  if (const WifKey* key = section->find("Authority"))
    for (size_t i = 0; i < std::size(kLeadingNames); ++i)
      if (same_word(kLeadingNames[i], key->value)) loom.leading = static_cast<Leading>(i);
  if (const WifKey* key = section->find("Locked")) loom.locked = word_as_bool(key->value).value_or(false);
  loom.shafts = count_of(*section, "Shafts", kMaxShafts);
  loom.treadles = count_of(*section, "Treadles", kMaxShafts);
  loom.next_pick = count_of(*section, "Next Pick", kMaxThreads);
  loom.next_end = count_of(*section, "Next End", kMaxThreads);
  loom.next_dent = count_of(*section, "Next Dent", design::kMaxLoomDents);
  read_bool(*section, "Tabby Between", loom.tabby_between);
  read_bool(*section, "At Tabby", loom.at_tabby);
  read_bool(*section, "Second Tabby", loom.second_tabby);
}

void read_weaves(const Source& s, std::vector<WeaveUse>& weaves) {
  const WifSection* section = private_section(s.text, "WEAVES");
  if (!section) return;
  weaves.resize(static_cast<size_t>(count_of(*section, "Weaves", kMaxWeaveUses)));
  std::vector<int> place;
  for (const WifKey& key : section->keys) {
    const int number = leading_int(key.key).value_or(0);
    const size_t blank = key.key.find(' ');
    if (number < 1 || static_cast<size_t>(number) > weaves.size() || blank == std::string_view::npos) continue;
    WeaveUse& use = weaves[static_cast<size_t>(number) - 1];
    const std::string_view name = key.key.substr(blank + 1);
    if (same_word(name, "Weave")) use.weave = text_of(s, key);
    else if (name.starts_with(kWeaveNumber)) use.values.emplace_back(name.substr(kWeaveNumber.size()), text_of(s, key));
    if (!same_word(name, "Place")) continue;
    leading_ints(key.value, place);
    place.resize(4, 0);
    for (int& i : place) i = std::clamp(i, 0, kMaxThreads);
    use.first_end = std::max(place[0] - 1, 0), use.ends = place[1];
    use.first_pick = std::max(place[2] - 1, 0), use.picks = place[3];
  }
  for (WeaveUse& use : weaves) std::ranges::sort(use.values);
}

/// "1 2 1+3 0" as rows of bits; values beyond `columns` are ignored.
BitMatrix rows_from(std::string_view text, int columns) {
  std::vector<std::string_view> words;
  for (std::string_view word; words.size() < static_cast<size_t>(kMaxThreads) && !(word = next_word(text)).empty();)
    words.push_back(word);
  BitMatrix rows(static_cast<int>(words.size()), columns);
  for (size_t row = 0; row < words.size(); ++row)
    for (std::string_view rest = words[row]; !rest.empty();) {
      const size_t plus = std::min(rest.find('+'), rest.size());
      const int bit = leading_int(rest.substr(0, plus)).value_or(0);
      if (bit >= 1 && bit <= columns) rows.set(static_cast<int>(row), bit - 1, true);
      rest.remove_prefix(std::min(plus + 1, rest.size()));
    }
  return rows;
}

template <class T, class Read>
void read_column(const WifSection& section, const std::string& key, std::vector<T>& values, Read read) {
  const WifKey* found = section.find(key);
  if (!found) return;
  std::string_view text = found->value;
  for (T& value : values) {
    const std::string_view word = next_word(text);
    if (word.empty()) return;
    value = read(word);
  }
}

ThreadSection read_section(const Source& s, const WifSection& section, const std::string& prefix) {
  ThreadSection out;
  if (const WifKey* key = section.find(prefix + "Name")) out.name = text_of(s, *key);
  if (const WifKey* key = section.find(prefix + "Lifts"); key && word_as_bool(key->value) == true)
    out.shed_control = ShedControl::kLiftplan;
  const WifKey* rows = section.find(prefix + "Rows");
  out.rows =
      rows_from(rows ? rows->value : std::string_view(), count_of(section, (prefix + "Columns").c_str(), kMaxShafts));
  out.threads.resize(out.rows.rows());
  const auto from_1 = [](std::string_view word) { return std::max(leading_int(word).value_or(1) - 1, 0); };
  const auto number = [](std::string_view word) { return as_float(word).value_or(kFromYarn); };
  read_column(section, prefix + "Colors", out.threads.color, from_1);
  read_column(section, prefix + "Yarns", out.threads.yarn, from_1);
  read_column(section, prefix + "Spacing", out.threads.spacing_mm, number);
  read_column(section, prefix + "Thickness", out.threads.thickness_mm, number);
  return out;
}

void read_assembly(const Source& s, const char* name, Assembly& assembly) {
  const WifSection* section = private_section(s.text, name);
  if (!section) return;
  constexpr int64_t kMaxBits = int64_t{1} << 28;  // of all sections
  if (const WifKey* order = section->find("Order")) assembly.order = text_of(s, *order);
  const int count = count_of(*section, "Sections", kMaxSections);
  int64_t bits = 0;
  for (int i = 1; i <= count && bits < kMaxBits; ++i) {
    assembly.sections.push_back(read_section(s, *section, std::to_string(i) + " "));
    const BitMatrix& rows = assembly.sections.back().rows;
    bits += int64_t{rows.rows()} * rows.cols();
  }
}

void restore_text(const Source& s, const WifSection& section, const std::string& name, std::string& text) {
  const WifKey* key = section.find(name);
  if (!key) return;
  const std::string exact = text_of(s, *key);
  if (one_line(exact) == text) text = exact;
}

void read_exact_text(const Source& s, Design& design) {
  const WifSection* section = private_section(s.text, "TEXT");
  if (!section) return;
  restore_text(s, *section, "Title", design.title);
  restore_text(s, *section, "Author", design.author);
  for (const WifKey& key : section->keys) {
    if (key.key.size() < 6 || !same_word(key.key.substr(0, 5), "NOTE ")) continue;
    const int note = leading_int(key.key.substr(5)).value_or(0);
    if (note < 1 || static_cast<size_t>(note) > design.notes.size()) continue;
    std::string& text = design.notes[static_cast<size_t>(note) - 1];
    const std::string exact = text_of(s, key);
    if (one_line(exact) == text) text = exact;
  }
}

void read_exact_colors(const Source& s, const WifDialect& dialect, Draft& draft) {
  const WifSection* section = private_section(s.text, "COLORS");
  if (!section) return;
  const auto number = [&](float channel) { return channel_number(channel, dialect.range_low, dialect.range_high); };
  each_row(*section, static_cast<int>(draft.palette.size()), 1, s.diagnostics, [&](int index, const WifKey& key) {
    Rgb& color = draft.palette[static_cast<size_t>(index)];
    const std::vector<float> c = as_floats(key.value);
    if (c.size() != 3) return s.unusable(key);
    const bool same =
        number(c[0]) == number(color.r) && number(c[1]) == number(color.g) && number(c[2]) == number(color.b);
    if (same) color = {c[0], c[1], c[2]};
  });
}

void read_exact_measures(const Source& s, const char* name, std::vector<float>& measures) {
  const WifSection* section = private_section(s.text, name);
  if (!section) return;
  each_row(*section, static_cast<int>(measures.size()), 1, s.diagnostics, [&](int thread, const WifKey& key) {
    const std::optional<float> mm = as_float(key.value);
    float& public_mm = measures[static_cast<size_t>(thread)];
    if (mm && public_mm == kFromYarn) public_mm = *mm;
  });
}

/// The grid of the inactive shed control.
void read_inactive_grid(const Source& s, const char* name, BitMatrix& bits) {
  const WifSection* section = private_section(s.text, name);
  if (!section) return;
  std::vector<int> list;
  each_row(*section, bits.rows(), 1, s.diagnostics, [&](int row, const WifKey& key) {
    leading_ints(key.value, list);
    for (const int value : list) {
      if (value >= 1 && value <= bits.cols()) bits.set(row, value - 1, true);
    }
  });
}

}  // namespace

void read_private_sections(const WifText& text, const WifDialect& dialect, Diagnostics& diagnostics, Design& design) {
  const Source s{text, diagnostics};
  read_yarns(s, design);
  read_finish(s, design.finish);
  read_plan(s, design.plan);
  read_thread_yarns(s, "WARP YARNS", design.yarns.size(), design.draft.warp);
  read_thread_yarns(s, "WEFT YARNS", design.yarns.size(), design.draft.weft);
  read_look_and_scene(s, design);
  read_views(s, design.views);
  read_loom(s, design.loom);
  read_weaves(s, design.weaves);
  read_assembly(s, "WARP SECTIONS", design.warp_assembly);
  read_assembly(s, "WEFT SECTIONS", design.weft_assembly);
  read_exact_text(s, design);
  read_exact_colors(s, dialect, design.draft);
  read_exact_measures(s, "WARP SPACING", design.draft.warp.spacing_mm);
  read_exact_measures(s, "WEFT SPACING", design.draft.weft.spacing_mm);
  read_exact_measures(s, "WARP THICKNESS", design.draft.warp.thickness_mm);
  read_exact_measures(s, "WEFT THICKNESS", design.draft.weft.thickness_mm);
  if (design.draft.shed_control == ShedControl::kLiftplan) {
    read_inactive_grid(s, "TREADLING", design.draft.treadling);
  } else {
    read_inactive_grid(s, "LIFTPLAN", design.draft.liftplan);
  }
}

}  // namespace weftlight::wif
