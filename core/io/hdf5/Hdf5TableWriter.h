#pragma once

#include "core/io/hdf5/Hdf5Output.h"
#include "core/io/hdf5/Hdf5Program.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// A file that an Hdf5Output left, as far as it is wanted.
class Hdf5Input {
public:
    /// @param wanted tables and lists; the others are as if they were not there
    /// @throw InputError when it cannot be read, or is no file of an Hdf5Output, or not as that
    ///        left it; Error
    Hdf5Input(const std::filesystem::path& path, const std::vector<std::string>& wanted);

    [[nodiscard]] const Hdf5Content& content() const noexcept { return content_; }
    [[nodiscard]] const std::string& name() const noexcept { return content_.file(); }
    /// Returns whether it holds a table or a list of this name.
    [[nodiscard]] bool has(const std::string& what) const;
    /// @return empty: it has no such attribute of text
    [[nodiscard]] std::string attribute(const std::string& attribute) const;
    /// @throw InputError
    [[nodiscard]] std::vector<std::uint32_t> list(const std::string& list) const;
    /// @throw InputError naming a location in the file, always
    [[noreturn]] void fail(const std::string& location, const std::string& what) const {
        content_.fail(location, what);
    }

private:
    Hdf5Content content_;
};

/// A column of a table in an HDF5 file.
struct Hdf5Column {
    enum class Type {
        Double,
        Single,  ///< numbers in single precision
        Text,    ///< UTF-8, filled up with zero bytes
    };

    std::string name;
    std::string unit;  ///< its attribute `unit`, written only; empty: it has none
    Type type = Type::Double;
    std::size_t width = 1;  ///< of a text's cells [byte]
    std::string sameAs;     ///< the path of a dataset that holds these values; empty: its own
};

/// Parts of a table in an HDF5 file.
struct Hdf5Table {
    std::vector<Hdf5Column> columns;
    std::vector<std::string> comments;  ///< an attribute, a line each
    unsigned long long rows = 0;
};

/// Writes a table into an HDF5 file, row by row: a group, in it a compressed dataset a column, in
/// their order. A column that holds what another one holds is a link to that one's dataset.
class Hdf5TableWriter {
public:
    /// @param file  outlives it
    /// @param table as many rows must be added as it says
    /// @throw Error
    Hdf5TableWriter(const Hdf5Output& file, const std::string& name, const Hdf5Table& table);

    [[nodiscard]] Hdf5Column::Type type(std::size_t column) const {
        return stored_[column].column.type;
    }
    /// The next cell of the row, of the column's type.
    void add(double number);
    void add(std::string_view text);
    /// @throw Error
    void endRow();
    /// Writes what is left. @throw Error
    void close();

private:
    struct Stored {
        Hdf5Column column;
        Hdf5Object dataset;
        Hdf5Object type;          ///< of what waits
        std::vector<char> waits;  ///< to be written, cell after cell
    };

    void addColumn(const Hdf5Output& file, hid_t group, const Hdf5Column& column);
    [[nodiscard]] Hdf5Object layout() const;
    void write(Stored& stored);
    void flush();
    [[noreturn]] void fail() const;

    std::string name_;  ///< of the file
    std::vector<Stored> stored_;
    std::size_t cell_ = 0;            ///< of the row
    unsigned long long rows_;         ///< of the table
    unsigned long long written_ = 0;  ///< rows
    unsigned long long waiting_ = 0;  ///< rows
};

/// The rows of a table that Hdf5TableWriter wrote, one after the other.
class Hdf5Rows {
public:
    /// @param file outlives it, and was asked for the table
    /// @throw InputError where there is no such table, or one of its columns is none
    Hdf5Rows(const Hdf5Input& file, std::string name);

    [[nodiscard]] const std::vector<Hdf5Column>& columns() const { return columns_; }
    [[nodiscard]] std::vector<std::string> comments() const;

    /// @return false: there are no more rows. @throw InputError
    [[nodiscard]] bool next();
    /// Returns a number of the present row; the column is no text.
    [[nodiscard]] double number(std::size_t column) const;
    /// Returns a text of the present row; the column is a text.
    [[nodiscard]] std::string_view text(std::size_t column) const;

private:
    /// Values of a column; the list that its type does not need is empty.
    struct Block {
        std::vector<double> numbers;
        std::vector<char> texts;
    };

    void addColumn(const Hdf5Item& dataset, const std::string& name);
    void read();

    const Hdf5Input& file_;
    std::string name_;
    std::vector<Hdf5Column> columns_;
    std::vector<const Hdf5Item*> datasets_;
    std::vector<Block> blocks_;
    std::uint64_t rows_ = 0;
    std::uint64_t read_ = 0;   ///< rows up to the block's end
    std::uint64_t begin_ = 0;  ///< of the block
    std::uint64_t next_ = 0;   ///< row
};

}  // namespace asperity
