#include "weaves/sections.h"

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "base/utf8.h"
#include "design/loom.h"
#include "weaves/families.h"

namespace weftlight::weaves {

using base::arg, base::fill, base::tr;
using design::may_paint;
using draft::BitGrid, draft::BitMatrix, draft::Draft, draft::ShedControl, draft::Threads, draft::for_each_bit,
    draft::kMaxCells, draft::kMaxThreads;

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool separates(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ','; }
bool ends_word(char c) { return separates(c) || c == '(' || c == ')'; }

constexpr std::string_view kBackSign = "'", kForthAndBackSign = "<>", kTurnSigns = "'<>";

std::string_view sign_of(Turn turn) {
  return turn == Turn::kBack ? kBackSign : turn == Turn::kForthAndBack ? kForthAndBackSign : std::string_view();
}

/// The turn at the end of a word, which loses its sign.
Turn taken_turn(std::string_view& word) {
  for (const Turn turn : {Turn::kBack, Turn::kForthAndBack})
    if (word.ends_with(sign_of(turn))) {
      word.remove_suffix(sign_of(turn).size());
      return turn;
    }
  return Turn::kForth;
}

/// Repeat count of "4x", "x4", "4*" or "4"; -1: not a count.
int count_of(std::string_view word) {
  const auto is_sign = [](char c) { return c == 'x' || c == 'X' || c == '*'; };
  if (!word.empty() && is_sign(word.back())) word.remove_suffix(1);
  else if (!word.empty() && is_sign(word.front())) word.remove_prefix(1);
  if (word.empty() || !std::ranges::all_of(word, is_digit)) return -1;
  int count = 0;
  for (const char c : word) count = std::min(count * 10 + (c - '0'), kMaxThreads);
  return count;
}

struct OrderReader {
  std::string_view text;
  size_t at = 0;
  int read = 0;  // items
  std::string why{};

  void fail(const std::string& what, size_t where) {
    if (why.empty()) why = fill(tr("{problem} at character {at}"), arg("problem", what), arg("at", where + 1));
    at = text.size();
  }
  /// Skips separators; true if there was a comma.
  bool skip() {
    bool comma = false;
    for (; at < text.size() && separates(text[at]); ++at) comma = comma || text[at] == ',';
    return comma;
  }
  std::string_view word() {
    const size_t begin = at;
    while (at < text.size() && !ends_word(text[at])) ++at;
    return text.substr(begin, at - begin);
  }
  bool set_times(OrderItem& item, int times, size_t where) {
    if (times < 1) fail(tr("a repeat count below 1"), where);
    item.times = times;
    return times >= 1;
  }
  OrderItem group(int depth) {
    OrderItem item;
    const size_t open = at++;
    if (depth >= kMaxOrderDepth) fail(tr("brackets nested too deeply"), open);
    else item.items = list(depth + 1);
    if (why.empty() && at >= text.size()) fail(tr("a bracket is not closed"), open);
    ++at;
    for (const Turn turn : {Turn::kBack, Turn::kForthAndBack})
      if (at < text.size() && item.turn == Turn::kForth && text.substr(at).starts_with(sign_of(turn))) {
        item.turn = turn;
        at += sign_of(turn).size();
      }
    return item;
  }
  /// Until a closing bracket or the end.
  std::vector<OrderItem> list(int depth) {
    std::vector<OrderItem> items;
    int before = 0;           // a count read before its item
    bool may_follow = false;  // a count now belongs to the item just read
    size_t before_at = 0;
    for (;;) {
      if (skip()) may_follow = false;
      if (at >= text.size() || text[at] == ')') break;
      const size_t begin = at;
      if (text[at] != '(') {
        std::string_view name = word();
        if (const int times = count_of(name); times >= 0) {
          if (may_follow) set_times(items.back(), times, begin);
          else if (before != 0) fail(tr("two repeat counts in a row"), begin);
          else before = times == 0 ? -1 : times, before_at = begin;
          may_follow = false;
          continue;
        }
        const Turn turn = taken_turn(name);
        if (name.empty()) fail(tr("a turn without a section"), begin);
        items.push_back({std::string(name), {}, 1, turn});
      } else {
        items.push_back(group(depth));
      }
      if (++read > kMaxOrderItems) fail(tr("too many sections"), begin);
      if (!why.empty()) return items;
      may_follow = before == 0;
      if (before != 0) set_times(items.back(), std::exchange(before, 0), before_at);
    }
    if (before != 0) fail(tr("a repeat count without a section"), before_at);
    return items;
  }
};

void write(const std::vector<OrderItem>& items, std::string& out) {
  for (size_t i = 0; i < items.size(); ++i) {
    if (i > 0) out += items[i - 1].times > 1 ? ", " : " ";
    if (items[i].section.empty()) {
      out += '(';
      write(items[i].items, out);
      out += ')';
    } else {
      out += items[i].section;
    }
    out += sign_of(items[i].turn);
    if (items[i].times > 1) out.append(" ").append(std::to_string(items[i].times)).append("x");
  }
}

void list_rows(const std::vector<OrderItem>& items, std::vector<int>& path, std::vector<OrderRow>& out) {
  for (size_t i = 0; i < items.size(); ++i) {
    path.push_back(static_cast<int>(i));
    out.push_back({path, items[i].section, items[i].times, items[i].turn});
    list_rows(items[i].items, path, out);
    path.pop_back();
  }
}

const ThreadSection* find_section(const Assembly& assembly, std::string_view name) {
  const auto found = std::ranges::find(assembly.sections, name, &ThreadSection::name);
  return found == assembly.sections.end() ? nullptr : &*found;
}

/// Number of threads of the items; -1: too many. Sets `unknown` to the first name that is not a section.
int64_t threads_in(const Assembly& assembly, const std::vector<OrderItem>& items, std::string* unknown) {
  int64_t sum = 0;
  for (const OrderItem& item : items) {
    int64_t own = 0;
    if (item.section.empty()) {
      own = threads_in(assembly, item.items, unknown);
    } else if (const ThreadSection* section = find_section(assembly, item.section)) {
      own = section->threads.size();
    } else if (unknown != nullptr && unknown->empty()) {
      *unknown = item.section;
    }
    if (own < 0) return -1;
    if (item.turn == Turn::kForthAndBack && own > 1) own = 2 * own - 2;
    sum += own * item.times;
    if (sum > kMaxThreads) return -1;
  }
  return sum;
}

/// A thread of a section.
struct Source {
  const ThreadSection* section = nullptr;
  int thread = 0;
};

/// The threads in order, repeats expanded.
std::vector<Source> expanded(const Assembly& assembly, const std::vector<OrderItem>& items) {
  std::vector<Source> out;
  for (const OrderItem& item : items) {
    std::vector<Source> own;
    if (item.section.empty()) {
      own = expanded(assembly, item.items);
    } else if (const ThreadSection* section = find_section(assembly, item.section)) {
      for (int i = 0; i < section->threads.size(); ++i) own.push_back({section, i});
    }
    if (item.turn == Turn::kBack) std::ranges::reverse(own);
    if (item.turn == Turn::kForthAndBack)
      for (int i = static_cast<int>(own.size()) - 2; i > 0; --i) own.push_back(Source(own[static_cast<size_t>(i)]));
    for (int i = 0; i < item.times && !own.empty(); ++i) out.insert(out.end(), own.begin(), own.end());
  }
  return out;
}

void copy_thread(Threads& to, size_t at, const Threads& from, size_t thread, int colors, int yarns) {
  to.color[at] = from.color[thread] < colors ? from.color[thread] : 0;
  to.yarn[at] = from.yarn[thread] < yarns ? from.yarn[thread] : 0;
  to.spacing_mm[at] = from.spacing_mm[thread];
  to.thickness_mm[at] = from.thickness_mm[thread];
}

void copy_row(BitMatrix& to, int at, const BitMatrix& from, int row) {
  for_each_bit(from.row(row), [&](int bit) {
    if (bit < to.cols()) to.set(at, bit, true);
  });
}

base::Failure impossible(std::string why) { return base::failure(base::ErrorKind::kInput, std::move(why)); }

/// Whether the sections can be assembled.
base::Result<void> check_sections(const Design& design, System system, const std::vector<Source>& order) {
  const Draft& d = design.draft;
  if (system == System::kWarp) return may_paint(design, BitGrid::kThreading);
  for (const auto& [section, thread] : order)
    if (section->shed_control != d.shed_control)
      return impossible(
          fill(d.shed_control == ShedControl::kLiftplan
                   ? tr("section {name} holds treadles, and the draft has a liftplan; define the section again")
                   : tr("section {name} holds lifts, and the draft has a treadling; define the section again"),
               arg("name", section->name)));
  return may_paint(design, d.shed_control == ShedControl::kLiftplan ? BitGrid::kLiftplan : BitGrid::kTreadling);
}

Design woven(Design design, System system, const std::vector<Source>& order) {
  Draft& d = design.draft;
  const int count = static_cast<int>(order.size());
  const bool warp = system == System::kWarp;
  Threads threads;
  threads.resize(count);
  BitMatrix rows(count, warp || d.shed_control == ShedControl::kLiftplan ? d.shafts : d.treadles);
  const auto colors = static_cast<int>(d.palette.size()), yarns = static_cast<int>(design.yarns.size());
  for (int i = 0; i < count; ++i) {
    const auto& [section, thread] = order[static_cast<size_t>(i)];
    copy_thread(threads, static_cast<size_t>(i), section->threads, static_cast<size_t>(thread), colors, yarns);
    copy_row(rows, i, section->rows, thread);
  }
  d.threads(system) = std::move(threads);
  if (warp) {
    d.threading = std::move(rows);
  } else {
    const bool lifted = d.shed_control == ShedControl::kLiftplan;
    d.treadling = lifted ? BitMatrix(count, d.treadles) : rows;
    d.liftplan = lifted ? std::move(rows) : BitMatrix(count, d.shafts);
  }
  return design;
}

}  // namespace

base::Result<std::vector<OrderItem>> read_order(std::string_view text) {
  OrderReader reader{text};
  std::vector<OrderItem> items = reader.list(0);
  if (reader.why.empty() && reader.at < text.size()) reader.fail(tr("an unmatched closing bracket"), reader.at);
  if (!reader.why.empty()) return impossible(std::move(reader.why));
  return items;
}

std::string order_text(const std::vector<OrderItem>& items) {
  std::string out;
  write(items, out);
  return out;
}

std::vector<OrderRow> order_rows(const std::vector<OrderItem>& items) {
  std::vector<OrderRow> out;
  std::vector<int> path;
  list_rows(items, path, out);
  return out;
}

std::vector<OrderItem>& list_of(std::vector<OrderItem>& items, std::span<const int> path) {
  std::vector<OrderItem>* list = &items;
  for (size_t depth = 0; depth + 1 < path.size(); ++depth) list = &(*list)[static_cast<size_t>(path[depth])].items;
  return *list;
}

OrderItem& item_at(std::vector<OrderItem>& items, std::span<const int> path) {
  return list_of(items, path)[static_cast<size_t>(path.back())];
}

std::string section_name(std::string_view typed) {
  std::string name;
  const bool utf8 = base::is_utf8(typed);
  for (const char c : utf8 ? base::cut_utf8(typed, kMaxSectionNameBytes) : typed.substr(0, kMaxSectionNameBytes))
    name += ends_word(c) || kTurnSigns.find(c) != kTurnSigns.npos ? '_' : c;
  const size_t first = name.find_first_not_of('_'), last = name.find_last_not_of('_');
  name = first == std::string::npos ? "" : name.substr(first, last - first + 1);
  return count_of(name) < 0 ? name : "S" + name;
}

std::string free_section_name(const Assembly& assembly) {
  for (int round = 1;; ++round)
    for (char letter = 'A'; letter <= 'Z'; ++letter) {
      std::string name(1, letter);
      if (round > 1) name += std::to_string(round);
      if (find_section(assembly, name) == nullptr) return name;
    }
}

const Assembly& assembly_of(const Design& design, System system) {
  return system == System::kWarp ? design.warp_assembly : design.weft_assembly;
}

ThreadSection section_of(const Design& design, const ThreadRange& range, std::string name) {
  const Draft& d = design.draft;
  const bool warp = range.system == System::kWarp;
  const BitMatrix& rows = warp ? d.threading : d.shed_control == ShedControl::kLiftplan ? d.liftplan : d.treadling;
  const int first = std::clamp(range.first, 0, rows.rows()), end = std::clamp(range.end, first, rows.rows());
  ThreadSection out{
      std::move(name), BitMatrix(end - first, rows.cols()), {}, warp ? ShedControl::kTreadling : d.shed_control};
  out.threads.resize(end - first);
  const Threads& from = d.threads(range.system);
  for (int i = first; i < end; ++i) {
    const auto to = static_cast<size_t>(i - first), at = static_cast<size_t>(i);
    std::ranges::copy(rows.row(i), out.rows.row(i - first).begin());
    out.threads.color[to] = from.color[at];
    out.threads.yarn[to] = from.yarn[at];
    out.threads.spacing_mm[to] = from.spacing_mm[at];
    out.threads.thickness_mm[to] = from.thickness_mm[at];
  }
  return out;
}

Assembly with_section(Assembly assembly, ThreadSection section) {
  const auto same = std::ranges::find(assembly.sections, section.name, &ThreadSection::name);
  if (same != assembly.sections.end()) *same = std::move(section);
  else if (assembly.sections.size() < kMaxSections) assembly.sections.push_back(std::move(section));
  return assembly;
}

int assembled_threads(const Assembly& assembly, const std::vector<OrderItem>& items) {
  return static_cast<int>(threads_in(assembly, items, nullptr));
}

base::Result<Design> assembled(Design design, System system, Assembly assembly) {
  const base::Result<std::vector<OrderItem>> order = read_order(assembly.order);
  if (!order) return failed(order);
  std::string unknown;
  const int64_t count = threads_in(assembly, *order, &unknown);
  if (!unknown.empty()) return impossible(fill(tr("there is no section {name}"), arg("name", unknown)));
  if (count < 0) return impossible(fill(tr("this is more than {most} threads"), arg("most", kMaxThreads)));
  const int64_t across = system == System::kWarp ? design.draft.picks() : design.draft.ends();
  if (count * across > kMaxCells) return impossible(tr("too many crossings"));
  if (count > 0) {
    const std::vector<Source> threads = expanded(assembly, *order);
    if (const base::Result<void> possible = check_sections(design, system, threads); !possible) return failed(possible);
    design = woven(std::move(design), system, threads);
  }
  (system == System::kWarp ? design.warp_assembly : design.weft_assembly) = std::move(assembly);
  return design;
}

}  // namespace weftlight::weaves
