#pragma once

#include "core/io/hdf5/Hdf5Column.h"
#include "core/io/hdf5/Hdf5File.h"

#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// The rows of a table that Hdf5TableWriter wrote, one after the other.
class Hdf5Rows {
public:
    /// @param file outlives it
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
    void addColumn(const std::string& name);
    void read();
    [[nodiscard]] const char* cell(std::size_t column) const;

    const Hdf5Input& file_;
    std::string name_;
    Hdf5Object group_;
    std::vector<Hdf5Column> columns_;
    std::vector<Hdf5Object> datasets_;
    std::vector<std::vector<char>> block_;  ///< of each column
    long long rows_ = 0;
    long long read_ = 0;   ///< rows up to the block's end
    long long begin_ = 0;  ///< of the block
    long long next_ = 0;   ///< row
};

}  // namespace asperity
