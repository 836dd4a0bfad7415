#include "core/deformation/HalfSpaceField.h"

#include "core/surface/HeightMap.h"
#include "core/surface/TangentFrame.h"
#include "core/surface/fit/BSplineFit.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

/// The grid as an image: its top row is the last one.
HeightMap imageOf(const std::vector<double>& displacement, int samples, double pitch) {
    HeightMap map{.columns = samples,
                  .rows = samples,
                  .pitchX = pitch,
                  .pitchY = pitch,
                  .heights = {},
                  .invalid = {}};
    map.heights.reserve(displacement.size());
    for (int row = samples - 1; row >= 0; --row) {
        const auto first = displacement.begin() + static_cast<std::ptrdiff_t>(row) * samples;
        map.heights.insert(map.heights.end(), first, first + samples);
    }
    return map;
}

}  // namespace

HalfSpaceField::HalfSpaceField(const std::vector<double>& displacement, int samples, double pitch)
    : halfWidth_(0.5 * (samples - 1) * pitch)
    , middle_(0.5 * samples * pitch)
    , displacement_(fitSurface(imageOf(displacement, samples, pitch))) {}

double HalfSpaceField::at(double along, double across) const {
    const double reach = std::max(std::abs(along), std::abs(across));
    const double inside = reach > halfWidth_ ? halfWidth_ / reach : 1.0;
    return inside * displacement_.at(middle_ + inside * along, middle_ + inside * across).height;
}

DisplacementField halfSpaceField(const TipContact& contact,
                                 std::shared_ptr<const HalfSpaceField> field, double share) {
    return [frame = tangentFrame(contact.closest, contact.normal), field = std::move(field),
            share](const Vector3& rest) -> Vector3 {
        const Vector3 place = frame.local(rest);
        return -share * field->at(place.x(), place.y()) * frame.normal;
    };
}

}  // namespace asperity
