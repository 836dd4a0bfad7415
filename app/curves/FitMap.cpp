#include "app/curves/FitMap.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"
#include "core/Version.h"
#include "core/io/heightmap/gwy/GwyWriter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace asperity {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A value of the fits as an image, with those of its deviations.
struct MapValue {
    const char* key;
    const char* title;
};
constexpr std::array kMapValues{
    MapValue{"youngs_modulus_pa", "Young's modulus"},
    MapValue{"youngs_modulus_sqrt_radius_pa_m05", "Young's modulus times root of radius"},
    MapValue{"pull_off_force_n", "Adhesion force"},
    MapValue{"work_of_adhesion_j_m2", "Work of adhesion"},
    MapValue{"contact_point_m", "Contact point"}};

/// Distance of neighbors along one axis [m]; 0: the positions do not say it.
double pitchOf(const FitMap& map, int CurveCell::*cell, double CurvePosition::*position) {
    const FittedCurve* low = nullptr;
    const FittedCurve* high = nullptr;
    for (const FittedCurve& curve : map.curves) {
        if (curve.cell && curve.position) {
            low = low == nullptr || *curve.cell.*cell < *low->cell.*cell ? &curve : low;
            high = high == nullptr || *curve.cell.*cell > *high->cell.*cell ? &curve : high;
        }
    }
    const int steps = low != nullptr ? *high->cell.*cell - *low->cell.*cell : 0;
    return steps > 0 ? std::abs(*high->position.*position - *low->position.*position) / steps : 0.0;
}

/// Size of a pixel [m]. A line has square pixels.
struct PixelSize {
    double x = 0.0;
    double y = 0.0;
};

PixelSize pixelSize(const FitMap& map) {
    const double x = pitchOf(map, &CurveCell::column, &CurvePosition::x);
    const double y = pitchOf(map, &CurveCell::row, &CurvePosition::y);
    return {x > 0.0 ? x : y, y > 0.0 ? y : x};
}

double lowestOf(const FitMap& map, double CurvePosition::*position) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const FittedCurve& curve : map.curves) {
        if (curve.position) {
            lowest = std::min(lowest, *curve.position.*position);
        }
    }
    return std::isfinite(lowest) ? lowest : 0.0;
}

class FitImages {
public:
    explicit FitImages(const FitMap& map) : map_(map), pixel_(pixelSize(map)) {}

    using Value = std::function<double(const CurveIdentification&)>;

    /// Adds an image where one pixel at least has the value.
    void add(const std::string& title, const std::string& unit, const Value& value) {
        const auto pixels =
            static_cast<std::size_t>(map_.grid.columns) * static_cast<std::size_t>(map_.grid.rows);
        std::vector<double> values(pixels, kNone);
        for (const FittedCurve& curve : map_.curves) {
            if (curve.cell && curve.found.verdict != FitVerdict::Refused) {
                const int row = map_.grid.rows - 1 - curve.cell->row;
                const int index = (row * map_.grid.columns) + curve.cell->column;
                values[static_cast<std::size_t>(index)] = value(curve.found);
            }
        }
        if (std::ranges::none_of(values, [](double one) { return std::isfinite(one); })) {
            return;
        }
        const int columns = map_.grid.columns;
        images_.push_back(
            {.rows = {.columns = columns,
                      .rows = map_.grid.rows,
                      .pitchX = pixel_.x,
                      .pitchY = pixel_.y,
                      .readRow =
                          [columns, values = std::move(values)](int row, double* out) {
                              std::copy_n(values.begin() +
                                              static_cast<std::ptrdiff_t>(row) * columns,
                                          columns, out);
                          }},
             .meta = {.title = title,
                      .originX = lowestOf(map_, &CurvePosition::x) - (0.5 * pixel_.x),
                      .originY = lowestOf(map_, &CurvePosition::y) - (0.5 * pixel_.y),
                      .unit = unit,
                      .metadata = {{"program", std::string("Asperity ") + kVersion},
                                   {"curves", map_.curves.front().file}}}});
    }

    void addValue(const MapValue& row) {
        const auto part = [&row](double IdentifiedValue::*member) {
            return [&row, member](const CurveIdentification& found) {
                const IdentifiedValue* const value = found.find(row.key);
                return value != nullptr &&
                               (member == &IdentifiedValue::value || value->*member > 0.0)
                           ? value->*member
                           : kNone;
            };
        };
        const std::string unit = unitOf(row.key);
        add(row.title, unit, part(&IdentifiedValue::value));
        add(std::string(row.title) + ", deviation by noise", unit, part(&IdentifiedValue::std));
        add(std::string(row.title) + ", deviation by calibration", unit,
            part(&IdentifiedValue::stdCalibration));
    }

    [[nodiscard]] const std::vector<WrittenImage>& images() const { return images_; }

private:
    /// "Pa m^0.5" is no unit of an image: such values are numbers.
    [[nodiscard]] std::string unitOf(const char* key) const {
        for (const FittedCurve& curve : map_.curves) {
            if (const IdentifiedValue* const value = curve.found.find(key)) {
                return value->unit.find(' ') == std::string::npos ? value->unit : "";
            }
        }
        return "";
    }

    const FitMap& map_;
    PixelSize pixel_;
    std::vector<WrittenImage> images_;
};

double residualIn(const CurveIdentification& found) {
    const auto row = std::ranges::find(found.residuals, "rms_contact", &FitNumber::key);
    return row != found.residuals.end() ? row->value : kNone;
}

}  // namespace

std::string refusalOfMap(const FitMap& map) {
    if (map.grid.columns <= 0 || map.grid.rows <= 0) {
        return "its curves lie on no grid";
    }
    if (!(pixelSize(map).x > 0.0)) {
        return "the file does not say where its curves were measured";
    }
    const bool anyFitted = std::ranges::any_of(map.curves, [](const FittedCurve& curve) {
        return curve.cell && curve.found.verdict != FitVerdict::Refused;
    });
    return anyFitted ? "" : "none of its curves could be fitted";
}

void writeFitMap(const std::filesystem::path& path, const FitMap& map) {
    if (const std::string refusal = refusalOfMap(map); !refusal.empty()) {
        throw Error(path.string() + ": " + refusal);
    }
    FitImages images(map);
    for (const MapValue& row : kMapValues) {
        images.addValue(row);
    }
    images.add("Residual in contact, share of the force range", "", residualIn);
    const TemporaryFile temporary(path);
    writeGwyImages(temporary.path(), images.images(), nullptr);
    temporary.commit();
}

}  // namespace asperity
