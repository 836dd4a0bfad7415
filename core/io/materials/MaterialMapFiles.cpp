#include "core/io/materials/MaterialMapFiles.h"

#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/scene/SceneFields.h"
#include "core/surface/HeightMap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <span>
#include <utility>

namespace asperity {

namespace {

constexpr double kSameSize =
    0.01;  // relative difference of lateral sizes that instruments round to

/// Possible values of a map.
struct MapQuantityRange {
    const char* name;                ///< for people
    std::vector<std::string> units;  ///< base units; empty: any
    Limits limits;                   ///< in the first unit
    std::ptrdiff_t alsoNamed = 0;    ///< number of the last units that need the channel's name
};

/// Returns the limits of the same quantity where it is the same everywhere.
Limits limitsOf(const char* key) { return sceneField(SceneGroup::Material, key).limits; }

MapQuantityRange modulusRange() {
    return {"a modulus [Pa]", {"Pa"}, limitsOf("youngs_modulus_pa")};
}
/// Stiffness has the unit N/m, too.
MapQuantityRange adhesionRange() {
    return {"a work of adhesion [J/m^2]",
            {"J/m^2", "J/m²", "N/m"},
            limitsOf("work_of_adhesion_j_m2"),
            1};
}
MapQuantityRange frictionRange() {
    return {"a coefficient of friction [no unit]", {""}, limitsOf("friction_coefficient")};
}
MapQuantityRange maskRange() { return {"a mask", {}, {0.0, 1e300, "be 0 or more"}}; }

/// Receivers of the reports on the reading of a map; either may be null.
struct MapReading {
    Progress* progress;
    std::vector<std::string>* notes;
};

/// @param isNamed a channel that nobody named may be meant by its first units only
bool hasUnit(const ScanChannel& channel, const MapQuantityRange& quantity, bool isNamed) {
    const std::vector<std::string>& units = quantity.units;
    const auto end = isNamed ? units.end() : units.begin() + std::ssize(units) - quantity.alsoNamed;
    return units.empty() || std::find(units.begin(), end, parseUnit(channel.unit).base) != end;
}

/// The channel that is asked for, or the only one that may be meant.
const ScanChannel& channelOf(const HeightMapFile& file, const MapSource& source,
                             const MapQuantityRange& quantity) {
    std::vector<const ScanChannel*> fitting;
    std::string names;
    for (const ScanChannel& channel : file.channels) {
        if (hasUnit(channel, quantity, !source.channel.empty()) &&
            (source.channel.empty() || channel.name == source.channel)) {
            fitting.push_back(&channel);
        }
        names += (names.empty() ? "'" : ", '") + channel.name + "' (" +
                 (channel.unit.empty() ? "no unit" : channel.unit) + ")";
    }
    if (fitting.empty() || (fitting.size() > 1 && source.channel.empty())) {
        const std::string wanted = source.channel.empty() ? "" : " named '" + source.channel + "'";
        throw InputError(source.file, "channel",
                         std::string("expected ") +
                             (fitting.empty() ? "a channel" : "a choice of one channel") + " of " +
                             quantity.name + wanted + "; the file has " + names);
    }
    return *fitting.front();
}

bool isNear(double size, double other) { return std::abs(size - other) <= kSameSize * other; }

/// The pixels of a map that lie over the loaded part of the scan.
PixelRectangle coveredPart(const HeightMap& map, bool hasSize, const MapArea& area,
                           const std::string& file) {
    const PixelRectangle all{0, 0, map.columns, map.rows};
    const PixelRectangle& part = area.part;
    const bool hasScansPixels = map.columns == area.columns && map.rows == area.rows;
    const bool isPart = part.columns != area.columns || part.rows != area.rows;
    if (!hasSize) {
        return isPart && hasScansPixels ? part : all;
    }
    const auto covers = [&map](double sizeX, double sizeY) {
        return isNear(map.sizeX(), sizeX) && isNear(map.sizeY(), sizeY);
    };
    const double sizeX = area.columns * area.pitchX;
    const double sizeY = area.rows * area.pitchY;
    // A part may be hardly smaller than the scan: what has the scan's pixels covers the scan.
    if (hasScansPixels && covers(sizeX, sizeY)) {
        return part;
    }
    if (covers(part.columns * area.pitchX, part.rows * area.pitchY)) {
        return all;
    }
    if (!covers(sizeX, sizeY)) {
        throw InputError(file, "",
                         formatted("expected a map of %.6g x %.6g m, the size of the scan; it is "
                                   "%.6g x %.6g m",
                                   sizeX, sizeY, map.sizeX(), map.sizeY()));
    }
    if (!hasScansPixels) {
        throw InputError(file, "",
                         formatted("expected a map of the scan's %d x %d pixels, since a part of "
                                   "it is loaded; it has %d x %d",
                                   area.columns, area.rows, map.columns, map.rows));
    }
    return part;
}

void requireRange(double value, int row, int column, const MapQuantityRange& quantity,
                  const MapSource& source) {
    if (isFiniteHeight(value) && !quantity.limits.hold(value)) {
        throw InputError(
            source.file, formatted("%s, row %d, column %d", source.channel.c_str(), row, column),
            formatted("%.6g is not %s: it must %s", value, quantity.name, quantity.limits.words));
    }
}

/// Checks the file against the hash that the description has of it, and keeps that.
void settleHash(const ScanFile& file, MapSource& source, Progress* progress) {
    std::string hash = file.sha256(progress);
    if (!source.sha256.empty() && source.sha256 != hash) {
        throw InputError(source.file, "",
                         "the map has changed since the run was recorded (its hash differs)");
    }
    source.sha256 = std::move(hash);
}

/// A map over the loaded part of the scan.
struct MapOfPart {
    HeightMap values;      ///< in SI base units, or as the file has them where any unit will do
    double highest = 0.0;  ///< in the whole file, too
    bool hasUnit = false;
};

/// With a value in each pixel.
MapOfPart readMap(MapSource& source, const MapQuantityRange& quantity, const MapArea& area,
                  MapReading& reading) {
    source.file = std::filesystem::absolute(source.file).lexically_normal().string();
    const ScanFile file(source.file);
    const ScanChannel& channel = channelOf(file.contents(), source, quantity);
    source.channel = channel.name;
    const PixelRectangle part = coveredPart(channel.map, channel.hasSize(), area, source.file);
    const double factor = quantity.units.empty() ? 1.0 : parseUnit(channel.unit).factor;
    MapOfPart read{.values = {.columns = part.columns,
                              .rows = part.rows,
                              .pitchX = area.part.columns * area.pitchX / part.columns,
                              .pitchY = area.part.rows * area.pitchY / part.rows,
                              .heights = {},
                              .invalid = {}}};
    read.hasUnit = !channel.unit.empty();
    HeightMap& map = read.values;
    map.heights.reserve(map.index(map.rows, 0));
    ProgressPart rows(reading.progress, 0.0, 0.6);
    file.forEachRow(channel, [&](int row, std::span<const double> line) {
        const bool isInPart = row >= part.row && row < part.row + part.rows;
        for (int column = 0; column < channel.map.columns; ++column) {
            const double value = factor * line[static_cast<std::size_t>(column)];
            requireRange(value, row, column, quantity, source);
            read.highest = isFiniteHeight(value) ? std::max(read.highest, value) : read.highest;
            if (isInPart && column >= part.column && column < part.column + part.columns) {
                map.heights.push_back(value);
            }
        }
        reportTo(&rows, static_cast<double>(row) / channel.map.rows);
    });
    ProgressPart hashing(reading.progress, 0.6, 1.0);
    settleHash(file, source, &hashing);
    const auto holes =
        std::ranges::count_if(map.heights, [](double value) { return !isFiniteHeight(value); });
    if (holes == std::ssize(map.heights)) {
        throw InputError(source.file, source.channel, "expected a map with data; no pixel has any");
    }
    if (holes > 0 && reading.notes != nullptr) {
        reading.notes->push_back(formatted("material: %td of %zu pixels of '%s' hold no data and "
                                           "get a blend of their surroundings",
                                           holes, map.heights.size(), source.channel.c_str()));
    }
    map = withInvalidPixelsFilled(std::move(map));
    map.invalid.clear();
    return read;
}

std::shared_ptr<const PixelField> fieldOf(const HeightMap& map, const char* unit) {
    return std::make_shared<const PixelField>(map, unit);
}

std::shared_ptr<const PixelField> readField(std::optional<MapSource>& source,
                                            const MapQuantityRange& quantity, const char* unit,
                                            const MapArea& area, MapReading reading) {
    return source ? fieldOf(readMap(*source, quantity, area, reading).values, unit) : nullptr;
}

/// Shares of the second material; a mask that has a unit, or exceeds 1, counts in shares of its
/// largest value.
HeightMap readShares(MapSource& source, const MapArea& area, MapReading reading) {
    MapOfPart mask = readMap(source, maskRange(), area, reading);
    const bool isOfShares = !mask.hasUnit && mask.highest <= 1.0;
    const double most = isOfShares || mask.highest == 0.0 ? 1.0 : mask.highest;
    for (double& value : mask.values.heights) {
        value /= most;
    }
    return std::move(mask.values);
}

MaterialMaps mixedBy(const HeightMap& shares, const MaterialMask& mask) {
    const auto between = [&shares](double zero, double one, const char* unit) {
        HeightMap mixed = shares;
        for (double& value : mixed.heights) {
            value = zero + value * (one - zero);
        }
        return fieldOf(mixed, unit);
    };
    return {.youngsModulus = between(mask.zero.youngsModulus, mask.one.youngsModulus, "Pa"),
            .workOfAdhesion = between(mask.zero.workOfAdhesion, mask.one.workOfAdhesion, "J/m^2"),
            .friction = between(mask.zero.frictionCoefficient, mask.one.frictionCoefficient, "")};
}

MaterialMaps readMaps(MaterialSources& sources, const MapArea& area, MapReading reading) {
    if (sources.mask) {
        return mixedBy(readShares(sources.mask->source, area, reading), *sources.mask);
    }
    ProgressPart first(reading.progress, 0.0, 1.0 / 3.0);
    ProgressPart second(reading.progress, 1.0 / 3.0, 2.0 / 3.0);
    ProgressPart third(reading.progress, 2.0 / 3.0, 1.0);
    const auto read = [&](std::optional<MapSource>& source, const MapQuantityRange& quantity,
                          const char* unit, Progress& part) {
        return readField(source, quantity, unit, area, {&part, reading.notes});
    };
    MaterialMaps maps;
    maps.youngsModulus = read(sources.youngsModulus, modulusRange(), "Pa", first);
    maps.workOfAdhesion = read(sources.workOfAdhesion, adhesionRange(), "J/m^2", second);
    maps.friction = read(sources.friction, frictionRange(), "", third);
    return maps;
}

}  // namespace

SceneMaps readSceneMaps(SceneDescription& description, const MapArea& area, Progress* progress,
                        std::vector<std::string>* notes) {
    MaterialSources& believed = description.sample.material.maps;
    MaterialSources& actual = description.truth.material.maps;
    const bool areSame = actual == believed;
    ProgressPart first(progress, 0.0, areSame ? 1.0 : 0.5);
    SceneMaps maps{.sample = readMaps(believed, area, {&first, notes}), .truth = {}};
    if (areSame) {
        actual = believed;
        maps.truth = maps.sample;
    } else {
        ProgressPart second(progress, 0.5, 1.0);
        maps.truth = readMaps(actual, area, {&second, notes});
    }
    return maps;
}

}  // namespace asperity
