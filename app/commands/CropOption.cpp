#include "app/commands/CropOption.h"

#include "core/io/TextValue.h"

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>

namespace asperity {

std::optional<PixelRectangle> parseCrop(const std::string& text) {
    std::array<int, 4> numbers{};
    std::istringstream parts(text);
    std::string part;
    for (int& number : numbers) {
        std::getline(parts, part, ',');
        const std::optional<long long> given = parts ? parseInteger(part) : std::nullopt;
        if (!given || *given < 0 || *given > std::numeric_limits<int>::max()) {
            return std::nullopt;
        }
        number = static_cast<int>(*given);
    }
    const PixelRectangle crop{numbers[0], numbers[1], numbers[2], numbers[3]};
    const bool isWhole = std::count(text.begin(), text.end(), ',') == 3;
    return isWhole && crop.columns > 0 && crop.rows > 0 ? std::optional(crop) : std::nullopt;
}

void addCropOption(CLI::App& command, std::optional<PixelRectangle>& crop) {
    command
        .add_option_function<std::string>(
            "--crop", [&crop](const std::string& text) { crop = parseCrop(text); },
            "part of the height map to load, in pixels: first column, first row (0,0: upper "
            "left), columns, rows")
        ->check(CLI::Validator(
            [](const std::string& text) {
                return parseCrop(text) ? std::string()
                                       : "expected COLUMN,ROW,COLUMNS,ROWS such as 20,30,100,80, "
                                         "not '" +
                                             text + "'";
            },
            "C,R,W,H"));
}

}  // namespace asperity
