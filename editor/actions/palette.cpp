// The lists of colours and yarns of the draft: swap, sort, merge, remove. Under Draft.

#include <algorithm>
#include <optional>
#include <utility>

#include "actions/action_parts.h"
#include "render_data/fibre_lobes.h"
#include "session/editing/palette_deletion.h"

namespace weftlight::actions {

using base::mark, base::tr;
using design::ColorOrder, design::Design, design::Yarn, design::with_merged_colors, design::with_merged_yarns,
    design::with_sorted_colors, design::with_sorted_yarns, design::with_swapped_lightness, design::with_swapped_systems,
    design::without_unused_colors, design::without_unused_yarns;
using render_data::FibreLobes, render_data::lobes_of_fibres;
using session::Edit, session::SlowEdit, session::keeping_active;

namespace {

/// An action whose label is that of its edit. `unchanged`: said if there was nothing to do; null: never.
struct PaletteAction {
  const char *submenu, *id, *label;  // `submenu`: marked
  Design (*edit)(Design);
  const char* unchanged = nullptr;
};

Action& add_edit(Actions& all, const ActiveDraft& draft, const PaletteAction& a) {
  Action& added = add(all, "Draft", a.id, a.label, "", [&draft, a] {
    Edit edit{a.label, a.edit};
    if (a.unchanged) edit.why = [text = a.unchanged](const Design&) { return std::string(text); };
    keeping_active(draft.view().drawing, draft.document(), [&] { draft.commit(edit); });
  });
  added.item.submenu = a.submenu;
  return added;
}

Action& add_dialog(Actions& all, const char* submenu, const char* id, const char* label,
                   const std::function<void()>& run) {
  Action& added = add(all, "Draft", id, label, "", run);
  added.item.submenu = submenu;
  return added;
}

/// Takes a minute, in which the weaver goes on: the optics are for the yarn, whatever is woven with it meanwhile.
SlowEdit optics_from_fibres(size_t yarn) {
  SlowEdit edit;
  edit.label = tr("Fit optics to the fibres");
  edit.doing = tr("Tracing the fibres of the yarn");
  edit.no_change = tr("No optics are nearer to the fibres than these.");
  edit.apply = [yarn](Design d, const base::TaskProgress& progress) -> base::Result<Design> {
    const base::Result<FibreLobes> fitted = lobes_of_fibres(d.yarns[yarn], {}, progress);
    if (!fitted) return failed(fitted);
    d.yarns[yarn].lobes = fitted->lobes;
    return d;
  };
  edit.onto = [yarn](Design now, const Design& before, const Design& made) -> std::optional<Design> {
    if (yarn >= now.yarns.size() || !(now.yarns[yarn] == before.yarns[yarn])) return std::nullopt;
    now.yarns[yarn] = made.yarns[yarn];
    return now;
  };
  return edit;
}

Design by_hue(Design d) { return with_sorted_colors(std::move(d), ColorOrder::kHue); }
Design by_lightness(Design d) { return with_sorted_colors(std::move(d), ColorOrder::kLightness); }

}  // namespace

void add_palette_actions(Actions& all, const ActiveDraft& draft, const DraftDialogs& dialogs,
                         const YarnActions& yarns) {
  constexpr const char *kColors = mark("Colours"), *kYarns = mark("Yarns");
  const char* const sorted = tr("Already in this order.");
  add_dialog(all, kColors, "colors.gradient", tr("Gradient\xE2\x80\xA6"), dialogs.gradient);
  add_edit(all, draft,
           {kColors, "colors.swap_systems", tr("Swap warp and weft colours"), with_swapped_systems,
            tr("Warp and weft have the same colours.")});
  add_edit(all, draft,
           {kColors, "colors.swap_lightness", tr("Swap light and dark colours"), with_swapped_lightness,
            tr("All threads have one colour.")});
  new_group(add_edit(all, draft, {kColors, "colors.sort_hue", tr("Sort colours by hue"), by_hue, sorted}));
  add_edit(all, draft, {kColors, "colors.sort_lightness", tr("Sort colours from light to dark"), by_lightness, sorted});
  add_edit(all, draft,
           {kColors, "colors.merge", tr("Merge identical colours"), with_merged_colors,
            tr("There are no identical colours.")});
  add_edit(all, draft,
           {kColors, "colors.remove_unused", tr("Remove unused colours"), without_unused_colors,
            tr("Every colour is in use.")});
  add_dialog(all, kColors, "colors.delete", tr("Delete the active colour"), dialogs.delete_color).enabled = [&draft] {
    return draft.document().now().draft.palette.size() > 1;
  };
  add_dialog(all, kYarns, "yarns.library", tr("Yarn library\xE2\x80\xA6"), yarns.show_library);
  add_dialog(all, kYarns, "yarns.keep", tr("Add the active yarn to the library"), yarns.keep);
  const auto active = [&draft]() -> const Yarn& {
    return draft.document().now().yarns[static_cast<size_t>(draft.view().drawing.yarn)];
  };
  add_dialog(all, kYarns, "yarns.optics_from_fibres", tr("Optics from the fibres"), [&draft] {
    draft.compute(optics_from_fibres(static_cast<size_t>(draft.view().drawing.yarn)));
  }).enabled = [active] { return !active().lobes.metallic; };
  new_group(add_edit(all, draft, {kYarns, "yarns.sort", tr("Sort yarns by name"), with_sorted_yarns, sorted}));
  add_edit(
      all, draft,
      {kYarns, "yarns.merge", tr("Merge identical yarns"), with_merged_yarns, tr("There are no identical yarns.")});
  add_edit(
      all, draft,
      {kYarns, "yarns.remove_unused", tr("Remove unused yarns"), without_unused_yarns, tr("Every yarn is in use.")});
  add_dialog(all, kYarns, "yarns.delete", tr("Delete the active yarn"), dialogs.delete_yarn).enabled = [&draft] {
    return draft.document().now().yarns.size() > 1;
  };
}

}  // namespace weftlight::actions
