// `info`: the properties of a draft as text or as JSON.

#include <cstdio>

#include "analysis/floats.h"
#include "base/json.h"
#include "base/text.h"
#include "commands/commands.h"
#include "commands/open_design.h"
#include "design/repeat.h"
#include "weaves/families.h"

namespace weftlight::commands {

using analysis::LongestFloats, analysis::longest_floats;
using base::arg, base::fill, base::mark, base::tr;
using design::Design, design::Repeat, design::design_repeat, design::structure_repeat;
using draft::BitMatrix, draft::Draft, draft::ShedControl, draft::drawdown;
using weaves::iso_code;
using wif::Diagnostic, wif::Severity;

namespace {

/// For JSON; tr() of it for people.
const char* severity_name(Severity severity) {
  return severity == Severity::kError ? mark("error") : severity == Severity::kWarning ? mark("warning") : mark("note");
}

/// What the text and the JSON show.
struct Facts {
  LongestFloats floats;
  Repeat repeat;
  std::string weave_code;  // of ISO 9354; empty: none
};

Facts facts_of(const Design& design) {
  const BitMatrix cells = drawdown(design.draft);
  const Repeat weave = structure_repeat(cells);
  return {longest_floats(cells), design_repeat(design, cells), iso_code(cells, {weave.ends, weave.picks})};
}

nlohmann::ordered_json as_json(const OpenedDesign& opened, const Facts& facts) {
  const LongestFloats& floats = facts.floats;
  const Repeat& repeat = facts.repeat;
  const Draft& draft = opened.design.draft;
  nlohmann::ordered_json json = {{"ends", draft.ends()},
                                 {"picks", draft.picks()},
                                 {"shafts", draft.shafts},
                                 {"treadles", draft.treadles},
                                 {"rising", draft.rising},
                                 {"source_program", opened.file.source_program},
                                 {"title", opened.design.title},
                                 {"has_liftplan", opened.file.has_liftplan},
                                 {"longest_float",
                                  {{"warp_front", floats.warp_front},
                                   {"warp_back", floats.warp_back},
                                   {"weft_front", floats.weft_front},
                                   {"weft_back", floats.weft_back}}},
                                 {"repeat", {{"ends", repeat.ends}, {"picks", repeat.picks}}},
                                 {"weave_code", facts.weave_code},
                                 {"versions", nlohmann::ordered_json::array()},
                                 {"warnings", nlohmann::ordered_json::array()}};
  for (const design::Version& version : opened.design.versions) json["versions"].push_back(version.name);
  for (const Diagnostic& d : opened.diagnostics) {
    json["warnings"].push_back(
        {{"line", d.line}, {"severity", severity_name(d.severity)}, {"text", d.text}, {"remedy", d.remedy}});
  }
  return json;
}

void print_text(const std::string& path, const OpenedDesign& opened, const Facts& facts) {
  const Draft& draft = opened.design.draft;
  if (!opened.design.title.empty()) print_row(tr("title"), opened.design.title);
  if (!opened.file.source_program.empty()) print_row(tr("source program"), opened.file.source_program);
  print_row(tr("ends"), std::to_string(draft.ends()));
  print_row(tr("picks"), std::to_string(draft.picks()));
  print_row(tr("shafts"), std::to_string(draft.shafts));
  print_row(tr("treadles"), std::to_string(draft.treadles));
  print_row(tr("shed"), draft.rising ? tr("rising") : tr("sinking"));
  const bool liftplan = draft.shed_control == ShedControl::kLiftplan;
  print_row(tr("shed control"), liftplan ? tr("liftplan") : tr("tie-up and treadling"));
  print_row(tr("longest float"), longest_float_text(facts.floats));
  print_row(tr("repeat"), threads_text(facts.repeat.ends, facts.repeat.picks));
  if (!facts.weave_code.empty())
    print_row(tr("weave code"), fill(tr("{code} (ISO 9354)"), arg("code", facts.weave_code)));
  for (const design::Version& version : opened.design.versions) print_row(tr("version"), version.name);
  for (const Diagnostic& d : opened.diagnostics) {
    const std::string file = d.line > 0 ? path + ":" + std::to_string(d.line) : path;
    const std::string line =
        fill(tr("{file}: {severity}: {problem}; {remedy}"), arg("file", file),
             arg("severity", tr(severity_name(d.severity))), arg("problem", d.text), arg("remedy", d.remedy));
    std::printf("%s\n", line.c_str());
  }
}

}  // namespace

int info_command(const InfoOptions& options) {
  const OpenedDesign opened = open_design(options.file);
  if (!opened.ok) return kBadInput;
  const Facts facts = facts_of(opened.design);
  if (options.json) {
    std::printf("%s\n", as_json(opened, facts).dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
  } else {
    print_text(options.file, opened, facts);
  }
  return kDone;
}

}  // namespace weftlight::commands
