#include "core/io/heightmap/ScanOrigin.h"

#include "core/io/TextValue.h"
#include "core/io/heightmap/ScanImage.h"

#include <algorithm>
#include <cmath>

namespace asperity {

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
