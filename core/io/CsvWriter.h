#pragma once

#include "core/TemporaryFile.h"

#include <filesystem>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// Writes a CSV table: a block of `#` comments, one line of column names, then rows. Numbers have
/// 17 significant digits, so that they read back to the same bits, whatever the locale.
class CsvWriter {
public:
    /// Into a file that takes its place when close() is called; without that, nothing is left.
    /// @param comments one line each, without the `#`
    /// @throw Error when the file's folder cannot be written
    CsvWriter(const std::filesystem::path& path, const std::vector<std::string>& comments,
              const std::vector<std::string>& columns);
    /// Into a stream that outlives the writer, such as standard output.
    CsvWriter(std::ostream& stream, const std::vector<std::string>& comments,
              const std::vector<std::string>& columns);

    /// The next cell of the row; text is quoted where it must be.
    CsvWriter& add(double value);
    CsvWriter& add(std::string_view text);
    /// @throw Error when the row has another number of cells than there are columns
    void endRow();
    /// A whole row of numbers. @throw Error as endRow()
    void row(std::span<const double> values);

    /// Writes what is left and puts the file in place. @throw Error when not all could be written
    void close();

private:
    void writeHeader(const std::vector<std::string>& comments,
                     const std::vector<std::string>& columns);
    void separate();
    void flush();

    std::optional<OutputFile> file_;
    std::ostream* stream_;
    std::size_t columns_;
    std::size_t cells_ = 0;  ///< of the row so far
    std::string buffer_;
};

}  // namespace asperity
