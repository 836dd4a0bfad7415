#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>

/// Compiles a function twice, for any x86-64 processor and for those with AVX2; the loader picks.
/// All that it calls must be inlined into it. Not for sanitizers: they are not yet at work when the
/// loader picks.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) &&                             \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define ASPERITY_WITH_AVX2 [[gnu::target_clones("avx2", "default")]]
#else
#define ASPERITY_WITH_AVX2
#endif
#define ASPERITY_INLINE [[gnu::always_inline]] inline

namespace asperity {

// Four doubles that the compiler keeps in one register where the processor has such. Lanes are
// added and multiplied in the written order with and without AVX2, so results are the same bits.
using Double4 [[gnu::vector_size(32)]] = double;
using Long4 [[gnu::vector_size(32)]] = long;

// Eight floats or ints in one register.
constexpr int kFloatLanes = 8;
using Float8 [[gnu::vector_size(32)]] = float;
using Int8 [[gnu::vector_size(32)]] = int;

ASPERITY_INLINE Double4 least(Double4 a, Double4 b) { return b < a ? b : a; }
ASPERITY_INLINE Double4 most(Double4 a, Double4 b) { return a < b ? b : a; }
ASPERITY_INLINE Double4 magnitude(Double4 a) {
    constexpr long kAllButSign = 0x7fffffffffffffff;
    return reinterpret_cast<Double4>(reinterpret_cast<Long4>(a) & kAllButSign);
}
ASPERITY_INLINE double least(double a, double b) { return std::min(a, b); }
ASPERITY_INLINE double most(double a, double b) { return std::max(a, b); }
ASPERITY_INLINE double magnitude(double a) { return std::abs(a); }

/// Loads as many elements as the vector has lanes, from anywhere.
template <class Vector, class Element>
ASPERITY_INLINE Vector loaded(const Element* from) {
    Vector vector;
    std::memcpy(&vector, from, sizeof vector);
    return vector;
}

/// Bit k: lane k is set.
ASPERITY_INLINE unsigned bitsOf(Long4 lanes) {
    const Long4 bits = lanes & Long4{1, 2, 4, 8};
    return static_cast<unsigned>(bits[0] | bits[1] | bits[2] | bits[3]);
}

/// Sums of the lanes of four vectors.
ASPERITY_INLINE Double4 laneSums(Double4 a, Double4 b, Double4 c, Double4 d) {
    const Double4 ab =
        __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Double4 cd =
        __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
    return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) +
           __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

/// Four rows of four become four columns.
ASPERITY_INLINE void transpose(Double4 (&rows)[4]) {
    const Double4 a = __builtin_shufflevector(rows[0], rows[1], 0, 4, 2, 6);
    const Double4 b = __builtin_shufflevector(rows[0], rows[1], 1, 5, 3, 7);
    const Double4 c = __builtin_shufflevector(rows[2], rows[3], 0, 4, 2, 6);
    const Double4 d = __builtin_shufflevector(rows[2], rows[3], 1, 5, 3, 7);
    rows[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
    rows[1] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
    rows[2] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
    rows[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}

}  // namespace asperity
