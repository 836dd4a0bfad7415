#include "core/identify/SpringConstant.h"

#include "core/Error.h"
#include "core/identify/LeastSquares.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace asperity {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Complex = std::complex<double>;

constexpr double kBoltzmann = 1.380649e-23;  // [J/K]
constexpr Index kMinPeakSamples = 20;

/// Samples of a spectrum around its peak.
struct PeakSamples {
    VectorXd frequency = {};
    VectorXd power = {};
    double resonance = 0.0;
    double quality = 0.0;  ///< by the width at half height
    double peak = 0.0;
};

/// Half height to either side of the peak; a lever of small Q has no lower side.
double widthOf(const std::vector<double>& frequency, const std::vector<double>& power,
               std::size_t top) {
    std::size_t low = top;
    std::size_t high = top;
    while (low > 0 && power[low] > 0.5 * power[top]) {
        --low;
    }
    while (high + 1 < power.size() && power[high] > 0.5 * power[top]) {
        ++high;
    }
    return std::max(frequency[high] - frequency[low], 2.0 * (frequency[high] - frequency[top]));
}

PeakSamples samplesAround(const std::vector<double>& frequency, const std::vector<double>& power) {
    constexpr double kReach = 30.0;  // widths to either side
    // Slow drift makes the first samples of a spectrum large: a peak rises from both sides.
    std::size_t top = 0;
    for (std::size_t i = power.size() / 100 + 1; i + 1 < power.size(); ++i) {
        const bool isPeak = power[i] >= power[i - 1] && power[i] >= power[i + 1];
        if (isPeak && (top == 0 || power[i] * frequency[i] > power[top] * frequency[top])) {
            top = i;
        }
    }
    if (top == 0) {
        throw Error("the thermal spectrum has no peak");
    }
    PeakSamples result{.resonance = frequency[top], .peak = power[top]};
    const double width = widthOf(frequency, power, top);
    result.quality = std::max(1.0, frequency[top] / width);
    const double low = std::max(frequency[top] - (kReach * width), 0.3 * frequency[top]);
    const double high = std::min(frequency[top] + (kReach * width), 2.0 * frequency[top]);
    const auto first = std::lower_bound(frequency.begin(), frequency.end(), low);
    const auto last = std::upper_bound(frequency.begin(), frequency.end(), high);
    const auto count = static_cast<Index>(last - first);
    if (count < kMinPeakSamples) {
        throw Error("the thermal spectrum has fewer than 20 samples around its peak");
    }
    const Index offset = first - frequency.begin();
    result.frequency = VectorXd::Map(frequency.data() + offset, count);
    result.power = VectorXd::Map(power.data() + offset, count);
    return result;
}

/// Power by the logarithms of resonance, quality factor, peak and background.
VectorXd oscillatorPower(const VectorXd& frequency, const VectorXd& p) {
    const double resonance = std::exp(p[0]);
    const double quality = std::exp(p[1]);
    const Eigen::ArrayXd ratio = frequency.array() / resonance;
    const Eigen::ArrayXd square = ratio.square();
    // At the resonance the power is that of the peak.
    const double level = std::exp(p[2]) / (quality * quality);
    return level / ((square - 1.0).square() + square / (quality * quality)) + std::exp(p[3]);
}

/// The sum of c_i x^i over the sum of d_i x^i, i = 0 .. 6.
double ratioOfPolynomials(const std::array<double, 7>& over, const std::array<double, 7>& under,
                          double x) {
    double numerator = 0.0;
    double denominator = 0.0;
    for (std::size_t i = 7; i-- > 0;) {
        numerator = (numerator * x) + over[i];
        denominator = (denominator * x) + under[i];
    }
    return numerator / denominator;
}

/// exp(z) times the modified Bessel function K_n(z), Re z > 0: the integral of
/// exp(z (1 - cosh t)) cosh(n t) over t > 0, whose sum over equal steps converges as no power.
Complex scaledBesselK(int order, Complex z) {
    constexpr double kStep = 0.01;
    constexpr double kEnd = 745.0;  // exp of less is 0
    Complex sum = 0.5;
    for (double t = kStep; z.real() * (std::cosh(t) - 1.0) < kEnd; t += kStep) {
        sum += std::exp(z * (1.0 - std::cosh(t))) * std::cosh(order * t);
    }
    return kStep * sum;
}

/// Hydrodynamic function of a rectangular lever. Source: Sader (1998), equations 20, 21.
Complex hydrodynamicFunction(double reynolds) {
    const double x = std::log10(reynolds);
    const Complex correction(
        ratioOfPolynomials({0.91324, -0.48274, 0.46842, -0.12886, 0.044055, -0.0035117, 0.00069085},
                           {1.0, -0.56964, 0.48690, -0.13444, 0.045155, -0.0035862, 0.00069085}, x),
        ratioOfPolynomials(
            {-0.024134, -0.029256, 0.016294, -0.00010961, 0.000064577, -0.000044510, 0.0},
            {1.0, -0.59702, 0.55182, -0.18357, 0.079156, -0.014369, 0.0028361}, x));
    const Complex i(0.0, 1.0);
    const Complex root = std::sqrt(i * reynolds);
    const Complex argument = -i * root;
    const Complex circle =
        1.0 + (4.0 * i * scaledBesselK(1, argument) / (root * scaledBesselK(0, argument)));
    return correction * circle;
}

}  // namespace

ThermalOscillator fitThermalSpectrum(const std::vector<double>& frequency,
                                     const std::vector<double>& power, double temperature) {
    const PeakSamples samples = samplesAround(frequency, power);
    VectorXd start(4);
    start << std::log(samples.resonance), std::log(samples.quality), std::log(samples.peak),
        std::log(std::max(samples.power.minCoeff(), 1e-6 * samples.peak));
    const FitResult fit = leastSquares(
        [&](const VectorXd& p, VectorXd& r) {
            r = (oscillatorPower(samples.frequency, p) - samples.power) / samples.peak;
        },
        start, VectorXd::Constant(4, 0.1), static_cast<std::size_t>(samples.power.size()));
    ThermalOscillator result;
    result.resonance = std::exp(fit.parameters[0]);
    result.resonanceStd = result.resonance * fit.std(0);
    result.quality = std::exp(fit.parameters[1]);
    result.qualityStd = result.quality * fit.std(1);
    result.background = std::exp(fit.parameters[3]);
    result.misfit = fit.rms;
    // Peak P0 Q^2 and mean square pi/2 P0 f0 Q: it goes with peak, resonance and 1 / Q.
    const double square =
        0.5 * std::numbers::pi * std::exp(fit.parameters[2]) * result.resonance / result.quality;
    Eigen::Vector4d rate(1.0, -1.0, 1.0, 0.0);
    result.stiffness = kBoltzmann * temperature / square;
    result.stiffnessStd = result.stiffness * std::sqrt(rate.dot(fit.covariance * rate));
    return result;
}

double saderStiffness(double length, double width, double resonance, double quality,
                      const LeverFluid& fluid) {
    for (const double number :
         {length, width, resonance, quality, fluid.density, fluid.viscosity}) {
        if (!(number > 0.0)) {
            throw Error("the stiffness by Sader's method needs length, width, resonance, quality "
                        "factor and fluid, all above 0");
        }
    }
    const double omega = 2.0 * std::numbers::pi * resonance;
    const double reynolds = fluid.density * omega * width * width / (4.0 * fluid.viscosity);
    return 0.1906 * fluid.density * width * width * length * quality * omega * omega *
           hydrodynamicFunction(reynolds).imag();
}

}  // namespace asperity
