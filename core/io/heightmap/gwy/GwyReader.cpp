#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/io/ByteReader.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/WholeImages.h"
#include "core/io/heightmap/gwy/GwyWriter.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

// Gwyddion's own files: one container whose keys are paths; /N/data is image N.
// Source: Gwyddion user guide, "Gwyddion native file format"; docs/formats.md 1.

namespace asperity {

namespace {

/// One named value of a serialized Gwyddion object. The value stays in the source.
struct GwyComponent {
    std::string name;
    char type = 0;   ///< one of b c i q d s o, in capitals an array
    ByteSpan value;  ///< of a string without the NUL, of an array the items
};

/// A serialized object: a class name and a block of components.
struct GwyObject {
    std::string className;
    ByteSpan components;
};

/// Walks through the components of an object, one level deep: what is inside a component that
/// nobody asks for is skipped by its size, so depth and unknown classes cost nothing.
/// Source: Gwyddion user guide, "Gwyddion native file format"; docs/formats.md 1.
class GwyComponents {
public:
    /// @param source must outlive this
    GwyComponents(const GwyObject& object, const ByteSource& source)
        : reader_(source, object.components) {}

    /// The next component; empty at the end. @throw InputError when it does not fit
    [[nodiscard]] std::optional<GwyComponent> next();
    /// Returns the name of the component that was asked for last, as far as it could be read.
    [[nodiscard]] const std::string& name() const { return name_; }

private:
    ByteSpan takeValue(char type);
    ByteSpan takeArray(char type);

    ByteReader reader_;
    std::string name_;
};

/// Limit of a title or a unit: the rest is cut off.
constexpr std::uint64_t kGwyMaxText = 65536;

/// Bytes of one value of a type with a fixed size; 0: no such type.
std::uint64_t valueSize(char type) {
    switch (type) {
    case 'b':
    case 'c':
    case 'C':
        return 1;
    case 'i':
    case 'I':
        return 4;
    case 'q':
    case 'Q':
    case 'd':
    case 'D':
        return 8;
    default:
        return 0;
    }
}

void requireType(const GwyComponent& component, char type, const ByteSource& source) {
    if (component.type == type) {
        return;
    }
    throw InputError(source.name(), "byte " + std::to_string(component.value.offset),
                     "the component '" + toUtf8(component.name) + "' has the type '" +
                         toUtf8({&component.type, 1}) + "'; expected '" + type + "'");
}

/// Reads an object at the reader's offset. @throw InputError when it does not fit
GwyObject takeGwyObject(ByteReader& reader) {
    GwyObject object;
    object.className = reader.takeName("a class name");
    const auto size = reader.takeNumber<std::uint32_t>("an object's size");
    object.components = reader.take(size, "an object");
    return object;
}

std::optional<GwyComponent> GwyComponents::next() {
    if (reader_.atEnd()) {
        return std::nullopt;
    }
    GwyComponent component;
    name_.clear();
    component.name = name_ = reader_.takeName("a component's name");
    component.type = reader_.takeNumber<char>("a component's type");
    component.value = takeValue(component.type);
    return component;
}

ByteSpan GwyComponents::takeValue(char type) {
    if (type == 's') {
        return reader_.takeString("a text");
    }
    if (type == 'o') {
        const std::uint64_t start = reader_.offset();
        (void)takeGwyObject(reader_);
        return {start, reader_.offset() - start};
    }
    if (type >= 'A' && type <= 'Z') {
        return takeArray(type);
    }
    const std::uint64_t size = valueSize(type);
    if (size == 0) {
        reader_.fail("unknown type of component; the file is damaged");
    }
    return reader_.take(size, "a value");
}

ByteSpan GwyComponents::takeArray(char type) {
    const std::uint64_t count = reader_.takeNumber<std::uint32_t>("an array's length");
    if (const std::uint64_t size = valueSize(type); size != 0) {
        return reader_.take(count * size, "an array");
    }
    if (type != 'S' && type != 'O') {
        reader_.fail("unknown type of array; the file is damaged");
    }
    const std::uint64_t start = reader_.offset();
    for (std::uint64_t i = 0; i < count; ++i) {
        if (type == 'S') {
            (void)reader_.takeString("a text");
        } else {
            (void)takeGwyObject(reader_);
        }
    }
    return {start, reader_.offset() - start};
}

/// The values, checked to have the type that the format prescribes. @throw InputError otherwise
std::int32_t gwyInteger(const GwyComponent& component, const ByteSource& source) {
    requireType(component, 'i', source);
    return numberIn<std::int32_t>(source, component.value);
}

double gwyNumber(const GwyComponent& component, const ByteSource& source) {
    requireType(component, 'd', source);
    return numberIn<double>(source, component.value);
}

std::string gwyText(const GwyComponent& component, const ByteSource& source) {
    requireType(component, 's', source);
    const ByteSpan& value = component.value;
    constexpr std::uint64_t kCharacter = 4;
    const std::string text =
        bytesOf(source, {value.offset, std::min(value.count, kGwyMaxText + kCharacter)});
    return toUtf8(utf8Start(text, kGwyMaxText));
}

ByteSpan gwyNumbers(const GwyComponent& component, const ByteSource& source) {
    requireType(component, 'D', source);
    return component.value;
}

GwyObject gwyObject(const GwyComponent& component, const ByteSource& source) {
    requireType(component, 'o', source);
    ByteReader reader(source, component.value);
    return takeGwyObject(reader);
}

constexpr std::string_view kGwyMagic = "GWYP";
constexpr std::string_view kOldMagic = "GWYO";

/// Stacks have some hundred.
constexpr std::size_t kGwyMaxImages = 1024;

/// The container's components of one image.
struct ImageParts {
    std::optional<GwyObject> data;
    std::optional<GwyObject> mask;
    std::optional<GwyObject> metadata;
    std::string title;
};

/// A GwyDataField whose values are still bytes.
struct DataField {
    ImageSize size;
    double sizeX = 0.0;  ///< in the lateral unit; 0: not given
    double sizeY = 0.0;
    double offsetX = 0.0;
    double offsetY = 0.0;
    PhysicalUnit lateralUnit;
    PhysicalUnit unit;
    ByteSpan values;  ///< doubles, top row first

    [[nodiscard]] ReadRow rows(const ByteSource& source) const {
        return rowsOf(source, {.size = size, .type = SampleType::Float64, .offset = values.offset});
    }
};

/// "/12/data/title" → 12 and "data/title"; empty for a key that belongs to no image.
struct ImageKey {
    long long image = 0;
    std::string_view rest;
};

/// Graphs, spectra at points, and maps of curves.
bool isOfCurves(std::string_view key) {
    return key.starts_with("/0/graph/graph/") || key.starts_with("/sps/") ||
           key.starts_with("/lawn/");
}

std::optional<ImageKey> parseKey(std::string_view key) {
    if (!key.starts_with('/')) {
        return std::nullopt;
    }
    const std::size_t slash = key.find('/', 1);
    if (slash == std::string_view::npos) {
        return std::nullopt;
    }
    const std::optional<long long> image = parseInteger(key.substr(1, slash - 1));
    if (!image || *image < 0) {
        return std::nullopt;
    }
    return ImageKey{*image, key.substr(slash + 1)};
}

class GwyReader {
public:
    explicit GwyReader(const ByteSource& bytes) : bytes_(bytes), file_(bytes.name()) {}

    StoredScan read() {
        collectImages();
        for (const auto& [number, parts] : parts_) {
            if (parts.data) {
                addChannel(number, parts);
            }
        }
        images_.finish(result_);
        if (isCut_) {
            result_.notes.push_back("the file holds more than " + std::to_string(kGwyMaxImages) +
                                    " images; those after the first " +
                                    std::to_string(kGwyMaxImages) + " are left out");
        }
        if (result_.channels.empty()) {
            throw InputError(file_, "",
                             holdsCurves_ ? "the file holds curves, such as force curves, and no "
                                            "image"
                                          : "the file holds no image (no /0/data or similar)");
        }
        result_.provenance = {{"format version", std::string(kGwyMagic), "byte 0"}};
        return std::move(result_);
    }

private:
    void collectImages() {
        if (bytes_.start(kOldMagic.size()) == kOldMagic) {
            throw InputError(file_, "byte 0",
                             "this is a file of Gwyddion 1; open and save it with Gwyddion 2");
        }
        ByteReader reader(bytes_);
        (void)reader.take(kGwyMagic.size(), "the file's mark");
        const GwyObject container = takeContainer(reader);
        if (!reader.atEnd()) {
            result_.notes.push_back(std::to_string(reader.remaining()) +
                                    " bytes after the end of the data are ignored");
        }
        GwyComponents components(container, bytes_);
        try {
            while (const std::optional<GwyComponent> component = components.next()) {
                store(*component);
            }
        } catch (const InputError& error) {
            if (images_.areAll()) {
                throw;
            }
            leaveOutCut(components.name(), error);
        }
    }

    /// Leaves out an image that the file's end cuts. One whose mask is cut is not whole: masks hold
    /// pixels without data, which importers fill.
    void leaveOutCut(const std::string& name, const InputError& error) {
        if (!name.empty()) {
            images_.leaveOut(toUtf8(name), error);
        }
        if (const std::optional<ImageKey> key = parseKey(name); key && key->rest == "mask") {
            parts_.erase(key->image);
        }
    }

    /// The container, or what is there of it in a truncated file.
    [[nodiscard]] GwyObject takeContainer(ByteReader& reader) {
        GwyObject container;
        container.className = reader.takeName("a class name");
        if (container.className != "GwyContainer") {
            throw InputError(file_, "byte 4", "expected an object of class GwyContainer");
        }
        const auto size = reader.takeNumber<std::uint32_t>("an object's size");
        const std::uint64_t there = std::min<std::uint64_t>(size, reader.remaining());
        container.components = reader.take(there, "an object");
        if (there < size) {
            result_.notes.emplace_back(
                "a mask of pixels without data may be lost with the end of the file");
            images_.leaveOut("what follows byte " + std::to_string(bytes_.size()),
                             InputError(file_, "byte " + std::to_string(bytes_.size()),
                                        "expected " + std::to_string(size - there) +
                                            " further bytes of the container; the file is "
                                            "truncated"));
        }
        return container;
    }

    void store(const GwyComponent& component) {
        holdsCurves_ = holdsCurves_ || isOfCurves(component.name);
        constexpr std::array<std::string_view, 4> kRead{"data", "mask", "meta", "data/title"};
        const std::optional<ImageKey> key = parseKey(component.name);
        if (!key || std::ranges::count(kRead, key->rest) == 0 || isBeyond(key->image)) {
            return;
        }
        ImageParts& parts = parts_[key->image];
        if (key->rest == "data") {
            parts.data = field(component);
        } else if (key->rest == "mask") {
            parts.mask = field(component);
        } else if (key->rest == "meta") {
            parts.metadata = gwyObject(component, bytes_);
        } else {
            parts.title = gwyText(component, bytes_);
        }
    }

    /// Returns whether an image is left out because there are too many.
    bool isBeyond(long long image) {
        const bool isBeyond = parts_.size() == kGwyMaxImages && !parts_.contains(image);
        isCut_ = isCut_ || isBeyond;
        return isBeyond;
    }

    [[nodiscard]] GwyObject field(const GwyComponent& component) const {
        GwyObject object = gwyObject(component, bytes_);
        if (object.className != "GwyDataField") {
            throw InputError(file_, location(object),
                             "'" + toUtf8(component.name) + "' is no GwyDataField");
        }
        return object;
    }

    void addChannel(long long number, const ImageParts& parts) {
        const DataField data = readField(*parts.data);
        ScanChannel channel;
        channel.name = parts.title.empty() ? "Image " + std::to_string(number) : parts.title;
        channel.unit = data.unit.base;
        channel.lateralUnit = data.lateralUnit.base;
        channel.direction = directionFromName(channel.name);
        setOrigin(channel, data.offsetX * data.lateralUnit.factor,
                  data.offsetY * data.lateralUnit.factor, GivenPoint::Corner);
        channel.map = emptyMap(data.size, data.sizeX * data.lateralUnit.factor,
                               data.sizeY * data.lateralUnit.factor);
        ReadRow rows = data.rows(bytes_);
        if (parts.mask) {
            rows = masked(std::move(rows), data.size.columns,
                          maskOf(channel, *parts.mask).rows(bytes_));
        }
        if (parts.metadata) {
            const BoundedTexts texts = readMetadata(*parts.metadata);
            channel.metadata = texts.all();
            result_.hasCutTexts = result_.hasCutTexts || texts.isCut();
        }
        addProvenance(channel, data, "/" + std::to_string(number) + "/data");
        result_.channels.push_back({.channel = std::move(channel),
                                    .factor = data.unit.factor,
                                    .readRow = std::move(rows)});
    }

    static void addProvenance(ScanChannel& channel, const DataField& data,
                              const std::string& location) {
        assumeMeters(channel);
        settleSize(channel, location + ", xreal and yreal");
        channel.provenance.push_back(
            scaleProvenance(data.unit.factor, channel.unit, location + ", si_unit_z"));
        channel.provenance.push_back(
            {"orientation", "the top row is stored first", "the same in every .gwy file"});
    }

    /// Importers put void pixels into the mask and fill the data by interpolation.
    DataField maskOf(ScanChannel& channel, const GwyObject& object) const {
        DataField mask = readField(object);
        if (mask.size.columns != channel.map.columns || mask.size.rows != channel.map.rows) {
            throw InputError(file_, location(object),
                             "the mask of '" + channel.name + "' has another size than its image");
        }
        std::ptrdiff_t marked = 0;
        RowRoom room;
        std::vector<double> values(static_cast<std::size_t>(mask.size.columns));
        const ReadRow rows = mask.rows(bytes_);
        for (int row = 0; row < mask.size.rows; ++row) {
            rows(row, room, values.data());
            marked += std::ranges::count_if(values, isMarked);
        }
        if (marked > 0) {
            channel.notes.push_back(std::to_string(marked) +
                                    " pixels marked by the file's mask are taken as invalid");
        }
        return mask;
    }

    [[nodiscard]] DataField readField(const GwyObject& object) const {
        DataField field;
        std::int32_t columns = 0;
        std::int32_t rows = 0;
        GwyComponents components(object, bytes_);
        while (const std::optional<GwyComponent> part = components.next()) {
            if (part->name == "xres") {
                columns = gwyInteger(*part, bytes_);
            }
            if (part->name == "yres") {
                rows = gwyInteger(*part, bytes_);
            }
            if (part->name == "xreal") {
                field.sizeX = gwyNumber(*part, bytes_);
            }
            if (part->name == "yreal") {
                field.sizeY = gwyNumber(*part, bytes_);
            }
            if (part->name == "xoff") {
                field.offsetX = gwyNumber(*part, bytes_);
            }
            if (part->name == "yoff") {
                field.offsetY = gwyNumber(*part, bytes_);
            }
            if (part->name == "si_unit_xy") {
                field.lateralUnit = readUnit(*part);
            }
            if (part->name == "si_unit_z") {
                field.unit = readUnit(*part);
            }
            if (part->name == "data") {
                field.values = gwyNumbers(*part, bytes_);
            }
        }
        field.size = checkedImageSize(columns, rows, file_, location(object));
        if (field.values.count / sizeof(double) != field.size.pixels()) {
            throw InputError(file_, location(object),
                             std::to_string(columns) + " x " + std::to_string(rows) +
                                 " pixels are promised, but there are " +
                                 std::to_string(field.values.count / sizeof(double)));
        }
        return field;
    }

    [[nodiscard]] PhysicalUnit readUnit(const GwyComponent& component) const {
        PhysicalUnit unit;
        GwyComponents components(gwyObject(component, bytes_), bytes_);
        while (const std::optional<GwyComponent> part = components.next()) {
            if (part->name == "unitstr") {
                unit = parseUnit(gwyText(*part, bytes_));
            }
        }
        return unit;
    }

    [[nodiscard]] BoundedTexts readMetadata(const GwyObject& object) const {
        BoundedTexts metadata(TextQuota::ofEach(parts_.size()));
        const ByteSpan& whole = object.components;
        const std::string texts = bytesOf(bytes_, whole);  // they are many, and short
        GwyComponents components(object, bytes_);
        while (const std::optional<GwyComponent> part = components.next()) {
            if (part->type == 's') {
                metadata.set(toUtf8(part->name),
                             toUtf8(std::string_view(texts).substr(
                                 part->value.offset - whole.offset, part->value.count)));
            }
        }
        return metadata;
    }

    static std::string location(const GwyObject& object) {
        return "byte " + std::to_string(object.components.offset);
    }

    const ByteSource& bytes_;
    const std::string& file_;
    std::map<long long, ImageParts> parts_;  ///< by the number of the image
    WholeImages images_;
    bool isCut_ = false;  ///< there are more images than are read
    bool holdsCurves_ = false;
    StoredScan result_;
};

constexpr std::array<std::string_view, 1> kGwyExtensions{".gwy"};

}  // namespace

const HeightMapFormat kGwyFormat = {
    .name = "Gwyddion .gwy",
    .extensions = kGwyExtensions,
    .recognizes =
        [](const ByteSource& bytes) {
            return bytes.startsWith(kGwyMagic) || bytes.startsWith(kOldMagic);
        },
    .read = [](const ByteSource& bytes) { return GwyReader(bytes).read(); },
    .write = writeGwy,
    .writeAll = writeGwyImages};

}  // namespace asperity
