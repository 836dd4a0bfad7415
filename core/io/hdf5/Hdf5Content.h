#pragma once

#include "core/io/ByteReader.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// Type of values that the program asperity_hdf5_reader writes; its bytes in that file.
enum class Hdf5Type : char {
    Real = 'f',
    Signed = 'i',
    Unsigned = 'u',
    Text = 't',   ///< of a fixed number of bytes, filled up with zeros
    Other = 'o',  ///< none that is written
};

/// Layout of that file: kStart, then records. Numbers have the byte order of the machine.
///
/// kGroup     path
/// kDataset   path, values
/// kAttribute path, '@' and name, values
/// kEnd       uint64: number of records before it; then the file ends
///
/// A path is a uint32, its bytes, and as many characters. Values are their type (Hdf5Type), uint32
/// bytes of one, uint8 number of dimensions, a uint64 for each, a uint8 that says whether the
/// values follow, and then these, the last dimension running fastest.
namespace hdf5_content {
inline constexpr std::string_view kStart = "asperity hdf5 content 1\n";
inline constexpr char kGroup = 'g';
inline constexpr char kDataset = 'd';
inline constexpr char kAttribute = 'a';
inline constexpr char kEnd = 'z';
inline constexpr std::size_t kMaxDimensions = 8;
inline constexpr std::size_t kMaxPath = 4096;  // [byte]
inline constexpr std::size_t kMaxItems = 100'000;
/// Largest size of all paths together, which are kept in memory.
inline constexpr std::size_t kMaxAllPaths = std::size_t{1} << 25U;  // [byte]
}  // namespace hdf5_content

/// No byte of a compressed chunk makes more bytes.
inline constexpr std::uint64_t kMaxHdf5Expansion = 1032;

/// A group, a dataset or an attribute of an HDF5 file.
struct Hdf5Item {
    enum class Kind : std::uint8_t { Group, Dataset, Attribute };

    Kind kind = Kind::Group;
    std::string
        path;  ///< "/group/dataset"; of an attribute "/group/dataset@name", of the root's "/@name"
    Hdf5Type type = Hdf5Type::Other;                     ///< of no group, as all that follows
    std::uint32_t bytes = 0;                             ///< of a value
    std::vector<std::uint64_t> shape;                    ///< empty: a single value
    std::uint64_t count = 0;                             ///< of values
    std::optional<std::uint64_t> offset = std::nullopt;  ///< of the values; none: not written
};

/// Content of an HDF5 file, as the program asperity_hdf5_reader writes it. Nothing here trusts
/// that program: a damaged file may have led it astray.
class Hdf5Content {
public:
    /// @param content of the program's file @param file the HDF5 file, for messages
    /// @throw InputError where it is none, or not whole
    Hdf5Content(std::shared_ptr<const ByteSource> content, std::string file);

    /// Groups are before what they hold, in the order in which it was made; attributes follow what
    /// they belong to.
    [[nodiscard]] const std::vector<Hdf5Item>& items() const noexcept { return items_; }
    /// Null: there is none.
    [[nodiscard]] const Hdf5Item* find(Hdf5Item::Kind kind, std::string_view path) const;

    /// Reads values of numbers from one of them on. @param item of items(), with its values there
    /// @throw InputError where these are no numbers or not as many
    void read(const Hdf5Item& item, std::uint64_t first, std::span<double> numbers) const;
    /// Reads values of text as they are stored, one behind the other. @throw as read()
    void read(const Hdf5Item& item, std::uint64_t first, std::span<char> texts) const;
    /// Returns a text; empty where there is no such one.
    [[nodiscard]] std::string text(Hdf5Item::Kind kind, std::string_view path) const;

    [[nodiscard]] const std::string& file() const noexcept { return file_; }
    /// @throw InputError naming a location in the HDF5 file, always
    [[noreturn]] void fail(const std::string& location, const std::string& what) const;

private:
    void requireValues(const Hdf5Item& item, std::uint64_t first, std::uint64_t count) const;

    std::shared_ptr<const ByteSource> content_;
    std::string file_;
    std::vector<Hdf5Item> items_;
    std::vector<std::size_t> byPath_;  ///< indices of items_, in the order of their paths
};

}  // namespace asperity
