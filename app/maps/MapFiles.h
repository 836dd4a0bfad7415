#pragma once

#include "app/maps/MapPart.h"
#include "app/program/LoadedScene.h"
#include "core/Progress.h"

#include <filesystem>
#include <vector>

namespace asperity {

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
    [[nodiscard]] std::filesystem::path part() const { return gwy_.string() + ".part"; }

private:
    [[nodiscard]] std::filesystem::path beside(const std::string& end) const {
        return (gwy_.parent_path() / gwy_.stem()).string() + end;
    }

    std::filesystem::path gwy_;
};

/// Whether the .gwy of a map stays below its 4 GiB.
[[nodiscard]] bool mapFits(const MapPlan& plan);

/// Refuses a map that its files cannot hold, before long work is done for it.
/// @throw Error unless mapFits()
void requireMapFits(const MapPlan& plan);

/// Writes every quantity as a channel with its unit to .gwy, .vti and .exr, one row after the other
/// from the part; each file whole or not at all, the .gwy last. Rows that the part lacks hold no
/// data. @param progress may be null @throw Error; Canceled
void writeMapFiles(const MapFiles& files, const LoadedScene& loaded, const MapPlan& plan,
                   const MapPart& part, Progress* progress);

}  // namespace asperity
