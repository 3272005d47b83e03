// `convert`: a copy of the draft, the same bytes unless another drive, another loom or the plain form is asked for.

#include <cstdio>
#include <utility>

#include "commands/commands.h"
#include "draft/edits.h"
#include "draft/factor.h"

namespace weftlight::commands {
namespace {

bool asks_for_loom(const ConvertOptions& o) { return o.loom != LoomSize{}; }

std::string converted(const WifFile& file, const Design& design, const ConvertOptions& options) {
  const bool liftplan = options.drive == ConvertShedControl::kLiftplan,
             treadling = options.drive == ConvertShedControl::kTreadling;
  if (options.plain) {
    return write_plain_wif(design, liftplan    ? PlainShedControl::kLiftplan
                                   : treadling ? PlainShedControl::kTreadling
                                               : PlainShedControl::kAsIs);
  }
  return liftplan || treadling || asks_for_loom(options) ? write_wif(file, design) : file.bytes;
}

/// Driven as asked; an exit code, with the problem printed.
int drive(Design& design, const ConvertOptions& options) {
  if (options.drive == ConvertShedControl::kLiftplan) design = to_liftplan(std::move(design));
  if (options.drive != ConvertShedControl::kTreadling) return kDone;
  design = to_treadling(std::move(design));
  if (design.draft.drive == ShedControl::kTreadling) return kDone;
  std::fprintf(stderr, "%s: the draft needs more than %d treadles; keep its liftplan\n", options.in.c_str(),
               kMaxShafts);
  return kBadInput;
}

/// The same for the loom.
int fit(Design& design, const ConvertOptions& options) {
  if (!asks_for_loom(options)) return kDone;
  Factored fitted = within_loom(design.draft, options.loom);
  if (!fitted.done() && !options.nearest) {
    std::fprintf(stderr, "%s: %s; --nearest weaves it as nearly as that loom can\n", options.in.c_str(),
                 fitted.why.c_str());
    return kBadInput;
  }
  if (!fitted.done()) {
    fitted = closest_drawdown(design.draft, drawdown(design.draft), options.loom);
    const long long all = static_cast<long long>(design.draft.ends()) * design.draft.picks();
    std::printf("%lld of %lld crossings differ\n", static_cast<long long>(fitted.wrong), all);
  }
  design.draft = std::move(fitted.draft);
  return kDone;
}

}  // namespace

int convert_command(const ConvertOptions& options) {
  if (options.picture != files::PictureDraft{} && !is_picture(options.in)) {
    std::fprintf(stderr, "weftlight: --ends, --colors and --floats are for pictures, and %s is none\n",
                 options.in.c_str());
    return kUsage;
  }
  const OpenedDesign opened = open_design(options.in, false, options.picture);
  if (!opened.ok) return kBadInput;
  Design design = opened.design;
  if (const int code = drive(design, options); code != kDone) return code;
  if (const int code = fit(design, options); code != kDone) return code;
  const std::string error = write_file_atomically(options.out, converted(opened.file, design, options));
  return error.empty() ? kDone : not_written(error);
}

}  // namespace weftlight::commands
