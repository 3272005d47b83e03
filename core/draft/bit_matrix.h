#pragma once
// A dense matrix of bits, rows padded to 64-bit words: threading, tie-up, treadling,
// liftplan and drawdown are all of this type. Padding bits are always zero.

#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace weftlight::draft {

/// Leaves new words uninitialised: a matrix that is written whole next then costs one pass over memory, not two.
template <class T>
struct UnsetAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = UnsetAllocator<U>;
  };
  template <class U>
  void construct(U* at) {
    ::new (static_cast<void*>(at)) U;
  }
  template <class U, class... Args>
  void construct(U* at, Args&&... args) {
    ::new (static_cast<void*>(at)) U(std::forward<Args>(args)...);
  }
};

class BitMatrix {
 public:
  BitMatrix() = default;
  BitMatrix(int rows, int cols)
      : rows_(rows), cols_(cols), words_((cols + 63) / 64), bits_(static_cast<size_t>(rows) * words_, 0) {}

  /// Uninitialised: the caller writes every word of every row, padding included.
  static BitMatrix unset(int rows, int cols) {
    BitMatrix m;
    m.rows_ = rows;
    m.cols_ = cols;
    m.words_ = (cols + 63) / 64;
    m.bits_.resize(static_cast<size_t>(rows) * m.words_);
    return m;
  }

  int rows() const { return rows_; }
  int cols() const { return cols_; }
  int words() const { return words_; }

  bool get(int row, int col) const { return (bits_[word_at(row, col)] >> (col & 63)) & 1u; }
  void set(int row, int col, bool on) {
    const uint64_t bit = uint64_t{1} << (col & 63);
    uint64_t& word = bits_[word_at(row, col)];
    word = on ? (word | bit) : (word & ~bit);
  }
  std::span<uint64_t> row(int r) {
    return {bits_.data() + static_cast<size_t>(r) * words_, static_cast<size_t>(words_)};
  }
  std::span<const uint64_t> row(int r) const {
    return {bits_.data() + static_cast<size_t>(r) * words_, static_cast<size_t>(words_)};
  }
  /// Mask of the bits of a row's last word that are columns, not padding.
  uint64_t last_word_mask() const { return (cols_ & 63) ? (uint64_t{1} << (cols_ & 63)) - 1 : ~uint64_t{0}; }
  /// Keeps the cells that both sizes share; new cells are 0.
  void resize(int rows, int cols);
  /// First set column of a row, or -1.
  int first(int row) const;
  int64_t count() const;
  int count(int row) const;

  bool operator==(const BitMatrix&) const = default;

 private:
  size_t word_at(int row, int col) const { return static_cast<size_t>(row) * words_ + static_cast<size_t>(col >> 6); }
  int rows_ = 0, cols_ = 0, words_ = 0;
  std::vector<uint64_t, UnsetAllocator<uint64_t>> bits_;
};

/// Calls visit(column) for every set column of a row, in order.
template <class Visit>
void for_each_bit(std::span<const uint64_t> row, Visit visit) {
  for (size_t w = 0; w < row.size(); ++w) {
    for (uint64_t rest = row[w]; rest; rest &= rest - 1) visit(static_cast<int>(w) * 64 + std::countr_zero(rest));
  }
}

/// How many columns two rows of one width differ in.
int differences(std::span<const uint64_t> a, std::span<const uint64_t> b);
/// For each row, the first row equal to it.
std::vector<int> first_equal_rows(const BitMatrix& matrix);
BitMatrix transposed(const BitMatrix& matrix);

}  // namespace weftlight::draft
