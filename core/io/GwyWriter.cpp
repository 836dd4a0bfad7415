#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/HeightMapEncoders.h"

#include <limits>
#include <string_view>
#include <utility>

// Gwyddion's own files; see GwyReader.cpp.

namespace asperity {

namespace {

/// A serialised object in the making.
class GwyObjectBytes {
public:
    explicit GwyObjectBytes(std::string className) : className_(std::move(className)) {}

    GwyObjectBytes& boolean(std::string_view name, bool value) {
        begin(name, 'b');
        components_ += value ? '\1' : '\0';
        return *this;
    }
    GwyObjectBytes& integer(std::string_view name, std::int32_t value) {
        begin(name, 'i');
        appendLittleEndian(components_, value);
        return *this;
    }
    GwyObjectBytes& number(std::string_view name, double value) {
        begin(name, 'd');
        appendLittleEndian(components_, value);
        return *this;
    }
    GwyObjectBytes& text(std::string_view name, std::string_view value) {
        begin(name, 's');
        appendText(components_, value);
        return *this;
    }
    GwyObjectBytes& numbers(std::string_view name, const std::vector<double>& values) {
        begin(name, 'D');
        appendLittleEndian(components_, static_cast<std::uint32_t>(values.size()));
        for (const double value : values) {
            appendLittleEndian(components_, value);
        }
        return *this;
    }
    GwyObjectBytes& object(std::string_view name, const GwyObjectBytes& value) {
        begin(name, 'o');
        components_ += value.bytes();
        return *this;
    }

    [[nodiscard]] std::string bytes() const {
        if (components_.size() > std::numeric_limits<std::uint32_t>::max()) {
            throw Error("a .gwy file holds at most 4 GiB");
        }
        std::string bytes;
        appendText(bytes, className_);
        appendLittleEndian(bytes, static_cast<std::uint32_t>(components_.size()));
        return bytes + components_;
    }

private:
    void begin(std::string_view name, char type) {
        appendText(components_, name);
        components_ += type;
    }
    /// NUL ends a text, so what follows one is cut off.
    static void appendText(std::string& bytes, std::string_view text) {
        bytes += text.substr(0, text.find('\0'));
        bytes += '\0';
    }

    std::string className_;
    std::string components_;
};

GwyObjectBytes metre() {
    GwyObjectBytes unit("GwySIUnit");
    unit.text("unitstr", "m");
    return unit;
}

GwyObjectBytes dataField(const HeightMap& map, const HeightMapMeta& meta,
                         const std::vector<double>& values) {
    GwyObjectBytes field("GwyDataField");
    field.integer("xres", map.columns)
        .integer("yres", map.rows)
        .number("xreal", map.sizeX())
        .number("yreal", map.sizeY())
        .number("xoff", meta.originX)
        .number("yoff", meta.originY)
        .object("si_unit_xy", metre());
    return field.numbers("data", values);
}

/// The format forbids NaN: pixels without data hold the lowest height, and the mask marks them.
std::vector<double> filledHeights(const HeightMap& map) {
    std::vector<double> heights = map.heights;
    const double filling = heightRange(map).lowest;
    for (std::size_t i = 0; i < map.invalid.size(); ++i) {
        if (map.invalid[i] != 0) {
            heights[i] = filling;
        }
    }
    return heights;
}

}  // namespace

void writeGwy(const std::filesystem::path& target, const HeightMap& map,
              const HeightMapMeta& meta) {
    GwyObjectBytes image = dataField(map, meta, filledHeights(map));
    image.object("si_unit_z", metre());
    GwyObjectBytes container("GwyContainer");
    container.object("/0/data", image)
        .text("/0/data/title", meta.title)
        .boolean("/0/data/visible", true);
    if (!map.invalid.empty()) {
        const std::vector<double> mask(map.invalid.begin(), map.invalid.end());
        container.object("/0/mask", dataField(map, meta, mask));
    }
    writeBytes(target, "GWYP" + container.bytes());
}

}  // namespace asperity
