#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/text/TextHeader.h"
#include "core/io/heightmap/text/TextRows.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <span>
#include <utility>

// A matrix of numbers as text, the first line the top row: Gwyddion's export, "h=.. w=.." before
// the numbers, ESRI grids, NumPy's and CSV files. Written is a matrix of heights after the comment
// lines of two programs: those of Gwyddion's export, and those of SPIP, which Gwyddion recognizes.
// Source: docs/formats.md 4.

namespace asperity {

namespace {

/// The header of SPIP's ASCII files, by which Gwyddion reads size, unit and values; it takes
/// lengths in nanometers.
std::string spipHeader(const HeightRows& map, const HeightMapMeta& meta) {
    constexpr double kPerMeter = 1e9;
    return "# File Format = ASCII\n# Created by Asperity\n# x-pixels = " +
           std::to_string(map.columns) + "\n# y-pixels = " + std::to_string(map.rows) +
           "\n# x-length = " + exactText(kPerMeter * map.sizeX()) +
           "\n# y-length = " + exactText(kPerMeter * map.sizeY()) +
           "\n# x-offset = " + exactText(kPerMeter * meta.originX) +
           "\n# y-offset = " + exactText(kPerMeter * meta.originY) +
           "\n# z-unit = " + oneLine(meta.unit) + "\n";
}

std::string lengthLine(std::string_view key, double length) {
    return "# " + std::string(key) + ": " + exactText(length) + " m\n";
}

/// Returns the header of Gwyddion's exported matrix, which our reader follows.
std::string gwyddionHeader(const HeightRows& map, const HeightMapMeta& meta) {
    return "# Channel: " + oneLine(meta.title) + "\n" + lengthLine("Width", map.sizeX()) +
           lengthLine("Height", map.sizeY()) +
           (meta.unit.empty() ? "" : "# Value units: " + oneLine(meta.unit) + "\n") +
           lengthLine(kOriginXComment, meta.originX) + lengthLine(kOriginYComment, meta.originY);
}

/// Returns further comments; a reader looks for the numbers in the first lines alone.
std::string metadataComments(const HeightMapMeta& meta) {
    constexpr std::size_t kMaxBytes = 40000;
    constexpr int kMaxLines = 800;
    const std::set<std::string_view> own = {kOriginXComment, kOriginYComment, "Start of Data"};
    std::string lines;
    int count = 0;
    for (const auto& [name, value] : writtenMetadata(meta, kMaxBytes)) {
        const bool isKey = name.find_first_of(":=#%") == std::string::npos && !own.contains(name);
        if (isKey && ++count <= kMaxLines) {
            lines.append("# ").append(name).append(": ").append(value).append("\n");
        }
    }
    return lines;
}

/// The `write` of kTextFormat.
void writeText(const std::filesystem::path& target, const HeightRows& map,
               const HeightMapMeta& meta, Progress* progress) {
    std::ofstream stream(target, std::ios::binary);
    stream << spipHeader(map, meta) << gwyddionHeader(map, meta) << metadataComments(meta)
           << "# Start of Data:\n";
    forEachRow(map, progress, [&](int, const std::vector<double>& heights) {
        std::string line;
        for (const double height : heights) {
            line += line.empty() ? "" : "\t";
            line += isFiniteHeight(height) ? exactText(height) : "nan";
        }
        stream << line << '\n';
    });
    finish(stream);
}

constexpr long long kMaxRows = 65536;
/// Value that many programs write where there are no data.
constexpr double kUsualNoData = -9999.0;

/// All but the first.
std::span<const double> rest(const std::vector<double>& numbers) {
    return std::span(numbers).subspan(1);
}

/// Returns whether they are 0, 1, 2...
bool countsUp(std::span<const double> numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i] != static_cast<double>(i)) {
            return false;
        }
    }
    return true;
}

/// Two may be heights, three hardly.
bool looksLikeNumbering(std::span<const double> numbers) {
    return numbers.size() > 2 && countsUp(numbers);
}

bool rises(std::span<const double> numbers) {
    return std::ranges::adjacent_find(numbers, std::not_fn(std::less())) == numbers.end();
}

class TextMatrixReader {
public:
    explicit TextMatrixReader(const ByteSource& bytes)
        : file_(bytes.name())
        , lines_(bytes)
        , header_(requireTextHeader(lines_))
        , rows_(lines_, header_)
        , columns_(static_cast<long long>(rows_.columns())) {}

    StoredScan read() {
        requireNoProfile();
        readNumbers();
        dropNumbering();
        takeMask();
        requirePromisedSize();
        markNoData();
        StoredScan scan;
        scan.texts = std::move(header_.texts);
        scan.channels.push_back(channel());
        return scan;
    }

private:
    void requireNoProfile() {
        if (header_.isMatrix || columns_ > 2) {
            return;
        }
        lines_.fail(columns_ == 1
                        ? "one column of numbers is a profile, no height map"
                        : "two columns of numbers are a profile or a curve, such as a force curve, "
                          "and no height map");
    }

    void readNumbers() {
        for (auto row = rows_.next(); !row.empty(); row = rows_.next()) {
            if (++count_ > kMaxRows) {
                lines_.fail("more than " + std::to_string(kMaxRows) + " lines of numbers");
            }
            numbers_.insert(numbers_.end(), row.begin(), row.end());
        }
        if (count_ == 1 && !header_.isMatrix) {
            lines_.fail("one line of numbers is a profile, no height map");
        }
    }

    /// Leaves out the numbers of rows and columns that tables of pandas have: 0, 1, 2... in the
    /// first line and column, and nothing in their corner. What only looks like a numbering or like
    /// axes stays, and a note says so.
    void dropNumbering() {
        if (header_.isMatrix || count_ < 2 || columns_ < 3) {
            return;
        }
        const std::vector<double> line = firstLine();
        const std::vector<double> column = firstColumn();
        const bool hasCorner = std::isnan(line.front());
        if (hasCorner && countsUp(rest(line)) && countsUp(rest(column))) {
            dropFirst();
            header_.notes.emplace_back(
                "its first line and first column number the others and are left out");
        } else if (hasCorner && rises(rest(line)) && rises(rest(column))) {
            header_.notes.emplace_back("its corner is empty, and its first line and first column "
                                       "rise: remove them if they are axes and no heights");
        } else if (looksLikeNumbering(line) || looksLikeNumbering(column)) {
            header_.notes.push_back(std::string("its first ") +
                                    (looksLikeNumbering(line) ? "line" : "column") +
                                    " counts 0, 1, 2...: remove it if it is a numbering and no "
                                    "heights");
        }
    }

    [[nodiscard]] std::vector<double> firstLine() const {
        return {numbers_.begin(), numbers_.begin() + columns_};
    }
    [[nodiscard]] std::vector<double> firstColumn() const {
        std::vector<double> column;
        for (long long row = 0; row < count_; ++row) {
            column.push_back(numbers_[static_cast<std::size_t>(row * columns_)]);
        }
        return column;
    }

    /// The first line and the first column.
    void dropFirst() {
        std::deque<double> heights;
        for (long long row = 1; row < count_; ++row) {
            const auto begin = numbers_.begin() + row * columns_;
            heights.insert(heights.end(), begin + 1, begin + columns_);
        }
        numbers_ = std::move(heights);
        --count_;
        --columns_;
    }

    /// SPIP's lines of 1 and 0 behind the numbers, one for each: 0 is a pixel without data.
    void takeMask() {
        if (header_.hasMask && count_ == header_.rows) {
            header_.notes.emplace_back(
                "the file is truncated: it does not hold the lines of 'voidpixels', which say what "
                "pixels have no data; all are taken as valid");
        }
        if (!header_.hasMask || count_ != 2 * header_.rows) {
            return;
        }
        const auto half = static_cast<std::ptrdiff_t>(numbers_.size() / 2);
        std::transform(numbers_.begin(), numbers_.begin() + half, numbers_.begin() + half,
                       numbers_.begin(), [](double number, double valid) {
                           return valid == 0.0 ? std::numeric_limits<double>::quiet_NaN() : number;
                       });
        numbers_.resize(static_cast<std::size_t>(half));
        count_ /= 2;
    }

    void requirePromisedSize() const {
        const bool fits = (header_.columns == 0 || header_.columns == columns_) &&
                          (header_.rows == 0 || header_.rows == count_);
        if (!fits) {
            throw InputError(file_, "header",
                             "it promises " + std::to_string(header_.columns) + " x " +
                                 std::to_string(header_.rows) + " numbers, and there are " +
                                 std::to_string(columns_) + " x " + std::to_string(count_) +
                                 "; the file is truncated or damaged");
        }
    }

    void markNoData() {
        double noData = kUsualNoData;
        if (header_.noData) {
            noData = *header_.noData;
        } else if (std::ranges::any_of(numbers_, [](double z) { return z < kUsualNoData; })) {
            return;  // it is a number among others
        }
        const auto marked = std::ranges::count(numbers_, noData);
        if (marked == 0) {
            return;
        }
        std::ranges::replace(numbers_, noData, std::numeric_limits<double>::quiet_NaN());
        header_.notes.push_back(std::to_string(marked) + " numbers are " + exactText(noData) +
                                " and taken as pixels without data");
    }

    StoredChannel channel() {
        const ImageSize size = checkedImageSize(columns_, count_, file_, "matrix");
        const bool byPixel = header_.pitch > 0.0;
        ScanChannel channel;
        channel.name = header_.title.empty() ? "matrix" : header_.title;
        channel.unit = header_.unit.base;
        channel.lateralUnit = header_.lateralUnit;
        channel.direction = directionFromName(channel.name);
        channel.map = emptyMap(size, byPixel ? header_.pitch * size.columns : header_.sizeX,
                               byPixel ? header_.pitch * size.rows : header_.sizeY);
        setOrigin(channel, header_.originX, header_.originY, GivenPoint::Corner);
        channel.notes = std::move(header_.notes);
        settleSize(channel, header_.sizeSource);
        if (!channel.unit.empty()) {
            channel.provenance.push_back(
                scaleProvenance(header_.unit.factor, channel.unit, header_.unitSource));
        }
        std::ranges::move(rows_.provenance(), std::back_inserter(channel.provenance));
        channel.provenance.push_back(
            {"orientation", "the first line is the top row", "usual; the file does not say"});
        return {.channel = std::move(channel),
                .factor = header_.unit.factor,
                .readRow = rowsOfNumbers(std::move(numbers_), size.columns)};
    }

    std::string file_;
    TextLines lines_;
    TextHeader header_;
    TextRows rows_;
    std::deque<double> numbers_;
    long long columns_;
    long long count_ = 0;  ///< of rows
};

constexpr std::array<std::string_view, 1> kMatrixExtensions{".txt"};

}  // namespace

const HeightMapFormat kTextFormat = {
    .name = "text matrix",
    .extensions = kMatrixExtensions,
    .recognizes = [](const ByteSource& bytes) { return glanceAtText(bytes).has_value(); },
    .read = [](const ByteSource& bytes) { return TextMatrixReader(bytes).read(); },
    .write = writeText};

}  // namespace asperity
