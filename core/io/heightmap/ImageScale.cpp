#include "core/io/heightmap/ImageScale.h"

#include "core/SiFormat.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightStatistics.h"
#include "core/io/heightmap/PhysicalUnit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace asperity {

namespace {

/// Smallest and largest sample of a type of integers.
struct SampleEnds {
    double lowest = 0.0;
    double highest = 0.0;  ///< 0 for floats
};

template <typename Integer>
SampleEnds endsOf() {
    return {static_cast<double>(std::numeric_limits<Integer>::min()),
            static_cast<double>(std::numeric_limits<Integer>::max())};
}

SampleEnds endsOf(SampleType type) {
    switch (type) {
    case SampleType::Int8:
        return endsOf<std::int8_t>();
    case SampleType::UInt8:
        return endsOf<std::uint8_t>();
    case SampleType::Int16:
        return endsOf<std::int16_t>();
    case SampleType::UInt16:
        return endsOf<std::uint16_t>();
    case SampleType::Int32:
        return endsOf<std::int32_t>();
    case SampleType::UInt32:
        return endsOf<std::uint32_t>();
    case SampleType::Int64:
        return endsOf<std::int64_t>();
    case SampleType::UInt64:
        return endsOf<std::uint64_t>();
    case SampleType::Float32:
    case SampleType::Float64:
        return {};
    }
    return {};
}

bool isFloat(SampleType type) { return endsOf(type).highest == 0.0; }

/// The texts of Gwyddion's keys.
class GwyTexts {
public:
    GwyTexts(const ImageTexts& texts, const std::string& file) : texts_(texts), file_(file) {}

    [[nodiscard]] std::string text(const std::string& key) const {
        const auto found = texts_.find("Gwy::" + key);
        return found == texts_.end() ? std::string() : std::string(trimmed(found->second));
    }
    [[nodiscard]] bool has(const std::string& key) const { return !text(key).empty(); }
    /// 0 where there is none.
    [[nodiscard]] double number(const std::string& key) const {
        if (!has(key)) {
            return 0.0;
        }
        const std::optional<double> value = parseNumber(text(key));
        if (!value) {
            throw InputError(file_, "Gwy::" + key, "expected a number, found '" + text(key) + "'");
        }
        return *value;
    }

private:
    const ImageTexts& texts_;
    const std::string& file_;
};

void takeLateral(ImageScale& scale, const GwyTexts& texts, const std::string& source) {
    const PhysicalUnit lateral = parseUnit(texts.text("XYUnit"));
    scale.lateralUnit = lateral.base;
    scale.sizeX = texts.number("XReal") * lateral.factor;
    scale.sizeY = texts.number("YReal") * lateral.factor;
    scale.originX = texts.number("XOffset") * lateral.factor;
    scale.originY = texts.number("YOffset") * lateral.factor;
    scale.sizeSource = source + " Gwy::XReal, Gwy::YReal";
}

void takeNoData(ImageScale& scale, const ImageTexts& texts, const std::string& file,
                const std::string& source) {
    const auto found = texts.find(std::string(kNoDataKey));
    if (found == texts.end()) {
        return;
    }
    scale.noData = parseNumber(found->second);
    if (!scale.noData) {
        throw InputError(file, std::string(kNoDataKey),
                         "expected a number, found '" + found->second + "'");
    }
    scale.provenance.push_back({"pixels without data", "count " + exactText(*scale.noData),
                                source + " " + std::string(kNoDataKey)});
}

ReadRow withoutCount(ReadRow rows, int columns, double count) {
    constexpr double kNoHeight = std::numeric_limits<double>::quiet_NaN();
    return replaced(std::move(rows), columns,
                    [count](double number) { return number == count ? kNoHeight : number; });
}

ReadRow linear(ReadRow rows, int columns, double factor, double offset) {
    return
        [rows = std::move(rows), columns, factor, offset](int row, RowRoom& room, double* numbers) {
            rows(row, room, numbers);
            for (int i = 0; i < columns; ++i) {
                numbers[i] = factor * numbers[i] + offset;
            }
        };
}

constexpr const char* kGiven = "given by the user";

std::string sizeText(double x, double y) { return formatSi(x, "m") + " x " + formatSi(y, "m"); }

void applySize(ScanChannel& channel, const GivenScale& given) {
    HeightMap& map = channel.map;
    std::string note = "size " + sizeText(given.sizeX, given.sizeY) + " as given";
    if (channel.hasSize()) {
        note +=
            "; that of the file is " + sizeText(map.pitchX * map.columns, map.pitchY * map.rows);
    }
    std::erase(channel.notes, kNoSizeNote);
    map.pitchX = pixelPitch(given.sizeX, map.columns);
    map.pitchY = pixelPitch(given.sizeY, map.rows);
    channel.lateralUnit = "m";
    channel.notes.push_back(note);
    if (std::abs(map.pitchX - map.pitchY) > 1e-3 * map.pitchX) {
        channel.notes.push_back("its pixels are not square: " + sizeText(map.pitchX, map.pitchY));
    }
    std::erase_if(channel.provenance,
                  [](const Provenance& entry) { return entry.what == "lateral size"; });
    channel.provenance.push_back(
        {"lateral size", exactText(given.sizeX) + " x " + exactText(given.sizeY) + " m", kGiven});
}

void applyHeight(StoredChannel& stored, const GivenScale& given) {
    ScanChannel& channel = stored.channel;
    const std::string factor = exactText(given.heightPerValue);
    channel.notes.push_back("numbers taken as heights of " + factor + " m each as given");
    channel.provenance.push_back(scaleProvenance(given.heightPerValue, "m", kGiven));
    channel.unit = "m";
    stored.factor *= given.heightPerValue;
}

/// With the options and the keys of a scene that say it.
std::string missingText(const ScaleGap& gap) {
    const std::string size = "the size of the scan (set it by --size, or size_x_m and size_y_m in "
                             "a scene)";
    const std::string height = "the unit of its values (set it by --z-unit and --z-scale, or "
                               "z_scale_m in a scene)";
    const std::string isMask =
        gap.mask ? "this is a mask, not heights (use it as material_mask of a scene); " : "";
    if (gap.size && gap.height) {
        return isMask + "the file holds neither " + size + " nor " + height;
    }
    return isMask + "the file does not hold " + (gap.size ? size : height);
}

}  // namespace

ImageScale gwyScale(const ImageTexts& texts, SampleType type, const std::string& file,
                    const std::string& source) {
    const GwyTexts gwy(texts, file);
    ImageScale scale;
    scale.title = gwy.text("Title");
    takeLateral(scale, gwy, source);
    takeNoData(scale, texts, file, source);
    const PhysicalUnit vertical = parseUnit(gwy.text("ZUnit"));
    if (isFloat(type)) {
        scale.unit = vertical.base;
        scale.factor = vertical.factor * (gwy.has("ZScale") ? gwy.number("ZScale") : 1.0);
        if (gwy.has("ZScale") || gwy.has("ZUnit")) {
            scale.provenance.push_back(
                scaleProvenance(scale.factor, scale.unit, source + " Gwy::ZScale, Gwy::ZUnit"));
        }
    } else if (gwy.has("ZMin") && gwy.has("ZMax")) {
        scale.unit = vertical.base;
        setEnds(scale, type, gwy.number("ZMin") * vertical.factor,
                gwy.number("ZMax") * vertical.factor, source + " Gwy::ZMin, Gwy::ZMax");
    }
    return scale;
}

void setEnds(ImageScale& scale, SampleType type, double lowest, double highest,
             const std::string& source) {
    const SampleEnds ends = endsOf(type);
    scale.factor = (highest - lowest) / (ends.highest - ends.lowest);
    scale.offset = lowest - scale.factor * ends.lowest;
    scale.provenance.push_back({"scale",
                                exactText(lowest) + " to " + exactText(highest) + " " + scale.unit +
                                    " for the smallest and the largest count",
                                source});
}

void invert(ImageScale& scale, SampleType type) {
    if (isFloat(type)) {
        return;
    }
    const SampleEnds ends = endsOf(type);
    scale.offset += scale.factor * (ends.lowest + ends.highest);
    scale.factor = -scale.factor;
    scale.provenance.push_back({"inversion", "the largest count is the lowest", "white is zero"});
}

StoredChannel scaledChannel(const ImageScale& scale, ImageSize size, ReadRow rows,
                            const std::string& name, const std::string& file) {
    StoredChannel stored{.channel = {}, .readRow = std::move(rows)};
    ScanChannel& channel = stored.channel;
    channel.name = scale.title.empty() ? name : scale.title;
    channel.unit = scale.unit;
    channel.lateralUnit = scale.lateralUnit;
    channel.direction = directionFromName(channel.name);
    channel.map = emptyMap(size, scale.sizeX, scale.sizeY);
    setOrigin(channel, scale.originX, scale.originY, GivenPoint::Corner);
    channel.notes = scale.notes;
    channel.provenance = scale.provenance;
    if (channel.unit.empty()) {
        channel.notes.emplace_back("the file gives no unit of the values; they are numbers");
    }
    settleSize(channel, scale.sizeSource);
    if (scale.noData) {
        stored.readRow = withoutCount(std::move(stored.readRow), size.columns, *scale.noData);
    }
    setScale(stored, scale.factor, scale.offset, file);
    return stored;
}

void setScale(StoredChannel& stored, double factor, double offset, const std::string& file) {
    constexpr double kMax = 1e100;
    const bool good = std::abs(factor) <= kMax && std::abs(offset) <= kMax;
    if (!good) {
        throw InputError(file, "channel '" + stored.channel.name + "'",
                         "its scale is " + exactText(factor) + " with an offset of " +
                             exactText(offset) + "; the file is damaged");
    }
    if (offset == 0.0) {
        stored.factor = factor;
        return;
    }
    stored.factor = 1.0;
    stored.readRow = linear(std::move(stored.readRow), stored.channel.map.columns, factor, offset);
}

void applyScale(StoredScan& scan, const GivenScale& given, const std::string& file) {
    const bool hasNumbers = std::ranges::any_of(
        scan.channels, [](const StoredChannel& each) { return each.channel.unit.empty(); });
    if (given.hasHeight() && !hasNumbers) {
        throw InputError(file, "",
                         "its values have units; --z-unit, --z-scale and z_scale_m are for values "
                         "without one");
    }
    for (StoredChannel& stored : scan.channels) {
        if (given.hasSize()) {
            applySize(stored.channel, given);
        }
        if (given.hasHeight() && stored.channel.unit.empty()) {
            applyHeight(stored, given);
        }
    }
}

MissingScale::MissingScale(const std::filesystem::path& path, const ScaleGap& gap)
    : InputError(path.string(), "channel '" + gap.channel + "'", missingText(gap))
    , path_(path)
    , gap_(gap) {}

void requireScale(const ScanChannel& channel, const std::filesystem::path& path) {
    const ScaleGap gap{.channel = channel.name,
                       .columns = channel.map.columns,
                       .rows = channel.map.rows,
                       .size = !channel.hasSize(),
                       .height = channel.unit.empty(),
                       .mask = channel.unit.empty() && channel.isMask};
    if (gap.size || gap.height) {
        throw MissingScale(path, gap);
    }
}

}  // namespace asperity
