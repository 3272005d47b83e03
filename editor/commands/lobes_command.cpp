// `weftlight lobes`: the draft with the lobes of its yarns fitted to their traced fibres.

#include "base/text.h"
#include "commands/commands.h"
#include "commands/open_design.h"
#include "commands/progress_line.h"
#include "render_data/fibre_lobes.h"

namespace weftlight::commands {

using base::Result, base::TaskProgress, base::arg, base::fill, base::tr, base::write_file_atomically;
using design::Yarn;
using render_data::FibreLobes, render_data::lobes_of_fibres;
using wif::write_wif;

namespace {

ProgressForm form_of(const LobesOptions& o) {
  if (o.quiet) return ProgressForm::kNone;
  return o.progress_json ? ProgressForm::kJson : ProgressForm::kTerminal;
}

std::string result_text(const FibreLobes& fitted) {
  return fill(tr("{before:.2f} octaves from its fibres, now {now:.2f}"), arg("before", fitted.octaves_before),
              arg("now", fitted.octaves));
}

}  // namespace

int lobes_command(const LobesOptions& o) {
  if (const auto place = base::check_writable(o.out); !place) return fail(place.error());
  OpenedDesign opened = open_design(o.file);
  if (!opened.ok) return kBadInput;
  std::vector<Yarn>& yarns = opened.design.yarns;
  const auto say = [&o](const std::string& yarn, const std::string& what) {
    if (!o.quiet) print_row(yarn, what);
  };
  ProgressMeter meter(form_of(o), static_cast<int>(yarns.size()));
  for (size_t k = 0; k < yarns.size(); ++k) {
    Yarn& yarn = yarns[k];
    const int index = static_cast<int>(k);
    if (yarn.lobes.metallic) {
      meter.skip(index, yarn.name);
      meter.clear();
      say(yarn.name, tr("metallic: has no dye, stays as it is"));
      continue;
    }
    const TaskProgress progress({}, [&](float share, const std::string&) {
      meter.set(index, std::min(static_cast<double>(share), 0.999), yarn.name);
    });
    const Result<FibreLobes> fitted = lobes_of_fibres(yarn, {.fit_lustre = o.fit_lustre}, progress);
    meter.clear();
    if (!fitted) return fail({fitted.error().kind, base::message(fitted.error()), o.file});
    yarn.lobes = fitted->lobes;
    say(yarn.name, result_text(*fitted));
  }
  const Result<void> saved = write_file_atomically(o.out, write_wif(opened.file, opened.design));
  if (saved && !yarns.empty()) meter.set(static_cast<int>(yarns.size()) - 1, 1, o.out);
  return finish(saved);
}

}  // namespace weftlight::commands
