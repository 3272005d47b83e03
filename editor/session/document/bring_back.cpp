#include "session/document/bring_back.h"

#include <array>
#include <ctime>
#include <utility>

#include "base/text.h"
#include "platform/clock.h"
#include "wif/wif.h"

namespace weftlight::session {

using base::arg, base::fill, base::mark, base::tr;
using design::Design;
using wif::Severity, wif::WifRead, wif::read_wif;

namespace {

constexpr int64_t kNsPerS = 1'000'000'000;

// As they stand in a date.
constexpr std::array<const char*, 12> kMonths = {
    mark("January"), mark("February"), mark("March"),     mark("April"),   mark("May"),      mark("June"),
    mark("July"),    mark("August"),   mark("September"), mark("October"), mark("November"), mark("December")};

std::tm local_time(int64_t ns) { return platform::local_time(ns / kNsPerS); }

}  // namespace

OpenResult bring_back(const LeftWork& left) {
  const base::Result<JournalEntry> entry = read_left(left);
  if (!entry)
    return {
        {},
        {{Severity::kError, 0,
          fill(tr("{file} cannot be read: {problem}"), arg("file", left.journal), arg("problem", entry.error().text)),
          tr("The file was left as it is.")}}};
  WifRead read = read_wif(entry->text);
  if (!read.file) return {{}, std::move(read.diagnostics)};
  const DocumentNote& note = entry->note;
  FileIdentity began_with = note.file;
  if (!note.path.empty() && began_with.there && changed_since(note.path, began_with) == FileChange::kNone) {
    OpenResult original = open_document(note.path);
    if (original.document) {
      original.document->commit({tr("Recover unsaved work"), [d = read.file->design](const Design&) { return d; }}, 0);
      return original;
    }
  }
  Document document(std::move(*read.file), std::move(read.diagnostics), {});
  document.without_file(note.name);
  return {std::move(document), {}};
}

std::string name_of(const LeftWork& left) { return left.note ? name_of(*left.note) : left.journal; }

std::string time_in_words(int64_t then_ns, int64_t now_ns) {
  const std::tm then = local_time(then_ns), today = local_time(now_ns),
                yesterday = local_time(now_ns - 24 * 3600 * kNsPerS);
  const auto on = [&then](const std::tm& day) { return then.tm_year == day.tm_year && then.tm_yday == day.tm_yday; };
  const std::string time = fmt::format("{:02}:{:02}", then.tm_hour, then.tm_min);
  if (on(today)) return fill(tr("today {time}"), arg("time", time));
  if (on(yesterday)) return fill(tr("yesterday {time}"), arg("time", time));
  return fill(tr("{day} {month} {year}, {time}"), arg("day", then.tm_mday),
              arg("month", tr(kMonths.at(static_cast<size_t>(then.tm_mon)))), arg("year", then.tm_year + 1900),
              arg("time", time));
}

}  // namespace weftlight::session
