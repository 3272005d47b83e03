// .dtx (Fiberworks): text in sections. `@@Name` opens a section, `%%key value` is a property of it, other lines its
// data.

#include <algorithm>
#include <bit>

#include "base/text.h"
#include "wif/foreign.h"
#include "wif/numbers.h"
#include "wif/wif_text.h"

namespace weftlight::wif {

using base::arg, base::fill, base::tr;
using draft::BitMatrix, draft::Draft, draft::ShedControl, draft::Threads, draft::kMaxCells, draft::kMaxColors,
    draft::kMaxShafts, draft::kMaxThreads;

namespace {

constexpr double kSpacingStepMm = 0.53;  // of warp and weft spacing
constexpr int kDefaultSteps = 4;
constexpr size_t kMaxSections = 1000;

struct DtxLine {
  int line = 0;  // 0-based
  std::string_view text;
};

struct DtxSection {
  std::string name;  // upper case
  int line = 0;
  std::vector<DtxLine> keys, data;
  const DtxLine* key(std::string_view wanted) const {
    for (const DtxLine& k : keys) {
      const size_t blank = std::min(k.text.find_first_of(" \t"), k.text.size());
      if (same_word(k.text.substr(0, blank), wanted)) return &k;
    }
    return nullptr;
  }
};

/// The file up to the first line or section that is too much; why it is, if it is.
struct DtxText {
  std::vector<DtxSection> sections;
  std::string too_large;
};

DtxText text_of_dtx(std::string_view bytes) {
  DtxText file;
  std::vector<DtxSection>& sections = file.sections;
  for (int line = 0; !bytes.empty(); ++line) {
    if (static_cast<size_t>(line) == kMaxLines || sections.size() > kMaxSections) {
      file.too_large = sections.size() > kMaxSections
                           ? fill(tr("the file has more than {most} sections"), arg("most", kMaxSections))
                           : fill(tr("the file has more than {most} lines"), arg("most", kMaxLines));
      break;
    }
    const size_t end = std::min(bytes.find('\n'), bytes.size());
    std::string_view text = trimmed(bytes.substr(0, end));
    while (!text.empty() && (text.back() == '\r' || is_blank(text.back()))) text.remove_suffix(1);
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    if (text.starts_with("@@")) {
      sections.push_back({uppercase(trimmed(text.substr(2))), line, {}, {}});
    } else if (!text.empty() && !sections.empty()) {
      if (text.starts_with("%%")) sections.back().keys.push_back({line, text.substr(2)});
      else sections.back().data.push_back({line, text});
    }
  }
  return file;
}

struct Dtx {
  std::vector<DtxSection> sections;
  Diagnostics& diagnostics;

  const DtxSection* find(std::string_view name) const {
    const auto found = std::ranges::find(sections, name, &DtxSection::name);
    return found == sections.end() ? nullptr : &*found;
  }
  std::nullopt_t refuse(int line, const std::string& what, const std::string& remedy) const {
    diagnostics.add(Severity::kError, line, {}, what, remedy);
    return std::nullopt;
  }
};

/// A word between blanks. With `commas`, words joined by commas are one.
struct Word {
  int line = 0;
  std::string text;
};

std::vector<Word> words_of(const DtxSection& section, bool commas = false) {
  std::vector<Word> words;
  for (const DtxLine& line : section.data) {
    bool continues = false;
    for (size_t at = 0; at < line.text.size();) {
      if (is_blank(line.text[at])) {
        ++at;
        continue;
      }
      size_t end = at;
      while (end < line.text.size() && !is_blank(line.text[end])) ++end;
      const std::string_view word = line.text.substr(at, end - at);
      at = end;
      if (commas && (continues || word.front() == ',') && !words.empty()) words.back().text += word;
      else words.push_back({line.line, std::string(word)});
      if (words.size() > static_cast<size_t>(kMaxThreads)) return words;  // one too many: refused, or without a thread
      continues = commas && word.back() == ',';
    }
  }
  return words;
}

std::string limit_remedy(int most) { return fill(tr("at most {most} can be opened"), arg("most", most)); }

int count_in(const Dtx& dtx, const char* key, int most) {
  const DtxSection* info = dtx.find("INFO");
  const DtxLine* line = info ? info->key(key) : nullptr;
  if (!line) return 0;
  const size_t blank = line->text.find_first_of(" \t");
  const int count = blank == std::string_view::npos ? 0 : leading_int(trimmed(line->text.substr(blank))).value_or(0);
  if (count <= most) return std::max(count, 0);
  dtx.refuse(line->line, fill("%%{key} {count}", arg("key", key), arg("count", count)), limit_remedy(most));
  return 0;
}

bool read_threading(const Dtx& dtx, Draft& d) {
  const DtxSection* section = dtx.find("THREADING");
  if (!section) return dtx.refuse(-1, tr("there is no @@Threading"), tr("save the draft again")), false;
  const std::vector<Word> words = words_of(*section);
  const int stated = count_in(dtx, "ends", kMaxThreads);
  if (words.size() > static_cast<size_t>(kMaxThreads))
    return dtx.refuse(section->line, tr("too many ends"), limit_remedy(kMaxThreads)), false;
  // Ends that are not listed are on no shaft.
  const int listed = static_cast<int>(words.size()), ends = std::max(listed, stated);
  if (ends == 0) return dtx.refuse(section->line, tr("the threading is empty"), tr("save the draft again")), false;
  if (stated > 0 && stated < listed)
    dtx.diagnostics.warn(
        section->line, {},
        fill(tr("%%ends is {stated} but the threading has {listed}"), arg("stated", stated), arg("listed", listed)),
        tr("the threading was used"));
  d.shafts = std::max(count_in(dtx, "shafts", kMaxShafts), 1);
  std::vector<int> shaft_of;
  for (const Word& word : words) {
    const int shaft = leading_int(word.text).value_or(-1);
    if (shaft < 0 || shaft > kMaxShafts)
      return dtx.refuse(word.line, fill(tr("'{text}' is not a shaft"), arg("text", word.text.substr(0, 20))),
                        tr("correct the threading")),
             false;
    shaft_of.push_back(shaft);
    d.shafts = std::max(d.shafts, shaft);
  }
  d.warp.resize(ends);
  d.threading = BitMatrix(ends, d.shafts);
  for (int e = 0; e < listed; ++e)
    if (shaft_of[static_cast<size_t>(e)] > 0) d.threading.set(e, shaft_of[static_cast<size_t>(e)] - 1, true);
  return true;
}

bool is_bits(std::string_view text) { return text.find_first_not_of("01") == std::string_view::npos; }

bool read_tieup(const Dtx& dtx, Draft& d) {
  const DtxSection* section = dtx.find("TIEUP");
  if (!section)
    return dtx.refuse(-1, tr("there is neither @@Tieup nor @@Liftplan"), tr("save the draft again with one of them")),
           false;
  size_t columns = 0;
  for (const DtxLine& line : section->data) {
    if (!is_bits(line.text))
      return dtx.refuse(line.line, tr("a line of the tie-up has other characters than 0 and 1"),
                        tr("correct the line")),
             false;
    columns = std::max(columns, line.text.size());
  }
  const size_t rows = section->data.size();
  if (rows > static_cast<size_t>(kMaxShafts) || columns > static_cast<size_t>(kMaxShafts))
    return dtx.refuse(section->line, tr("the tie-up is too large"),
                      fill(tr("at most {most} shafts and treadles can be opened"), arg("most", kMaxShafts))),
           false;
  if (static_cast<int>(rows) > d.shafts) {
    d.shafts = static_cast<int>(rows);
    d.threading.resize(d.ends(), d.shafts);
  }
  d.treadles = std::max({count_in(dtx, "treadles", kMaxShafts), static_cast<int>(columns), 1});
  d.tieup = BitMatrix(d.treadles, d.shafts);
  for (size_t row = 0; row < rows; ++row)
    for (size_t t = 0; t < section->data[row].text.size(); ++t)
      if (section->data[row].text[t] == '1') d.tieup.set(static_cast<int>(t), static_cast<int>(rows - 1 - row), true);
  return true;
}

/// Sets the number of picks; picks that are not listed lift nothing.
bool set_picks(const Dtx& dtx, const DtxSection& section, size_t listed, Draft& d) {
  const int stated = count_in(dtx, "picks", kMaxThreads);
  const size_t count = std::max(listed, static_cast<size_t>(stated));
  if (count == 0 || count > static_cast<size_t>(kMaxThreads) || static_cast<int64_t>(count) * d.ends() > kMaxCells)
    return dtx.refuse(section.line, fill(tr("{count} picks cannot be opened"), arg("count", count)),
                      tr("save the draft again")),
           false;
  if (stated > 0 && static_cast<size_t>(stated) < listed)
    dtx.diagnostics.warn(
        section.line, {},
        fill(tr("%%picks is {stated} but there are {listed}"), arg("stated", stated), arg("listed", listed)),
        tr("the listed picks were used"));
  d.weft.resize(static_cast<int>(count));
  return true;
}

bool read_treadling(const Dtx& dtx, Draft& d) {
  const DtxSection* section = dtx.find("TREADLING");
  if (!section) return dtx.refuse(-1, tr("there is a tie-up but no @@Treadling"), tr("save the draft again")), false;
  const std::vector<Word> picks = words_of(*section, true);
  if (!set_picks(dtx, *section, picks.size(), d)) return false;
  d.treadling = BitMatrix(d.picks(), d.treadles);
  std::vector<int> list;
  for (int p = 0; p < static_cast<int>(picks.size()); ++p) {
    const Word& word = picks[static_cast<size_t>(p)];
    leading_ints(word.text, list);
    if (list.empty())
      return dtx.refuse(word.line, fill(tr("'{text}' is not a treadle"), arg("text", word.text.substr(0, 20))),
                        tr("correct the treadling")),
             false;
    for (const int treadle : list) {
      if (treadle < 0 || treadle > d.treadles)
        return dtx.refuse(word.line,
                          fill(tr("pick {pick} names treadle {treadle}, and there are {count}"), arg("pick", p + 1),
                               arg("treadle", treadle), arg("count", d.treadles)),
                          tr("correct the treadling or the tie-up")),
               false;
      if (treadle > 0) d.treadling.set(p, treadle - 1, true);
    }
  }
  return true;
}

bool read_liftplan(const Dtx& dtx, const DtxSection& section, Draft& d) {
  size_t shafts = static_cast<size_t>(d.shafts);
  for (const DtxLine& line : section.data) {
    if (!is_bits(line.text) || line.text.size() > static_cast<size_t>(kMaxShafts))
      return dtx.refuse(line.line, tr("a line of the liftplan has other characters than 0 and 1"),
                        tr("correct the line")),
             false;
    shafts = std::max(shafts, line.text.size());
  }
  if (!set_picks(dtx, section, section.data.size(), d)) return false;
  d.shafts = static_cast<int>(shafts);
  d.threading.resize(d.ends(), d.shafts);
  d.treadles = std::max(count_in(dtx, "treadles", kMaxShafts), 1);
  d.shed_control = ShedControl::kLiftplan;
  d.liftplan = BitMatrix(d.picks(), d.shafts);
  for (int p = 0; p < static_cast<int>(section.data.size()); ++p) {
    const std::string_view text = section.data[static_cast<size_t>(p)].text;
    for (size_t s = 0; s < text.size(); ++s)
      if (text[s] == '1') d.liftplan.set(p, static_cast<int>(s), true);
  }
  return true;
}

void read_palette(const Dtx& dtx, Draft& d) {
  const DtxSection* section = dtx.find("COLOR PALET");
  if (!section) section = dtx.find("COLOR PALETTE");
  const DtxSection* colors = dtx.find("WARP COLORS");
  if (!colors) colors = dtx.find("WEFT COLORS");
  if (!section && colors)
    dtx.diagnostics.warn(colors->line, {}, tr("threads have colours, but there is no @@Color Palette"),
                         tr("black and white were used"));
  if (!section) return;
  d.palette.clear();
  std::vector<int> list;
  for (const DtxLine& line : section->data) {
    leading_ints(line.text, list);
    if (list.size() < 3 || d.palette.size() >= static_cast<size_t>(kMaxColors)) {
      dtx.diagnostics.warn(line.line, "palette", tr("a line of the palette is not red, green and blue"),
                           tr("read as black"));
      list.assign(3, 0);
    }
    d.palette.push_back(color_of_bytes(list[0], list[1], list[2], 255));
  }
}

void read_colors(const Dtx& dtx, const char* name, Draft& d, Threads& threads) {
  const DtxSection* section = dtx.find(name);
  if (!section) return;
  const std::vector<Word> words = words_of(*section);
  const auto color = [&](const Word& word) {
    const int index = leading_int(word.text).value_or(-1);
    if (index >= 0 && static_cast<size_t>(index) < d.palette.size()) return index;
    dtx.diagnostics.warn(word.line, name,
                         fill(tr("{section}: there is no colour {number}"), arg("section", name),
                              arg("number", word.text.substr(0, 20))),
                         fill(tr("the first was used; the palette has {count}"), arg("count", d.palette.size())));
    return 0;
  };
  for (size_t i = 0; i < threads.color.size(); ++i)
    if (!words.empty()) threads.color[i] = color(words[i < words.size() ? i : 0]);
}

void read_spacing(const Dtx& dtx, const char* name, Threads& threads) {
  const DtxSection* section = dtx.find(name);
  const std::vector<Word> words = section ? words_of(*section) : std::vector<Word>{};
  for (size_t i = 0; i < threads.spacing_mm.size(); ++i) {
    const int steps = i < words.size() ? leading_int(words[i].text).value_or(kDefaultSteps) : kDefaultSteps;
    threads.spacing_mm[i] = static_cast<float>(std::clamp(steps, 1, 1000) * kSpacingStepMm);
  }
}

void note_unknown(const Dtx& dtx) {
  constexpr const char* kKnown[] = {"STARTDTX",     "DESCRIPTION",   "CONTENTS",    "IMPRINT",     "PRIVATE",
                                    "INFO",         "THREADING",     "TIEUP",       "TREADLING",   "LIFTPLAN",
                                    "COLOR PALET",  "COLOR PALETTE", "WARP COLORS", "WEFT COLORS", "WARP SPACING",
                                    "WEFT SPACING", "NOTES",         "ENDDTX"};
  for (const DtxSection& section : dtx.sections) {
    const bool known = std::ranges::any_of(kKnown, [&](const char* name) { return section.name == name; });
    if (!known)
      dtx.diagnostics.add(Severity::kNote, section.line, "unknown section",
                          fill(tr("@@{section} is not known"), arg("section", section.name)), tr("it was ignored"));
    if (section.name == "PRIVATE" && !section.data.empty())
      dtx.diagnostics.add(Severity::kNote, section.line, {}, tr("@@Private holds data of Fiberworks alone"),
                          tr("it was ignored"));
  }
}

std::optional<WifFile> read_sections(const Dtx& dtx) {
  WifFile file;
  Draft& d = file.design.draft;
  d.palette = {{0, 0, 0}, {1, 1, 1}};
  if (!read_threading(dtx, d)) return {};
  const DtxSection* liftplan = dtx.find("LIFTPLAN");
  if (liftplan && !dtx.find("TREADLING")) {
    if (!read_liftplan(dtx, *liftplan, d)) return {};
  } else if (!read_tieup(dtx, d) || !read_treadling(dtx, d)) {
    return {};
  }
  if (dtx.diagnostics.has_error()) return {};
  d.tieup.resize(d.treadles, d.shafts);
  d.treadling.resize(d.picks(), d.treadles);
  d.liftplan.resize(d.picks(), d.shafts);
  std::ranges::fill(d.weft.color, 1);
  read_palette(dtx, d);
  if (d.palette.empty()) d.palette = {{0, 0, 0}, {1, 1, 1}};
  if (d.palette.size() < 2) std::ranges::fill(d.weft.color, 0);
  read_colors(dtx, "WARP COLORS", d, d.warp);
  read_colors(dtx, "WEFT COLORS", d, d.weft);
  read_spacing(dtx, "WARP SPACING", d.warp);
  read_spacing(dtx, "WEFT SPACING", d.weft);
  if (const DtxSection* s = dtx.find("DESCRIPTION"); s && !s->data.empty())
    file.design.title = text_of_foreign(s->data.front().text);
  if (const DtxSection* s = dtx.find("NOTES"))
    for (const DtxLine& line : s->data) file.design.notes.push_back(text_of_foreign(line.text));
  file.source_program = "Fiberworks";
  if (const DtxSection* s = dtx.find("IMPRINT"); s && !s->data.empty())
    file.source_program.append(" ").append(text_of_foreign(s->data.front().text));
  note_unknown(dtx);
  return file;
}

}  // namespace

WifRead read_dtx(std::string_view bytes) {
  Diagnostics diagnostics;
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  const bool too_large = bytes.size() > kMaxForeignBytes;
  DtxText text = too_large ? DtxText{} : text_of_dtx(bytes);
  const Dtx dtx{std::move(text.sections), diagnostics};
  std::optional<WifFile> file;
  if (too_large) dtx.refuse(-1, tr("the file is larger than 64 MB"), tr("choose a .dtx file"));
  else if (!text.too_large.empty()) dtx.refuse(-1, text.too_large, tr("choose a .dtx file"));
  else if (dtx.sections.empty() || dtx.sections.front().name != "STARTDTX")
    dtx.refuse(0, tr("the file does not begin with @@StartDTX"), tr("choose a .dtx file"));
  else file = read_sections(dtx);
  return foreign_file(std::move(file), "dtx", diagnostics);
}

}  // namespace weftlight::wif
