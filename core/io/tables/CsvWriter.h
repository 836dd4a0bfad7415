#pragma once

#include "core/GrowingFile.h"
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
    /// @param comments one line each, without the `#`; made printable()
    /// @throw Error when the file's folder cannot be written
    CsvWriter(const std::filesystem::path& path, const std::vector<std::string>& comments,
              const std::vector<std::string>& columns);
    /// Into a file that grows in its place; the line of names is in it at once. @throw Error
    CsvWriter(GrowingFile file, const std::vector<std::string>& comments,
              const std::vector<std::string>& columns);
    /// Into a stream that outlives the writer, such as standard output.
    CsvWriter(std::ostream& stream, const std::vector<std::string>& comments,
              const std::vector<std::string>& columns);

    /// The next cell of the row; text is made printable(), and quoted where it must be.
    CsvWriter& add(double value);
    CsvWriter& add(std::string_view given);
    /// @throw Error when the row has another number of cells than there are columns
    void endRow();
    /// A whole row of numbers. @throw Error as endRow()
    void row(std::span<const double> values);

    /// Hands all rows so far to the file or the stream. @throw Error when a growing file does not
    /// take them
    void flush();
    /// Waits until the disk holds what was flushed to a growing file. @throw Error
    void sync() const;
    /// Writes what is left and puts the file in place. @throw Error when not all could be written
    void close();

private:
    void writeHeader(const std::vector<std::string>& comments,
                     const std::vector<std::string>& columns);
    void separate();

    std::optional<OutputFile> file_;
    std::optional<GrowingFile> growing_;
    std::ostream* stream_ = nullptr;  ///< null: into the growing file
    std::size_t columns_;
    std::size_t cells_ = 0;  ///< of the row so far
    std::string buffer_;
};

}  // namespace asperity
