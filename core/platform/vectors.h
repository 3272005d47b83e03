#pragma once
// Vector instructions that only some processors of a kind have: a piece of work is compiled for each, and the program
// chooses while it runs. Functions, not files, are compiled for them, since an inline function of a file might be the
// one that the linker keeps for the whole program.

// GCC, Clang. Not for Windows, where GCC keeps such vectors on a stack that is not aligned for them (its bug 54412).
#if defined(__x86_64__) && defined(__GNUC__) && !defined(_WIN32)
#define WEFTLIGHT_INLINE_ALL [[gnu::flatten]]
#define WEFTLIGHT_AVX2 [[gnu::flatten, gnu::target("avx2")]]
#define WEFTLIGHT_AVX2_FMA [[gnu::flatten, gnu::target("avx2,fma")]]
#else  // one kind of vectors: the compiler's own
#define WEFTLIGHT_INLINE_ALL
#define WEFTLIGHT_AVX2
#define WEFTLIGHT_AVX2_FMA
#endif

namespace weftlight::platform {

/// The compiler's baseline, or AVX2 with fused multiply-add.
enum class Vectors { kBaseline, kAvx2 };

/// The widest that both this processor and the compiler know. Constant while the program runs.
Vectors widest_vectors();

namespace compiled {
template <class Work>
WEFTLIGHT_INLINE_ALL inline void for_baseline(const Work& work) {
  work();
}
template <class Work>
WEFTLIGHT_AVX2 inline void for_avx2(const Work& work) {
  work();
}
template <class Work>
WEFTLIGHT_AVX2_FMA inline void for_avx2_fma(const Work& work) {
  work();
}
}  // namespace compiled

/// Calls work() with these vectors, at most widest_vectors(). All that it calls is inlined and compiled for them.
/// Results depend on them by rounding: products and sums may be fused.
template <class Work>
void with_vectors(Vectors vectors, const Work& work) {
  if (vectors == Vectors::kAvx2) return compiled::for_avx2_fma(work);
  compiled::for_baseline(work);
}

/// Calls work() with the widest vectors, nothing fused: its results are the same bit for bit on every processor.
template <class Work>
void with_widest_vectors(const Work& work) {
  if (widest_vectors() == Vectors::kAvx2) return compiled::for_avx2(work);
  work();
}

}  // namespace weftlight::platform

#undef WEFTLIGHT_INLINE_ALL
#undef WEFTLIGHT_AVX2
#undef WEFTLIGHT_AVX2_FMA
