#include "wif/encoding.h"

#include <array>
#include <cstdint>

#include "base/utf8.h"
#include "wif/numbers.h"

namespace weftlight::wif {

using base::utf8_sequence;

namespace {

/// Code points of bytes 0x80..0x9F; the five unassigned bytes map to themselves.
constexpr std::array<uint16_t, 32> kHigh = {0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                            0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0x8D,   0x017D, 0x8F,
                                            0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                            0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};

/// U+00C0..U+00FF without accents.
constexpr std::string_view kPlainLetters = "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYTsaaaaaaaceeeeiiiidnooooo/ouuuuyty";

void append_utf8(std::string& out, uint32_t code) {
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xC0 | (code >> 6));
    out += static_cast<char>(0x80 | (code & 0x3F));
  } else {
    out += static_cast<char>(0xE0 | (code >> 12));
    out += static_cast<char>(0x80 | ((code >> 6) & 0x3F));
    out += static_cast<char>(0x80 | (code & 0x3F));
  }
}

/// Size of the valid UTF-8 sequence at `at` (its code point in `code`), or 0.
size_t sequence(std::string_view text, size_t at, uint32_t& code) { return utf8_sequence(text.substr(at), code); }

int latin1_byte(uint32_t code) {
  if (code < 0x80 || (code >= 0xA0 && code <= 0xFF)) return static_cast<int>(code);
  for (size_t i = 0; i < kHigh.size(); ++i) {
    if (kHigh[i] == code) return static_cast<int>(0x80 + i);
  }
  return -1;
}

bool is_control(uint32_t code) { return code < 0x20 || code == 0x7F; }

char plain_char(uint32_t code) {
  if (code >= 0xC0 && code <= 0xFF) return kPlainLetters[code - 0xC0];
  if (code >= 0x2010 && code <= 0x2015) return '-';
  if (code == 0x2018 || code == 0x2019) return '\'';
  if (code == 0x201C || code == 0x201D || code == 0xAB || code == 0xBB) return '"';
  if (code == 0xA0) return ' ';
  return '?';
}

}  // namespace

std::string to_utf8(std::string_view bytes, Encoding from) {
  if (from == Encoding::kUtf8) return std::string(bytes);
  std::string out;
  for (const char c : bytes) {
    const uint8_t byte = static_cast<uint8_t>(c);
    append_utf8(out, byte >= 0x80 && byte < 0xA0 ? kHigh[byte - 0x80u] : byte);
  }
  return out;
}

std::optional<std::string> from_utf8(std::string_view text, Encoding to) {
  if (to == Encoding::kUtf8) return std::string(text);
  std::string out;
  uint32_t code = 0;
  for (size_t at = 0; at < text.size();) {
    const size_t size = sequence(text, at, code);
    const int byte = size ? latin1_byte(code) : -1;
    if (byte < 0) return std::nullopt;
    out += static_cast<char>(byte);
    at += size;
  }
  return out;
}

/// Calls write(out, code, bytes) for each character; invalid bytes become '?'.
template <class Write>
static std::string rewritten(std::string_view text, const Write& write) {
  std::string out;
  uint32_t code = 0;
  for (size_t at = 0; at < text.size();) {
    const size_t size = sequence(text, at, code);
    if (size) write(out, code, text.substr(at, size));
    else out += '?';
    at += size ? size : 1;
  }
  return out;
}

std::string to_ascii(std::string_view text) {
  return rewritten(text, [](std::string& out, uint32_t code, std::string_view) {
    out += code < 0x80 ? (is_control(code) ? ' ' : static_cast<char>(code)) : plain_char(code);
  });
}

std::string escaped(std::string_view text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string out;
  uint32_t code = 0;
  for (size_t at = 0; at < text.size();) {
    const size_t size = sequence(text, at, code);
    const bool edge_blank = text[at] == ' ' && (at == 0 || at + 1 == text.size());
    if (text[at] == '\n') {
      out += "\\n";
    } else if (text[at] == '\\') {
      out += "\\\\";
    } else if (size == 0 || is_control(code) || edge_blank) {
      const uint8_t byte = static_cast<uint8_t>(text[at]);
      out += "\\x";
      out += kHex[byte >> 4];
      out += kHex[byte & 15];
    } else {
      out.append(text, at, size);
    }
    at += size ? size : 1;
  }
  return out;
}

std::string unescaped(std::string_view text) {
  const auto hex = [](char c) {
    if (c >= '0' && c <= '9') return c - '0';
    return upper(c) >= 'A' && upper(c) <= 'F' ? upper(c) - 'A' + 10 : -1;
  };
  std::string out;
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 >= text.size()) {
      out += text[i];
    } else if (text[i + 1] == 'x' && i + 3 < text.size() && hex(text[i + 2]) >= 0 && hex(text[i + 3]) >= 0) {
      out += static_cast<char>(hex(text[i + 2]) * 16 + hex(text[i + 3]));
      i += 3;
    } else {
      out += text[i + 1] == 'n' ? '\n' : text[i + 1];
      ++i;
    }
  }
  return out;
}

std::string one_line(std::string_view text) {
  return std::string(trimmed(rewritten(text, [](std::string& out, uint32_t code, std::string_view bytes) {
    out += is_control(code) ? std::string_view(" ") : bytes;
  })));
}

}  // namespace weftlight::wif
