#pragma once

#include "core/io/tables/CsvWriter.h"
#include "core/surface/measure/Profile.h"
#include "core/surface/measure/Roughness.h"
#include "core/surface/measure/Texture.h"

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
    Texture texture;
    std::optional<MeasuredProfile> profile;
};

/// Prints the measures for people.
void printMeasures(std::ostream& out, const MeasuredMap& measured);

/// SI values in full precision.
[[nodiscard]] std::string measuresJson(const MeasuredMap& measured);

/// Writes the roughness of many files as a table, a row each, with SI values in full precision. A
/// cell is empty where a number does not exist.
class RoughnessTable {
public:
    /// @param out outlives the table
    explicit RoughnessTable(std::ostream& out);

    /// @param file as the user gave it; the cells are of the rectangle that was measured
    void add(const std::string& file, const MeasuredMap& measured);
    /// Writes the row of a file that could not be measured: its name alone.
    void addUnmeasured(const std::string& file);
    /// @throw Error when not all could be written
    void close() { csv_.close(); }

private:
    CsvWriter csv_;
};

/// The samples of a profile as a table.
void writeProfile(std::ostream& out, const MeasuredMap& measured, const Profile& profile);

}  // namespace asperity
