#pragma once

#include "app/maps/ComparedMap.h"
#include "app/maps/MapPart.h"
#include "app/program/LoadedScene.h"
#include "core/Progress.h"
#include "core/map/MapPlan.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// SHA-256 of all that the values of a map depend on: the program's version and commit, the scan's
/// content, the scene with the model that it is computed with, and the plan; 64 hexadecimal digits.
[[nodiscard]] std::string mapKey(const LoadedScene& loaded, const MapPlan& plan);

/// The files of a map, all beside its .gwy.
class MapFiles {
public:
    /// @param gwy the file that a user names
    explicit MapFiles(std::filesystem::path gwy) : gwy_(std::move(gwy)) {}

    [[nodiscard]] const std::filesystem::path& gwy() const { return gwy_; }
    [[nodiscard]] std::filesystem::path vti() const { return beside(".vti"); }
    [[nodiscard]] std::filesystem::path exr() const { return beside(".exr"); }
    /// A sheet of pictures, from 1.
    [[nodiscard]] std::filesystem::path sheet(int number) const {
        return beside("_" + std::to_string(number) + ".png");
    }
    /// Numbers of a comparison with measured maps.
    [[nodiscard]] std::filesystem::path comparison() const { return beside(".compare.json"); }
    /// The sheet of a compared channel, from 1.
    [[nodiscard]] std::filesystem::path comparisonSheet(int number) const {
        return beside("_compare_" + std::to_string(number) + ".png");
    }
    [[nodiscard]] std::filesystem::path part() const { return gwy_.string() + ".part"; }

private:
    [[nodiscard]] std::filesystem::path beside(const std::string& end) const {
        return (gwy_.parent_path() / gwy_.stem()).string() + end;
    }

    std::filesystem::path gwy_;
};

/// Returns whether the .gwy of a map stays below its 4 GiB.
/// @param compared channels that it is compared with: each adds two
[[nodiscard]] bool mapFits(const MapPlan& plan, std::size_t compared = 0);

/// Refuses a map that its files cannot hold, before long work is done for it.
/// @param compared as in mapFits() @throw Error unless it does
void requireMapFits(const MapPlan& plan, std::size_t compared = 0);

/// Returns whether the .gwy in place is the result of this map, by the key that it carries; false
/// where it cannot be read.
[[nodiscard]] bool holdsMap(const MapFiles& files, const LoadedScene& loaded, const MapPlan& plan);

/// Writes every quantity as a channel with its unit to .gwy, .vti and .exr, one row after the other
/// from the part, and difference and residual of each comparison; each file whole or not at all,
/// the .gwy last. Rows that the part lacks hold no data.
/// @param progress may be null @throw Error; Canceled
void writeMapFiles(const MapFiles& files, const LoadedScene& loaded, const MapPlan& plan,
                   const MapPart& part, Progress* progress,
                   std::span<const ComparedMap> compared = {});

/// Returns in how many of the computed pixels a standard deviation is not known, and why, in one
/// sentence: a blank is no deviation of 0. Empty where all are known, or the quantity is none.
/// @param index of the quantity in the plan  @throw Error as MapPart::read()
[[nodiscard]] std::string unknownDeviations(const MapPlan& plan, const MapPart& part,
                                            std::size_t index);

/// The same of all standard deviations of a map, each with its name.
[[nodiscard]] std::vector<std::string> unknownDeviations(const MapPlan& plan, const MapPart& part);

}  // namespace asperity
