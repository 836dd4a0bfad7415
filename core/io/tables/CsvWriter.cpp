#include "core/io/tables/CsvWriter.h"

#include "core/Error.h"
#include "core/PrintableText.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace asperity {

namespace {

constexpr std::size_t kBufferBytes = 1U << 16U;
/// Enough for every double to read back to the same bits.
constexpr int kDigits = 17;

}  // namespace

CsvWriter::CsvWriter(const std::filesystem::path& path, const std::vector<std::string>& comments,
                     const std::vector<std::string>& columns)
    : file_(std::in_place, path), stream_(&file_->stream()), columns_(columns.size()) {
    writeHeader(comments, columns);
}

CsvWriter::CsvWriter(GrowingFile file, const std::vector<std::string>& comments,
                     const std::vector<std::string>& columns)
    : growing_(std::move(file)), columns_(columns.size()) {
    writeHeader(comments, columns);
    flush();
}

CsvWriter::CsvWriter(std::ostream& stream, const std::vector<std::string>& comments,
                     const std::vector<std::string>& columns)
    : stream_(&stream), columns_(columns.size()) {
    writeHeader(comments, columns);
}

void CsvWriter::writeHeader(const std::vector<std::string>& comments,
                            const std::vector<std::string>& columns) {
    for (const std::string& comment : comments) {
        buffer_ += "# " + printable(comment) + "\n";
    }
    for (const std::string& column : columns) {
        add(column);
    }
    endRow();
}

CsvWriter& CsvWriter::add(double value) {
    separate();
    std::array<char, 32> text{};
    const std::to_chars_result result = std::to_chars(text.data(), text.data() + text.size(), value,
                                                      std::chars_format::general, kDigits);
    buffer_.append(text.data(), result.ptr);
    return *this;
}

CsvWriter& CsvWriter::add(std::string_view given) {
    separate();
    const bool isPlain = std::ranges::all_of(given, [](char c) { return c >= ' ' && c <= '~'; });
    const std::string safe = isPlain ? std::string() : printable(given);
    const std::string_view text = isPlain ? given : std::string_view(safe);
    if (text.find_first_of(",\"#\n") == std::string_view::npos) {
        buffer_ += text;
        return *this;
    }
    buffer_ += '"';
    for (const char c : text) {
        buffer_ += c == '"' ? std::string("\"\"") : std::string(1, c);
    }
    buffer_ += '"';
    return *this;
}

void CsvWriter::separate() {
    if (cells_++ > 0) {
        buffer_ += ',';
    }
}

void CsvWriter::endRow() {
    if (cells_ != columns_) {
        throw Error("a CSV row has " + std::to_string(cells_) + " cells; the table has " +
                    std::to_string(columns_) + " columns");
    }
    buffer_ += '\n';
    cells_ = 0;
    if (buffer_.size() >= kBufferBytes) {
        flush();
    }
}

void CsvWriter::row(std::span<const double> values) {
    for (const double value : values) {
        add(value);
    }
    endRow();
}

void CsvWriter::flush() {
    if (growing_) {
        growing_->append(buffer_);
    } else {
        stream_->write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    }
    buffer_.clear();
}

void CsvWriter::sync() const {
    if (growing_) {
        growing_->sync();
    }
}

void CsvWriter::close() {
    flush();
    if (file_) {
        file_->commit();
        return;
    }
    if (stream_ != nullptr && !stream_->flush()) {
        throw Error("the CSV output could not be written");
    }
}

}  // namespace asperity
