#include "core/io/heightmap/vti/VtiHead.h"

#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/vti/VtiValues.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <pugixml.hpp>

// The XML of a VTK image. Its values are in it, in base64 or as text, or follow the mark
// <AppendedData encoding="raw">_, as they are or in base64.
// Source: VTK File Formats (4.2), "XML File Formats".

namespace asperity {

namespace {

/// Twice that of our longest file; the parser needs 20 times its bytes.
constexpr std::uint64_t kMaxHead = std::uint64_t{1} << 22U;
/// Limit of a text or numbers beside the image.
constexpr std::uint64_t kMaxFieldBytes = std::uint64_t{1} << 20U;
/// Limit of all of these: many arrays may name the same values.
constexpr std::uint64_t kMaxAllFieldBytes = 4 * kMaxFieldBytes;
constexpr std::size_t kMaxPieces = 4096;

std::vector<std::string_view> wordsOf(std::string_view text) {
    constexpr std::string_view kBlanks = " \t\r\n";
    std::vector<std::string_view> words;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        const std::size_t end = std::min(text.find_first_of(kBlanks), text.size());
        words.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return words;
}

std::string attribute(const pugi::xml_node& node, const char* name) {
    return toUtf8(trimmed(node.attribute(name).value()));
}

bool isNumber(double value) { return isFiniteHeight(value); }

/// Empty for those that a height map does not have.
std::optional<SampleType> sampleType(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, SampleType>, 10> kTypes{
        {{"Int8", SampleType::Int8},
         {"UInt8", SampleType::UInt8},
         {"Int16", SampleType::Int16},
         {"UInt16", SampleType::UInt16},
         {"Int32", SampleType::Int32},
         {"UInt32", SampleType::UInt32},
         {"Int64", SampleType::Int64},
         {"UInt64", SampleType::UInt64},
         {"Float32", SampleType::Float32},
         {"Float64", SampleType::Float64}}};
    const auto* const found =
        std::ranges::find(kTypes, name, &std::pair<std::string_view, SampleType>::first);
    return found == kTypes.end() ? std::nullopt : std::optional(found->second);
}

/// The tags of the XML, without what is appended to them. A text between tags, which may be long,
/// becomes its offset and length in the file.
class VtiTags {
public:
    explicit VtiTags(const ByteSource& bytes) : bytes_(bytes) {
        constexpr std::uint64_t kChunk = std::uint64_t{1} << 16U;
        for (std::uint64_t offset = 0; offset < bytes.size() && !appended_; offset += kChunk) {
            const std::string chunk =
                bytesOf(bytes, {offset, std::min(kChunk, bytes.size() - offset)});
            for (std::size_t i = 0; i < chunk.size() && !appended_; ++i) {
                if (hasText_ && !inTag_) {
                    i = std::min(chunk.find('<', i), chunk.size() - 1);
                }
                add(chunk[i], offset + i);
            }
        }
    }

    [[nodiscard]] const std::string& text() const { return tags_; }
    /// Returns the offset of the appended values.
    [[nodiscard]] std::optional<std::uint64_t> appended() const { return appended_; }

private:
    void add(char c, std::uint64_t offset) {
        if (inTag_) {
            addToTag(c, offset);
        } else if (c == '<') {
            addText(offset);
            tagBegin_ = tags_.size();
            tags_ += c;
            inTag_ = true;
        } else if (trimmed(std::string_view(&c, 1)).empty()) {
            return;
        } else if (isAppended_) {
            if (c != '_') {
                fail("AppendedData", "expected the mark '_' before the values");
            }
            appended_ = offset + 1;
            tags_ += "</AppendedData></VTKFile>";
        } else {
            hasText_ = true;
        }
    }

    void addToTag(char c, std::uint64_t offset) {
        tags_ += c;
        if (tags_.size() > kMaxHead) {
            fail("byte " + std::to_string(offset), "the XML is too long for that of a VTK image");
        }
        const std::string_view tag = std::string_view(tags_).substr(tagBegin_);
        if (tag == "<![CDATA[") {
            // It would pass for the offset of a text.
            fail("byte " + std::to_string(offset), "expected values, found a CDATA section");
        }
        const bool isComment = tag.starts_with("<!--");
        if (!isComment && (c == '"' || c == '\'')) {
            quote_ = quote_ == 0 ? c : (quote_ == c ? char{0} : quote_);
        }
        if (c == '>' && quote_ == 0 && (!isComment || tag.ends_with("-->"))) {
            inTag_ = false;
            textBegin_ = offset + 1;
            isAppended_ = tag.starts_with("<AppendedData") && !tag.ends_with("/>");
        }
    }

    void addText(std::uint64_t end) {
        if (isAppended_) {
            fail("AppendedData", "expected the mark '_' before the values");
        }
        if (hasText_) {
            tags_ += std::to_string(textBegin_) + " " + std::to_string(end - textBegin_);
        }
        hasText_ = false;
    }

    [[noreturn]] void fail(const std::string& location, const std::string& what) const {
        throw InputError(bytes_.name(), location, what);
    }

    const ByteSource& bytes_;
    std::string tags_;
    bool inTag_ = false;
    char quote_ = 0;
    bool isAppended_ = false;  ///< the last tag begins the appended values
    bool hasText_ = false;     ///< after the last tag
    std::size_t tagBegin_ = 0;
    std::uint64_t textBegin_ = 0;
    std::optional<std::uint64_t> appended_;
};

/// First and last index along x and y.
struct Extent {
    long long left = 0;
    long long right = 0;
    long long bottom = 0;
    long long top = 0;

    [[nodiscard]] bool meets(const Extent& other) const {
        return left < other.right && other.left < right && bottom < other.top && other.bottom < top;
    }
    [[nodiscard]] bool contains(const Extent& other) const {
        return left <= other.left && other.right <= right && bottom <= other.bottom &&
               other.top <= top;
    }
    [[nodiscard]] long long cells() const { return (right - left) * (top - bottom); }
};

/// Neighbors share the points of their edges.
bool fill(const Extent& whole, const std::vector<Extent>& pieces) {
    if (pieces.size() == 1) {
        return pieces[0].contains(whole) && whole.contains(pieces[0]);
    }
    long long cells = 0;
    for (auto piece = pieces.begin(); piece != pieces.end(); ++piece) {
        const bool isAlone = std::none_of(pieces.begin(), piece,
                                          [&](const Extent& other) { return other.meets(*piece); });
        if (!isAlone || !whole.contains(*piece)) {
            return false;
        }
        cells += piece->cells();
    }
    return cells == whole.cells() && cells > 0;
}

class VtiHeadReader {
public:
    explicit VtiHeadReader(const ByteSource& bytes) : bytes_(bytes) { parse(); }

    VtiHead read() {
        head_.version = attribute(root_, "version");
        readCoding();
        const pugi::xml_node image = root_.child("ImageData");
        readGrid(image);
        readFieldData(image.child("FieldData"));
        readPieces(image);
        readArrays("PointData");
        if (head_.arrays.empty()) {
            // The values of cells lie between the points.
            isOfCells_ = true;
            head_.size = checkedImageSize(whole_.right - whole_.left, whole_.top - whole_.bottom,
                                          bytes_.name(), "WholeExtent");
            readArrays("CellData");
        }
        if (head_.arrays.empty()) {
            fail("PointData", "expected an array of numbers, one for each point or cell");
        }
        return std::move(head_);
    }

private:
    void parse() {
        const VtiTags xml(bytes_);
        values_ = xml.appended();
        const pugi::xml_parse_result result = document_.load_string(xml.text().c_str());
        if (!result) {
            fail("VTKFile", std::string("this is no XML: ") + result.description());
        }
        root_ = document_.child("VTKFile");
        if (const std::string type = attribute(root_, "type"); type != "ImageData") {
            fail("VTKFile",
                 "it holds VTK data of type '" + type + "'; an image (ImageData) is expected");
        }
    }

    void readCoding() {
        coding_.order =
            attribute(root_, "byte_order") == "BigEndian" ? ByteOrder::Big : ByteOrder::Little;
        coding_.countBytes = attribute(root_, "header_type") == "UInt64" ? 8 : 4;
        constexpr std::array<std::pair<std::string_view, VtiCompressor>, 4> kCompressors{
            {{"", VtiCompressor::None},
             {"vtkZLibDataCompressor", VtiCompressor::Zlib},
             {"vtkLZ4DataCompressor", VtiCompressor::Lz4},
             {"vtkLZMADataCompressor", VtiCompressor::Lzma}}};
        const std::string name = attribute(root_, "compressor");
        const auto* const found = std::ranges::find(
            kCompressors, name, &std::pair<std::string_view, VtiCompressor>::first);
        if (found == kCompressors.end()) {
            fail("VTKFile", "its compressor '" + name + "' is not known");
        }
        coding_.compressor = found->second;
        const std::string encoding = attribute(root_.child("AppendedData"), "encoding");
        if (values_ && encoding != "raw" && encoding != "base64") {
            fail("AppendedData", "its encoding '" + encoding + "' is not known");
        }
        appended_ = encoding == "base64" ? VtiForm::Base64 : VtiForm::Raw;
    }

    [[nodiscard]] std::vector<double> numbers(const pugi::xml_node& node, const char* name,
                                              std::size_t count) const {
        const std::string text = attribute(node, name);
        std::vector<double> values;
        for (const std::string_view word : wordsOf(text)) {
            values.push_back(parseNumber(word).value_or(std::numeric_limits<double>::quiet_NaN()));
        }
        if (values.size() != count || !std::ranges::all_of(values, isNumber)) {
            fail(name, "expected " + std::to_string(count) + " numbers, found '" + text + "'");
        }
        return values;
    }

    [[nodiscard]] Extent extentOf(const pugi::xml_node& node, const char* name) const {
        constexpr double kMaxIndex = 1e9;
        const std::vector<double> extent = numbers(node, name, 6);
        if (std::ranges::any_of(extent, [](double index) { return std::abs(index) > kMaxIndex; })) {
            fail(name, "expected numbers of pixels");
        }
        if (extent[4] != extent[5]) {
            fail(name, whatHasHeight(extent));
        }
        return {std::llround(extent[0]), std::llround(extent[1]), std::llround(extent[2]),
                std::llround(extent[3])};
    }

    /// @param extent whose first and last index along z differ
    static std::string whatHasHeight(const std::vector<double>& extent) {
        const bool isThinX = extent[0] == extent[1];
        const bool isThinY = extent[2] == extent[3];
        if (isThinX && isThinY) {
            return "it is a line along z, no height map";
        }
        return isThinX || isThinY ? "its image stands upright; one along x and y is expected"
                                  : "it holds a volume; an image of one layer is expected";
    }

    void readGrid(const pugi::xml_node& image) {
        whole_ = extentOf(image, "WholeExtent");
        head_.size = checkedImageSize(whole_.right - whole_.left + 1,
                                      whole_.top - whole_.bottom + 1, bytes_.name(), "WholeExtent");
        const std::vector<double> spacing = numbers(image, "Spacing", 3);
        head_.pitchX = spacing[0];
        head_.pitchY = spacing[1];
        if (image.attribute("Direction") && numbers(image, "Direction", 9) != kUpright) {
            fail("Direction", "the image is turned; axes along x and y are expected");
        }
    }

    /// VTK writes an image that is not made in pieces once for each piece.
    void readPieces(const pugi::xml_node& image) {
        for (const pugi::xml_node& piece : image.children("Piece")) {
            const Extent extent = extentOf(piece, "Extent");
            const bool isRepeated = std::ranges::any_of(
                extents_, [&](const Extent& other) { return other.contains(extent); });
            if (!isRepeated) {
                pieces_.push_back(piece);
                extents_.push_back(extent);
            }
            if (pieces_.size() > kMaxPieces) {
                fail("Piece", "expected at most " + std::to_string(kMaxPieces) + " pieces");
            }
        }
        if (pieces_.empty() || !fill(whole_, extents_)) {
            fail("Piece", "expected pieces that fill the extent of the whole image once");
        }
    }

    void readFieldData(const pugi::xml_node& data) {
        for (const pugi::xml_node& array : data.children()) {
            const std::string name = attribute(array, "Name");
            const std::string type = attribute(array, "type");
            const std::optional<SampleType> numbers = sampleType(type);
            if (type == "String") {
                head_.texts.add(name, textOf(array));
            } else if (numbers) {
                head_.numbers.emplace(name, numbersOf(array, *numbers));
            } else {
                head_.notes.push_back("field data '" + name + "' have values of type " + type +
                                      " and were left out");
            }
        }
    }

    /// Counts the bytes of field data. @throw InputError when that is too much in all
    [[nodiscard]] std::string counted(std::string values) {
        fieldBytes_ += values.size();
        if (fieldBytes_ > kMaxAllFieldBytes) {
            fail("FieldData", "expected texts and numbers of at most " +
                                  std::to_string(kMaxAllFieldBytes) + " bytes in all");
        }
        return values;
    }

    [[nodiscard]] std::string textOf(const pugi::xml_node& array) {
        if (attribute(array, "format") == "ascii") {
            return textOfCodes(array);
        }
        const std::string text =
            counted(decodedVti(bytes_, coding_, valuesOf(array), kMaxFieldBytes));
        return toUtf8(text.substr(0, text.find(char{0})));
    }

    [[nodiscard]] std::vector<double> numbersOf(const pugi::xml_node& array, SampleType type) {
        const VtiValues values = valuesOf(array);
        const SampleLayout layout = layoutOf(values, type, {1, 1});
        OwnedBytes samples(counted(decodedVti(bytes_, coding_, values, kMaxFieldBytes)),
                           bytes_.name());
        std::vector<double> result(samples.size() / sizeOf(layout.type));
        if (!result.empty()) {
            SampleLayout row = layout;
            row.size.columns = static_cast<int>(result.size());
            RowRoom room;
            rowsOf(samples, row)(0, room, result.data());
        }
        std::ranges::transform(result, result.begin(), finiteOrZero);
        return result;
    }

    /// The numbers of a text's bytes, and 0 at its end.
    [[nodiscard]] std::string textOfCodes(const pugi::xml_node& array) {
        constexpr long long kBytes = 256;
        const ByteSpan span = valuesOf(array).span;
        const std::string given =
            counted(bytesOf(bytes_, {span.offset, std::min(span.count, kMaxFieldBytes)}));
        std::string text;
        for (const std::string_view word : wordsOf(given)) {
            const std::optional<long long> code = parseInteger(word);
            if (!code || *code <= -kBytes || *code >= kBytes) {
                fail("FieldData, " + attribute(array, "Name"),
                     "expected the number of a character, found '" + toUtf8(word) + "'");
            }
            if (*code == 0) {
                break;
            }
            text += static_cast<char>(*code);
        }
        return toUtf8(text);
    }

    /// Returns whether an array holds ids of points or cells, by VTK's mark or its name.
    [[nodiscard]] static bool holdsIds(const pugi::xml_node& array) {
        return array.attribute("IdType").as_bool() || attribute(array, "Name").ends_with("Ids");
    }

    /// @param kind PointData or CellData
    void readArrays(const char* kind) {
        head_.scalars = attribute(pieces_[0].child(kind), "Scalars");
        for (const pugi::xml_node& array : pieces_[0].child(kind).children("DataArray")) {
            const std::string name = attribute(array, "Name");
            const std::optional<SampleType> type = sampleType(attribute(array, "type"));
            const std::string components = attribute(array, "NumberOfComponents");
            if (holdsIds(array)) {
                head_.notes.push_back("array '" + name + "' holds ids and was left out");
                continue;
            }
            if (!type || (!components.empty() && components != "1")) {
                head_.notes.push_back("array '" + name + "' has " +
                                      (type ? components + " numbers a point"
                                            : "values of type " + attribute(array, "type")) +
                                      " and was left out");
                continue;
            }
            head_.arrays.push_back({.name = name, .type = *type, .pieces = {}});
            // Before each is searched for in the other pieces.
            requireImages(head_.arrays.size(), bytes_.name(), kind);
            for (std::size_t i = 0; i < pieces_.size(); ++i) {
                const pugi::xml_node part = pieces_[i].child(kind).find_child_by_attribute(
                    "DataArray", "Name", array.attribute("Name").value());
                if (attribute(part, "type") != attribute(array, "type")) {
                    fail("array '" + name + "'", "expected it in each piece of the image");
                }
                head_.arrays.back().pieces.push_back(pieceOf(part, *type, extents_[i]));
            }
        }
    }

    [[nodiscard]] VtiPiece pieceOf(const pugi::xml_node& array, SampleType type,
                                   const Extent& extent) const {
        const int more = isOfCells_ ? 0 : 1;
        const ImageSize size{.columns = static_cast<int>(extent.right - extent.left) + more,
                             .rows = static_cast<int>(extent.top - extent.bottom) + more};
        VtiValues values = valuesOf(array);
        const bool isPlain =
            values.form == VtiForm::Raw && coding_.compressor == VtiCompressor::None;
        VtiPiece piece{.firstColumn = static_cast<int>(extent.left - whole_.left),
                       .firstRow = static_cast<int>(extent.bottom - whole_.bottom),
                       .layout = layoutOf(values, type, size),
                       .decode = {}};
        if (isPlain) {
            piece.layout.offset = values.span.offset + coding_.countBytes;
            requirePlain(values, piece.layout);
            return piece;
        }
        piece.decode = [&bytes = bytes_, coding = coding_, values = std::move(values),
                        wanted = piece.layout.bytes()] {
            std::string samples = decodedVti(bytes, coding, values, wanted);
            requireBytes(bytes, values.location, wanted, samples.size());
            return samples;
        };
        return piece;
    }

    [[nodiscard]] VtiValues valuesOf(const pugi::xml_node& array) const {
        VtiValues values{.span = {}, .location = "array '" + attribute(array, "Name") + "'"};
        const std::string format = attribute(array, "format");
        if (format == "appended") {
            const std::optional<long long> offset = parseInteger(attribute(array, "offset"));
            if (!values_ || !offset || *offset < 0 ||
                static_cast<std::uint64_t>(*offset) > bytes_.size() - *values_) {
                fail(values.location, "its values would begin behind the end of the file, which is "
                                      "truncated or damaged");
            }
            const std::uint64_t begin = *values_ + static_cast<std::uint64_t>(*offset);
            values.form = appended_;
            values.span = {begin, bytes_.size() - begin};
        } else if (format == "binary" || format == "ascii") {
            values.form = format == "ascii" ? VtiForm::Text : VtiForm::Base64;
            values.span = spanOf(array);
        } else {
            fail(values.location, "its format '" + format + "' is not known");
        }
        return values;
    }

    /// Returns the span of the text in an element, see VtiTags. It is checked: what is a tag there
    /// may be a text to the parser, as after a quote in <?...?>.
    [[nodiscard]] ByteSpan spanOf(const pugi::xml_node& node) const {
        const std::vector<std::string_view> words = wordsOf(node.text().get());
        if (words.empty()) {
            return {};
        }
        const auto end = static_cast<long long>(bytes_.size());
        const long long offset = parseInteger(words.front()).value_or(-1);
        const long long count = parseInteger(words.back()).value_or(-1);
        if (words.size() != 2 || offset < 0 || offset > end || count < 0 || count > end - offset) {
            fail("array '" + attribute(node, "Name") + "'", "expected values within its tags");
        }
        return {static_cast<std::uint64_t>(offset), static_cast<std::uint64_t>(count)};
    }

    /// Returns the layout of the samples that decodedVti() gives.
    [[nodiscard]] SampleLayout layoutOf(const VtiValues& values, SampleType type,
                                        ImageSize size) const {
        const bool isText = values.form == VtiForm::Text;
        return {.size = size,
                .type = isText ? SampleType::Float64 : type,
                .order = isText ? ByteOrder::Little : coding_.order,
                .bottomFirst = true};
    }

    void requirePlain(const VtiValues& values, const SampleLayout& layout) const {
        if (values.span.count < coding_.countBytes) {
            fail(values.location, "its values would begin behind the end of the file, which is "
                                  "truncated or damaged");
        }
        const std::string count = bytesOf(bytes_, {values.span.offset, coding_.countBytes});
        requireBytes(bytes_, values.location, layout.bytes(), vtiCount(count.data(), coding_));
        requireSamples(bytes_, layout, values.location);
    }

    static void requireBytes(const ByteSource& bytes, const std::string& location,
                             std::uint64_t expected, std::uint64_t found) {
        if (found != expected) {
            throw InputError(bytes.name(), location,
                             "expected " + std::to_string(expected) + " bytes of values, found " +
                                 std::to_string(found));
        }
    }

    [[noreturn]] void fail(const std::string& location, const std::string& what) const {
        throw InputError(bytes_.name(), location, what);
    }

    inline static const std::vector<double> kUpright = {1, 0, 0, 0, 1, 0, 0, 0, 1};

    const ByteSource& bytes_;
    pugi::xml_document document_;
    pugi::xml_node root_;
    std::optional<std::uint64_t> values_;  ///< offset of the appended ones
    VtiForm appended_ = VtiForm::Raw;
    VtiCoding coding_;
    Extent whole_;
    std::vector<pugi::xml_node> pieces_;
    std::vector<Extent> extents_;  ///< of the pieces
    bool isOfCells_ = false;
    std::uint64_t fieldBytes_ = 0;
    VtiHead head_;
};

}  // namespace

bool isVtkXml(const ByteSource& bytes) {
    constexpr std::uint64_t kFront = 1024;
    const std::string front = bytes.start(kFront);
    return trimmed(front).starts_with('<') && front.find("<VTKFile") != std::string::npos;
}

VtiHead readVtiHead(const ByteSource& bytes) { return VtiHeadReader(bytes).read(); }

ReadRow rowsOf(const ByteSource& bytes, const VtiArray& array, int rows) {
    struct Part {
        int firstColumn;
        int top;     ///< its highest row, 0 at the top of the image
        int bottom;  ///< one below its lowest
        ReadRow read;
    };
    std::vector<Part> parts;
    for (const VtiPiece& piece : array.pieces) {
        const int bottom = rows - piece.firstRow;
        parts.push_back({piece.firstColumn, bottom - piece.layout.size.rows, bottom,
                         piece.decode ? rowsOfDecoded(piece.decode, piece.layout, bytes.name())
                                      : rowsOf(bytes, piece.layout)});
    }
    return [parts = std::move(parts)](int row, RowRoom& room, double* numbers) {
        for (const Part& part : parts) {
            if (row >= part.top && row < part.bottom) {
                part.read(row - part.top, room, numbers + part.firstColumn);
            }
        }
    };
}

}  // namespace asperity
