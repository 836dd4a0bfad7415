#include "core/io/heightmap/x3p/X3pDescription.h"

#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/io/ByteReader.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/ScanImage.h"

#include <cmath>
#include <initializer_list>
#include <limits>
#include <pugixml.hpp>

// ISO 25178-72 (once ISO 5436-2): Record1 has the axes, Record2 the origin of the data, Record3 the
// matrix; docs/formats.md 11.

namespace asperity {

namespace {

/// Limit of a text that is kept; a comment may be of any length.
constexpr std::size_t kX3pMaxText = 4096;
/// Elements and attributes. Each takes the parser up to 128 bytes, but the file less than one where
/// it is packed: as many as a list of a 1024 x 1024 image has, and a head of any length.
constexpr std::uint64_t kMaxXmlParts = 1'200'000;

std::string_view localName(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    return name.substr(name.find(':') + 1);
}

pugi::xml_node child(const pugi::xml_node& node, std::string_view name) {
    return node.find_child([name](const pugi::xml_node& each) { return localName(each) == name; });
}

pugi::xml_node descendant(pugi::xml_node node, std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names) {
        node = child(node, name);
    }
    return node;
}

std::string textOf(const pugi::xml_node& node) { return toUtf8(trimmed(node.text().get())); }

/// Counts them without a parser's memory; a '=' of a text is taken for an attribute.
std::uint64_t xmlParts(std::string_view xml) {
    std::uint64_t parts = 0;
    for (std::size_t i = 0; i < xml.size(); ++i) {
        const bool isTag = xml[i] == '<' && xml.substr(i + 1, 1) != "/";
        parts += isTag || xml[i] == '=' ? 1 : 0;
    }
    return parts;
}

class X3pMain {
public:
    X3pMain(std::string xml, const std::string& file, const std::string& entry)
        : xml_(std::move(xml)), file_(file), entry_(entry) {
        if (const std::uint64_t parts = xmlParts(xml_); parts > kMaxXmlParts) {
            throw InputError(file_, entry_,
                             "expected at most " + std::to_string(kMaxXmlParts) +
                                 " elements and attributes, found " + std::to_string(parts));
        }
        // One node for an element and its text: a list has many of them.
        constexpr unsigned kOptions = pugi::parse_default | pugi::parse_embed_pcdata;
        const pugi::xml_parse_result result =
            document_.load_buffer_inplace(xml_.data(), xml_.size(), kOptions);
        if (!result) {
            fail("byte " + std::to_string(result.offset),
                 std::string("this is no XML: ") + result.description());
        }
        root_ = document_.document_element();
        const std::string_view root = localName(root_);
        if (root != "ISO5436_2" && root != "ISO5436") {
            fail("root",
                 "expected the element ISO5436_2 or ISO5436, found '" + toUtf8(root_.name()) + "'");
        }
    }

    X3pDescription describe() {
        requireSurface();
        description_.revision = textOf(descendant(root_, {"Record1", "Revision"}));
        description_.x = incrementalAxis("CX");
        description_.y = incrementalAxis("CY");
        description_.z = valueAxis();
        description_.isRotated = bool(descendant(root_, {"Record1", "Axes", "Rotation"}));
        readMatrix();
        readMetadata();
        return std::move(description_);
    }

private:
    void requireSurface() const {
        const std::string feature = textOf(descendant(root_, {"Record1", "FeatureType"}));
        if (feature == "SUR") {
            return;
        }
        fail("Record1/FeatureType",
             feature == "PRF"   ? "it holds a profile (PRF); a surface (SUR) is expected"
             : feature == "PCL" ? "it holds a cloud of points (PCL); a surface (SUR) is expected"
                                : "expected SUR, found '" + feature + "'");
    }

    /// Returns that of x or y: the pixels follow each other at equal steps.
    [[nodiscard]] X3pAxis incrementalAxis(std::string_view name) const {
        const pugi::xml_node axis = descendant(root_, {"Record1", "Axes", name});
        const std::string location = "Record1/Axes/" + std::string(name);
        if (const std::string type = textOf(child(axis, "AxisType")); type != "I") {
            fail(location + "/AxisType",
                 "expected I (equal steps), found '" + type + "'" +
                     (type == "A" ? ": a list of points is no height map" : ""));
        }
        return {.increment = number(axis, "Increment", location).value_or(0.0),
                .offset = number(axis, "Offset", location).value_or(0.0)};
    }

    X3pAxis valueAxis() {
        const pugi::xml_node axis = descendant(root_, {"Record1", "Axes", "CZ"});
        const std::string location = "Record1/Axes/CZ";
        description_.type = sampleType(textOf(child(axis, "DataType")), location + "/DataType");
        const X3pAxis values{.increment = number(axis, "Increment", location).value_or(1.0),
                             .offset = number(axis, "Offset", location).value_or(0.0)};
        if (!std::isfinite(values.increment) || values.increment == 0.0 ||
            !std::isfinite(values.offset)) {
            fail(location, "expected a scale (Increment) that is not 0 and a finite Offset");
        }
        return values;
    }

    [[nodiscard]] std::optional<SampleType> sampleType(const std::string& letter,
                                                       const std::string& location) const {
        if (letter.empty()) {
            return std::nullopt;
        }
        if (letter == "I") {
            return SampleType::Int16;
        }
        if (letter == "L") {
            return SampleType::Int32;
        }
        if (letter == "F") {
            return SampleType::Float32;
        }
        if (letter == "D") {
            return SampleType::Float64;
        }
        fail(location, "expected I, L, F or D, found '" + letter + "'");
    }

    /// Empty when the element is missing or has no text.
    [[nodiscard]] std::optional<double> number(const pugi::xml_node& parent, const char* name,
                                               const std::string& location) const {
        const std::string text = textOf(child(parent, name));
        if (text.empty()) {
            return std::nullopt;
        }
        const std::optional<double> value = parseNumber(text);
        if (!value) {
            fail(location + "/" + name, "expected a number, found '" + text + "'");
        }
        return value;
    }

    void readMatrix() {
        const pugi::xml_node record = child(root_, "Record3");
        const pugi::xml_node matrix = child(record, "MatrixDimension");
        if (!matrix) {
            fail("Record3", "expected MatrixDimension: only heights on a grid are read");
        }
        description_.size = checkedImageSize(side(matrix, "SizeX"), side(matrix, "SizeY"), file_,
                                             entry_ + ", Record3/MatrixDimension");
        const long long layers = child(matrix, "SizeZ") ? side(matrix, "SizeZ") : 1;
        if (layers < 1 || layers > static_cast<long long>(kMaxImages)) {
            fail("Record3/MatrixDimension/SizeZ", "expected 1 to " + std::to_string(kMaxImages) +
                                                      ", found " + std::to_string(layers));
        }
        description_.layers = static_cast<int>(layers);
        readData(record);
    }

    void readData(const pugi::xml_node& record) {
        if (const pugi::xml_node list = child(record, "DataList")) {
            description_.listed = listedNumbers(list);
            return;
        }
        const pugi::xml_node link = child(record, "DataLink");
        description_.points = {.entry = textOf(child(link, "PointDataLink")),
                               .md5 = lowerCase(textOf(child(link, "MD5ChecksumPointData")))};
        description_.validPoints = {.entry = textOf(child(link, "ValidPointsLink")),
                                    .md5 =
                                        lowerCase(textOf(child(link, "MD5ChecksumValidPoints")))};
        if (description_.points.entry.empty()) {
            fail("Record3", "expected the heights: a DataList, or a DataLink with PointDataLink");
        }
        if (!description_.type) {
            fail("Record1/Axes/CZ/DataType", "expected I, L, F or D; it is missing");
        }
    }

    [[nodiscard]] long long side(const pugi::xml_node& matrix, const char* name) const {
        const std::string text = textOf(child(matrix, name));
        const std::optional<long long> value = parseInteger(text);
        if (!value) {
            fail(std::string("Record3/MatrixDimension/") + name,
                 "expected a whole number, found '" + text + "'");
        }
        return *value;
    }

    /// An empty element holds no data; of "x;y;z" the last number counts.
    [[nodiscard]] std::string listedNumbers(const pugi::xml_node& list) const {
        std::uint64_t count = 0;
        for (const pugi::xml_node& each : list.children()) {
            count += localName(each) == "Datum" ? 1 : 0;
        }
        if (count != description_.numbers()) {
            fail("Record3/DataList", "expected " + std::to_string(description_.numbers()) +
                                         " elements Datum, found " + std::to_string(count));
        }
        std::string numbers;
        numbers.reserve(static_cast<std::size_t>(count * sizeof(double)));
        for (const pugi::xml_node& each : list.children()) {
            if (localName(each) == "Datum") {
                appendLittleEndian(numbers, datum(each, numbers.size() / sizeof(double)));
            }
        }
        return numbers;
    }

    [[nodiscard]] double datum(const pugi::xml_node& node, std::size_t index) const {
        const std::string_view text = trimmed(node.text().get());
        const std::string_view last = text.substr(text.find_last_of(';') + 1);
        if (trimmed(last).empty()) {
            return std::numeric_limits<double>::quiet_NaN();
        }
        const std::optional<double> value = parseNumber(last);
        if (!value) {
            fail("Record3/DataList, Datum " + std::to_string(index + 1),
                 "expected a number, found '" + toUtf8(text) + "'");
        }
        return *value;
    }

    void readMetadata() {
        for (const pugi::xml_node& each : child(root_, "Record2").children()) {
            keep(each, std::string(localName(each)));
            for (const pugi::xml_node& part : each.children()) {
                keep(part, std::string(localName(each)) + " " + std::string(localName(part)));
            }
        }
    }

    void keep(const pugi::xml_node& node, const std::string& name) {
        if (const std::string text = textOf(node); !text.empty()) {
            description_.texts.set(toUtf8(name), std::string(utf8Start(text, kX3pMaxText)));
        }
    }

    [[noreturn]] void fail(const std::string& location, const std::string& what) const {
        throw InputError(file_, entry_ + ", " + location, what);
    }

    std::string xml_;  ///< the document's texts lie in it
    const std::string& file_;
    const std::string& entry_;
    pugi::xml_document document_;
    pugi::xml_node root_;
    X3pDescription description_;
};

}  // namespace

X3pDescription describeX3p(std::string xml, const std::string& file, const std::string& entry) {
    return X3pMain(std::move(xml), file, entry).describe();
}

}  // namespace asperity
