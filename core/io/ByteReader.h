#pragma once

#include "core/io/ByteSource.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace asperity {

/// A number stored with its lowest byte first; `bytes` must hold sizeof(Number) of them.
template <typename Number>
[[nodiscard]] Number littleEndian(const char* bytes) {
    std::array<char, sizeof(Number)> raw{};
    std::copy_n(bytes, raw.size(), raw.begin());
    if constexpr (std::endian::native == std::endian::big) {
        std::ranges::reverse(raw);
    }
    return std::bit_cast<Number>(raw);
}

/// The same with its highest byte first.
template <typename Number>
[[nodiscard]] Number bigEndian(const char* bytes) {
    std::array<char, sizeof(Number)> turned{};
    std::reverse_copy(bytes, bytes + turned.size(), turned.begin());
    return littleEndian<Number>(turned.data());
}

/// Appends a number with its lowest byte first.
template <typename Number>
void appendLittleEndian(std::string& bytes, Number value) {
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
    if constexpr (std::endian::native == std::endian::big) {
        std::ranges::reverse(raw);
    }
    bytes.append(raw.data(), raw.size());
}

/// Where a run of bytes lies in its source.
struct ByteSpan {
    std::uint64_t place = 0;
    std::uint64_t count = 0;

    [[nodiscard]] std::uint64_t end() const { return place + count; }
};

/// The bytes of a span. Only for what is small: they are copied.
[[nodiscard]] std::string bytesOf(const ByteSource& source, const ByteSpan& span);

/// The number in a span of sizeof(Number) bytes.
template <typename Number>
[[nodiscard]] Number numberIn(const ByteSource& source, const ByteSpan& span) {
    std::array<char, sizeof(Number)> bytes{};
    source.read(span.place, bytes);
    return littleEndian<Number>(bytes.data());
}

/// Walks through a span of a source and never past its end: every step is checked and throws an
/// InputError that names the file, the byte and what was expected there. Holds a few bytes around
/// its place, so that small steps cost no read each.
class ByteReader {
public:
    /// @param source must outlive the reader
    explicit ByteReader(const ByteSource& source) : ByteReader(source, {0, source.size()}) {}
    /// @param span within the source
    ByteReader(const ByteSource& source, const ByteSpan& span)
        : source_(&source), place_(span.place), end_(span.end()) {}

    [[nodiscard]] bool atEnd() const { return place_ == end_; }
    [[nodiscard]] std::uint64_t remaining() const { return end_ - place_; }
    [[nodiscard]] std::uint64_t place() const { return place_; }  ///< byte in the source

    /// Skips the next `count` bytes. @throw InputError when fewer are left
    ByteSpan take(std::uint64_t count, std::string_view what);
    /// Skips the bytes up to the next NUL, and that; it is not in the span.
    /// @throw InputError when there is none
    ByteSpan takeString(std::string_view what);
    /// As takeString(), for what cannot be long. @throw InputError when it is, too
    std::string takeName(std::string_view what);

    template <typename Number>
    Number takeNumber(std::string_view what) {
        const ByteSpan span = take(sizeof(Number), what);
        return littleEndian<Number>(window(span.place, sizeof(Number)).data());
    }

    /// Copies the next bytes. @throw InputError when fewer are left
    void copy(std::span<char> bytes, std::string_view what);

    [[noreturn]] void fail(std::string_view message) const;

private:
    /// Bytes from a place within the span on: `least` of them or more.
    std::string_view window(std::uint64_t place, std::uint64_t least);

    const ByteSource* source_;
    std::uint64_t place_;
    std::uint64_t end_;
    std::string window_;             ///< what was read last
    std::uint64_t windowPlace_ = 0;  ///< of its first byte
};

}  // namespace asperity
