#include "core/contact/halfspace/PressureSearch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

double dot(std::span<const double> first, std::span<const double> second) {
    double sum = 0.0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        sum += first[i] * second[i];
    }
    return sum;
}

/// Over so much of the range at least, and twice the range at most, the stress falls off: a sharper
/// law would make pixels flicker, a blunter one leave a contact without all of its cohesion.
constexpr double kMinZone = 0.02;
constexpr double kMaxZone = 2.0;

double difference(std::span<const double> gaps, std::size_t before, std::size_t after) noexcept {
    return 0.5 * (gaps[after] - gaps[before]);
}

}  // namespace

PressureSearch::PressureSearch(const Medium& medium, FieldConvolution& influence,
                               FieldConvolution& preconditioner, Fields fields)
    : medium_(medium)
    , influence_(&influence)
    , preconditioner_(&preconditioner)
    , fields_(std::move(fields))
    , gap_(fields_.rigidGap.size())
    , touches_(gap_.size(), 0)
    , residual_(gap_.size(), 0.0)
    , descent_(gap_.size(), 0.0)
    , direction_(gap_.size(), 0.0)
    , response_(gap_.size(), 0.0) {
    updateGap();
    if (updateCohesion()) {
        updateGap();
    }
}

double PressureSearch::pressureAt(std::size_t pixel) const noexcept {
    return fields_.traction.contact[pixel] -
           medium_.cohesiveStress * fields_.traction.cohesion[pixel];
}

void PressureSearch::updateGap() {
    for (std::size_t i = 0; i < gap_.size(); ++i) {
        gap_[i] = pressureAt(i);
    }
    influence_->apply(gap_, gap_);
    ++convolutions_;
    for (std::size_t i = 0; i < gap_.size(); ++i) {
        gap_[i] = fields_.rigidGap[i] + medium_.compliance * gap_[i];
    }
}

/// Returns whether the gaps left by the last step ask for another cohesive zone.
bool PressureSearch::updateCohesion() {
    if (medium_.cohesiveStress == 0.0) {
        return false;
    }
    std::vector<double>& before = response_;  // done with until the next step
    std::swap(before, fields_.traction.cohesion);
    cohesiveShares(gap_, influence_->size(), medium_.cohesiveRange, fields_.traction.cohesion);
    double change = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < gap_.size(); ++i) {
        if (fields_.traction.contact[i] > 0.0) {
            fields_.traction.cohesion[i] = 1.0;  // it touches, whatever gap the search has left
        }
        change += std::abs(fields_.traction.cohesion[i] - before[i]);
        all += std::abs(pressureAt(i));
    }
    cohesionChange_ = all > 0.0 ? medium_.cohesiveStress * change / all : 0.0;
    return change > 0.0;
}

/// The set of pixels that touch, and the conjugate direction on them (Polak-Ribiere: it forgets
/// what a changed set has made useless).
void PressureSearch::chooseDirection() {
    std::vector<double>& residualBefore = response_;  // done with since the last step
    std::swap(residualBefore, residual_);
    bool grown = false;
    for (std::size_t i = 0; i < gap_.size(); ++i) {
        const bool touches = fields_.traction.contact[i] > 0.0 || gap_[i] < 0.0;
        grown = grown || (touches && touches_[i] == 0);
        touches_[i] = touches ? 1 : 0;
        residual_[i] = touches ? gap_[i] : 0.0;
    }
    preconditioner_->apply(residual_, descent_);
    double product = 0.0;
    double overlap = 0.0;
    for (std::size_t i = 0; i < gap_.size(); ++i) {
        descent_[i] = touches_[i] != 0 ? descent_[i] : 0.0;
        product += residual_[i] * descent_[i];
        overlap += residualBefore[i] * descent_[i];
    }
    const bool restart = grown || !(product_ > 0.0);
    const double keep = restart ? 0.0 : std::max(0.0, (product - overlap) / product_);
    product_ = product;
    for (std::size_t i = 0; i < gap_.size(); ++i) {
        direction_[i] = touches_[i] != 0 ? descent_[i] + keep * direction_[i] : 0.0;
    }
}

/// To the least energy along the direction, then to where no pixel that touches is pulled by more
/// than the cohesive stress. Whether pressures were cut off on the way.
bool PressureSearch::moveAlongDirection() {
    influence_->apply(direction_, response_);
    ++convolutions_;
    const double curvature = medium_.compliance * dot(direction_, response_);
    const double step = curvature > 0.0 ? dot(residual_, direction_) / curvature : 0.0;
    bool cut = false;
    for (std::size_t i = 0; i < gap_.size(); ++i) {
        const double pressure = fields_.traction.contact[i] - step * direction_[i];
        cut = cut || pressure < 0.0;
        fields_.traction.contact[i] = std::max(0.0, pressure);
        gap_[i] -= step * medium_.compliance * response_[i];
    }
    return cut;
}

void PressureSearch::advance() {
    chooseDirection();
    const bool cut = moveAlongDirection();
    const bool moved = updateCohesion();
    if (cut || moved) {
        updateGap();
    }
}

double PressureSearch::residual() const {
    double square = 0.0;
    double count = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < gap_.size(); ++i) {
        largest = std::max(largest, std::abs(gap_[i] - fields_.rigidGap[i]));
        if (fields_.traction.contact[i] > 0.0 || gap_[i] < 0.0) {
            square += gap_[i] * gap_[i];
            count += 1.0;
        }
    }
    const double gaps = count > 0.0 ? std::sqrt(square / count) : 0.0;
    return std::max(largest > 0.0 ? gaps / largest : 0.0, cohesionChange_);
}

void cohesiveShares(std::span<const double> gaps, int size, double range,
                    std::span<double> shares) noexcept {
    const auto width = static_cast<std::size_t>(size);
    for (std::size_t row = 0; row < width; ++row) {
        const std::size_t below = row > 0 ? row - 1 : row;
        const std::size_t above = std::min(row + 1, width - 1);
        for (std::size_t column = 0; column < width; ++column) {
            const std::size_t left = column > 0 ? column - 1 : column;
            const std::size_t right = std::min(column + 1, width - 1);
            const double across = difference(gaps, row * width + left, row * width + right);
            const double up = difference(gaps, below * width + column, above * width + column);
            const double blur =
                std::clamp(std::abs(across) + std::abs(up), kMinZone * range, kMaxZone * range);
            const std::size_t pixel = row * width + column;
            shares[pixel] = std::clamp(0.5 + (range - gaps[pixel]) / blur, 0.0, 1.0);
        }
    }
}

}  // namespace asperity
