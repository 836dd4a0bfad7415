#include "core/io/scene/DevicePathFile.h"

#include "core/Error.h"

#include <cmath>
#include <string>

namespace asperity {

namespace {

/// @param prefix of the columns of the position: "" or "base_"
DevicePath readPath(const CsvTable& table, const std::string& prefix) {
    const std::string& path = table.file();
    if (table.rows() == 0) {
        throw InputError(path, "", "holds no row of a path");
    }
    DevicePath points(table.rows());
    for (std::size_t row = 0; row < points.size(); ++row) {
        points[row] = {table.number(row, "time_s"),
                       {table.number(row, prefix + "x_m"), table.number(row, prefix + "y_m"),
                        table.number(row, prefix + "z_m")}};
        const std::string location = "line " + std::to_string(table.line(row));
        if (!points[row].position.allFinite() || !std::isfinite(points[row].time)) {
            throw InputError(path, location, "time and position must be finite numbers");
        }
        if (row > 0 ? points[row].time <= points[row - 1].time : points[row].time < 0.0) {
            throw InputError(path, location, "time_s must start at 0 or later and rise");
        }
    }
    return points;
}

}  // namespace

DevicePath readDevicePath(const std::filesystem::path& path) { return readPath(readCsv(path), ""); }

DevicePath readRecordedPath(const CsvTable& forceLog) { return readPath(forceLog, "base_"); }

}  // namespace asperity
