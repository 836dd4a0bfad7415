#pragma once

#include "core/Progress.h"
#include "core/io/heightmap/HeightMapFormat.h"

#include <algorithm>
#include <atomic>
#include <string>
#include <utility>
#include <vector>

namespace asperity {

/// The rows of a stored image as values, each of them checked: a height lies within 1 km of zero,
/// every other value within single precision. What is beyond is damage or a wrong unit, and no
/// infinity is made of it. Any threads.
class ChannelRows {
public:
    /// @param stored, bytes must outlive this
    /// @throw InputError when a pixel is smaller than 1 fm or the image larger than 1 km, or the
    ///        scale of the values is no number
    ChannelRows(const StoredChannel& stored, const ByteSource& bytes);

    /// Writes the values of a row, 0 at the top, in the channel's unit; what is not finite holds no
    /// data.
    /// @return whether there may be such pixels
    /// @throw InputError naming the pixel when a value is beyond its limit
    bool read(int row, RowRoom& room, double* values);

    /// Returns whether a pixel that was read may hold no data.
    [[nodiscard]] bool mayHaveHoles() const { return mayHaveHoles_; }
    /// To be called when all rows are read.
    /// @throw InputError when no height differs from zero in single precision though the file
    ///        says that some are none, or the content has changed
    void finish() const;

private:
    void requireScale() const;
    void requireWithin(int row, const double* values, const double* numbers) const;
    void requireNotLost() const;
    [[noreturn]] void refusePixel(int row, int column, const std::string& what) const;

    const StoredChannel& stored_;
    const ByteSource& bytes_;
    double limit_;  ///< of a value's magnitude, in the channel's unit
    std::atomic<bool> mayHaveHoles_ = false;
    std::atomic<bool> hasSize_ = false;  ///< a value that is not 0 in single precision was read
};

/// Calls visit(row, values) with each row of an image, from the top, and finishes.
/// @return whether some pixels may hold no data
/// @throw InputError; Canceled
template <class Visit>
bool forEachStoredRow(const StoredChannel& stored, const ByteSource& bytes, Progress* progress,
                      const Visit& visit) {
    constexpr int kReports = 32;
    const HeightMap& map = stored.channel.map;
    const int step = std::max(map.rows / kReports, 1);
    ChannelRows rows(stored, bytes);
    RowRoom room;
    std::vector<double> values(static_cast<std::size_t>(map.columns));
    for (int row = 0; row < map.rows; ++row) {
        if (row % step == 0) {
            reportTo(progress, static_cast<double>(row) / map.rows);
        }
        (void)rows.read(row, room, values.data());
        visit(row, std::as_const(values));
    }
    rows.finish();
    return rows.mayHaveHoles();
}

}  // namespace asperity
