#include "ui/panels/ReliefImage.h"

#include "ui/Theme.h"
#include "ui/panels/HeightColors.h"
#include "vtkplugins/pictures/Palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace asperity {

namespace {

constexpr int kMaxSide = 512;        ///< [pixel]
constexpr int kColors = 256;         ///< of the table that stands for the scale
constexpr double kShownSlope = 0.5;  ///< slopes are scaled until this is their root mean square
constexpr double kShadeStrength = 0.55;

struct Samples {
    int columns = 0;
    int rows = 0;
    std::vector<HeightSample> values;    ///< top row first
    std::vector<std::uint8_t> measured;  ///< whether the scan holds data there
};

Samples sampled(const BSplineSurface& surface) {
    const double longer = std::max(surface.sizeX(), surface.sizeY());
    const auto pixels = [longer](double size) {
        return std::clamp(static_cast<int>(std::lround(kMaxSide * size / longer)), 1, kMaxSide);
    };
    Samples samples{.columns = pixels(surface.sizeX()), .rows = pixels(surface.sizeY())};
    samples.values.reserve(static_cast<std::size_t>(samples.columns) *
                           static_cast<std::size_t>(samples.rows));
    for (int row = 0; row < samples.rows; ++row) {
        const double y = surface.sizeY() * (samples.rows - row - 0.5) / samples.rows;
        for (int column = 0; column < samples.columns; ++column) {
            const double x = surface.sizeX() * (column + 0.5) / samples.columns;
            samples.values.push_back(surface.at(x, y));
            samples.measured.push_back(surface.isMeasured(x, y) ? 1 : 0);
        }
    }
    return samples;
}

/// Factor for slopes that makes flat and steep scans alike show their shape.
double slopeScale(const Samples& samples) {
    double squares = 0.0;
    for (const HeightSample& sample : samples.values) {
        squares += (sample.dx * sample.dx) + (sample.dy * sample.dy);
    }
    const double slope = std::sqrt(squares / static_cast<double>(samples.values.size()));
    return slope > 0.0 ? kShownSlope / slope : 0.0;
}

/// Brightness, 1 for level ground. The light comes from the upper left, 45 degrees high.
double shade(const HeightSample& sample, double scale) {
    const double dx = scale * sample.dx;
    const double dy = scale * sample.dy;
    const double towardsLight = ((dx - dy) / std::sqrt(2.0)) + 1.0;
    const double light = towardsLight / std::sqrt(1.0 + (dx * dx) + (dy * dy));
    return std::clamp(1.0 + (kShadeStrength * (light - 1.0)), 0.35, 1.4);
}

std::array<QColor, kColors> colorTable(const ColorScale& scale) {
    std::array<QColor, kColors> table;
    for (int i = 0; i < kColors; ++i) {
        table.at(static_cast<std::size_t>(i)) =
            colorAt(scale, std::lerp(scale.low, scale.high, i / (kColors - 1.0)));
    }
    return table;
}

}  // namespace

QColor hatched(int row, int column) {
    constexpr int kStripe = 5;  // [pixel]
    const QColor gray = toQColor(palette::kNoData);
    return ((row + column) / kStripe) % 2 == 0 ? gray : gray.lighter(140);
}

namespace {

QRgb shaded(const QColor& color, double brightness) {
    const auto part = [brightness](int channel) {
        return std::min(255, static_cast<int>(std::lround(channel * brightness)));
    };
    return qRgb(part(color.red()), part(color.green()), part(color.blue()));
}

ColorScale colorsOf(const Samples& samples) {
    const auto [low, high] = std::minmax_element(
        samples.values.begin(), samples.values.end(),
        [](const HeightSample& a, const HeightSample& b) { return a.height < b.height; });
    return heightColors(low->height, high->height);
}

}  // namespace

ReliefImage reliefImage(const BSplineSurface& surface) {
    const Samples samples = sampled(surface);
    ReliefImage relief{
        QImage(samples.columns, samples.rows, QImage::Format_RGB32), {}, colorsOf(samples), false};
    relief.heights.reserve(samples.values.size());
    const std::array<QColor, kColors> table = colorTable(relief.colors);
    const double extent = relief.colors.high - relief.colors.low;
    const double scale = slopeScale(samples);
    std::size_t next = 0;
    for (int row = 0; row < samples.rows; ++row) {
        auto* line = reinterpret_cast<QRgb*>(relief.image.scanLine(row));
        for (int column = 0; column < samples.columns; ++column, ++next) {
            const HeightSample& sample = samples.values[next];
            const double share = extent > 0.0 ? (sample.height - relief.colors.low) / extent : 0.5;
            const auto entry = static_cast<std::size_t>(std::lround(share * (kColors - 1)));
            relief.heights.push_back(sample.height);
            const bool measured = samples.measured[next] != 0;
            relief.hasFilled = relief.hasFilled || !measured;
            line[column] =
                shaded(measured ? table.at(entry) : hatched(row, column), shade(sample, scale));
        }
    }
    return relief;
}

}  // namespace asperity
