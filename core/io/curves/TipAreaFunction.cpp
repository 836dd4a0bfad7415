#include "core/io/curves/TipAreaFunction.h"

#include "core/io/FileBytes.h"
#include "core/io/TextLines.h"
#include "core/io/TextValue.h"
#include "core/io/curves/CurveColumns.h"
#include "core/io/heightmap/PhysicalUnit.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace asperity {

namespace {

/// Factors of both columns to SI.
struct AreaUnits {
    double depth = 1e-9;
    double area = 1e-18;
};

/// The text in the last brackets of a title; empty: there are none.
std::string unitIn(const std::string& title) {
    const std::size_t open = title.find_last_of("([");
    const std::size_t close = title.find_last_of(")]");
    return open == std::string::npos || close == std::string::npos || close < open
               ? std::string()
               : std::string(trimmed(std::string_view(title).substr(open + 1, close - open - 1)));
}

/// Units of a line "depth (nm), area (nm^2)"; empty: it is no such line.
std::optional<AreaUnits> unitsOf(const std::vector<std::string>& titles) {
    if (titles.size() < 2) {
        return std::nullopt;
    }
    const PhysicalUnit depth = parseUnit(toUtf8(unitIn(titles[0])));
    std::string square = toUtf8(unitIn(titles[1]));
    for (const std::string_view power : {"^2", "2", "\u00B2"}) {
        if (square.ends_with(power)) {
            square.resize(square.size() - power.size());
            break;
        }
    }
    const PhysicalUnit side = parseUnit(square);
    if (depth.base != "m" || side.base != "m") {
        return std::nullopt;
    }
    return AreaUnits{depth.factor, side.factor * side.factor};
}

class AreaReader {
public:
    explicit AreaReader(TextLines& lines) : lines_(lines) {}

    void take(std::string_view line) {
        const std::vector<std::string> cells = curveCells(line, {1, 2});
        if (!cells.empty()) {
            add(cells);
        } else if (const auto units = unitsOf(curveCells(line)); units && function_.depth.empty()) {
            units_ = *units;
        } else {
            lines_.fail("expected two numbers, contact depth and area");
        }
    }

    [[nodiscard]] TipAreaFunction finish() {
        if (function_.depth.size() < 2) {
            lines_.fail("an area function needs two points or more");
        }
        return std::move(function_);
    }

private:
    void add(const std::vector<std::string>& cells) {
        constexpr std::size_t kMaxPoints = 1'000'000;
        const double depth = units_.depth * cellNumber(cells[0]).value_or(NAN);
        const double area = units_.area * cellNumber(cells[1]).value_or(NAN);
        if (!std::isfinite(depth) || !std::isfinite(area) || depth < 0.0 || area < 0.0) {
            lines_.fail("expected a depth and an area of 0 or more");
        }
        if (!function_.depth.empty() &&
            (!(depth > function_.depth.back()) || area < function_.area.back())) {
            lines_.fail("the depth must rise from line to line, and the area must not fall");
        }
        if (function_.depth.size() == kMaxPoints) {
            lines_.fail("more points than an area function has");
        }
        function_.depth.push_back(depth);
        function_.area.push_back(area);
    }

    TextLines& lines_;
    AreaUnits units_;
    TipAreaFunction function_;
};

}  // namespace

TipAreaFunction readTipAreaFunction(const std::filesystem::path& path) {
    const BufferedFile file(path);
    TextLines lines(file);
    AreaReader reader(lines);
    while (const std::optional<std::string_view> line = lines.next()) {
        const std::string_view text = trimmed(*line);
        if (!text.empty() && !text.starts_with('#')) {
            reader.take(text);
        }
    }
    return reader.finish();
}

}  // namespace asperity
