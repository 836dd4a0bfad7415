// Time of the half-space solver on a rough surface, cold and from the frame before, in one run.
// Times are of the processor, medians over positions: one thread solves, and others may share the
// machine. The limits beside them are a quarter of a frame of 25 Hz and what as many
// convolutions of the whole grid would take alone.
#include "core/contact/halfspace/FieldConvolution.h"
#include "core/contact/halfspace/HalfSpaceSolver.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <vector>

namespace asperity {

namespace {

constexpr double kTipRadius = 15e-9;
constexpr double kHalfWidth = 14.9e-9;  // of the patch: about the tip itself
constexpr double kIndentation = 0.5e-9;
constexpr double kModulus = 2.35e9;  // polystyrene under silicon
constexpr double kWork = 0.066;
constexpr double kRange = 0.35677581392778259e-9;
constexpr double kFrame = 0.25 * 1e3 / 25.0;  // a quarter of one [ms]
constexpr int kPositions = 25;

double millisecondsSince(std::clock_t start) {
    return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

/// Hills of a few angstrom, some 10 nm wide [m].
double height(double x, double y) {
    return 0.15e-9 * (std::sin(x / 2.1e-9) * std::cos(y / 1.7e-9) + std::cos((x + 0.6 * y) / 3e-9));
}

/// The tip at (x, 0), as deep as in every other position.
HalfSpaceContact contactAt(int samples, double x, bool adhesive) {
    HalfSpaceContact contact{.samples = samples,
                             .pitch = 2.0 * kHalfWidth / samples,
                             .gap = {},
                             .reducedModulus = kModulus,
                             .cohesiveStress = adhesive ? kWork / kRange : 0.0,
                             .cohesiveRange = kRange,
                             .tipRadius = kTipRadius};
    const auto position = [&](int i) { return (i - 0.5 * (samples - 1)) * contact.pitch; };
    for (int row = 0; row < samples; ++row) {
        for (int column = 0; column < samples; ++column) {
            const double r2 = std::pow(position(column), 2) + std::pow(position(row), 2);
            const double up = std::sqrt(std::max(0.0, kTipRadius * kTipRadius - r2));
            const double sphere = r2 / (kTipRadius + up);
            contact.gap.push_back(sphere - height(x + position(column), position(row)));
        }
    }
    contact.approach = *std::min_element(contact.gap.begin(), contact.gap.end()) + kIndentation;
    return contact;
}

/// One kind of solution: what it took at each position.
struct Timing {
    std::vector<double> times{};  ///< [ms]
    std::vector<double> iterations{};
    std::vector<double> convolutions{};
    int failed = 0;

    HalfSpaceSolution run(HalfSpaceSolver& solver, const HalfSpaceContact& contact,
                          const SurfaceTraction& start) {
        const std::clock_t begin = std::clock();
        HalfSpaceSolution solution = solver.solve(contact, start);
        times.push_back(millisecondsSince(begin));
        iterations.push_back(solution.iterations);
        convolutions.push_back(solution.convolutions);
        failed += solution.status == HalfSpaceStatus::Converged ? 0 : 1;
        return solution;
    }
    void print(const char* name, double convolution) const {
        const double time = median(times);
        std::printf("  %-22s %8.2f ms  %5.0f iterations %5.0f convolutions  %5.2f x quarter frame"
                    "  %5.2f x whole-grid convolutions%s\n",
                    name, time, median(iterations), median(convolutions), time / kFrame,
                    time / (convolution * median(convolutions)),
                    failed > 0 ? "  NOT CONVERGED" : "");
    }
};

double convolutionTime(int samples) {
    FieldConvolution convolution = FieldConvolution::padded(fieldSize(samples), loveInfluence);
    const auto size = static_cast<std::size_t>(convolution.size());
    std::vector<double> field(size * size, 1.0);
    std::vector<double> result(field.size());
    std::vector<double> times;
    for (int i = 0; i < kPositions; ++i) {
        const std::clock_t begin = std::clock();
        convolution.apply(field, result);
        times.push_back(millisecondsSince(begin));
    }
    return median(times);
}

void measure(int samples, bool adhesive) {
    Timing cold;
    Timing far;
    Timing near;
    HalfSpaceSolver solver;
    (void)solver.solve(contactAt(samples, 0.0, adhesive));  // transforms are planned once
    for (int i = 0; i < kPositions; ++i) {
        const double x = 1.3e-9 * i;
        const SurfaceTraction start =
            cold.run(solver, contactAt(samples, x, adhesive), {}).traction;
        (void)far.run(solver, contactAt(samples, x + 4e-9, adhesive), start);
        (void)near.run(solver, contactAt(samples, x + 0.1e-9, adhesive), start);
    }
    const double convolution = convolutionTime(samples);
    std::printf("%d^2, %s; one convolution of the grid %.2f ms\n", samples,
                adhesive ? "with adhesion" : "elastic", convolution);
    cold.print("cold", convolution);
    far.print("warm, 4 nm step", convolution);
    near.print("warm, 0.1 nm step", convolution);
}

}  // namespace

}  // namespace asperity

int main() {
    for (const int samples : {64, 128, 256}) {
        asperity::measure(samples, false);
        asperity::measure(samples, true);
    }
    return 0;
}
