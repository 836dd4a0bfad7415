#pragma once

#include "core/io/ByteSource.h"
#include "core/io/hdf5/Hdf5Type.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// A group, a dataset or an attribute of an HDF5 file.
struct Hdf5Item {
    enum class Kind : std::uint8_t { Group, Dataset, Attribute };

    Kind kind = Kind::Group;
    std::string
        path;  ///< "/group/dataset"; of an attribute "/group/dataset@name", of the root's "/@name"
    Hdf5Type type = Hdf5Type::Other;                    ///< of no group, as all that follows
    std::uint32_t bytes = 0;                            ///< of a value
    std::vector<std::uint64_t> shape;                   ///< empty: a single value
    std::uint64_t count = 0;                            ///< of values
    std::optional<std::uint64_t> place = std::nullopt;  ///< of the values; none: not handed over
};

/// What an HDF5 file holds, as the program asperity_hdf5_reader hands it over. Nothing here trusts
/// that program: it may have gone astray in a damaged file.
class Hdf5Content {
public:
    /// @param content of the program's file @param file the HDF5 file, for messages
    /// @throw InputError where it is none, or not whole
    Hdf5Content(std::shared_ptr<const ByteSource> content, std::string file);

    /// Groups go before what they hold, in the order in which it was made; attributes follow what
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
    /// @throw InputError naming a place in the HDF5 file, always
    [[noreturn]] void fail(const std::string& place, const std::string& what) const;

private:
    void requireValues(const Hdf5Item& item, std::uint64_t first, std::uint64_t count) const;

    std::shared_ptr<const ByteSource> content_;
    std::string file_;
    std::vector<Hdf5Item> items_;
    std::vector<std::size_t> byPath_;  ///< indices of items_, in the order of their paths
};

}  // namespace asperity
