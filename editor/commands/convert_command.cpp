// `convert`: a copy of the draft, the same bytes unless it is turned, or another shed control, another loom or the
// plain form is asked for.

#include <cstdio>
#include <utility>

#include "base/text.h"
#include "commands/commands.h"
#include "commands/open_design.h"
#include "design/edits.h"
#include "design/palette_edits.h"
#include "design/turned.h"
#include "design/versions.h"
#include "draft/factor.h"

namespace weftlight::commands {

using base::ErrorKind, base::arg, base::fill, base::tr, base::tr_n, base::write_file_atomically;
using design::Design, design::Version, design::at_version, design::to_liftplan, design::to_treadling, design::turned,
    design::version_named, design::with_merged_colors, design::with_merged_yarns, design::without_unused_colors,
    design::without_unused_yarns;
using draft::ClosestDraft, draft::LoomSize, draft::ShedControl, draft::closest_drawdown, draft::drawdown,
    draft::kMaxShafts, draft::within_loom, draft::Draft;
using files::is_picture;
using wif::PlainShedControl, wif::WifFile, wif::write_plain_wif, wif::write_wif;

namespace {

bool asks_for_loom(const ConvertOptions& o) { return o.loom != LoomSize{}; }

std::string converted(const WifFile& file, const Design& design, const ConvertOptions& options) {
  const bool liftplan = options.shed_control == ConvertShedControl::kLiftplan,
             treadling = options.shed_control == ConvertShedControl::kTreadling;
  if (options.plain) {
    return write_plain_wif(design, liftplan    ? PlainShedControl::kLiftplan
                                   : treadling ? PlainShedControl::kTreadling
                                               : PlainShedControl::kAsIs);
  }
  const bool changed =
      liftplan || treadling || asks_for_loom(options) || options.turned || options.tidy || !options.version.empty();
  return changed ? write_wif(file, design) : file.bytes;
}

Design tidied(Design design, const ConvertOptions& options) {
  if (!options.tidy) return design;
  design = without_unused_colors(with_merged_colors(std::move(design)));
  return without_unused_yarns(with_merged_yarns(std::move(design)));
}

base::Result<Design> with_shed_control(Design design, const ConvertOptions& options) {
  if (options.shed_control == ConvertShedControl::kLiftplan) return to_liftplan(std::move(design));
  if (options.shed_control != ConvertShedControl::kTreadling) return design;
  design = to_treadling(std::move(design));
  if (design.draft.shed_control == ShedControl::kTreadling) return design;
  return base::failure(
      ErrorKind::kInput,
      fill(tr("the draft needs more than {count} treadles; keep its liftplan"), arg("count", int{kMaxShafts})),
      options.in);
}

/// The draft as one of its versions keeps it.
base::Result<Design> at_named_version(Design design, const ConvertOptions& options) {
  if (options.version.empty()) return design;
  if (const Version* version = version_named(design, options.version)) return at_version(design, *version);
  std::string names;
  for (const Version& version : design.versions) names.append(names.empty() ? "" : ", ").append(version.name);
  const char* why = names.empty() ? tr("the draft has no versions, so none is called '{name}'")
                                  : tr("no version is called '{name}'; there are: {names}");
  return base::failure(ErrorKind::kInput, fill(why, arg("name", options.version), arg("names", names)), options.in);
}

base::Result<Design> turned_if_asked(Design design, const ConvertOptions& options) {
  if (!options.turned) return design;
  return turned(design).map_error([&](base::Error error) {
    error.file = options.in;
    return error;
  });
}

/// Makes the draft fit the loom.
base::Result<Design> fitted_to_loom(Design design, const ConvertOptions& options) {
  if (!asks_for_loom(options)) return design;
  base::Result<Draft> fitted = within_loom(design.draft, options.loom);
  if (!fitted && !options.closest) {
    return base::failure(
        ErrorKind::kInput,
        fill(tr("{problem}; --closest gives the closest weave for that loom"), arg("problem", fitted.error().text)),
        options.in);
  }
  if (!fitted) {
    ClosestDraft closest = closest_drawdown(design.draft, drawdown(design.draft), options.loom);
    const long long all = static_cast<long long>(design.draft.ends()) * design.draft.picks();
    const std::string line =
        fill(tr_n("{count} of {all} crossings differs", "{count} of {all} crossings differ", closest.wrong),
             arg("count", closest.wrong), arg("all", all));
    std::printf("%s\n", line.c_str());
    fitted = std::move(closest.draft);
  }
  design.draft = std::move(*fitted);
  return design;
}

}  // namespace

int convert_command(const ConvertOptions& options) {
  if (options.picture != files::PictureDraft{} && !is_picture(options.in)) {
    return refuse(fill(tr("--crop, --ends, --picks, --colors, --weave, --floats and --picture-colors apply to pictures "
                          "only, and {file} is "
                          "not a picture"),
                       arg("file", options.in)));
  }
  const OpenedDesign opened = open_design(options.in, false, options.picture);
  if (!opened.ok) return kBadInput;
  const base::Result<Design> design =
      at_named_version(opened.design, options)
          .map([&](Design taken) { return tidied(std::move(taken), options); })
          .and_then([&](Design taken) { return turned_if_asked(std::move(taken), options); })
          .and_then([&](Design taken) { return with_shed_control(std::move(taken), options); })
          .and_then([&](Design changed) { return fitted_to_loom(std::move(changed), options); });
  if (!design) return fail(design.error());
  return finish(write_file_atomically(options.out, converted(opened.file, *design, options)));
}

}  // namespace weftlight::commands
