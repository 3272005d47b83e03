// `info`: what a draft is, for people or as JSON.

#include <cstdio>
#include <nlohmann/json.hpp>

#include "analysis/floats.h"
#include "commands/commands.h"
#include "draft/repeat.h"

namespace weftlight::commands {
namespace {

const char* severity_name(Severity severity) {
  return severity == Severity::kError ? "error" : severity == Severity::kWarning ? "warning" : "note";
}

nlohmann::ordered_json as_json(const OpenedDesign& opened, const LongestFloats& floats, const Repeat& repeat) {
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
                                 {"warnings", nlohmann::ordered_json::array()}};
  for (const Diagnostic& d : opened.diagnostics) {
    json["warnings"].push_back(
        {{"line", d.line}, {"severity", severity_name(d.severity)}, {"text", d.text}, {"remedy", d.remedy}});
  }
  return json;
}

void print_text(const std::string& path, const OpenedDesign& opened, const LongestFloats& floats,
                const Repeat& repeat) {
  const Draft& draft = opened.design.draft;
  if (!opened.design.title.empty()) std::printf("title           %s\n", opened.design.title.c_str());
  if (!opened.file.source_program.empty()) std::printf("source program  %s\n", opened.file.source_program.c_str());
  std::printf("ends            %d\npicks           %d\nshafts          %d\ntreadles        %d\n", draft.ends(),
              draft.picks(), draft.shafts, draft.treadles);
  std::printf("shed            %s\n", draft.rising ? "rising" : "sinking");
  std::printf("driven by       %s\n", draft.drive == ShedControl::kLiftplan ? "liftplan" : "tie-up and treadling");
  std::printf("longest float   warp %d front, %d back; weft %d front, %d back\n", floats.warp_front, floats.warp_back,
              floats.weft_front, floats.weft_back);
  std::printf("repeat          %d ends, %d picks\n", repeat.ends, repeat.picks);
  for (const Diagnostic& d : opened.diagnostics) {
    const std::string place = d.line > 0 ? path + ":" + std::to_string(d.line) : path;
    std::printf("%s: %s: %s; %s\n", place.c_str(), severity_name(d.severity), d.text.c_str(), d.remedy.c_str());
  }
}

}  // namespace

int info_command(const InfoOptions& options) {
  const OpenedDesign opened = open_design(options.file);
  if (!opened.ok) return kBadInput;
  const BitMatrix cells = drawdown(opened.design.draft);
  const LongestFloats floats = longest_floats(cells);
  const Repeat repeat = design_repeat(opened.design, cells);
  if (options.json) {
    std::printf("%s\n",
                as_json(opened, floats, repeat).dump(2, ' ', false, nlohmann::json::error_handler_t::replace).c_str());
  } else {
    print_text(options.file, opened, floats, repeat);
  }
  return kDone;
}

}  // namespace weftlight::commands
