#include "core/io/heightmap/vti/VtiHead.h"

#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/TextValue.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <pugixml.hpp>

// The XML of a VTK image. Its values follow the mark <AppendedData encoding="raw">_ as they are,
// each array after the number of its bytes. Source: VTK File Formats (4.2), "XML File Formats".

namespace asperity {

namespace {

/// Twice that of our longest file; the parser needs 20 times its bytes.
constexpr std::uint64_t kMaxHead = std::uint64_t{1} << 22U;
constexpr std::string_view kAppended = "<AppendedData";
constexpr const char* kExpected =
    "; only appended, raw, uncompressed values are read (in ParaView: data mode Appended, no "
    "encoding, no compressor)";

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
    constexpr std::array<std::pair<std::string_view, SampleType>, 8> kTypes{
        {{"Int8", SampleType::Int8},
         {"UInt8", SampleType::UInt8},
         {"Int16", SampleType::Int16},
         {"UInt16", SampleType::UInt16},
         {"Int32", SampleType::Int32},
         {"UInt32", SampleType::UInt32},
         {"Float32", SampleType::Float32},
         {"Float64", SampleType::Float64}}};
    const auto* const found =
        std::ranges::find(kTypes, name, &std::pair<std::string_view, SampleType>::first);
    return found == kTypes.end() ? std::nullopt : std::optional(found->second);
}

class VtiHeadReader {
public:
    explicit VtiHeadReader(const ByteSource& bytes) : bytes_(bytes) { parse(); }

    VtiHead read() {
        head_.version = attribute(root_, "version");
        requireRawValues();
        const pugi::xml_node image = root_.child("ImageData");
        readGrid(image);
        readFieldData(image.child("FieldData"));
        const pugi::xml_node piece = image.child("Piece");
        if (piece.next_sibling("Piece") ||
            wordsOf(attribute(piece, "Extent")) != wordsOf(attribute(image, "WholeExtent"))) {
            fail("Piece", "expected one piece with the extent of the whole image");
        }
        for (const pugi::xml_node& array : piece.child("PointData").children("DataArray")) {
            readArray(array);
        }
        if (head_.arrays.empty()) {
            fail("PointData", "expected an array of numbers, one for each point");
        }
        return std::move(head_);
    }

private:
    /// The values behind the XML are no part of it.
    void parse() {
        std::string xml = bytes_.start(kMaxHead);
        const std::size_t appended = xml.find(kAppended);
        std::size_t end = xml.size();
        if (appended != std::string::npos) {
            const std::size_t tag = xml.find('>', appended);
            const std::size_t mark = xml.find('_', std::min(tag, xml.size()));
            if (mark == std::string::npos ||
                !trimmed(std::string_view(xml).substr(tag + 1, mark - tag - 1)).empty()) {
                fail("AppendedData", "expected the mark '_' before the values");
            }
            values_ = mark + 1;
            end = tag + 1;
        }
        if (appended == std::string::npos && bytes_.size() > kMaxHead) {
            fail("AppendedData", "the XML before it is too long" + std::string(kExpected));
        }
        xml.resize(end);
        xml += appended == std::string::npos ? "" : "</AppendedData></VTKFile>";
        const pugi::xml_parse_result result = document_.load_string(xml.c_str());
        if (!result) {
            fail("byte " + std::to_string(result.offset),
                 std::string("this is no XML: ") + result.description());
        }
        root_ = document_.child("VTKFile");
        if (const std::string type = attribute(root_, "type"); type != "ImageData") {
            fail("VTKFile",
                 "it holds VTK data of type '" + type + "'; an image (ImageData) is expected");
        }
    }

    void requireRawValues() const {
        if (root_.attribute("compressor")) {
            fail("VTKFile", "its values are compressed" + std::string(kExpected));
        }
        const pugi::xml_node appended = root_.child("AppendedData");
        if (!appended || attribute(appended, "encoding") != "raw") {
            fail("AppendedData", (appended ? "its values have the encoding '" +
                                                 attribute(appended, "encoding") + "'"
                                           : std::string("its values stand within the XML")) +
                                     kExpected);
        }
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

    void readGrid(const pugi::xml_node& image) {
        constexpr double kMaxIndex = 1e9;
        const std::vector<double> extent = numbers(image, "WholeExtent", 6);
        if (std::ranges::any_of(extent, [](double index) { return std::abs(index) > kMaxIndex; })) {
            fail("WholeExtent", "expected numbers of pixels");
        }
        if (extent[4] != extent[5]) {
            fail("WholeExtent", "it holds a volume; an image of one layer is expected");
        }
        head_.size =
            checkedImageSize(std::llround(extent[1] - extent[0]) + 1,
                             std::llround(extent[3] - extent[2]) + 1, bytes_.name(), "WholeExtent");
        const std::vector<double> spacing = numbers(image, "Spacing", 3);
        head_.pitchX = spacing[0];
        head_.pitchY = spacing[1];
        if (image.attribute("Direction") && numbers(image, "Direction", 9) != kUpright) {
            fail("Direction", "the image is turned; axes along x and y are expected");
        }
    }

    void readFieldData(const pugi::xml_node& data) {
        for (const pugi::xml_node& array : data.children()) {
            if (attribute(array, "format") != "ascii") {
                head_.notes.push_back("field data '" + attribute(array, "Name") +
                                      "' are not plain text and were left out");
            } else if (attribute(array, "type") == "String") {
                head_.texts.emplace(attribute(array, "Name"), textOf(array));
            } else {
                head_.numbers.emplace(attribute(array, "Name"), numbersOf(array));
            }
        }
    }

    [[nodiscard]] static std::vector<double> numbersOf(const pugi::xml_node& array) {
        std::vector<double> values;
        for (const std::string_view word : wordsOf(array.text().get())) {
            values.push_back(finiteOrZero(parseNumber(word).value_or(0.0)));
        }
        return values;
    }

    /// The numbers of a text's bytes, and 0 at its end.
    [[nodiscard]] std::string textOf(const pugi::xml_node& array) const {
        constexpr long long kBytes = 256;
        std::string text;
        for (const std::string_view word : wordsOf(array.text().get())) {
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

    void readArray(const pugi::xml_node& array) {
        const std::string name = attribute(array, "Name");
        const std::optional<SampleType> type = sampleType(attribute(array, "type"));
        const std::string components = attribute(array, "NumberOfComponents");
        if (!type || (!components.empty() && components != "1")) {
            head_.notes.push_back("array '" + name + "' has " +
                                  (type ? components + " numbers a point"
                                        : "values of type " + attribute(array, "type")) +
                                  " and was left out");
            return;
        }
        const std::optional<long long> offset = parseInteger(attribute(array, "offset"));
        if (attribute(array, "format") != "appended" || !offset || *offset < 0) {
            fail("array '" + name + "'", "its values are not appended" + std::string(kExpected));
        }
        head_.arrays.push_back({name, layoutOf(name, *type, static_cast<std::uint64_t>(*offset))});
    }

    [[nodiscard]] SampleLayout layoutOf(const std::string& name, SampleType type,
                                        std::uint64_t offset) const {
        const ByteOrder order =
            attribute(root_, "byte_order") == "BigEndian" ? ByteOrder::Big : ByteOrder::Little;
        const std::uint64_t headBytes = attribute(root_, "header_type") == "UInt64" ? 8 : 4;
        const std::uint64_t left = bytes_.size() - values_;
        if (left < headBytes || offset > left - headBytes) {
            fail(
                "array '" + name + "'",
                "its values would begin behind the end of the file, which is truncated or damaged");
        }
        const SampleLayout layout{.size = head_.size,
                                  .type = type,
                                  .order = order,
                                  .place = values_ + offset + headBytes,
                                  .bottomFirst = true};
        const std::uint64_t count = countAt(values_ + offset, headBytes, order);
        if (count != layout.bytes()) {
            fail("array '" + name + "'", "expected " + std::to_string(layout.bytes()) +
                                             " bytes of values, found " + std::to_string(count));
        }
        requireSamples(bytes_, layout, "array '" + name + "'");
        return layout;
    }

    [[nodiscard]] std::uint64_t countAt(std::uint64_t place, std::uint64_t width,
                                        ByteOrder order) const {
        const std::string bytes = bytesOf(bytes_, {place, width});
        const bool little = order == ByteOrder::Little;
        if (width == sizeof(std::uint64_t)) {
            return little ? littleEndian<std::uint64_t>(bytes.data())
                          : bigEndian<std::uint64_t>(bytes.data());
        }
        return little ? littleEndian<std::uint32_t>(bytes.data())
                      : bigEndian<std::uint32_t>(bytes.data());
    }

    [[noreturn]] void fail(const std::string& place, const std::string& what) const {
        throw InputError(bytes_.name(), place, what);
    }

    inline static const std::vector<double> kUpright = {1, 0, 0, 0, 1, 0, 0, 0, 1};

    const ByteSource& bytes_;
    pugi::xml_document document_;
    pugi::xml_node root_;
    std::uint64_t values_ = 0;  ///< where they begin
    VtiHead head_;
};

}  // namespace

bool isVtkXml(const ByteSource& bytes) {
    constexpr std::uint64_t kFront = 1024;
    const std::string front = bytes.start(kFront);
    return trimmed(front).starts_with('<') && front.find("<VTKFile") != std::string::npos;
}

VtiHead readVtiHead(const ByteSource& bytes) { return VtiHeadReader(bytes).read(); }

}  // namespace asperity
