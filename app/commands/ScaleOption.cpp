#include "app/commands/ScaleOption.h"

#include "core/io/TextValue.h"
#include "core/io/heightmap/PhysicalUnit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <sstream>
#include <utility>

namespace asperity {

namespace {

bool isPositive(double value) { return value > 0.0 && std::isfinite(value); }

std::optional<double> unitLength(const std::string& text) {
    const PhysicalUnit unit = parseUnit(text);
    return unit.base == "m" ? std::optional(unit.factor) : std::nullopt;
}

/// "5x2um" as "5um" and "2um".
std::pair<std::string, std::string> sidesOf(const std::string& text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string::npos) {
        return {text, text};
    }
    std::string first = text.substr(0, cross);
    std::string second = text.substr(cross + 1);
    const std::optional<LeadingNumber> one = parseLeadingNumber(first);
    const std::optional<LeadingNumber> other = parseLeadingNumber(second);
    if (one && one->rest.empty() && other) {
        first += other->rest;
    } else if (one && other && other->rest.empty()) {
        second.clear();  // "5umx2": of micrometers or of meters?
    }
    return {first, second};
}

/// Height of a value of 1: the number times the unit, either of them 1 unless given.
struct HeightOptions {
    double number = 1.0;
    double unit = 1.0;
};

/// Refuses what is no such value, in words. @param isOne of a text
CLI::Validator expects(const char* expected, bool (*isOne)(const std::string&), const char* name) {
    return {[=](const std::string& text) {
                return isOne(text) ? std::string()
                                   : "expected " + std::string(expected) + ", not '" + text + "'";
            },
            name};
}

void addSizeOption(CLI::App& command, GivenScale& scale) {
    const auto take = [&scale](const std::string& text) {
        const GivenScale size = parseScanSize(text).value_or(GivenScale{});
        scale.sizeX = size.sizeX;
        scale.sizeY = size.sizeY;
    };
    command
        .add_option_function<std::string>(
            "--size", take,
            "size of the scan where the file does not say it: 5umx2um, or 5um of a square")
        ->check(expects(
            "a size such as 5um or 5umx2um",
            [](const std::string& text) { return parseScanSize(text).has_value(); }, "X[xY]"));
}

void addHeightOptions(CLI::App& command, GivenScale& scale) {
    const auto height = std::make_shared<HeightOptions>();
    const auto take = [height, &scale] {
        scale.heightPerValue = inMeters(height->number, height->unit);
        if (!isPositive(scale.heightPerValue)) {
            throw CLI::ValidationError("--z-scale", "--z-scale times --z-unit is no length");
        }
    };
    const auto takeUnit = [=](const std::string& text) {
        height->unit = unitLength(text).value_or(1.0);
        take();
    };
    const auto takeNumber = [=](const double& number) {
        height->number = number;
        take();
    };
    command
        .add_option_function<std::string>("--z-unit", takeUnit,
                                          "unit of the heights where the file does not say it: nm")
        ->check(expects(
            "a unit of length such as nm",
            [](const std::string& text) { return unitLength(text).has_value(); }, "UNIT"));
    command
        .add_option_function<double>("--z-scale", takeNumber,
                                     "height of a value of 1 in --z-unit, or in meters")
        ->check(expects(
            "a number above 0",
            [](const std::string& text) { return isPositive(parseNumber(text).value_or(0.0)); },
            "NUMBER"));
}

}  // namespace

std::optional<double> parseLength(const std::string& text) {
    const std::optional<LeadingNumber> number = parseLeadingNumber(text);
    if (!number) {
        return std::nullopt;
    }
    const std::optional<double> unit =
        number->rest.empty() ? 1.0 : unitLength(std::string(number->rest));
    const double length = unit ? inMeters(number->value, *unit) : 0.0;
    return isPositive(length) ? std::optional(length) : std::nullopt;
}

std::optional<GivenScale> parseScanSize(const std::string& text) {
    const auto [first, second] = sidesOf(text);
    const std::optional<double> x = parseLength(first);
    const std::optional<double> y = parseLength(second);
    return x && y ? std::optional(GivenScale{.sizeX = *x, .sizeY = *y}) : std::nullopt;
}

void addScaleOptions(CLI::App& command, GivenScale& scale) {
    addSizeOption(command, scale);
    addHeightOptions(command, scale);
}

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
