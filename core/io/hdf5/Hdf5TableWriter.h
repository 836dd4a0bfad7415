#pragma once

#include "core/io/hdf5/Hdf5Column.h"
#include "core/io/hdf5/Hdf5Output.h"

#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// What a table of an HDF5 file is made of.
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

}  // namespace asperity
