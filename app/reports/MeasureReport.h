#pragma once

#include "core/surface/measure/Profile.h"
#include "core/surface/measure/Roughness.h"

#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace asperity {

/// Readings of a profile.
struct MeasuredProfile {
    Profile profile;
    std::optional<PointReading> ends;     ///< from its start to its end
    std::optional<double> fittedAngle;    ///< of the line through all samples [rad]
    std::optional<StepHeight> grating;    ///< of a whole grating
    std::optional<StepHeight> twoLevels;  ///< between the stretches that were asked for
};

/// Measurements on a height map.
struct MeasuredMap {
    std::string file;
    std::string channel;
    std::string leveling;  ///< its steps
    std::vector<std::string> notes;
    int columns = 0;
    int rows = 0;
    double sizeX = 0.0;  ///< [m]
    double sizeY = 0.0;  ///< [m]
    PixelRectangle rectangle;
    Roughness roughness;
    std::optional<MeasuredProfile> profile;
};

/// Prints the measures for people.
void printMeasures(std::ostream& out, const MeasuredMap& measured);

/// SI values in full precision.
[[nodiscard]] std::string measuresJson(const MeasuredMap& measured);

/// The samples of a profile as a table.
void writeProfile(std::ostream& out, const MeasuredMap& measured, const Profile& profile);

}  // namespace asperity
