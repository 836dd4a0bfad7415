#include "ui/view/ReliefImage.h"

#include "ui/widgets/Theme.h"
#include "vtkplugins/pictures/ColorMaps.h"
#include "vtkplugins/pictures/Palette.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

namespace asperity {

namespace {

constexpr int kMaxReliefSide = 512;  ///< [pixel]
constexpr double kShownSlope = 0.5;  ///< slopes are scaled until this is their root mean square
constexpr double kShadeStrength = 0.55;

/// Factor for slopes that makes flat and steep scans alike show their shape.
double slopeScale(const std::vector<Vector3>& normals) {
    double squares = 0.0;
    for (const Vector3& normal : normals) {
        squares += normal.head<2>().squaredNorm() / (normal.z() * normal.z());
    }
    const double slope = std::sqrt(squares / static_cast<double>(normals.size()));
    return slope > 0.0 ? kShownSlope / slope : 0.0;
}

/// Brightness, 1 for a level surface. The light comes from the upper left, 45 degrees high.
double shade(const Vector3& normal, double scale) {
    const double dx = -scale * normal.x() / normal.z();
    const double dy = -scale * normal.y() / normal.z();
    const double towardsLight = ((dx - dy) / std::sqrt(2.0)) + 1.0;
    const double light = towardsLight / std::sqrt(1.0 + (dx * dx) + (dy * dy));
    return std::clamp(1.0 + (kShadeStrength * (light - 1.0)), 0.35, 1.4);
}

QRgb shaded(const QColor& color, double brightness) {
    const auto part = [brightness](int channel) {
        return std::min(255, static_cast<int>(std::lround(channel * brightness)));
    };
    return qRgb(part(color.red()), part(color.green()), part(color.blue()));
}

constexpr int kMaxPictureSide = 512;  // [pixel]
constexpr double kOutliers = 0.005;   // share of the pixels at either end

/// Pixels of the picture, each with one of the map; NaN where that holds no data.
struct Sampled {
    int columns = 0;
    int rows = 0;
    std::vector<double> heights;
};

Sampled sampled(const HeightMap& map) {
    const int longer = std::max(map.columns, map.rows);
    const auto pixels = [longer](int count) {
        return longer <= kMaxPictureSide
                   ? count
                   : std::max(1, static_cast<int>(std::lround(static_cast<double>(count) *
                                                              kMaxPictureSide / longer)));
    };
    Sampled picture{.columns = pixels(map.columns), .rows = pixels(map.rows), .heights = {}};
    picture.heights.reserve(static_cast<std::size_t>(picture.columns) *
                            static_cast<std::size_t>(picture.rows));
    for (int row = 0; row < picture.rows; ++row) {
        const auto from = static_cast<int>((row + 0.5) * map.rows / picture.rows);
        for (int column = 0; column < picture.columns; ++column) {
            const auto at = static_cast<int>((column + 0.5) * map.columns / picture.columns);
            picture.heights.push_back(map.isValid(from, at) ? map.at(from, at) : std::nan(""));
        }
    }
    return picture;
}

/// @param heights of which some are numbers; their order is lost
ColorTable robustColors(std::vector<double> heights) {
    const auto skip = static_cast<std::ptrdiff_t>(kOutliers * static_cast<double>(heights.size()));
    std::nth_element(heights.begin(), heights.begin() + skip, heights.end());
    const double low = heights[static_cast<std::size_t>(skip)];
    const auto last = static_cast<std::ptrdiff_t>(heights.size()) - 1 - skip;
    std::nth_element(heights.begin(), heights.begin() + last, heights.end());
    return {ColorMap::Standard, low, heights[static_cast<std::size_t>(last)]};
}

}  // namespace

QColor hatched(int row, int column) {
    constexpr int kStripe = 5;  // [pixel]
    const QColor gray = toQColor(palette::kNoData);
    return ((row + column) / kStripe) % 2 == 0 ? gray : gray.lighter(140);
}

void ReliefImage::setSurface(const BSplineSurface& surface) {
    sizeX_ = surface.sizeX();
    sizeY_ = surface.sizeY();
    const double longer = std::max(sizeX_, sizeY_);
    const auto pixels = [longer](double size) {
        return std::clamp(static_cast<int>(std::lround(kMaxReliefSide * size / longer)), 1,
                          kMaxReliefSide);
    };
    image_ = QImage(pixels(sizeX_), pixels(sizeY_), QImage::Format_RGB32);
    heights_.clear();
    normals_.clear();
    measured_.clear();
    for (int row = 0; row < image_.height(); ++row) {
        const double y = yOf(row);
        for (int column = 0; column < image_.width(); ++column) {
            const double x = xOf(column);
            const HeightSample sample = surface.at(x, y);
            heights_.push_back(sample.height);
            normals_.push_back(sample.normal());
            measured_.push_back(surface.isMeasured(x, y) ? 1 : 0);
        }
    }
    hasFilled_ = std::ranges::count(measured_, 0) > 0;
    const double scale = slopeScale(normals_);
    shades_.clear();
    for (const Vector3& normal : normals_) {
        shades_.push_back(static_cast<float>(shade(normal, scale)));
    }
    paint();
}

void ReliefImage::setLook(const SurfaceLook& look, const SurfaceField& field) {
    ranges_.setChannel(look.channel);
    look_ = look;
    field_ = field.isLive() ? SurfaceField() : field;
    if (!image_.isNull()) {
        paint();
    }
}

double ReliefImage::xOf(int column) const { return sizeX_ * (column + 0.5) / image_.width(); }

double ReliefImage::yOf(int row) const {
    return sizeY_ * (image_.height() - row - 0.5) / image_.height();
}

std::vector<double> ReliefImage::values() const {
    std::vector<double> values;
    values.reserve(heights_.size());
    std::size_t next = 0;
    for (int row = 0; row < image_.height(); ++row) {
        const double y = yOf(row);
        for (int column = 0; column < image_.width(); ++column, ++next) {
            const double x = xOf(column);
            values.push_back(measured_[next] != 0
                                 ? field_.at({x, y, heights_[next]}, normals_[next])
                                 : std::numeric_limits<double>::quiet_NaN());
        }
    }
    return values;
}

/// Of a pixel without value.
QColor ReliefImage::colorOfNone(int row, int column) const {
    return field_.covers({xOf(column), yOf(row), 0.0}) ? hatched(row, column)
                                                       : toQColor(palette::kUndefined);
}

void ReliefImage::paint() {
    const std::vector<double> shownValues = values();
    const QuantityColors& chosen = look_.of(field_.quantity());
    ColorRange& range = ranges_.of(field_.quantity());
    range.fit(shownValues, {.colors = chosen, .isSigned = field_.isSigned()});
    const ColorTable table(chosen.map, range.range().low, range.range().high);
    colors_ = scaleOf(table, QString::fromStdString(field_.name()),
                      QString::fromStdString(field_.unit()));
    range.describe(colors_, chosen);
    std::size_t next = 0;
    for (int row = 0; row < image_.height(); ++row) {
        auto* line = reinterpret_cast<QRgb*>(image_.scanLine(row));
        for (int column = 0; column < image_.width(); ++column, ++next) {
            const double value = shownValues[next];
            const QColor color =
                std::isnan(value) ? colorOfNone(row, column) : toQColor(table.of(value));
            line[column] = shaded(color, shades_[next]);
        }
    }
}

QImage heightPicture(const HeightMap& map) {
    const Sampled picture = sampled(map);
    std::vector<double> known;
    std::ranges::copy_if(picture.heights, std::back_inserter(known),
                         [](double height) { return isFiniteHeight(height); });
    const ColorTable colors =
        known.empty() ? ColorTable(ColorMap::Standard, 0.0, 0.0) : robustColors(std::move(known));
    QImage image(picture.columns, picture.rows, QImage::Format_RGB32);
    std::size_t next = 0;
    for (int row = 0; row < picture.rows; ++row) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(row));
        for (int column = 0; column < picture.columns; ++column, ++next) {
            const double height = picture.heights[next];
            const QColor color =
                isFiniteHeight(height) ? toQColor(colors.of(height)) : hatched(row, column);
            line[column] = color.rgb();
        }
    }
    return image;
}

}  // namespace asperity
