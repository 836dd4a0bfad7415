#pragma once

#include "app/program/LoadedScene.h"
#include "core/GrowingFile.h"
#include "core/TemporaryFile.h"
#include "core/map/MapPlan.h"
#include "core/surface/PixelField.h"

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// Treatment of a part file that is there.
enum class PartUse : std::uint8_t {
    New,     ///< it is refused
    Resume,  ///< its rows are kept
    Replace  ///< it is deleted
};

/// @throw Error where there is a part of an unfinished map, which says how to continue it
void requireNoPart(const std::filesystem::path& path);

/// The rows of a map that are finished, in a file beside the map, which grows by a record each:
/// whatever ends the program, they are there. Rows stay in the file, not in memory.
class MapPart {
public:
    /// @param key of the map, see mapKey()
    /// @throw Error where there is a part and it is not to be used, or it is of another map, or
    /// another process writes it; FileError
    MapPart(std::filesystem::path path, const MapPlan& plan, const std::string& key, PartUse use);

    [[nodiscard]] bool has(int row) const { return starts_[index(row)] != kNone; }
    /// Rows that are there.
    [[nodiscard]] int count() const;
    [[nodiscard]] int rows() const { return static_cast<int>(starts_.size()); }

    /// Keeps the values of a row, as mapRow() gives them; any threads. @throw Error
    void keep(int row, const std::vector<double>& values);

    /// Writes the values of one quantity in a row, by its index in the plan; NaN where the row is
    /// not there. Not while rows are kept. @throw Error
    void read(int row, std::size_t quantity, double* values) const;

    /// The map is complete.
    void remove() const;

private:
    static constexpr std::uint64_t kNone = 0;  ///< there the head is

    [[nodiscard]] static std::size_t index(int row) { return static_cast<std::size_t>(row); }
    [[nodiscard]] std::uint64_t recordBytes() const;
    /// Notes the rows of a file. @return how much of it is whole records [bytes]
    [[nodiscard]] std::uint64_t takeRecords(const std::string& head);
    void open(const std::string& head, PartUse use);

    std::filesystem::path path_;
    std::size_t columns_;
    std::size_t quantities_;
    std::vector<std::uint64_t> starts_;  ///< of each row's values in the file [bytes]
    std::mutex mutex_;
    std::uint64_t size_ = 0;  ///< [bytes]
    std::optional<GrowingFile> file_;
    FileDescriptor reading_{-1};
};

/// A map with the scene that it is of. Its rows are in a temporary file, deleted with it.
class HeldMap {
public:
    /// @throw Error where the temporary file cannot be made
    HeldMap(LoadedScene loaded, const MapPlan& plan);

    [[nodiscard]] const LoadedScene& loaded() const { return loaded_; }
    [[nodiscard]] const MapPlan& plan() const { return plan_; }
    [[nodiscard]] MapPart& part() { return part_; }
    [[nodiscard]] const MapPart& part() const { return part_; }

    // Not while rows are computed.

    /// A quantity of the plan over the region; not a number where a pixel has no value, or its row
    /// is not there. @throw Error
    [[nodiscard]] RegionField field(MapQuantity quantity) const;
    /// Returns the values of a pixel, row 0 at the top; not a number as in field(). @throw Error
    [[nodiscard]] MapValues valuesAt(int row, int column) const;

private:
    PrivateFolder folder_;
    LoadedScene loaded_;
    MapPlan plan_;
    MapPart part_;
};

}  // namespace asperity
