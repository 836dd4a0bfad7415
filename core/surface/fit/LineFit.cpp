#include "core/surface/fit/LineFit.h"

#include "core/Error.h"
#include "core/surface/fit/GaussianFilter.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

/// A table of weights: one row for each control height, as many columns as there are samples.
class Weights {
public:
    explicit Weights(int samples)
        : samples_(static_cast<std::size_t>(samples)), values_((samples_ + 2) * samples_) {}

    /// Row of control height `i`, -1 for the padding before the line.
    [[nodiscard]] double* row(std::ptrdiff_t i) {
        return values_.data() + static_cast<std::size_t>(i + 1) * samples_;
    }
    [[nodiscard]] std::size_t samples() const { return samples_; }
    [[nodiscard]] std::vector<double> take() && { return std::move(values_); }

private:
    std::size_t samples_;
    std::vector<double> values_;
};

/// target = a * first + b * second, over a row of the table.
void combine(double* target, std::size_t count, double a, const double* first, double b,
             const double* second) {
    for (std::size_t k = 0; k < count; ++k) {
        target[k] = a * first[k] + b * second[k];
    }
}

/// Padding by straight continuation: all that one or two samples define.
void padStraight(Weights& table) {
    const auto last = static_cast<std::ptrdiff_t>(table.samples()) - 1;
    const std::size_t n = table.samples();
    combine(table.row(-1), n, 2.0, table.row(0), -1.0,
            table.row(std::min<std::ptrdiff_t>(1, last)));
    combine(table.row(last + 1), n, 2.0, table.row(last), -1.0,
            table.row(std::max<std::ptrdiff_t>(last - 1, 0)));
}

/// Padding that leaves no third difference at either end.
void padQuadratic(Weights& table) {
    const auto last = static_cast<std::ptrdiff_t>(table.samples()) - 1;
    for (std::size_t k = 0; k < table.samples(); ++k) {
        table.row(-1)[k] = 3.0 * (table.row(0)[k] - table.row(1)[k]) + table.row(2)[k];
        table.row(last + 1)[k] =
            3.0 * (table.row(last)[k] - table.row(last - 1)[k]) + table.row(last - 2)[k];
    }
}

/// Multipliers of the elimination; they do not depend on the samples.
std::vector<double> eliminationFactors(std::size_t count) {
    std::vector<double> factors(count, 0.0);
    factors[0] = -1.0;
    for (std::size_t i = 1; i + 1 < count; ++i) {
        factors[i] = 1.0 / (4.0 - factors[i - 1]);
    }
    return factors;
}

/// Turns weights of smoothed samples into weights of control heights, in place.
///
/// Inner rows of the system: c[i-1] + 4 c[i] + c[i+1] = 6 f[i]. Eliminating the padding with the
/// end condition leaves c[0] - c[1] = f[0] - f[1], and the mirror image at the other end.
void interpolate(Weights& table) {
    const std::size_t n = table.samples();
    if (n < 3) {
        padStraight(table);
        return;
    }
    const std::vector<double> factors = eliminationFactors(n);
    const auto last = static_cast<std::ptrdiff_t>(n) - 1;
    combine(table.row(0), n, 1.0, table.row(0), -1.0, table.row(1));
    combine(table.row(last), n, 1.0, table.row(last), -1.0, table.row(last - 1));
    for (std::ptrdiff_t i = 1; i < last; ++i) {
        const double factor = factors[static_cast<std::size_t>(i)];
        combine(table.row(i), n, 6.0 * factor, table.row(i), -factor, table.row(i - 1));
    }
    const double closing = 1.0 / (1.0 + factors[n - 2]);
    combine(table.row(last), n, closing, table.row(last), closing, table.row(last - 1));
    for (std::ptrdiff_t i = last; i-- > 0;) {
        combine(table.row(i), n, 1.0, table.row(i), -factors[static_cast<std::size_t>(i)],
                table.row(i + 1));
    }
    padQuadratic(table);
}

/// Pixels over which the spline's answer to one sample falls below any rounding: each takes it down
/// to 2 - sqrt(3).
constexpr int kSplineDecay = 30;

/// Weights by distance from the middle row of a line so long that its ends do not matter, without
/// the farthest ones that add up to less than `neglected`.
std::vector<double> kernelOf(const std::vector<double>& weights, int samples, double neglected) {
    const int middle = samples / 2;
    const double* row =
        weights.data() + static_cast<std::size_t>(middle + 1) * static_cast<std::size_t>(samples);
    std::vector<double> kernel(row + middle, row + samples);
    double rest = 0.0;
    while (kernel.size() > 1) {
        rest += 2.0 * std::abs(kernel.back());
        if (rest > neglected) {
            break;
        }
        kernel.pop_back();
    }
    return kernel;
}

/// Returns how far the weights of a control height are from those that the kernel gives.
double deviation(const double* row, int samples, int control, const std::vector<double>& kernel) {
    double sum = 0.0;
    for (int j = 0; j < samples; ++j) {
        const auto distance = static_cast<std::size_t>(std::abs(j - control));
        sum += std::abs(row[j] - (distance < kernel.size() ? kernel[distance] : 0.0));
    }
    return sum;
}

}  // namespace

std::vector<double> lineFitWeights(int samples, double sigma) {
    const std::vector<double> gaussian = halfGaussian(sigma);
    if (samples < 1) {
        throw Error("a line needs at least one sample");
    }
    const int reach = static_cast<int>(gaussian.size()) - 1;
    Weights table(samples);
    for (int i = 0; i < samples; ++i) {
        double* row = table.row(i);
        for (int k = -reach; k <= reach; ++k) {
            const double weight = gaussian[static_cast<std::size_t>(std::abs(k))];
            const ReflectedSample sample = reflectedSample(samples, i + k);
            row[sample.index] += weight * sample.own;
            row[0] += weight * sample.first;
            row[samples - 1] += weight * sample.last;
        }
    }
    interpolate(table);
    return std::move(table).take();
}

template <class Height>
BasicLineFit<Height>::BasicLineFit(int samples, double sigma) : samples_(samples) {
    // Long enough for a middle that no end reaches, nor the other end one end's borders.
    const int unit = static_cast<int>(halfGaussian(sigma).size()) + kSplineDecay;
    const int enough = 4 * unit + 1;
    if (samples <= enough) {
        borderWeights_ = lineFitWeights(samples, sigma);
        border_ = controls();
        span_ = samples;
        return;
    }
    const std::vector<double> weights = lineFitWeights(enough, sigma);
    const std::vector<double> kernel = kernelOf(weights, enough, kNeglected);
    kernel_.assign(kernel.begin() + 1, kernel.end());
    const auto row = [&](int index) {
        return weights.data() + static_cast<std::size_t>(index) * static_cast<std::size_t>(enough);
    };
    border_ = 2 * unit;
    while (border_ > reach() + 2 &&
           deviation(row(border_ - 1), enough, border_ - 2, kernel) <= 2.0 * kNeglected) {
        --border_;
    }
    span_ = border_ + reach();
    for (int index = 0; index < border_; ++index) {
        borderWeights_.insert(borderWeights_.end(), row(index), row(index) + span_);
    }
}

template class BasicLineFit<float>;
template class BasicLineFit<double>;

}  // namespace asperity
