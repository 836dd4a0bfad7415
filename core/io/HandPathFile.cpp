#include "core/io/HandPathFile.h"

#include "core/Error.h"
#include "core/io/CsvTable.h"

#include <cmath>
#include <string>

namespace asperity {

HandPath readHandPath(const std::filesystem::path& path) {
    const CsvTable table = readCsv(path);
    if (table.rows() == 0) {
        throw InputError(path.string(), "", "holds no row of a path");
    }
    HandPath hand(table.rows());
    for (std::size_t row = 0; row < hand.size(); ++row) {
        hand[row] = {
            table.number(row, "time_s"),
            {table.number(row, "x_m"), table.number(row, "y_m"), table.number(row, "z_m")}};
        const std::string place = "line " + std::to_string(table.line(row));
        if (!hand[row].position.allFinite() || !std::isfinite(hand[row].time)) {
            throw InputError(path.string(), place, "time and place must be finite numbers");
        }
        if (row > 0 ? hand[row].time <= hand[row - 1].time : hand[row].time < 0.0) {
            throw InputError(path.string(), place, "time_s must start at 0 or later and rise");
        }
    }
    return hand;
}

}  // namespace asperity
