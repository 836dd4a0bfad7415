#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/GwyObject.h"
#include "core/io/HeightMapFormat.h"
#include "core/io/PhysicalUnit.h"
#include "core/io/ScanImage.h"
#include "core/io/TextValue.h"

#include <limits>
#include <optional>

// Gwyddion's own files: one container whose keys are paths; /N/data is image N.
// Source: Gwyddion user guide, "Gwyddion native file format"; docs/formats.md 1.

namespace asperity {

namespace {

constexpr std::string_view kMagic = "GWYP";
constexpr std::string_view kOldMagic = "GWYO";

/// What the container holds about one image.
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
    std::string_view values;  ///< doubles, top row first

    [[nodiscard]] double value(std::size_t pixel) const {
        return littleEndian<double>(values.data() + pixel * sizeof(double));
    }
    /// As a mask.
    [[nodiscard]] bool marks(std::size_t pixel) const { return value(pixel) > 0.0; }
};

/// "/12/data/title" → 12 and "data/title"; empty for a key that belongs to no image.
struct ImageKey {
    long long image = 0;
    std::string_view rest;
};

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
    GwyReader(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(file) {}

    StoredScan read() {
        collectImages();
        for (const auto& [number, parts] : images_) {
            if (parts.data) {
                addChannel(number, parts);
            }
        }
        if (result_.channels.empty()) {
            throw InputError(file_, "", "the file holds no image (no /0/data or similar)");
        }
        return std::move(result_);
    }

private:
    void collectImages() {
        if (bytes_.starts_with(kOldMagic)) {
            throw InputError(file_, "byte 0",
                             "this is a file of Gwyddion 1; open and save it with Gwyddion 2");
        }
        ByteReader reader(bytes_, file_);
        (void)reader.take(kMagic.size(), "the file's mark");
        const GwyObject container = takeGwyObject(reader);
        if (container.className != "GwyContainer") {
            throw InputError(file_, "byte 4", "expected an object of class GwyContainer");
        }
        if (!reader.atEnd()) {
            result_.notes.push_back(std::to_string(reader.remaining()) +
                                    " bytes after the end of the data are ignored");
        }
        GwyComponents components(container, file_);
        while (const std::optional<GwyComponent> component = components.next()) {
            store(*component);
        }
    }

    void store(const GwyComponent& component) {
        const std::optional<ImageKey> key = parseKey(component.name);
        if (!key) {
            return;
        }
        if (key->rest == "data") {
            images_[key->image].data = field(component);
        } else if (key->rest == "mask") {
            images_[key->image].mask = field(component);
        } else if (key->rest == "meta") {
            images_[key->image].metadata = gwyObject(component, file_);
        } else if (key->rest == "data/title") {
            images_[key->image].title = gwyText(component, file_);
        }
    }

    [[nodiscard]] GwyObject field(const GwyComponent& component) const {
        const GwyObject object = gwyObject(component, file_);
        if (object.className != "GwyDataField") {
            throw InputError(file_, place(object),
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
        channel.originX = finiteOrZero(data.offsetX * data.lateralUnit.factor);
        channel.originY = finiteOrZero(data.offsetY * data.lateralUnit.factor);
        channel.map = emptyMap(data.size, data.sizeX * data.lateralUnit.factor,
                               data.sizeY * data.lateralUnit.factor);
        std::optional<DataField> mask;
        if (parts.mask) {
            mask = maskOf(channel, *parts.mask);
        }
        if (parts.metadata) {
            channel.metadata = readMetadata(*parts.metadata);
        }
        settleSize(channel, result_.notes);
        result_.channels.push_back({std::move(channel), [data, mask](int row, double* values) {
                                        readRow(data, mask, row, values);
                                    }});
    }

    static void readRow(const DataField& data, const std::optional<DataField>& mask, int row,
                        double* values) {
        const auto columns = static_cast<std::size_t>(data.size.columns);
        const std::size_t first = static_cast<std::size_t>(row) * columns;
        for (std::size_t i = 0; i < columns; ++i) {
            values[i] = data.unit.factor * data.value(first + i);
        }
        if (!mask) {
            return;
        }
        for (std::size_t i = 0; i < columns; ++i) {
            if (mask->marks(first + i)) {
                values[i] = std::numeric_limits<double>::quiet_NaN();
            }
        }
    }

    /// Importers put void pixels into the mask and fill the data by interpolation.
    DataField maskOf(const ScanChannel& channel, const GwyObject& object) {
        const DataField mask = readField(object);
        if (mask.size.columns != channel.map.columns || mask.size.rows != channel.map.rows) {
            throw InputError(file_, place(object),
                             "the mask of '" + channel.name + "' has another size than its image");
        }
        std::size_t marked = 0;
        for (std::size_t i = 0; i < mask.size.pixels(); ++i) {
            marked += mask.marks(i) ? 1 : 0;
        }
        if (marked > 0) {
            result_.notes.push_back("'" + channel.name + "': " + std::to_string(marked) +
                                    " pixels marked by the file's mask are taken as invalid");
        }
        return mask;
    }

    [[nodiscard]] DataField readField(const GwyObject& object) const {
        DataField field;
        std::int32_t columns = 0;
        std::int32_t rows = 0;
        GwyComponents components(object, file_);
        while (const std::optional<GwyComponent> part = components.next()) {
            if (part->name == "xres") {
                columns = gwyInteger(*part, file_);
            }
            if (part->name == "yres") {
                rows = gwyInteger(*part, file_);
            }
            if (part->name == "xreal") {
                field.sizeX = gwyNumber(*part, file_);
            }
            if (part->name == "yreal") {
                field.sizeY = gwyNumber(*part, file_);
            }
            if (part->name == "xoff") {
                field.offsetX = gwyNumber(*part, file_);
            }
            if (part->name == "yoff") {
                field.offsetY = gwyNumber(*part, file_);
            }
            if (part->name == "si_unit_xy") {
                field.lateralUnit = readUnit(*part);
            }
            if (part->name == "si_unit_z") {
                field.unit = readUnit(*part);
            }
            if (part->name == "data") {
                field.values = gwyNumbers(*part, file_);
            }
        }
        field.size = checkedImageSize(columns, rows, file_, place(object));
        if (field.values.size() / sizeof(double) != field.size.pixels()) {
            throw InputError(file_, place(object),
                             std::to_string(columns) + " x " + std::to_string(rows) +
                                 " pixels are promised, but there are " +
                                 std::to_string(field.values.size() / sizeof(double)));
        }
        return field;
    }

    [[nodiscard]] PhysicalUnit readUnit(const GwyComponent& component) const {
        PhysicalUnit unit;
        GwyComponents components(gwyObject(component, file_), file_);
        while (const std::optional<GwyComponent> part = components.next()) {
            if (part->name == "unitstr") {
                unit = parseUnit(gwyText(*part, file_));
            }
        }
        return unit;
    }

    [[nodiscard]] std::map<std::string, std::string> readMetadata(const GwyObject& object) const {
        std::map<std::string, std::string> metadata;
        GwyComponents components(object, file_);
        while (const std::optional<GwyComponent> part = components.next()) {
            if (part->type == 's') {
                metadata[toUtf8(part->name)] = gwyText(*part, file_);
            }
        }
        return metadata;
    }

    static std::string place(const GwyObject& object) {
        return "byte " + std::to_string(object.place);
    }

    std::string_view bytes_;
    const std::string& file_;
    std::map<long long, ImageParts> images_;
    StoredScan result_;
};

}  // namespace

const HeightMapFormat kGwyFormat = {
    "Gwyddion .gwy",
    [](std::string_view bytes) {
        return bytes.starts_with(kMagic) || bytes.starts_with(kOldMagic);
    },
    [](std::string_view bytes, const std::string& file) { return GwyReader(bytes, file).read(); }};

}  // namespace asperity
