// `weave`: a draft from the table of weaves, or over some threads of a draft.

#include <cstdio>

#include "commands/commands.h"
#include "draft/edits.h"
#include "draft/generators/table.h"

namespace weftlight::commands {
namespace {

void print_kind(const WeaveKind& kind) {
  std::printf("%-18s %s: %s\n", kind.id, kind.name, kind.description);
  for (const WeaveParameter& n : kind.parameters) {
    std::printf("  --set %s=%s", n.id, n.default_value);
    if (n.kind == ParameterKind::kCount) std::printf("  (%d to %d)", n.low, n.high);
    for (size_t i = 0; i < n.choices.size(); ++i) std::printf(i == 0 ? "  (%s" : ", %s", n.choices[i]);
    std::printf("%s  %s\n", n.choices.empty() ? "" : ")", n.tip);
  }
}

/// False, with a line on stderr, when one is not of the form ID=VALUE or names no number of the weave.
bool take_values(const WeaveKind& kind, const std::vector<std::string>& set, WeaveValues& values) {
  for (const std::string& one : set) {
    const size_t equals = one.find('=');
    const std::string id = one.substr(0, equals);
    bool known = equals != std::string::npos;
    if (known) {
      known = false;
      for (const WeaveParameter& n : kind.parameters) known = known || id == n.id;
    }
    if (!known) {
      std::fprintf(stderr, "weftlight: --set %s: the weave %s has no such number; see weftlight weave --list\n",
                   one.c_str(), kind.id);
      return false;
    }
    values.emplace_back(id, one.substr(equals + 1));
  }
  return true;
}

}  // namespace

int weave_command(const WeaveOptions& options) {
  if (options.list) {
    for (const WeaveKind& kind : weave_kinds()) print_kind(kind);
    return kDone;
  }
  const WeaveKind* kind = find_weave(options.weave);
  if (!kind || options.out.empty()) {
    std::fprintf(stderr, "weftlight: %s; see weftlight weave --list\n",
                 kind ? "give a name for the draft with -o" : "there is no such weave");
    return kUsage;
  }
  WeaveValues values;
  if (!take_values(*kind, options.set, values)) return kUsage;
  GeneratedWeave made = new_draft(*kind, values, {options.ends, options.picks});
  made.design.title = kind->name;
  if (!made.why.empty()) std::fprintf(stderr, "%s: warning: %s\n", options.out.c_str(), made.why.c_str());
  const std::string error = write_file_atomically(options.out, write_new_wif(made.design));
  return error.empty() ? kDone : not_written(error);
}

}  // namespace weftlight::commands
