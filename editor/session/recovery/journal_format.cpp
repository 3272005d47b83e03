#include "session/recovery/journal_format.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

#include "wif/encoding.h"

namespace weftlight::session {

using base::content_hash;
using wif::escaped, wif::unescaped;

namespace {

// The magic line; then records: kind (1 byte), size of the payload (8), hash of kind, size and payload (8), payload.
// Numbers are little-endian.
constexpr std::string_view kMagic = "weftlight journal 1\n";
constexpr char kNote = 'N', kText = 'T', kDifference = 'D';
constexpr size_t kNumber = 8, kHead = 1 + 2 * kNumber;

void append_number(std::string& out, uint64_t value) {
  for (size_t i = 0; i < kNumber; ++i) out += static_cast<char>(value >> (8 * i) & 0xff);
}

/// Removes and returns the number at the front of `in`; 0 if there is none.
uint64_t take_number(std::string_view& in) {
  if (in.size() < kNumber) return 0;
  uint64_t value = 0;
  for (size_t i = 0; i < kNumber; ++i) value |= uint64_t{static_cast<unsigned char>(in[i])} << (8 * i);
  in.remove_prefix(kNumber);
  return value;
}

std::string record(char kind, std::string_view payload) {
  std::string out(1, kind);
  append_number(out, payload.size());
  append_number(out, content_hash(payload, content_hash(out)));
  return out.append(payload);
}

struct Record {
  char kind;
  std::string_view payload;
};

/// Removes and returns the record at the front of `in`; none if it is torn.
std::optional<Record> take_record(std::string_view& in) {
  if (in.size() < kHead) return {};
  std::string_view at = in.substr(1);
  const uint64_t size = take_number(at), hash = take_number(at);
  if (size > at.size()) return {};
  const Record r{in[0], at.substr(0, size)};
  if (content_hash(r.payload, content_hash(in.substr(0, 1 + kNumber))) != hash) return {};
  in = at.substr(size);
  return r;
}

constexpr size_t kNoteNumbers = 6;

std::string note_text(const DocumentNote& note) {
  const FileIdentity& f = note.file;
  std::string text = escaped(note.path) + "\n" + escaped(note.name) + "\n";
  for (const uint64_t n : {uint64_t{f.there}, f.device, f.inode, f.size, static_cast<uint64_t>(f.modified_ns), f.hash})
    text += std::to_string(n) + "\n";
  return text;
}

std::string_view take_line(std::string_view& in) {
  const size_t end = std::min(in.find('\n'), in.size());
  const std::string_view line = in.substr(0, end);
  in.remove_prefix(std::min(end + 1, in.size()));
  return line;
}

DocumentNote note_of(std::string_view text) {
  DocumentNote note;
  note.path = unescaped(take_line(text));
  note.name = unescaped(take_line(text));
  std::array<uint64_t, kNoteNumbers> n{};
  for (uint64_t& value : n) {
    const std::string_view line = take_line(text);
    std::from_chars(line.data(), line.data() + line.size(), value);
  }
  note.file = {n[0] != 0, n[1], n[2], n[3], static_cast<int64_t>(n[4]), n[5]};
  return note;
}

/// False if the difference does not fit this text.
bool apply_difference(std::string_view payload, std::string& text) {
  const uint64_t front = take_number(payload), back = take_number(payload), hash = take_number(payload);
  if (front > text.size() || back > text.size() - front) return false;
  if (front + back + payload.size() > kMaxJournalText) return false;
  std::string now = text;
  now.replace(front, text.size() - front - back, payload);
  if (content_hash(now) != hash) return false;
  text = std::move(now);
  return true;
}

}  // namespace

std::string journal_start(const JournalEntry& entry) {
  return std::string(kMagic) + record(kNote, note_text(entry.note)) + record(kText, entry.text);
}

std::string journal_entry(std::string_view before, std::string_view now) {
  const size_t shorter = std::min(before.size(), now.size());
  const size_t front = static_cast<size_t>(
      std::mismatch(before.begin(), before.begin() + static_cast<std::ptrdiff_t>(shorter), now.begin()).first -
      before.begin());
  size_t back = 0;
  while (back < shorter - front && before[before.size() - 1 - back] == now[now.size() - 1 - back]) ++back;
  std::string payload;
  for (const uint64_t n : {uint64_t{front}, uint64_t{back}, content_hash(now)}) append_number(payload, n);
  return record(kDifference, payload.append(now.substr(front, now.size() - front - back)));
}

std::optional<JournalEntry> read_journal(std::string_view bytes) {
  if (!bytes.starts_with(kMagic)) return {};
  bytes.remove_prefix(kMagic.size());
  JournalEntry entry;
  bool whole = false;
  while (const std::optional<Record> r = take_record(bytes)) {
    if (r->kind == kNote) entry.note = note_of(r->payload);
    if (r->kind == kText) {
      entry.text = r->payload;
      whole = true;
    }
    if (r->kind == kDifference && (!whole || !apply_difference(r->payload, entry.text))) break;
  }
  if (!whole) return {};
  return entry;
}

}  // namespace weftlight::session
