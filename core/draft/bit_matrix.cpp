#include "draft/bit_matrix.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace weftlight::draft {

void BitMatrix::resize(int rows, int cols) {
  if (rows == rows_ && cols == cols_) return;
  BitMatrix next(rows, cols);
  const int shared_words = std::min(words_, next.words_);
  for (int r = 0; r < std::min(rows_, rows); ++r) {
    std::copy_n(row(r).begin(), shared_words, next.row(r).begin());
    if (next.words_ > 0 && next.words_ <= words_) next.row(r).back() &= next.last_word_mask();
  }
  *this = std::move(next);
}

int BitMatrix::first(int r) const {
  const auto words = row(r);
  for (size_t w = 0; w < words.size(); ++w) {
    if (words[w]) return static_cast<int>(w) * 64 + std::countr_zero(words[w]);
  }
  return -1;
}

int BitMatrix::count(int r) const {
  int sum = 0;
  for (const uint64_t word : row(r)) sum += std::popcount(word);
  return sum;
}

int differences(std::span<const uint64_t> a, std::span<const uint64_t> b) {
  int sum = 0;
  for (size_t w = 0; w < a.size(); ++w) sum += std::popcount(a[w] ^ b[w]);
  return sum;
}

int64_t BitMatrix::count() const {
  int64_t sum = 0;
  for (const uint64_t word : bits_) sum += std::popcount(word);
  return sum;
}

namespace {

// Combines the words with the finaliser of MurmurHash3 (Austin Appleby, 2011).
uint64_t hash(std::span<const uint64_t> words) {
  uint64_t h = 0;
  for (const uint64_t word : words) {
    h = (h ^ word) * 0xff51afd7ed558ccdull;
    h = (h ^ (h >> 33)) * 0xc4ceb9fe1a85ec53ull;
    h ^= h >> 33;
  }
  return h;
}

// Transposes a 64 x 64 block in place by swapping ever smaller quadrants.
// Based on: Henry S. Warren, Hacker's Delight, 2nd ed. 2012, section 7-3.
void transpose_block(std::array<uint64_t, 64>& a) {
  uint64_t mask = 0x00000000FFFFFFFFull;
  for (unsigned j = 32; j != 0; j >>= 1, mask ^= mask << j) {
    for (unsigned k = 0; k < 64; k = (k + j + 1) & ~j) {
      const uint64_t swap = ((a[k] >> j) ^ a[k + j]) & mask;
      a[k] ^= swap << j;
      a[k + j] ^= swap;
    }
  }
}

}  // namespace

std::vector<int> first_equal_rows(const BitMatrix& m) {
  // Hash table with open addressing, at most half full; a slot holds the first of the equal rows.
  const size_t slots = std::bit_ceil(static_cast<size_t>(m.rows()) * 2 + 1);
  std::vector<int> table(slots, -1), first(static_cast<size_t>(m.rows()));
  for (int r = 0; r < m.rows(); ++r) {
    size_t at = hash(m.row(r)) & (slots - 1);
    while (table[at] >= 0 && !std::ranges::equal(m.row(table[at]), m.row(r))) at = (at + 1) & (slots - 1);
    if (table[at] < 0) table[at] = r;
    first[r] = table[at];
  }
  return first;
}

BitMatrix transposed(const BitMatrix& m) {
  BitMatrix out(m.cols(), m.rows());
  std::array<uint64_t, 64> block;
  for (int r0 = 0; r0 < m.rows(); r0 += 64) {
    const int rows = std::min(64, m.rows() - r0);
    for (int w = 0; w < m.words(); ++w) {
      block.fill(0);
      for (int r = 0; r < rows; ++r) block[r] = m.row(r0 + r)[w];
      transpose_block(block);
      const int cols = std::min(64, m.cols() - w * 64);
      for (int c = 0; c < cols; ++c) out.row(w * 64 + c)[r0 >> 6] = block[c];
    }
  }
  return out;
}

}  // namespace weftlight::draft
