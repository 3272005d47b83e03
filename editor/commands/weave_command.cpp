// `weave`: a draft from the table of weaves.

#include <algorithm>
#include <cstdio>
#include <utility>

#include "analysis/loom_sett.h"
#include "base/text.h"
#include "commands/closest_word.h"
#include "commands/commands.h"
#include "design/edits.h"
#include "design/yarn_presets.h"
#include "weaves/table.h"

namespace weftlight::commands {

using analysis::Units, analysis::firm_sett, analysis::with_loom_sett;
using base::arg, base::fill, base::tr, base::write_file_atomically;
using weaves::GeneratedWeave, weaves::ParameterKind, weaves::WeaveKind, weaves::WeaveParameter, weaves::WeaveValues,
    weaves::cut_repeat_note, weaves::find_weave, weaves::new_draft, weaves::weave_kinds, weaves::with_ground_yarn;
using wif::write_new_wif;

namespace {

/// "(2 to 32)", "(own, point)", or nothing for a text.
std::string range_text(const WeaveParameter& parameter) {
  if (parameter.kind == ParameterKind::kCount)
    return fill(tr("({low} to {high})"), arg("low", parameter.low), arg("high", parameter.high));
  std::string choices;
  for (const char* choice : parameter.choices) choices.append(choices.empty() ? "" : ", ").append(choice);
  return choices.empty() ? "" : "(" + choices + ")";
}

void print_kind(const WeaveKind& kind) {
  std::printf("%-18s %s: %s\n", kind.id, tr(kind.name), tr(kind.description));
  for (const WeaveParameter& parameter : kind.parameters) {
    const std::string range = range_text(parameter);
    std::printf("  --set %s=%s%s%s  %s\n", parameter.id, parameter.default_value, range.empty() ? "" : "  ",
                range.c_str(), tr(parameter.tip));
  }
}

bool has_parameter(const WeaveKind& kind, const std::string& id) {
  return std::any_of(kind.parameters.begin(), kind.parameters.end(),
                     [&id](const WeaveParameter& parameter) { return id == parameter.id; });
}

/// "ratio, direction".
std::string parameter_names(const WeaveKind& kind) {
  std::string names;
  for (const WeaveParameter& parameter : kind.parameters) names.append(names.empty() ? "" : ", ").append(parameter.id);
  return names;
}

/// What is wrong with --set ID=VALUE; empty if nothing is.
std::string problem_of_setting(const WeaveKind& kind, const std::string& one) {
  const std::string id = one.substr(0, one.find('='));
  if (kind.parameters.empty())
    return fill(tr("--set {value}: the weave {weave} has no parameters"), arg("value", one), arg("weave", kind.id));
  if (!has_parameter(kind, id))
    return fill(tr("--set {value}: the weave {weave} has no such parameter; it has {names}"), arg("value", one),
                arg("weave", kind.id), arg("names", parameter_names(kind)));
  if (id.size() == one.size())
    return fill(tr("--set {value}: give its value, as --set {value}=VALUE; see weftlight weave --list"),
                arg("value", one));
  return {};
}

/// False, with a line on stderr, if an entry is not of the form ID=VALUE or names no parameter of the weave.
bool read_values(const WeaveKind& kind, const std::vector<std::string>& set, WeaveValues& values) {
  for (const std::string& one : set) {
    if (const std::string problem = problem_of_setting(kind, one); !problem.empty()) {
      refuse(problem);
      return false;
    }
    const size_t equals = one.find('=');
    values.emplace_back(one.substr(0, equals), one.substr(equals + 1));
  }
  return true;
}

std::string unknown_weave(const std::string& id) {
  if (id.empty()) return tr("give the id of a weave; see weftlight weave --list");
  std::vector<std::string> ids;
  for (const WeaveKind& kind : weave_kinds()) ids.emplace_back(kind.id);
  const std::string closest = closest_word(id, ids);
  return closest.empty() ? fill(tr("no weave is called '{name}'; see weftlight weave --list"), arg("name", id))
                         : fill(tr("no weave is called '{name}'; did you mean '{closest}'?"), arg("name", id),
                                arg("closest", closest));
}

void warn(const WeaveOptions& options, const std::string& problem) {
  if (problem.empty()) return;
  const std::string line = fill(tr("{file}: warning: {problem}"), arg("file", options.out), arg("problem", problem));
  std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace

int weave_command(const WeaveOptions& options) {
  if (options.list) {
    for (const WeaveKind& kind : weave_kinds()) print_kind(kind);
    return kDone;
  }
  const WeaveKind* kind = find_weave(options.weave);
  if (!kind) return refuse(unknown_weave(options.weave));
  if (options.out.empty()) return refuse(tr("give a name for the draft with -o; see weftlight weave --help"));
  if (int64_t{options.ends} * options.picks > draft::kMaxCells)
    return refuse(fill(tr("--ends {ends} --picks {picks}: this is more than the {most} crossings that can be opened"),
                       arg("ends", options.ends), arg("picks", options.picks), arg("most", draft::kMaxCells)));
  WeaveValues values;
  if (!read_values(*kind, options.set, values)) return kUsage;
  if (const auto made = check_values(*kind, values); !made) return refuse(problem_of(made));
  GeneratedWeave generated = new_draft(*kind, values, {options.ends, options.picks});
  generated.design = with_ground_yarn(std::move(generated.design), design::ready_yarn(design::Fibre::kCotton));
  const analysis::LoomSett sett = firm_sett(generated.design, Units::kMetric);
  generated.design = with_loom_sett(std::move(generated.design), sett, Units::kMetric);
  generated.design.title = kind->name;
  warn(options, generated.note);
  warn(options, cut_repeat_note(*kind, values, {options.ends, options.picks}));
  return finish(write_file_atomically(options.out, write_new_wif(generated.design)));
}

}  // namespace weftlight::commands
