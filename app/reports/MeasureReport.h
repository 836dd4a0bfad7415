#pragma once

#include "core/io/tables/CsvWriter.h"
#include "core/surface/measure/PowerSpectrum.h"
#include "core/surface/measure/Profile.h"
#include "core/surface/measure/Roughness.h"
#include "core/surface/measure/Texture.h"

#include <filesystem>
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
    std::optional<PowerSpectrum> spectrum;  ///< if it was asked for
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
    /// Into a file. @param comments one line each @throw Error
    RoughnessTable(const std::filesystem::path& file, const std::vector<std::string>& comments);

    /// @param file as the user gave it; the cells are of the rectangle that was measured
    void add(const std::string& file, const MeasuredMap& measured);
    /// Writes the row of a file that could not be measured: its name alone.
    void addUnmeasured(const std::string& file);
    /// @throw Error when not all could be written
    void close() { csv_.close(); }

private:
    CsvWriter csv_;
};

/// Returns the comments of a table. @param what it has
[[nodiscard]] std::vector<std::string> provenanceOf(const MeasuredMap& measured,
                                                    const std::string& what);

/// The samples of a profile as a table.
void writeProfile(std::ostream& out, const MeasuredMap& measured, const Profile& profile);

// Tables in files: SI units, as each column's name ends, to 17 digits; whole or not at all.
// @param comments one line each, of where the heights come from. @throw Error

/// A profile with its name, as a table and a plot state it.
struct NamedProfile {
    std::string name;
    Profile profile;
};

/// The samples of profiles, one profile after the other.
void writeProfiles(const std::filesystem::path& file, std::vector<std::string> comments,
                   const std::vector<NamedProfile>& profiles);

/// A row a bin: middle, count, share of the area in it and share of the area above its lower edge
/// (ISO 25178-2, areal material ratio).
void writeHistogram(const std::filesystem::path& file, std::vector<std::string> comments,
                    const HeightHistogram& histogram);

/// A row a ring of waves.
void writeSpectrum(const std::filesystem::path& file, std::vector<std::string> comments,
                   const PowerSpectrum& spectrum);

}  // namespace asperity
