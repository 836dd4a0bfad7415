#include "app/maps/ComparedMap.h"

#include "core/Error.h"
#include "core/SiFormat.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace asperity {

namespace {

/// A user's request.
struct AskedChannel {
    const ScanChannel* channel = nullptr;
    std::string key;  ///< of a quantity; empty: by unit and title
};

/// Keys of quantities that a channel may be compared with: "height, indentation".
std::string keysOf(const std::vector<MapQuantity>& quantities) {
    std::string keys;
    for (const MapQuantity quantity : quantities) {
        if (isMeasurable(quantity)) {
            keys += (keys.empty() ? "" : ", ") + std::string(keyOf(quantity));
        }
    }
    return keys;
}

/// The channels of one file, and how they fit a map.
class ChannelReader {
public:
    ChannelReader(const std::filesystem::path& path, const Scene& scene, const MapPlan& plan)
        : path_(path)
        , file_(path)
        , scan_{0.0, 0.0, scene.surface.sizeX(), scene.surface.sizeY()}
        , plan_(plan) {}

    [[nodiscard]] const ScanFile& file() const { return file_; }
    [[nodiscard]] AskedChannel find(const std::string& asked) const;
    [[nodiscard]] MeasuredChannel read(const AskedChannel& asked) const;

private:
    [[nodiscard]] bool has(const std::string& name) const {
        return std::ranges::find(file_.contents().channels, toUtf8(name), &ScanChannel::name) !=
               file_.contents().channels.end();
    }
    [[noreturn]] void refuse(const AskedChannel& asked, const std::string& what) const {
        throw InputError(path_.string(), "channel '" + asked.channel->name + "'", what);
    }
    [[nodiscard]] MapQuantity quantityOf(const AskedChannel& asked, const std::string& unit) const;
    [[nodiscard]] MapQuantity quantityByKey(const AskedChannel& asked,
                                            const std::string& unit) const;
    [[nodiscard]] MapRegion areaOf(const AskedChannel& asked) const;
    [[nodiscard]] HeightMap mapOf(const ScanChannel& channel, double factor) const;

    std::filesystem::path path_;
    ScanFile file_;
    MapRegion scan_;
    const MapPlan& plan_;
};

/// A colon may be part of a channel's name.
AskedChannel ChannelReader::find(const std::string& asked) const {
    const std::size_t colon = asked.rfind(':');
    if (!has(asked) && colon != std::string::npos && has(asked.substr(0, colon))) {
        return {&channelNamed(file_.contents(), path_, asked.substr(0, colon)),
                asked.substr(colon + 1)};
    }
    return {&channelNamed(file_.contents(), path_, asked), ""};
}

MapQuantity ChannelReader::quantityByKey(const AskedChannel& asked, const std::string& unit) const {
    const auto found = std::ranges::find_if(plan_.quantities, [&](MapQuantity quantity) {
        return isMeasurable(quantity) && asked.key == keyOf(quantity);
    });
    if (found == plan_.quantities.end()) {
        refuse(asked, "the map has no quantity '" + asked.key +
                          "' to compare it with: expected one of " + keysOf(plan_.quantities));
    }
    if (rowOf(*found)->unit != unit) {
        refuse(asked, (unit.empty() ? "it has no unit" : "it has the unit " + unit) + "; " +
                          asked.key + " has " + rowOf(*found)->unit);
    }
    return *found;
}

MapQuantity ChannelReader::quantityOf(const AskedChannel& asked, const std::string& unit) const {
    if (!asked.key.empty()) {
        return quantityByKey(asked, unit);
    }
    const std::vector<MapQuantity> like = quantitiesLike(plan_, unit, asked.channel->name);
    if (like.empty()) {
        refuse(asked, (unit.empty() ? "it has no unit" : "it has the unit " + unit) +
                          ", which no quantity of the map has: there are " +
                          keysOf(plan_.quantities));
    }
    if (like.size() > 1) {
        refuse(asked, "several quantities of the map have its unit, " + keysOf(like) +
                          ": name one after a colon, as in --channel '" + asked.channel->name +
                          ":" + keyOf(like.front()) + "'");
    }
    return like.front();
}

MapRegion ChannelReader::areaOf(const AskedChannel& asked) const {
    const ScanChannel& channel = *asked.channel;
    if (!channel.hasSize()) {
        refuse(asked, "the file gives no lateral size in meters");
    }
    const auto text = [](double width, double height) {
        return formatSi(width, "m") + " x " + formatSi(height, "m");
    };
    const std::optional<MapRegion> area =
        measuredArea(channel.map.sizeX(), channel.map.sizeY(), plan_, scan_);
    if (!area) {
        const MapRegion& region = plan_.region;
        const std::string whole = text(scan_.right, scan_.top);
        refuse(asked, "it shows " + text(channel.map.sizeX(), channel.map.sizeY()) + ", the scan " +
                          whole +
                          (region == scan_
                               ? ""
                               : " and the region " +
                                     text(region.right - region.left, region.top - region.bottom)) +
                          ": a measured map must show the same area");
    }
    return *area;
}

HeightMap ChannelReader::mapOf(const ScanChannel& channel, double factor) const {
    HeightMap map{.columns = channel.map.columns,
                  .rows = channel.map.rows,
                  .pitchX = channel.map.pitchX,
                  .pitchY = channel.map.pitchY,
                  .heights = {},
                  .invalid = {}};
    map.heights.reserve(map.index(map.rows, 0));
    file_.forEachRow(channel, [&](int /*row*/, std::span<const double> values) {
        std::ranges::transform(values, std::back_inserter(map.heights),
                               [factor](double value) { return factor * value; });
    });
    return map;
}

MeasuredChannel ChannelReader::read(const AskedChannel& asked) const {
    const ScanChannel& channel = *asked.channel;
    const PhysicalUnit unit = parseUnit(channel.unit);
    const MapQuantity quantity = quantityOf(asked, unit.base);
    const MapRegion area = areaOf(asked);
    std::vector<double> values = valuesAt(plan_, mapOf(channel, unit.factor), area);
    if (std::ranges::none_of(values, [](double value) { return std::isfinite(value); })) {
        refuse(asked, "it holds no data at the pixels of the map");
    }
    return {.name = channel.name,
            .quantity = quantity,
            .grid = {channel.map.columns, channel.map.rows},
            .values = std::move(values)};
}

}  // namespace

MeasuredFile readMeasured(const std::filesystem::path& path, const std::vector<std::string>& asked,
                          const Scene& scene, const MapPlan& plan, Progress* progress) {
    const ChannelReader reader(path, scene, plan);
    MeasuredFile file{.path = path.string(),
                      .sha256 = {},
                      .channels = {},
                      .notes = reader.file().contents().notes};
    for (const std::string& one : asked) {
        const AskedChannel found = reader.find(one);
        file.channels.push_back(reader.read(found));
        std::ranges::move(ownNotes(*found.channel), std::back_inserter(file.notes));
    }
    file.sha256 = reader.file().sha256(progress);
    return file;
}

namespace {

std::vector<double> predictedBy(const MapPlan& plan, const MapPart& part, std::size_t index) {
    const auto columns = static_cast<std::size_t>(plan.grid.columns);
    std::vector<double> values(columns * static_cast<std::size_t>(plan.grid.rows));
    for (int row = 0; row < plan.grid.rows; ++row) {
        part.read(row, index, values.data() + static_cast<std::size_t>(row) * columns);
    }
    return values;
}

/// Reads a value of measured and predicted ones, row by row.
template <class Value>
RowReader readerOf(const ComparedMap& compared, const MapPart& part, Value value) {
    return
        [&compared, rows = static_cast<std::size_t>(part.rows()), value](int row, double* values) {
            const std::vector<double>& measured = compared.values.measured;
            const std::vector<double>& predicted = compared.values.predicted;
            const std::size_t columns = measured.size() / rows;
            const std::size_t first = static_cast<std::size_t>(row) * columns;
            for (std::size_t column = 0; column < columns; ++column) {
                values[column] = value(measured[first + column], predicted[first + column]);
            }
        };
}

}  // namespace

std::vector<ComparedMap> comparedMaps(std::vector<MeasuredChannel> channels, const MapPlan& plan,
                                      const MapPart& part) {
    std::vector<ComparedMap> maps;
    for (MeasuredChannel& channel : channels) {
        const auto index = static_cast<std::size_t>(
            std::ranges::find(plan.quantities, channel.quantity) - plan.quantities.begin());
        const auto before = std::ranges::count(maps, channel.quantity, &ComparedMap::quantity);
        maps.push_back(
            {.channel = std::move(channel.name),
             .quantity = channel.quantity,
             .grid = channel.grid,
             .index = index,
             .number = static_cast<int>(before) + 1,
             .values = compareQuantity(plan, channel.quantity, predictedBy(plan, part, index),
                                       std::move(channel.values))});
    }
    return maps;
}

std::vector<ComparisonLayer> layersOf(const ComparedMap& compared, const MapPart& part) {
    const MapQuantityRow& quantity = *rowOf(compared.quantity);
    const std::string end = compared.number > 1 ? "_" + std::to_string(compared.number) : "";
    const std::string names = std::string(quantity.name) + ", '" + compared.channel + "'";
    return {{.key = std::string(quantity.key) + "_difference" + end,
             .name = names + " minus predicted",
             .readRow =
                 readerOf(compared, part,
                          [](double measured, double predicted) { return measured - predicted; })},
            {.key = std::string(quantity.key) + "_residual" + end,
             .name = names + " minus its line over the prediction",
             .readRow = readerOf(compared, part, [&compared](double measured, double predicted) {
                 return compared.values.numbers.residual(measured, predicted);
             })}};
}

}  // namespace asperity
