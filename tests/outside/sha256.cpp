#include "sha256.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace weftlight::wif {
namespace {

/// First 32 bits of the fractional part of the square or cube root of a prime (FIPS 180-4, 4.2.2 and 5.3.3).
uint32_t root_bits(int prime, bool cube) {
  // Integer search: the largest r with (r / 2^32)^k <= prime, exact in 128 bits with 2^-32 steps.
  __extension__ using Wide = unsigned __int128;
  uint64_t root = 0;
  for (int bit = 36; bit >= 0; --bit) {
    const uint64_t next = root | (uint64_t{1} << bit);
    const Wide n = next;
    const bool fits = cube ? n * n * n <= (Wide{static_cast<unsigned>(prime)} << 96)
                           : n * n <= (Wide{static_cast<unsigned>(prime)} << 64);
    if (fits) root = next;
  }
  return static_cast<uint32_t>(root);
}

struct Constants {
  std::array<uint32_t, 64> k{};
  std::array<uint32_t, 8> h{};
};

Constants constants() {
  Constants c;
  size_t found = 0;
  for (int n = 2; found < c.k.size(); ++n) {
    bool prime = true;
    for (int d = 2; d * d <= n; ++d) prime = prime && n % d != 0;
    if (!prime) continue;
    if (found < c.h.size()) c.h[found] = root_bits(n, false);
    c.k[found++] = root_bits(n, true);
  }
  return c;
}

void compress(std::array<uint32_t, 8>& h, const std::array<uint32_t, 64>& k, const uint8_t* block) {
  std::array<uint32_t, 64> w{};
  for (size_t i = 0; i < 16; ++i) {
    w[i] = uint32_t{block[4 * i]} << 24 | uint32_t{block[4 * i + 1]} << 16 | uint32_t{block[4 * i + 2]} << 8 |
           block[4 * i + 3];
  }
  for (size_t i = 16; i < 64; ++i) {
    const uint32_t s0 = std::rotr(w[i - 15], 7) ^ std::rotr(w[i - 15], 18) ^ (w[i - 15] >> 3);
    const uint32_t s1 = std::rotr(w[i - 2], 17) ^ std::rotr(w[i - 2], 19) ^ (w[i - 2] >> 10);
    w[i] = w[i - 16] + s0 + w[i - 7] + s1;
  }
  std::array<uint32_t, 8> v = h;
  for (size_t i = 0; i < 64; ++i) {
    const uint32_t s1 = std::rotr(v[4], 6) ^ std::rotr(v[4], 11) ^ std::rotr(v[4], 25);
    const uint32_t t1 = v[7] + s1 + ((v[4] & v[5]) ^ (~v[4] & v[6])) + k[i] + w[i];
    const uint32_t s0 = std::rotr(v[0], 2) ^ std::rotr(v[0], 13) ^ std::rotr(v[0], 22);
    const uint32_t t2 = s0 + ((v[0] & v[1]) ^ (v[0] & v[2]) ^ (v[1] & v[2]));
    v = {t1 + t2, v[0], v[1], v[2], v[3] + t1, v[4], v[5], v[6]};
  }
  for (size_t i = 0; i < 8; ++i) h[i] += v[i];
}

}  // namespace

std::string sha256_hex(std::string_view bytes) {
  const Constants c = constants();
  std::string padded(bytes);
  padded += '\x80';
  while (padded.size() % 64 != 56) padded += '\0';
  const uint64_t bits = uint64_t{bytes.size()} * 8;
  for (int shift = 56; shift >= 0; shift -= 8) padded += static_cast<char>(bits >> shift);
  std::array<uint32_t, 8> h = c.h;
  for (size_t at = 0; at < padded.size(); at += 64) {
    compress(h, c.k, reinterpret_cast<const uint8_t*>(padded.data()) + at);
  }
  std::string hex;
  for (const uint32_t word : h) {
    for (int shift = 28; shift >= 0; shift -= 4) hex += "0123456789abcdef"[(word >> shift) & 15];
  }
  return hex;
}

}  // namespace weftlight::wif
