#include "session/editing/thread_choice.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <limits>
#include <set>
#include <utility>

#include "base/text.h"
#include "cloth/cloth.h"

namespace weftlight::session {

using base::arg, base::fill, base::tr, base::tr_n;
using cloth::ThreadSize, cloth::thread_size;
using draft::Threads;

namespace {

constexpr size_t kMaxOthers = 7;

std::vector<int> range(int a, int b) {
  std::vector<int> out;
  for (int i = std::min(a, b); i <= std::max(a, b); ++i) out.push_back(i);
  return out;
}

std::vector<int> joined(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> out;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
  return out;
}

std::vector<int> without(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> out;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
  return out;
}

/// Length of the run from `at` with threads `step` apart.
size_t run_length(const std::vector<int>& threads, size_t at, int step) {
  size_t end = at + 1;
  while (end < threads.size() && threads[end] - threads[end - 1] == step) ++end;
  return end - at;
}

/// Removes and returns the integer at the front of `text`.
std::optional<int> take_number(std::string_view& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<size_t>(end - text.data()));
  return value;
}

bool take_sign(std::string_view& text, char sign) {
  if (text.empty() || text.front() != sign) return false;
  text.remove_prefix(1);
  return true;
}

/// First, last and step of "3", "3-7", "20-40/2", "odd" or "even".
struct Span {
  int first = 0, last = 0, step = 1;
};

std::optional<Span> span_of(std::string_view word, int count) {
  if (word == "odd") return Span{1, count, 2};
  if (word == "even") return Span{2, count, 2};
  Span s;
  const std::optional<int> first = take_number(word);
  if (!first) return std::nullopt;
  s.first = s.last = *first;
  if (take_sign(word, '-')) {
    // "20-" ends at the last thread.
    s.last = word.empty() || word.front() == '/' ? count : take_number(word).value_or(-1);
    if (take_sign(word, '/')) s.step = take_number(word).value_or(-1);
  }
  const bool good = word.empty() && s.step > 0 && s.first >= 1 && s.last >= 1 && std::min(s.first, s.last) <= count;
  if (!good) return std::nullopt;
  if (s.first > s.last) std::swap(s.first, s.last);
  s.last = std::min(s.last, count);
  return s;
}

/// Lower case, without blanks, with en dashes as hyphens.
std::string plain(std::string_view words) {
  std::string out;
  for (size_t i = 0; i < words.size(); ++i) {
    if (words.substr(i).starts_with("\xE2\x80\x93")) {
      out += '-';
      i += 2;
    } else if (!std::isspace(static_cast<unsigned char>(words[i]))) {
      out += static_cast<char>(std::tolower(static_cast<unsigned char>(words[i])));
    }
  }
  return out;
}

void add(SharedIndex& shared, int value, bool first) {
  if (first) shared.value = value;
  if (value == shared.value || shared.others.size() >= kMaxOthers) return;
  if (std::find(shared.others.begin(), shared.others.end(), value) == shared.others.end())
    shared.others.push_back(value);
}

void add(SharedLength& shared, float mm, bool own, bool first) {
  shared.low = first ? mm : std::min(shared.low, mm);
  shared.high = first ? mm : std::max(shared.high, mm);
  shared.own += own ? 1 : 0;
}

/// Whole sentences, since a language may need another word for each.
const char* label_text(ThreadProperty property, bool warp, long long n) {
  switch (property) {
    case ThreadProperty::kYarn:
      return warp ? tr_n("Change yarn of {count} end", "Change yarn of {count} ends", n)
                  : tr_n("Change yarn of {count} pick", "Change yarn of {count} picks", n);
    case ThreadProperty::kColor:
      return warp ? tr_n("Change colour of {count} end", "Change colour of {count} ends", n)
                  : tr_n("Change colour of {count} pick", "Change colour of {count} picks", n);
    case ThreadProperty::kThickness:
      return warp ? tr_n("Change thickness of {count} end", "Change thickness of {count} ends", n)
                  : tr_n("Change thickness of {count} pick", "Change thickness of {count} picks", n);
    case ThreadProperty::kSpacing:
      return warp ? tr_n("Change spacing of {count} end", "Change spacing of {count} ends", n)
                  : tr_n("Change spacing of {count} pick", "Change spacing of {count} picks", n);
    case ThreadProperty::kThicknessAndSpacing:
      return warp ? tr_n("Change thickness and spacing of {count} end", "Change thickness and spacing of {count} ends",
                         n)
                  : tr_n("Change thickness and spacing of {count} pick",
                         "Change thickness and spacing of {count} picks", n);
  }
  return "";
}

}  // namespace

void begin_choice(ThreadChoice& choice, System system, int thread, Choose how) {
  if (system != choice.system) choice = {system, {}, -1, {}, false, false};
  choice.before = how == Choose::kAlso ? choice.threads : std::vector<int>{};
  choice.takes_away = how == Choose::kAlso && std::binary_search(choice.threads.begin(), choice.threads.end(), thread);
  if (how != Choose::kRange || choice.anchor < 0) choice.anchor = thread;
  choice.dragging = true;
  drag_choice(choice, thread);
}

void drag_choice(ThreadChoice& choice, int thread) {
  if (!choice.dragging || choice.anchor < 0) return;
  const std::vector<int> swept = range(choice.anchor, thread);
  choice.threads = choice.takes_away ? without(choice.before, swept) : joined(choice.before, swept);
}

void limit_choice(ThreadChoice& choice, const Draft& draft) {
  const int count = draft.threads(choice.system).size();
  const auto gone = [count](int thread) { return thread >= count; };
  std::erase_if(choice.threads, gone);
  std::erase_if(choice.before, gone);
  if (choice.anchor >= count) choice.anchor = -1;
}

std::vector<int> concerned(const ThreadChoice& choice, const Draft& draft) {
  return choice.threads.empty() ? range(0, draft.threads(choice.system).size() - 1) : choice.threads;
}

std::vector<int> threads_alike(const Draft& draft, System system, const std::vector<int>& threads) {
  const Threads& t = draft.threads(system);
  const auto look = [&t](int i) { return std::pair(t.color[static_cast<size_t>(i)], t.yarn[static_cast<size_t>(i)]); };
  std::set<std::pair<int, int>> looks;
  for (const int i : threads) looks.insert(look(i));
  std::vector<int> out;
  for (int i = 0; i < t.size(); ++i)
    if (looks.contains(look(i))) out.push_back(i);
  return out;
}

std::string words_of_threads(const std::vector<int>& threads) {
  std::string words;
  for (size_t at = 0; at < threads.size();) {
    const int step = at + 1 < threads.size() ? threads[at + 1] - threads[at] : 1;
    size_t length = run_length(threads, at, step);
    if (length < 3) length = 1;
    if (!words.empty()) words += ", ";
    words += std::to_string(threads[at] + 1);
    if (length > 1) words.append("-").append(std::to_string(threads[at + length - 1] + 1));
    if (length > 1 && step > 1) words.append("/").append(std::to_string(step));
    at += length;
  }
  return words;
}

std::optional<std::vector<int>> threads_of_words(std::string_view words, int count) {
  std::string text = plain(words);
  while (text.ends_with(',')) text.pop_back();
  std::vector<int> out;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find(',', at), text.size());
    const std::optional<Span> span = span_of(std::string_view(text).substr(at, end - at), count);
    if (!span) return std::nullopt;
    for (int64_t i = span->first; i <= span->last; i += span->step) out.push_back(static_cast<int>(i) - 1);
    at = end + 1;
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

std::optional<NamedThread> named_thread(std::string_view words) {
  const std::string text = plain(words);
  const size_t digit = std::min(text.find_first_of("0123456789"), text.size());
  const std::string word = text.substr(0, digit);
  NamedThread out;
  const auto [stop, error] = std::from_chars(text.data() + digit, text.data() + text.size(), out.number);
  if (error == std::errc::result_out_of_range) out.number = std::numeric_limits<int>::max();
  else if (error != std::errc()) return std::nullopt;
  if (stop != text.data() + text.size()) return std::nullopt;
  if (word.empty()) return out;
  const auto begins = [&word](std::string_view whole) { return plain(whole).starts_with(word); };
  if (begins("ends") || begins(tr("End"))) out.system = System::kWarp;
  else if (begins("picks") || begins(tr("Pick"))) out.system = System::kWeft;
  else return std::nullopt;
  return out;
}

SharedThreads shared_by(const Design& design, System system, const std::vector<int>& threads) {
  const Threads& t = design.draft.threads(system);
  SharedThreads shared;
  for (const int thread : threads) {
    const auto i = static_cast<size_t>(thread);
    const bool first = shared.count++ == 0;
    const ThreadSize size = thread_size(design, system, thread);
    add(shared.color, t.color[i], first);
    add(shared.yarn, t.yarn[i], first);
    add(shared.thickness, size.thickness_mm, t.thickness_mm[i] >= 0, first);
    add(shared.spacing, size.spacing_mm, t.spacing_mm[i] > 0, first);
  }
  return shared;
}

std::string thread_label(ThreadProperty property, System system, size_t count) {
  return fill(label_text(property, system == System::kWarp, static_cast<long long>(count)), arg("count", count));
}

}  // namespace weftlight::session
