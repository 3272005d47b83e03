#include "collection/query.h"

#include <algorithm>
#include <charconv>

namespace weftlight::collection {
namespace {

char small(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (size_t at = 0; at < text.size();) {
    at = text.find_first_not_of(" \t", at);
    if (at == std::string_view::npos) break;
    const size_t end = std::min(text.find_first_of(" \t", at), text.size());
    std::string& word = words.emplace_back(text.substr(at, end - at));
    std::ranges::transform(word, word.begin(), small);
    at = end;
  }
  return words;
}

bool has_facts(const DraftEntry& e, const DraftQuery& q) {
  return q.shafts.has(e.shafts) && q.treadles.has(e.treadles) && q.ends.has(e.ends) &&
         (!q.family || *q.family == e.family) && (e.colours & q.colours) == q.colours;
}

bool asks_for_facts(const DraftQuery& q) {
  return !q.shafts.any() || !q.treadles.any() || !q.ends.any() || q.family || q.colours != 0;
}

}  // namespace

std::optional<Span> span_from(std::string_view text) {
  constexpr int kMax = 1'000'000;
  const size_t dash = text.find('-');
  const auto number = [](std::string_view digits) -> std::optional<int> {
    int value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size() || value < 0 || value > kMax) return {};
    return value;
  };
  if (dash == std::string_view::npos) {
    const std::optional<int> one = number(text);
    if (!one || *one == 0) return {};
    return Span{*one, *one};
  }
  const std::string_view low = text.substr(0, dash), high = text.substr(dash + 1);
  if (low.empty() && high.empty()) return {};
  const std::optional<int> least = low.empty() ? 0 : number(low), most = high.empty() ? 0 : number(high);
  if (!least || !most || (*most > 0 && *most < *least) || (!high.empty() && *most == 0)) return {};
  return Span{*least, *most};
}

std::vector<int> found_drafts(const std::vector<DraftEntry>& entries, const DraftQuery& query) {
  const std::vector<std::string> words = words_of(query.words);
  const bool facts = asks_for_facts(query);
  std::vector<int> found;
  for (size_t i = 0; i < entries.size(); ++i) {
    const DraftEntry& e = entries[i];
    if (facts && (!e.readable || !has_facts(e, query))) continue;
    if (std::ranges::all_of(words, [&](const std::string& w) { return e.found_by.find(w) != std::string::npos; }))
      found.push_back(static_cast<int>(i));
  }
  return found;
}

}  // namespace weftlight::collection
