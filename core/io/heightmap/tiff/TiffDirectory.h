#pragma once

#include "core/io/ByteReader.h"
#include "core/io/heightmap/SampleRows.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// A field of a TIFF directory; its values lie within the file.
struct TiffField {
    std::uint16_t tag = 0;
    std::uint16_t type = 0;    ///< one of those of known size
    std::uint64_t count = 0;   ///< of values
    std::uint64_t offset = 0;  ///< of the first one [bytes]
};

/// Directory of one image in a TIFF file. Source: TIFF revision 6.0, sections 2 and 8, and the
/// layout of BigTIFF; docs/formats.md 9.
class TiffDirectory {
public:
    /// @param bytes  must outlive this
    /// @param offset in the file [bytes]
    /// @param number from 1, for messages
    TiffDirectory(const ByteSource& bytes, ByteOrder order, std::uint64_t offset,
                  std::size_t number, std::vector<TiffField> fields);

    [[nodiscard]] const ByteSource& bytes() const { return *bytes_; }
    [[nodiscard]] ByteOrder order() const { return order_; }
    [[nodiscard]] std::uint64_t offset() const { return offset_; }
    [[nodiscard]] const std::string& name() const { return name_; }  ///< "image 2"

    [[nodiscard]] bool has(std::uint16_t tag) const { return find(tag) != nullptr; }
    /// The first value; empty when there is none. @throw InputError when it is no whole number
    [[nodiscard]] std::optional<std::int64_t> integer(std::uint16_t tag) const;
    /// @throw InputError when there is none, too
    [[nodiscard]] std::int64_t requireInteger(std::uint16_t tag) const;
    /// All values; none when there are none.
    /// @throw InputError when they are no whole numbers, one is negative, or there are more than
    ///        2^20
    [[nodiscard]] std::vector<std::uint64_t> wholeNumbers(std::uint16_t tag) const;
    /// The first value, a fraction as its quotient; empty when there is none.
    /// @throw InputError when it is no number
    [[nodiscard]] std::optional<double> number(std::uint16_t tag) const;
    /// The text up to its NUL as UTF-8, cut off after 64 KiB; empty when there is none.
    [[nodiscard]] std::string text(std::uint16_t tag) const;
    /// Returns the position of the values. @throw InputError when there are none
    [[nodiscard]] ByteSpan requireSpan(std::uint16_t tag) const;

    /// @throw InputError that names the image
    [[noreturn]] void fail(const std::string& what) const;

private:
    [[nodiscard]] const TiffField* find(std::uint16_t tag) const;
    [[noreturn]] void failAt(std::uint16_t tag, const std::string& expected) const;

    const ByteSource* bytes_;
    ByteOrder order_;
    std::uint64_t offset_;
    std::string name_;
    std::vector<TiffField> fields_;  ///< by tag
};

class WholeImages;

/// Returns whether the content begins as a TIFF.
[[nodiscard]] bool isTiff(const ByteSource& bytes);

/// Returns whether it is a TIFF whose first directory can be read and has this tag.
[[nodiscard]] bool isTiffWithTag(const ByteSource& bytes, std::uint16_t tag);

/// The directories of all images, in the order of the file. Directories and values are together no
/// larger than the file, so that nothing is read many times over.
/// @param images where it is given, a directory behind the first that is not within the file is
///        left out, and those behind it are not looked for
/// @throw InputError when one, or anything that it names, is not within the file
[[nodiscard]] std::vector<TiffDirectory> readTiffDirectories(const ByteSource& bytes,
                                                             WholeImages* images = nullptr);

/// Values of the fields of a TIFF directory. Source: TIFF revision 6.0, section 2;
/// docs/formats.md 9.

/// Returns the size of a value of this type [bytes]; 0: there is no such type.
[[nodiscard]] std::uint64_t sizeOfTiffType(std::uint16_t type);

/// A number in the file's byte order. @param stored sizeof(Number) bytes
template <typename Number>
[[nodiscard]] Number orderedNumber(const char* stored, ByteOrder order) {
    return order == ByteOrder::Little ? littleEndian<Number>(stored) : bigEndian<Number>(stored);
}

/// A value of a type of whole numbers; empty for any other type.
[[nodiscard]] std::optional<std::int64_t> wholeTiffValue(std::uint16_t type, const char* stored,
                                                         ByteOrder order);

/// A value of a type of any numbers, a fraction as its quotient; empty for any other type.
[[nodiscard]] std::optional<double> tiffNumber(std::uint16_t type, const char* stored,
                                               ByteOrder order);

}  // namespace asperity
