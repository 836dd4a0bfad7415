#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
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

/// Appends a number with its lowest byte first.
template <typename Number>
void appendLittleEndian(std::string& bytes, Number value) {
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(value);
    if constexpr (std::endian::native == std::endian::big) {
        std::ranges::reverse(raw);
    }
    bytes.append(raw.data(), raw.size());
}

/// Walks through bytes and never past their end: every step is checked and throws an InputError
/// that names the file, the byte and what was expected there.
class ByteReader {
public:
    /// @param bytes  must outlive the reader and what it hands out
    /// @param file   for messages
    /// @param origin place of bytes[0] in the file, for messages
    ByteReader(std::string_view bytes, std::string_view file, std::size_t origin = 0)
        : bytes_(bytes), file_(file), origin_(origin) {}

    [[nodiscard]] bool atEnd() const { return position_ == bytes_.size(); }
    [[nodiscard]] std::size_t remaining() const { return bytes_.size() - position_; }
    [[nodiscard]] std::size_t place() const { return origin_ + position_; }  ///< byte in the file

    /// The next `count` bytes. @throw InputError when fewer are left
    std::string_view take(std::uint64_t count, std::string_view what);
    /// The bytes up to the next NUL, which is skipped. @throw InputError when there is none
    std::string_view takeString(std::string_view what);

    template <typename Number>
    Number takeNumber(std::string_view what) {
        return littleEndian<Number>(take(sizeof(Number), what).data());
    }

    [[noreturn]] void fail(std::string_view message) const;

private:
    std::string_view bytes_;
    std::string_view file_;
    std::size_t origin_ = 0;
    std::size_t position_ = 0;
};

}  // namespace asperity
