// Writes [PRIVATE WEFTLIGHT ...]; read by read_private.cpp.

#include <algorithm>

#include "design/dye.h"
#include "design/fibre.h"
#include "design/yarn_presets.h"
#include "wif/design_sections.h"
#include "wif/encoding.h"
#include "wif/numbers.h"
#include "wif/private.h"

namespace weftlight::wif {

using design::Assembly, design::ClothPlan, design::Design, design::Dye, design::Finish, design::Look, design::Loom,
    design::NamedView, design::Scene, design::ThreadSection, design::WeaveUse, design::Yarn, design::YarnField,
    design::YarnPurchase, design::dye_text, design::kCrossSectionNames, design::kFinishFields, design::kLobeFields,
    design::kPliesFacts, design::kTwistNames, design::kYarnFields, design::method_name, design::ready_yarn,
    design::sleying_text;
using draft::BitMatrix, draft::Draft, draft::Rgb, draft::ShedControl, draft::Threads, draft::kFromYarn;

namespace {

void add(WifEntries& section, std::string key, std::string value, bool is_text = false) {
  section.entries.push_back({-1, std::move(key), std::move(value), is_text});
}

void push_if_any(std::vector<WifEntries>& out, WifEntries section) {
  if (section.entries.empty()) return;
  section.name.insert(0, kPrivate);
  out.push_back(std::move(section));
}

std::string color_text(const Rgb& c) {
  std::string text = shortest(c.r);
  return text.append(",").append(shortest(c.g)).append(",").append(shortest(c.b));
}

template <class T, size_t N>
void add_fields(WifEntries& section, const std::string& prefix, const FloatField<T> (&fields)[N], const T& value) {
  for (const FloatField<T>& field : fields) add(section, prefix + field.key, shortest(value.*field.member));
}

template <class T, size_t N>
void add_fields(WifEntries& section, const std::string& prefix, const std::array<YarnField<T>, N>& fields,
                const T& value) {
  for (const YarnField<T>& field : fields)
    if (!field.facts.optional || value.*field.member != 0)
      add(section, prefix + field.facts.key, shortest(value.*field.member));
}

/// Without the numbers that are the default, which the reader takes for them. Texts stay: an absent one is empty.
WifEntries without_defaults(WifEntries section, const WifEntries& defaults) {
  std::erase_if(section.entries, [&](const WifEntry& e) {
    return !e.is_text && std::ranges::find(defaults.entries, e) != defaults.entries.end();
  });
  return section;
}

/// As a text: its first number alone is not the value.
void add_dye(WifEntries& out, const std::string& prefix, const Dye& dye) {
  if (!dye.stretches.empty()) add(out, prefix + "Dye", dye_text(dye.stretches), true);
  if (dye.shift != 0) add(out, prefix + "Dye Shift", std::to_string(dye.shift));
  if (dye.scatter != 0) add(out, prefix + "Dye Scatter", std::to_string(dye.scatter));
}

WifEntries yarn_entries(const Yarn& yarn, const std::string& prefix) {
  WifEntries out;
  if (!yarn.name.empty()) add(out, prefix + "Name", escaped(yarn.name), true);
  add(out, prefix + std::string(kMadeOf), ready_yarn(yarn.fibre).name, true);
  add(out, prefix + std::string(kSection), kCrossSectionNames[static_cast<size_t>(yarn.section)], true);
  add(out, prefix + "Twist", kTwistNames[static_cast<size_t>(yarn.twist)]);
  add(out, prefix + kPliesFacts.key, std::to_string(yarn.plies));
  add_fields(out, prefix, kYarnFields, yarn);
  add_fields(out, prefix, kLobeFields, yarn.lobes);
  add(out, prefix + "Tint", color_text(yarn.lobes.specular_tint));
  add(out, prefix + "Metallic", yarn.lobes.metallic ? "true" : "false");
  add_dye(out, prefix, yarn.dye);
  return out;
}

WifEntries yarns_of(const std::vector<Yarn>& yarns, const WifDialect& dialect) {
  WifEntries section{"YARNS", {}};
  if (!dialect.has_yarns && yarns == std::vector<Yarn>{Yarn{}}) return section;
  add(section, "Yarns", std::to_string(yarns.size()));
  for (size_t i = 0; i < yarns.size(); ++i) {
    const std::string prefix = std::to_string(i + 1) + " ";
    WifEntries yarn = yarn_entries(yarns[i], prefix);
    if (dialect.leaves_out_defaults) yarn = without_defaults(std::move(yarn), yarn_entries(Yarn{}, prefix));
    std::ranges::move(yarn.entries, std::back_inserter(section.entries));
  }
  return section;
}

WifEntries finish_of(const Finish& finish) {
  WifEntries section{"FINISH", {}};
  if (finish == Finish{}) return section;
  for (const auto& field : kFinishFields) {
    // Files of before it have no such line, and stay as they are.
    if (field.member == &Finish::washed && finish.washed == Finish{}.washed) continue;
    add(section, field.facts.key, shortest(finish.*field.member));
  }
  return section;
}

void add_purchases(WifEntries& section, const std::vector<YarnPurchase>& purchases) {
  if (!purchases.empty()) add(section, "Purchases", std::to_string(purchases.size()));
  for (size_t i = 0; i < purchases.size(); ++i) {
    const YarnPurchase& p = purchases[i];
    const std::string prefix = std::to_string(i + 1) + " ";
    add(section, prefix + "Yarn", escaped(p.yarn), true);
    add(section, prefix + "Cone Weight", shortest(p.cone_g));
    add(section, prefix + "Cone Length", shortest(p.cone_m));
    add(section, prefix + "Price", shortest(p.price));
  }
}

WifEntries plan_entries(const ClothPlan& plan) {
  WifEntries section{"PLAN", {}};
  add_fields(section, "", kPlanFloats, plan);
  add(section, "Pieces", std::to_string(plan.pieces));
  add(section, "Reed", shortest(plan.reed.dents));
  add(section, "Reed Per Inch", plan.reed.per_inch ? "true" : "false");
  // As a text: its first number alone is not the value.
  if (plan.sleying != ClothPlan{}.sleying) add(section, "Sleying", sleying_text(plan.sleying), true);
  add(section, "Floating Selvedges", plan.floating_selvedges ? "true" : "false");
  add_purchases(section, plan.purchases);
  return section;
}

/// Only what differs from the default, in every file.
WifEntries plan_of(const ClothPlan& plan) { return without_defaults(plan_entries(plan), plan_entries({})); }

WifEntries thread_yarns_of(const char* name, const Threads& threads) {
  WifEntries section{name, {}};
  for (int i = 0; i < threads.size(); ++i) {
    const int yarn = threads.yarn[static_cast<size_t>(i)];
    if (yarn != 0) section.entries.push_back({i + 1, {}, std::to_string(yarn + 1), false});
  }
  return section;
}

WifEntries look_entries(const Look& look) {
  WifEntries section{"LOOK", {}};
  add(section, "Method", std::string(method_name(look.method)));
  add_fields(section, "", kLookFloats, look);
  if (!look.automatic_exposure) add(section, "Automatic Exposure", "false");
  return section;
}

WifEntries look_of(const Look& look, const WifDialect& dialect) {
  if (look == Look{}) return {"LOOK", {}};
  return dialect.leaves_out_defaults ? without_defaults(look_entries(look), look_entries({})) : look_entries(look);
}

WifEntries scene_entries(const Scene& scene) {
  WifEntries section{"SCENE", {}};
  if (!scene.mesh.empty()) add(section, "Mesh", escaped(scene.mesh), true);
  if (scene.simulated_drape) add(section, "Own Drape", "true");
  add_fields(section, "", kSceneFloats, scene);
  if (scene.lights != Scene{}.lights) add(section, "Lights", escaped(scene.lights), true);
  if (scene.surroundings) add(section, "Surroundings", "true");
  add(section, "Background", color_text(scene.background));
  return section;
}

WifEntries scene_of(const Scene& scene, const WifDialect& dialect) {
  if (scene == Scene{}) return {"SCENE", {}};
  return dialect.leaves_out_defaults ? without_defaults(scene_entries(scene), scene_entries({})) : scene_entries(scene);
}

WifEntries view_of(const NamedView& view, size_t number) {
  WifEntries section = view.scene == Scene{} ? WifEntries{} : scene_entries(view.scene);
  section.name = "VIEW " + std::to_string(number);
  add(section, "Name", escaped(view.name), true);
  if (view.flat) add(section, "Flat", "true");
  return section;
}

WifEntries loom_of(const Loom& loom) {
  WifEntries section{"LOOM", {}};
  if (loom == Loom{}) return section;
  add(section, "Authority", kLeadingNames[static_cast<size_t>(loom.leading)]);
  add(section, "Locked", loom.locked ? "true" : "false");
  add(section, "Shafts", std::to_string(loom.shafts));
  add(section, "Treadles", std::to_string(loom.treadles));
  add(section, "Next Pick", std::to_string(loom.next_pick));
  if (loom.next_end > 0) add(section, "Next End", std::to_string(loom.next_end));
  if (loom.next_dent > 0) add(section, "Next Dent", std::to_string(loom.next_dent));
  if (loom.tabby_between) add(section, "Tabby Between", "true");
  if (loom.at_tabby) add(section, "At Tabby", "true");
  if (loom.second_tabby) add(section, "Second Tabby", "true");
  return section;
}

WifEntries weaves_of(const std::vector<WeaveUse>& weaves) {
  WifEntries section{"WEAVES", {}};
  if (weaves.empty()) return section;
  add(section, "Weaves", std::to_string(weaves.size()));
  for (size_t i = 0; i < weaves.size(); ++i) {
    const WeaveUse& use = weaves[i];
    const std::string prefix = std::to_string(i + 1) + " ";
    add(section, prefix + "Weave", escaped(use.weave), true);
    std::string place = std::to_string(use.first_end + 1);
    for (const int number : {use.ends, use.first_pick + 1, use.picks}) place.append(",").append(std::to_string(number));
    add(section, prefix + "Place", place);
    for (const auto& [id, value] : use.values)
      add(section, prefix + std::string(kWeaveNumber) + id, escaped(value), true);
  }
  return section;
}

/// "1 2 1+3 0": the set bits of each row, counted from 1.
std::string rows_text(const BitMatrix& rows) {
  std::string out;
  for (int row = 0; row < rows.rows(); ++row) {
    std::string list = bit_list(rows, row);
    std::ranges::replace(list, ',', '+');
    out.append(row > 0 ? " " : "").append(list);
  }
  return out;
}

template <class T, class Text>
void add_column(WifEntries& section, const std::string& key, const std::vector<T>& values, T default_value, Text text) {
  if (std::ranges::all_of(values, [&](const T& v) { return v == default_value; })) return;
  std::string out;
  for (const T& value : values) out.append(out.empty() ? "" : " ").append(text(value));
  add(section, key, out);
}

WifEntries assembly_entries(const char* name, const Assembly& assembly) {
  WifEntries section{name, {}};
  if (assembly == Assembly{}) return section;
  if (!assembly.order.empty()) add(section, "Order", escaped(assembly.order), true);
  add(section, "Sections", std::to_string(assembly.sections.size()));
  const auto from_1 = [](int i) { return std::to_string(i + 1); };
  for (size_t i = 0; i < assembly.sections.size(); ++i) {
    const ThreadSection& s = assembly.sections[i];
    const std::string prefix = std::to_string(i + 1) + " ";
    add(section, prefix + "Name", escaped(s.name), true);
    add(section, prefix + "Columns", std::to_string(s.rows.cols()));
    if (s.shed_control == ShedControl::kLiftplan) add(section, prefix + "Lifts", "true");
    add(section, prefix + "Rows", rows_text(s.rows));
    add_column(section, prefix + "Colors", s.threads.color, 0, from_1);
    add_column(section, prefix + "Yarns", s.threads.yarn, 0, from_1);
    add_column(section, prefix + "Spacing", s.threads.spacing_mm, kFromYarn, shortest);
    add_column(section, prefix + "Thickness", s.threads.thickness_mm, kFromYarn, shortest);
  }
  return section;
}

void add_exact(WifEntries& section, std::string key, const std::string& text) {
  if (one_line(text) != text) add(section, std::move(key), escaped(text), true);
}

WifEntries exact_text_of(const Design& design) {
  WifEntries section{"TEXT", {}};
  add_exact(section, "Title", design.title);
  add_exact(section, "Author", design.author);
  for (size_t i = 0; i < design.notes.size(); ++i) add_exact(section, "Note " + std::to_string(i + 1), design.notes[i]);
  return section;
}

WifEntries exact_colors_of(const std::vector<Rgb>& palette, const WifDialect& dialect) {
  WifEntries section{"COLORS", {}};
  const double span = dialect.range_high - static_cast<double>(dialect.range_low);
  const auto is_exact = [&](float channel) {
    const int number = channel_number(channel, dialect.range_low, dialect.range_high);
    return static_cast<float>((static_cast<double>(number) - dialect.range_low) / span) == channel;
  };
  for (size_t i = 0; i < palette.size(); ++i) {
    const Rgb& c = palette[i];
    if (!is_exact(c.r) || !is_exact(c.g) || !is_exact(c.b))
      section.entries.push_back({static_cast<int>(i) + 1, {}, color_text(c), false});
  }
  return section;
}

WifEntries exact_measures_of(const char* name, const std::vector<float>& mm) {
  WifEntries section{name, {}};
  for (size_t i = 0; i < mm.size(); ++i) {
    const bool public_value = mm[i] == kFromYarn || (mm[i] > 0 && mm[i] < kAny);
    if (!public_value) section.entries.push_back({static_cast<int>(i) + 1, {}, shortest(mm[i]), false});
  }
  return section;
}

WifEntries inactive_grid(const char* name, const BitMatrix& bits) {
  WifEntries section{name, {}};
  for (int row = 0; row < bits.rows(); ++row) {
    if (bits.first(row) >= 0) section.entries.push_back({row + 1, {}, bit_list(bits, row), false});
  }
  return section;
}

}  // namespace

void append_private_sections(std::vector<WifEntries>& out, const Design& design, const WifDialect& dialect) {
  const Draft& draft = design.draft;
  push_if_any(out, yarns_of(design.yarns, dialect));
  push_if_any(out, finish_of(design.finish));
  push_if_any(out, plan_of(design.plan));
  push_if_any(out, thread_yarns_of("WARP YARNS", draft.warp));
  push_if_any(out, thread_yarns_of("WEFT YARNS", draft.weft));
  push_if_any(out, look_of(design.look, dialect));
  push_if_any(out, scene_of(design.scene, dialect));
  for (size_t i = 0; i < design.views.size(); ++i) push_if_any(out, view_of(design.views[i], i + 1));
  push_if_any(out, loom_of(design.loom));
  push_if_any(out, weaves_of(design.weaves));
  push_if_any(out, assembly_entries("WARP SECTIONS", design.warp_assembly));
  push_if_any(out, assembly_entries("WEFT SECTIONS", design.weft_assembly));
  push_if_any(out, exact_text_of(design));
  push_if_any(out, exact_colors_of(draft.palette, dialect));
  push_if_any(out, exact_measures_of("WARP SPACING", draft.warp.spacing_mm));
  push_if_any(out, exact_measures_of("WEFT SPACING", draft.weft.spacing_mm));
  push_if_any(out, exact_measures_of("WARP THICKNESS", draft.warp.thickness_mm));
  push_if_any(out, exact_measures_of("WEFT THICKNESS", draft.weft.thickness_mm));
  const bool treadled = draft.shed_control == ShedControl::kTreadling;
  push_if_any(out, treadled ? inactive_grid("LIFTPLAN", draft.liftplan) : inactive_grid("TREADLING", draft.treadling));
}

}  // namespace weftlight::wif
