#pragma once

#include "core/io/hdf5/Hdf5Column.h"
#include "core/io/hdf5/Hdf5Input.h"

#include <string>
#include <string_view>
#include <vector>

namespace asperity {

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
    /// Of the present row; the column is no text.
    [[nodiscard]] double number(std::size_t column) const;
    /// Of the present row; the column is a text.
    [[nodiscard]] std::string_view text(std::size_t column) const;

private:
    /// Of a column; the one that its type does not need is empty.
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
