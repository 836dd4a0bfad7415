#include "core/io/heightmap/ScanImage.h"

#include "core/Error.h"
#include "core/io/TextValue.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace asperity {

namespace {

constexpr long long kImageMaxSide = 65536;

}  // namespace

ImageSize checkedImageSize(long long columns, long long rows, const std::string& file,
                           const std::string& location) {
    const bool good =
        columns >= 1 && rows >= 1 && columns <= kImageMaxSide && rows <= kImageMaxSide;
    if (!good) {
        throw InputError(file, location,
                         "found " + std::to_string(columns) + " x " + std::to_string(rows) +
                             " pixels; 1 to " + std::to_string(kImageMaxSide) +
                             " a side are expected");
    }
    return {static_cast<int>(columns), static_cast<int>(rows)};
}

double pixelPitch(double size, int pixels) {
    const double pitch = size / pixels;
    return std::isfinite(pitch) && pitch > 0.0 ? pitch : 0.0;
}

void requireImages(std::size_t count, const std::string& file, const std::string& location) {
    if (count > kMaxImages) {
        throw InputError(file, location,
                         "at most " + std::to_string(kMaxImages) + " images are expected, found " +
                             std::to_string(count));
    }
}

double finiteOrZero(double origin) { return std::isfinite(origin) ? origin : 0.0; }

HeightMap emptyMap(ImageSize size, double sizeX, double sizeY) {
    HeightMap map;
    map.columns = size.columns;
    map.rows = size.rows;
    map.pitchX = pixelPitch(sizeX, size.columns);
    map.pitchY = pixelPitch(sizeY, size.rows);
    return map;
}

void invalidate(HeightMap& map, std::size_t pixel) {
    if (map.invalid.empty()) {
        map.invalid.resize(map.heights.size(), false);
    }
    map.invalid[pixel] = true;
    map.heights[pixel] = std::numeric_limits<double>::quiet_NaN();
}

void invalidateNonFinite(HeightMap& map) {
    for (std::size_t i = 0; i < map.heights.size(); ++i) {
        if (!std::isfinite(map.heights[i])) {
            invalidate(map, i);
        }
    }
}

std::size_t countInvalid(const HeightMap& map) {
    return static_cast<std::size_t>(std::ranges::count(map.invalid, true));
}

void assumeMeters(ScanChannel& channel) {
    if (channel.map.pitchX > 0.0 && channel.map.pitchY > 0.0 && channel.lateralUnit.empty() &&
        channel.isHeight()) {
        channel.lateralUnit = "m";
        channel.notes.emplace_back("the lateral size has no unit; meters are assumed");
    }
}

void settleSize(ScanChannel& channel, const std::string& source) {
    const bool positive = channel.map.pitchX > 0.0 && channel.map.pitchY > 0.0;
    if (positive && channel.lateralUnit.empty() && channel.isHeight()) {
        channel.notes.emplace_back("no unit holds for both sides of the scan; their numbers are " +
                                   exactText(channel.map.sizeX()) + " and " +
                                   exactText(channel.map.sizeY()));
    }
    if (!positive || (channel.lateralUnit.empty() && channel.isHeight())) {
        channel.map.pitchX = channel.map.pitchY = 0.0;
        channel.notes.emplace_back(kNoSizeNote);
        return;
    }
    std::ostringstream size;
    size << std::setprecision(12) << channel.map.sizeX() << " x " << channel.map.sizeY() << " "
         << channel.lateralUnit;
    channel.provenance.push_back({"lateral size", size.str(), source});
}

Provenance scaleProvenance(double factor, const std::string& unit, std::string source) {
    return {"scale", exactText(factor) + (unit.empty() ? "" : " ") + unit + " per stored number",
            std::move(source)};
}

std::string directionFromName(std::string_view name) {
    const std::string lower = lowerCase(name);
    const auto says = [&lower](std::string_view word) {
        return lower.find(word) != std::string::npos;
    };
    if (says("backward") || says("retrace")) {
        return "backward";
    }
    if (says("forward") || says("trace")) {
        return "forward";
    }
    return {};
}

void setOrigin(ScanChannel& channel, double x, double y, GivenPoint point) {
    const HeightMap& map = channel.map;
    const bool hasSize = map.pitchX > 0.0 && map.pitchY > 0.0;
    if (point != GivenPoint::Corner && !hasSize) {
        return;
    }
    const double columns = point == GivenPoint::Center ? map.columns : 1;
    const double rows = point == GivenPoint::Center ? map.rows : 1;
    const bool isCorner = point == GivenPoint::Corner;
    channel.originX = finiteOrZero(x) - (isCorner ? 0.0 : 0.5 * columns * map.pitchX);
    channel.originY = finiteOrZero(y) - (isCorner ? 0.0 : 0.5 * rows * map.pitchY);
}

void noteRotation(std::vector<std::string>& notes, double degrees) {
    if (std::remainder(finiteOrZero(degrees), 360.0) == 0.0) {
        return;
    }
    const std::string note = "the scan was rotated by " + exactText(degrees) +
                             " degrees at the instrument; the image is as it was scanned, and its "
                             "origin is that without the rotation";
    if (std::ranges::count(notes, note) == 0) {
        notes.push_back(note);
    }
}

}  // namespace asperity
