#include "core/contact/halfspace/HalfSpaceSolver.h"

#include "core/Error.h"
#include "core/contact/halfspace/PressureSearch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr double kFarGap = 1.0;            // of what lies beyond the grid [m]
constexpr double kLargeRadiusRatio = 0.3;  // contact radius over tip radius; docs/theory.md 2.10
constexpr double kMinPixelsAcross = 8.0;   // pixels across contact and cohesive zone
constexpr double kMinPixelsInZone = 1.0;   // pixels from the contact's edge to the cohesive zone's

std::size_t pixelCount(int samples) {
    return static_cast<std::size_t>(samples) * static_cast<std::size_t>(samples);
}

void requireUsable(const HalfSpaceContact& contact, const SurfaceTraction& start) {
    const std::size_t count = contact.samples > 0 ? pixelCount(contact.samples) : 0;
    if (count == 0 || contact.gap.size() != count) {
        throw Error("a half-space contact needs a gap for each of its pixels");
    }
    const bool positive =
        contact.pitch > 0.0 && contact.reducedModulus > 0.0 && contact.tipRadius > 0.0;
    const bool coheres = contact.cohesiveStress >= 0.0 && contact.cohesiveRange >= 0.0;
    if (!positive || !coheres || !std::isfinite(contact.approach)) {
        throw Error("a half-space contact needs a positive pitch, modulus and tip radius, a "
                    "cohesion that is not negative and a finite approach");
    }
    const bool starts = !start.contact.empty() || !start.cohesion.empty();
    if (starts && (start.contact.size() != count || start.cohesion.size() != count)) {
        throw Error("a half-space contact starts from a traction on each of its pixels");
    }
}

/// The pixels for which asks(pixel) is true.
template <class Asks>
PixelBounds boundsOf(int samples, const Asks& asks) {
    PixelBounds bounds;
    std::size_t pixel = 0;
    for (int row = 0; row < samples; ++row) {
        for (int column = 0; column < samples; ++column, ++pixel) {
            if (asks(pixel)) {
                bounds.include(row, column);
            }
        }
    }
    return bounds;
}

PixelBounds actingPixels(int samples, const SurfaceTraction& traction) {
    return boundsOf(samples, [&](std::size_t pixel) {
        return traction.contact[pixel] > 0.0 || traction.cohesion[pixel] > 0.0;
    });
}

/// Returns where anything acts, or will, at the gaps of the displacement so far.
PixelBounds reachOf(const HalfSpaceContact& contact, const HalfSpaceSolution& solution) {
    const double range = contact.cohesiveStress > 0.0 ? contact.cohesiveRange : 0.0;
    PixelBounds reach = actingPixels(contact.samples, solution.traction);
    reach.include(boundsOf(contact.samples, [&](std::size_t pixel) {
        return contact.gap[pixel] - contact.approach + solution.displacement[pixel] < range;
    }));
    return reach;
}

PressureSearch::Fields fieldsIn(const HalfSpaceContact& contact, const PixelWindow& window,
                                const SurfaceTraction& start) {
    const std::size_t count = pixelCount(window.size);
    PressureSearch::Fields fields{.rigidGap = std::vector<double>(count, kFarGap),
                                  .traction = {.contact = std::vector<double>(count, 0.0),
                                               .cohesion = std::vector<double>(count, 0.0)}};
    forEachInWindow(contact.samples, window, [&](std::size_t pixel, std::size_t inner) {
        fields.rigidGap[inner] = contact.gap[pixel] - contact.approach;
        fields.traction.contact[inner] = start.contact[pixel];
        fields.traction.cohesion[inner] = start.cohesion[pixel];
    });
    return fields;
}

double circleRadius(double area) { return std::sqrt(area / std::numbers::pi); }

void summarize(const HalfSpaceContact& contact, HalfSpaceSolution& solution) {
    const double pixelArea = contact.pitch * contact.pitch;
    double touching = 0.0;
    double cohering = 0.0;
    for (std::size_t i = 0; i < contact.gap.size(); ++i) {
        const double pressure = solution.traction.contact[i];
        const double cohesion = solution.traction.cohesion[i];
        solution.force += (pressure - contact.cohesiveStress * cohesion) * pixelArea;
        touching += pressure > 0.0 ? pixelArea : 0.0;
        cohering += std::max(cohesion, pressure > 0.0 ? 1.0 : 0.0) * pixelArea;
    }
    solution.contactRadius = circleRadius(touching);
    solution.cohesiveRadius = circleRadius(cohering);
}

HalfSpaceDoubts doubtsAbout(const HalfSpaceContact& contact, const HalfSpaceSolution& solution,
                            const PixelBounds& reach) {
    const PixelWindow grid{.row = 0, .column = 0, .size = contact.samples};
    // Of all that bears traction: within a wide cohesive zone the contact may shrink to nothing, as
    // it does before the tip parts.
    const double across = 2.0 * solution.cohesiveRadius / contact.pitch;
    const double zone = (solution.cohesiveRadius - solution.contactRadius) / contact.pitch;
    const bool narrowZone = contact.cohesiveStress > 0.0 && zone < kMinPixelsInZone;
    return {.largeContact = solution.contactRadius > kLargeRadiusRatio * contact.tipRadius,
            .reachesBorder = !reach.empty() && !reach.within(grid, 1),
            .tooCoarse = across > 0.0 && (across < kMinPixelsAcross || narrowZone)};
}

}  // namespace

void PixelBounds::include(int row, int column) noexcept {
    lowRow = std::min(lowRow, row);
    highRow = std::max(highRow, row);
    lowColumn = std::min(lowColumn, column);
    highColumn = std::max(highColumn, column);
}

void PixelBounds::include(const PixelBounds& others) noexcept {
    if (!others.empty()) {
        include(others.lowRow, others.lowColumn);
        include(others.highRow, others.highColumn);
    }
}

bool PixelBounds::within(const PixelWindow& window, int margin) const noexcept {
    return lowRow >= window.row + margin && lowColumn >= window.column + margin &&
           highRow < window.row + window.size - margin &&
           highColumn < window.column + window.size - margin;
}

PixelWindow windowAround(const PixelBounds& bounds, int samples) noexcept {
    constexpr int kMinMargin = 2;
    constexpr int kMarginShare = 16;  // of the pixels across
    const int across =
        std::max(bounds.highRow - bounds.lowRow, bounds.highColumn - bounds.lowColumn) + 1;
    const int margin = kMinMargin + across / kMarginShare;
    const int size = std::min(fieldSize(across + 2 * margin), fieldSize(samples));
    const auto first = [&](int low, int high) {
        const int centerd = (low + high + 1 - size) / 2;
        return std::clamp(centerd, std::min(0, samples - size), std::max(0, samples - size));
    };
    return {.row = first(bounds.lowRow, bounds.highRow),
            .column = first(bounds.lowColumn, bounds.highColumn),
            .size = size};
}

HalfSpaceSolver::HalfSpaceSolver(HalfSpaceLimits limits) : limits_(limits) {}

HalfSpaceSolver::Operators& HalfSpaceSolver::operatorsOf(int size) {
    const auto found = operators_.find(size);
    if (found != operators_.end()) {
        return found->second;
    }
    // The half-space answers waves of pressure by 2 / |wave vector|; the mean has no wave.
    const auto inverse = [](int row, int column) {
        return row + column > 0 ? std::hypot(row, column) : 0.5;
    };
    return operators_
        .emplace(size, Operators{.influence = FieldConvolution::padded(size, loveInfluence),
                                 .preconditioner = FieldConvolution::periodic(size, inverse)})
        .first->second;
}

HalfSpaceSolution HalfSpaceSolver::solve(const HalfSpaceContact& contact,
                                         const SurfaceTraction& start,
                                         const std::stop_token& stop) {
    requireUsable(contact, start);
    HalfSpaceSolution solution{.traction = start};
    solution.traction.contact.resize(contact.gap.size(), 0.0);
    solution.traction.cohesion.resize(contact.gap.size(), 0.0);
    solution.displacement.resize(contact.gap.size(), 0.0);
    // A start knows the contact better than the overlap of undeformed bodies does.
    PixelBounds reach = actingPixels(contact.samples, solution.traction);
    if (reach.empty()) {
        reach = reachOf(contact, solution);
    }
    PixelBounds searched;
    solution.status = HalfSpaceStatus::Converged;
    while (!reach.empty() && solution.status == HalfSpaceStatus::Converged) {
        searched.include(reach);
        const PixelWindow window = windowAround(searched, contact.samples);
        searchIn(window, contact, solution, stop);
        displace(contact, solution);
        reach = reachOf(contact, solution);
        if (reach.within(window, 1) || window.size >= contact.samples) {
            break;
        }
    }
    summarize(contact, solution);
    solution.doubts = doubtsAbout(contact, solution, reach);
    return solution;
}

/// Iterates the traction within a window.
void HalfSpaceSolver::searchIn(const PixelWindow& window, const HalfSpaceContact& contact,
                               HalfSpaceSolution& solution, const std::stop_token& stop) {
    Operators& operators = operatorsOf(window.size);
    PressureSearch search({.compliance = contact.pitch / contact.reducedModulus,
                           .cohesiveStress = contact.cohesiveStress,
                           .cohesiveRange = contact.cohesiveRange},
                          operators.influence, operators.preconditioner,
                          fieldsIn(contact, window, solution.traction));
    solution.status = HalfSpaceStatus::NotConverged;
    while (solution.status == HalfSpaceStatus::NotConverged &&
           solution.iterations < limits_.iterations) {
        search.advance();
        ++solution.iterations;
        solution.residual = search.residual();
        if (solution.residual < limits_.tolerance) {
            solution.status = HalfSpaceStatus::Converged;
        } else if (stop.stop_requested()) {
            solution.status = HalfSpaceStatus::Canceled;
        }
    }
    solution.convolutions += search.convolutions();
    forEachInWindow(contact.samples, window, [&](std::size_t pixel, std::size_t inner) {
        solution.traction.contact[pixel] = search.fields().traction.contact[inner];
        solution.traction.cohesion[pixel] = search.fields().traction.cohesion[inner];
    });
}

/// Displaces the whole grid by the traction.
void HalfSpaceSolver::displace(const HalfSpaceContact& contact, HalfSpaceSolution& solution) {
    FieldConvolution& influence = operatorsOf(fieldSize(contact.samples)).influence;
    const PixelWindow whole{.row = 0, .column = 0, .size = influence.size()};
    std::vector<double> field(pixelCount(whole.size), 0.0);
    const double compliance = contact.pitch / contact.reducedModulus;
    forEachInWindow(contact.samples, whole, [&](std::size_t pixel, std::size_t inner) {
        field[inner] = solution.traction.contact[pixel] -
                       contact.cohesiveStress * solution.traction.cohesion[pixel];
    });
    influence.apply(field, field);
    ++solution.convolutions;
    forEachInWindow(contact.samples, whole, [&](std::size_t pixel, std::size_t inner) {
        solution.displacement[pixel] = compliance * field[inner];
    });
}

}  // namespace asperity
