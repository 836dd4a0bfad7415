#include "core/Error.h"
#include "core/io/TextLines.h"
#include "core/io/TextValue.h"
#include "core/io/curves/CurveFormat.h"
#include "core/io/curves/text/TextCurve.h"
#include "core/io/zip/ZipArchive.h"

#include <algorithm>
#include <cmath>

// Texts of single curves: named tables of any program, those of Optics11 Chiaro, also in a zip, of
// AFM Workshop, and the three columns without titles of NT-MDT. Source: docs/formats.md 21.

namespace asperity {

namespace {

constexpr std::uint64_t kTextLooked = std::uint64_t{1} << 16U;

/// A text is read when it is opened.
class TextCurves final : public StoredCurves {
public:
    explicit TextCurves(CurveContents contents) : contents_(std::move(contents)) {}

    [[nodiscard]] std::size_t count() const override { return 1; }
    [[nodiscard]] CurveContents read(std::size_t /*index*/) const override { return contents_; }

private:
    CurveContents contents_;
};

std::unique_ptr<StoredCurves> openText(const ByteSource& bytes, const CurveReadOptions& options) {
    const std::optional<CurveTable> table =
        options.columns.empty() ? std::nullopt : std::optional(givenTable(options.columns));
    return std::make_unique<TextCurves>(readTextCurve(bytes, options, table));
}

bool holdsText(const ByteSource& bytes, std::string_view mark) {
    return bytes.start(kTextLooked).find(mark) != std::string::npos;
}

bool recognizesChiaro(const ByteSource& bytes) {
    return holdsText(bytes, "Device:\tChiaro") && hasCurveTitles(bytes);
}

bool recognizesAfmWorkshop(const ByteSource& bytes) {
    return holdsText(bytes, "Extend Z-Sense(") && hasCurveTitles(bytes);
}

/// Steps of the first of three columns of numbers, line by line.
class EqualSteps {
public:
    /// Returns whether a line has three numbers, and the first one is a step further.
    [[nodiscard]] bool take(std::string_view line) {
        const std::vector<std::string> cells = curveCells(line, {1, 2, 3});
        if (cells.size() != 3) {
            return false;
        }
        const double value = cellNumber(cells[0]).value_or(0.0);
        const double step = value - last_;
        if (lines_ == 1) {
            step_ = step;
        }
        last_ = value;
        return lines_++ < 1 || std::abs(step - step_) < 0.1 * std::abs(step_);
    }
    [[nodiscard]] std::size_t lines() const { return lines_; }

private:
    std::size_t lines_ = 0;
    double last_ = 0.0;
    double step_ = 0.0;
};

/// The first column rises in equal steps of the base throughout, as x of points on a grid does not;
/// approach and retract follow. Source: docs/formats.md 21.
bool recognizesNtMdt(const ByteSource& bytes) {
    constexpr std::size_t kFewest = 10;
    const std::string start = bytes.start(kTextLooked);
    EqualSteps steps;
    if (!steps.take(std::string_view(start).substr(0, start.find('\n')))) {
        return false;
    }
    steps = {};
    TextLines lines(bytes);
    while (const std::optional<std::string_view> line = lines.next()) {
        if (!trimmed(*line).empty() && !steps.take(*line)) {
            return false;
        }
    }
    return steps.lines() >= kFewest;
}

std::unique_ptr<StoredCurves> openNtMdt(const ByteSource& bytes, const CurveReadOptions& options) {
    CurveContents contents = readTextCurve(
        bytes, options, givenTable(givenColumns("base=1:nm,signal=2:V,retract-signal=3:V")));
    contents.notes.emplace_back("the table names no units: its first column is taken as the base "
                                "in nm, the others as the signal of approach and retract in V");
    return std::make_unique<TextCurves>(std::move(contents));
}

/// Texts in a zip archive, a curve each.
class ZippedTexts final : public StoredCurves {
public:
    explicit ZippedTexts(const ByteSource& bytes, CurveReadOptions options)
        : archive_(bytes), options_(std::move(options)), most_(mostBytesOf(bytes)) {
        for (const ZipEntry& entry : archive_.entries()) {
            if (isText(entry)) {
                texts_.push_back(entry);
            }
        }
        if (texts_.empty()) {
            throw InputError(bytes.name(), "", "the zip archive holds no text (.txt, .csv, .tsv)");
        }
    }

    [[nodiscard]] std::size_t count() const override { return texts_.size(); }
    [[nodiscard]] CurveContents read(std::size_t index) const override {
        CurveContents contents = readTextCurve(*archive_.source(texts_[index], most_), options_);
        contents.notes.insert(contents.notes.begin(), "member " + texts_[index].name);
        return contents;
    }

    static bool isText(const ZipEntry& entry) {
        const std::string name = lowerCase(entry.name);
        return std::ranges::any_of(std::array{".txt", ".csv", ".tsv"},
                                   [&name](const char* end) { return name.ends_with(end); });
    }

private:
    /// Numbers in text are packed to about a third.
    static std::uint64_t mostBytesOf(const ByteSource& bytes) {
        constexpr std::uint64_t kAlwaysAllowed = std::uint64_t{1} << 20U;
        constexpr std::uint64_t kUsualPacking = 64;
        return std::max(kAlwaysAllowed, kUsualPacking * bytes.size());
    }

    ZipArchive archive_;
    CurveReadOptions options_;
    std::uint64_t most_;
    std::vector<ZipEntry> texts_;
};

/// By its directory: other archives of the same programs hold no texts.
bool recognizesZippedTexts(const ByteSource& bytes) {
    if (!isZip(bytes)) {
        return false;
    }
    const std::optional<std::string> directory = zipDirectory(bytes);
    return directory && lowerCase(*directory).find(".txt") != std::string::npos;
}

}  // namespace

const CurveFormat kTextCurveFormat = {
    .name = "text table of named columns", .recognizes = hasCurveTitles, .open = openText};

const CurveFormat kChiaroCurveFormat = {
    .name = "Optics11 Chiaro text", .recognizes = recognizesChiaro, .open = openText};

const CurveFormat kAfmWorkshopCurveFormat = {
    .name = "AFM Workshop .csv", .recognizes = recognizesAfmWorkshop, .open = openText};

const CurveFormat kNtMdtTextCurveFormat = {
    .name = "NT-MDT text", .recognizes = recognizesNtMdt, .open = openNtMdt};

const CurveFormat kZippedTextCurveFormat = {
    .name = "zip archive of text curves",
    .recognizes = recognizesZippedTexts,
    .open = [](const ByteSource& bytes, const CurveReadOptions& options)
        -> std::unique_ptr<StoredCurves> { return std::make_unique<ZippedTexts>(bytes, options); }};

}  // namespace asperity
