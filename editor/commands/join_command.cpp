// `join`: two drafts in one cloth.

#include "base/text.h"
#include "commands/commands.h"
#include "commands/open_design.h"
#include "design/edits.h"
#include "weaves/joined_drafts.h"

namespace weftlight::commands {

using base::arg, base::fill, base::tr, base::write_file_atomically;
using design::Design;
using weaves::JoinBy, weaves::Joining, weaves::joined_drafts;
using wif::write_new_wif;

namespace {

constexpr int kMaxInTurn = 1000;

/// "2:1"; false if it is something else.
bool read_turns(const std::string& text, Joining& joining) {
  const size_t colon = text.find(':');
  if (colon == std::string::npos) return false;
  const auto number = [](std::string_view digits) {
    int n = 0;
    for (const char c : digits) n = c >= '0' && c <= '9' && n <= kMaxInTurn ? n * 10 + (c - '0') : kMaxInTurn + 1;
    return n;
  };
  joining.first = number(std::string_view(text).substr(0, colon));
  joining.second = number(std::string_view(text).substr(colon + 1));
  return joining.first >= 1 && joining.first <= kMaxInTurn && joining.second >= 1 && joining.second <= kMaxInTurn;
}

}  // namespace

int join_command(const JoinOptions& options) {
  const bool ends = !options.ends.empty(), picks = !options.picks.empty(), layers = !options.layers.empty();
  if (ends + picks + layers != 1) return refuse(tr("give one of --ends, --picks and --layers, as --ends 1:1"));
  Joining joining;
  joining.by = ends ? JoinBy::kEnds : picks ? JoinBy::kPicks : JoinBy::kLayers;
  const std::string& turns = ends ? options.ends : picks ? options.picks : options.layers;
  if (!read_turns(turns, joining))
    return refuse(
        fill(tr("--{option} {value}: give the threads of each draft in turn as two numbers from 1 to 1000: 2:1"),
             arg("option", ends    ? "ends"
                           : picks ? "picks"
                                   : "layers"),
             arg("value", turns)));
  const OpenedDesign a = open_design(options.a), b = open_design(options.b);
  if (!a.ok || !b.ok) return kBadInput;
  const base::Result<Design> made = joined_drafts(a.design, b.design, joining);
  if (!made) return finish(failed(made));
  return finish(write_file_atomically(options.out, write_new_wif(*made)));
}

}  // namespace weftlight::commands
