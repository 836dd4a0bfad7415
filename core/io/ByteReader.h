#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace asperity {

/// Bytes that are copied out when they are asked for: no look into a file that others change can
/// end the program. Any threads.
class ByteSource {
public:
    /// @param name for messages: the file's path as the user gave it
    explicit ByteSource(std::string name) : name_(std::move(name)) {}
    ByteSource(const ByteSource&) = delete;
    ByteSource& operator=(const ByteSource&) = delete;
    virtual ~ByteSource() = default;

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] virtual std::uint64_t size() const = 0;  ///< [bytes]
    /// Fills `bytes` with those from `offset` on.
    /// @throw InputError when they are not there, or not there any more
    virtual void read(std::uint64_t offset, std::span<char> bytes) const = 0;
    /// @throw InputError when the content has changed since the beginning: what was read until now
    ///        may be of two contents
    virtual void requireUnchanged() const = 0;

    /// The bytes at the front, fewer where there are fewer.
    [[nodiscard]] std::string start(std::uint64_t most) const;
    /// The bytes at the front, read on until they are enough; at most `most` of them.
    [[nodiscard]] std::string startUntil(const std::function<bool(std::string_view)>& areEnough,
                                         std::uint64_t most) const;
    [[nodiscard]] bool startsWith(std::string_view mark) const {
        return start(mark.size()) == mark;
    }

private:
    std::string name_;
};

/// Bytes in memory, which must outlive this.
class MemoryBytes final : public ByteSource {
public:
    MemoryBytes(std::string_view bytes, std::string name)
        : ByteSource(std::move(name)), bytes_(bytes) {}

    [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
    void read(std::uint64_t offset, std::span<char> bytes) const override;
    void requireUnchanged() const override {}

private:
    std::string_view bytes_;
};

/// Bytes in memory that belong to it, as what was decoded.
class OwnedBytes final : public ByteSource {
public:
    OwnedBytes(std::string bytes, std::string name)
        : ByteSource(std::move(name)), bytes_(std::move(bytes)) {}

    [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
    void read(std::uint64_t offset, std::span<char> bytes) const override {
        MemoryBytes(bytes_, name()).read(offset, bytes);
    }
    void requireUnchanged() const override {}

private:
    std::string bytes_;
};

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

/// Position and size of a run of bytes in its source.
struct ByteSpan {
    std::uint64_t offset = 0;
    std::uint64_t count = 0;

    [[nodiscard]] std::uint64_t end() const { return offset + count; }
};

/// The bytes of a span. Only for what is small: they are copied.
[[nodiscard]] std::string bytesOf(const ByteSource& source, const ByteSpan& span);

/// The number in a span of sizeof(Number) bytes.
template <typename Number>
[[nodiscard]] Number numberIn(const ByteSource& source, const ByteSpan& span) {
    std::array<char, sizeof(Number)> bytes{};
    source.read(span.offset, bytes);
    return littleEndian<Number>(bytes.data());
}

/// Walks through a span of a source and never past its end: every step is checked and throws an
/// InputError that names the file, the byte and what was expected there. Holds a few bytes around
/// its offset, so that small steps cost no read each.
class ByteReader {
public:
    /// @param source must outlive the reader
    explicit ByteReader(const ByteSource& source) : ByteReader(source, {0, source.size()}) {}
    /// @param span within the source
    ByteReader(const ByteSource& source, const ByteSpan& span)
        : source_(&source), offset_(span.offset), end_(span.end()) {}

    [[nodiscard]] bool atEnd() const { return offset_ == end_; }
    [[nodiscard]] std::uint64_t remaining() const { return end_ - offset_; }
    [[nodiscard]] std::uint64_t offset() const { return offset_; }  ///< byte in the source

    /// Skips the next `count` bytes. @throw InputError when fewer are left
    ByteSpan take(std::uint64_t count, std::string_view what);
    /// Skips the bytes up to the next NUL, and that; it is not in the span.
    /// @throw InputError when there is none
    ByteSpan takeString(std::string_view what);
    /// The same as takeString(), for what cannot be long. @throw InputError when it is, too
    std::string takeName(std::string_view what);

    template <typename Number>
    Number takeNumber(std::string_view what) {
        const ByteSpan span = take(sizeof(Number), what);
        return littleEndian<Number>(window(span.offset, sizeof(Number)).data());
    }

    /// Copies the next bytes. @throw InputError when fewer are left
    void copy(std::span<char> bytes, std::string_view what);

    [[noreturn]] void fail(std::string_view message) const;

private:
    /// Bytes from an offset within the span on: `least` of them or more.
    std::string_view window(std::uint64_t offset, std::uint64_t least);

    const ByteSource* source_;
    std::uint64_t offset_;
    std::uint64_t end_;
    std::string window_;              ///< the bytes read last
    std::uint64_t windowOffset_ = 0;  ///< of its first byte
};

}  // namespace asperity
