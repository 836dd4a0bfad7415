#include "core/io/scene/CropKeys.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace asperity {

namespace {

constexpr const char* kCrop = "crop_px";

}  // namespace

std::optional<PixelRectangle> readCrop(TomlSection& section) {
    if (!section.has(kCrop)) {
        return std::nullopt;
    }
    constexpr std::size_t kNumbers = 4;
    const std::vector<std::int64_t> given = section.integers(kCrop);
    const auto isPixel = [](std::int64_t number) {
        return number >= 0 && number <= std::numeric_limits<int>::max();
    };
    if (given.size() != kNumbers || !std::ranges::all_of(given, isPixel) || given[2] == 0 ||
        given[3] == 0) {
        section.refuse(kCrop,
                       "[column, row, columns, rows]: the first from 0 at the upper left, and how "
                       "many of each");
    }
    return PixelRectangle{.column = static_cast<int>(given[0]),
                          .row = static_cast<int>(given[1]),
                          .columns = static_cast<int>(given[2]),
                          .rows = static_cast<int>(given[3])};
}

void insertCrop(const std::optional<PixelRectangle>& crop, toml::table& sample) {
    if (crop) {
        sample.insert(kCrop, toml::array{crop->column, crop->row, crop->columns, crop->rows});
    }
}

}  // namespace asperity
