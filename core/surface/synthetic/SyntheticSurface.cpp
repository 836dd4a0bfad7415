#include "core/surface/synthetic/SyntheticSurface.h"

#include "core/Error.h"
#include "core/Random.h"
#include "core/SmoothStep.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <string>
#include <unsupported/Eigen/FFT>

namespace asperity {

namespace {

/// Draws of a radius or a position before giving up.
constexpr int kMaxDraws = 10000;

double drawRadius(const Nanoparticles::Recipe& recipe, Random& random) {
    for (int draw = 0; draw < kMaxDraws; ++draw) {
        const double radius = recipe.medianRadius * std::exp(recipe.spread * random.normal());
        if (radius >= recipe.smallest && radius <= recipe.largest) {
            return radius;
        }
    }
    throw Error("hardly any particle radius falls between the minimum and the maximum");
}

using Complex = std::complex<double>;

/// Amplitudes of the waves exp(i q.x) of a real periodic map.
class Spectrum {
public:
    explicit Spectrum(const ScanSize& size)
        : size_(size)
        , waves_(static_cast<std::size_t>(size.columns) * static_cast<std::size_t>(size.rows)) {}

    /// Sets amplitude(|q|) with random phases on every wave that is not at the grid's limit.
    template <class Amplitude>
    void fill(Random& random, const Amplitude& amplitude) {
        for (int ky = 0; 2 * ky < size_.rows; ++ky) {
            for (int kx = -(size_.columns - 1) / 2; 2 * kx < size_.columns; ++kx) {
                const bool isFirstOfPair = ky > 0 || kx > 0;
                if (!isFirstOfPair) {
                    continue;
                }
                const double phase = 2.0 * std::numbers::pi * random.uniform();
                const double qx = 2.0 * std::numbers::pi * kx / size_.sizeX;
                const double qy = 2.0 * std::numbers::pi * ky / size_.sizeY;
                const Complex wave = std::polar(amplitude(std::hypot(qx, qy)), phase);
                at(kx, ky) = wave;
                at(-kx, -ky) = std::conj(wave);
            }
        }
    }

    void scaleToRms(double rms) {
        double power = 0.0;
        for (const Complex& wave : waves_) {
            power += std::norm(wave);
        }
        if (power == 0.0) {
            throw Error("the scan holds no wave between the shortest and the longest");
        }
        for (Complex& wave : waves_) {
            wave *= rms / std::sqrt(power);
        }
    }

    /// The map's values: the inverse transform along x, then along y.
    [[nodiscard]] std::vector<double> values() const {
        const auto columns = static_cast<std::size_t>(size_.columns);
        const auto rows = static_cast<std::size_t>(size_.rows);
        Eigen::FFT<double> transform;
        transform.SetFlag(Eigen::FFT<double>::Unscaled);
        std::vector<Complex> halfDone(waves_.size());
        for (std::size_t row = 0; row < rows; ++row) {
            transform.inv(halfDone.data() + row * columns, waves_.data() + row * columns,
                          size_.columns);
        }
        std::vector<double> values(waves_.size());
        std::vector<Complex> line(rows);
        std::vector<Complex> result(rows);
        for (std::size_t column = 0; column < columns; ++column) {
            for (std::size_t row = 0; row < rows; ++row) {
                line[row] = halfDone[row * columns + column];
            }
            transform.inv(result.data(), line.data(), size_.rows);
            for (std::size_t row = 0; row < rows; ++row) {
                values[row * columns + column] = result[row].real();
            }
        }
        return values;
    }

private:
    Complex& at(int kx, int ky) {
        const int column = kx < 0 ? kx + size_.columns : kx;
        const int row = ky < 0 ? ky + size_.rows : ky;
        return waves_[static_cast<std::size_t>(row) * static_cast<std::size_t>(size_.columns) +
                      static_cast<std::size_t>(column)];
    }

    ScanSize size_;
    std::vector<Complex> waves_;
};

/// A fixed random value in -1..1 for each lattice point.
double latticeValue(std::uint64_t seed, int i, int j) {
    std::uint64_t state = seed ^ (static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)) << 32U |
                                  static_cast<std::uint32_t>(j));
    return static_cast<double>(splitMix64(state) >> 11U) * 0x1p-52 - 1.0;
}

}  // namespace

HeightMap flatMap(const ScanSize& size) {
    constexpr int kMaxPixels = 1 << 15;  // a side
    if (size.columns < 1 || size.rows < 1 || size.columns > kMaxPixels || size.rows > kMaxPixels) {
        throw Error("a synthetic scan has 1 to " + std::to_string(kMaxPixels) + " pixels a side");
    }
    HeightMap map{.columns = size.columns,
                  .rows = size.rows,
                  .pitchX = size.sizeX / size.columns,
                  .pitchY = size.sizeY / size.rows,
                  .heights = {},
                  .invalid = {}};
    map.heights.resize(map.index(map.rows, 0), 0.0);
    requireUsable(map);
    return map;
}

HeightSample EggBox::at(double x, double y) const {
    const double kx = 2.0 * std::numbers::pi / periodX;
    const double ky = 2.0 * std::numbers::pi / periodY;
    const double sx = std::sin(kx * x + phaseX);
    const double cx = std::cos(kx * x + phaseX);
    const double sy = std::sin(ky * y + phaseY);
    const double cy = std::cos(ky * y + phaseY);
    return {.height = amplitude * sx * sy,
            .dx = amplitude * kx * cx * sy,
            .dy = amplitude * ky * sx * cy,
            .dxx = -amplitude * kx * kx * sx * sy,
            .dxy = amplitude * kx * ky * cx * cy,
            .dyy = -amplitude * ky * ky * sx * sy};
}

double TrapezoidGrating::height(double x, double y) const {
    const double across = x * std::cos(angle) + y * std::sin(angle);
    const double phase = across - pitch * std::floor(across / pitch);
    if (phase < topWidth) {
        return depth;
    }
    const double fromTop = std::min(phase - topWidth, pitch - phase);
    return fromTop < flankWidth ? depth * (1.0 - fromTop / flankWidth) : 0.0;
}

AtomicSteps::AtomicSteps(const Recipe& recipe, const ScanSize& size) : recipe_(recipe) {
    if (!(recipe.terraceWidth > 0.0) || !(recipe.edgeWidth > 0.0)) {
        throw Error("terraces and step edges need a positive width");
    }
    // One reach beyond the scan on every side, so that no step is missing in a corner.
    const double reach = size.sizeX + size.sizeY + 10.0 * recipe.edgeWidth;
    constexpr double kMaxTerraces = 1e6;
    if (reach > kMaxTerraces * recipe.terraceWidth) {
        throw Error("the terraces are too narrow for a scan of this size");
    }
    Random random(recipe.seed);
    const int last = static_cast<int>(std::ceil(reach / recipe.terraceWidth));
    for (int k = -last; k <= last; ++k) {
        steps_.push_back((k + 0.5) * recipe.terraceWidth + recipe.jitter * random.normal());
    }
}

double AtomicSteps::height(double x, double y) const {
    const double across = x * std::cos(recipe_.angle) + y * std::sin(recipe_.angle);
    double stepsUp = 0.0;
    for (const double step : steps_) {
        // The logistic step less its value at the origin's side, written so that exp stays finite.
        const double before = step <= 0.0 ? 1.0 : 0.0;
        stepsUp += 0.5 * (1.0 + std::tanh(0.5 * (across - step) / recipe_.edgeWidth)) - before;
    }
    return recipe_.stepHeight * (stepsUp - across / recipe_.terraceWidth);
}

Nanoparticles::Nanoparticles(const Recipe& recipe, const ScanSize& size) : recipe_(recipe) {
    if (recipe.count < 0 || !(recipe.medianRadius > 0.0) || !(recipe.smallest > 0.0) ||
        !(recipe.scanTipRadius >= 0.0)) {
        throw Error("particles need a positive radius");
    }
    Random random(recipe.seed);
    for (int i = 0; i < recipe.count; ++i) {
        Particle particle{.radius = drawRadius(recipe, random)};
        const double margin = outlineRadius(particle.radius) + recipe.clearance;
        bool placed = false;
        for (int draw = 0; draw < kMaxDraws && !placed; ++draw) {
            particle.x = random.uniform(margin, size.sizeX - margin);
            particle.y = random.uniform(margin, size.sizeY - margin);
            placed = 2.0 * margin < std::min(size.sizeX, size.sizeY) && hasRoom(particle);
        }
        if (!placed) {
            throw Error("there is no room for " + std::to_string(recipe.count) + " particles");
        }
        particles_.push_back(particle);
    }
}

/// Half the width at which a particle stands out: where the tip touches particle and plane at once,
/// or where it slides off the equator of a particle larger than itself.
double Nanoparticles::outlineRadius(double particleRadius) const {
    const double tip = recipe_.scanTipRadius;
    return tip < particleRadius ? particleRadius + tip : 2.0 * std::sqrt(particleRadius * tip);
}

bool Nanoparticles::hasRoom(const Particle& particle) const {
    return std::ranges::all_of(particles_, [&](const Particle& other) {
        return std::hypot(particle.x - other.x, particle.y - other.y) >
               outlineRadius(particle.radius) + outlineRadius(other.radius) + recipe_.clearance;
    });
}

double Nanoparticles::height(double x, double y) const {
    double height = 0.0;
    for (const Particle& particle : particles_) {
        const double distance = std::hypot(x - particle.x, y - particle.y);
        if (distance > outlineRadius(particle.radius)) {
            continue;
        }
        const double reach = particle.radius + recipe_.scanTipRadius;
        const double center = particle.radius + std::sqrt((reach - distance) * (reach + distance));
        height = std::max(height, center - recipe_.scanTipRadius);
    }
    return height;
}

HeightMap selfAffineMap(const ScanSize& size, const SelfAffine& recipe) {
    HeightMap map = flatMap(size);
    // Waves that fit the limits but for rounding belong to them.
    constexpr double kRounding = 1e-12;
    const double lowest = 2.0 * std::numbers::pi / recipe.longestWave * (1.0 - kRounding);
    const double rollOff = 2.0 * std::numbers::pi / recipe.rollOffWave;
    const double highest = 2.0 * std::numbers::pi / recipe.shortestWave * (1.0 + kRounding);
    Random random(recipe.seed);
    Spectrum spectrum(size);
    spectrum.fill(random, [&](double q) {
        if (q < lowest || q > highest) {
            return 0.0;
        }
        return q < rollOff ? 1.0 : std::pow(q / rollOff, -(1.0 + recipe.hurst));
    });
    spectrum.scaleToRms(recipe.rms);
    map.heights = spectrum.values();
    return map;
}

Spherulites::Spherulites(const Recipe& recipe, const ScanSize& size) : recipe_(recipe) {
    const bool lengthsArePositive = recipe.domeRadius > 0.0 && recipe.bandPeriod > 0.0 &&
                                    recipe.fibrilLength > 0.0 && recipe.grooveWidth > 0.0;
    if (recipe.nuclei < 1 || recipe.fibrils < 1 || !lengthsArePositive) {
        throw Error("spherulites need a nucleus, a fibril and positive lengths");
    }
    Random random(recipe.seed);
    for (int i = 0; i < recipe.nuclei; ++i) {
        Nucleus nucleus;
        nucleus.x = random.uniform(0.0, size.sizeX);
        nucleus.y = random.uniform(0.0, size.sizeY);
        nucleus.headStart = random.uniform(0.0, recipe.growthHeadStart);
        nuclei_.push_back(nucleus);
    }
}

double Spherulites::height(double x, double y) const {
    Arrival first = arrivalFrom(nuclei_.front(), x, y);
    Arrival second = first;  // a lone spherulite meets no other
    second.time = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < nuclei_.size(); ++i) {
        const Arrival arrival = arrivalFrom(nuclei_[i], x, y);
        if (arrival.time < first.time) {
            second = first;
            first = arrival;
        } else if (arrival.time < second.time) {
            second = arrival;
        }
    }
    const double own = heightWithin(first, x, y);
    // Half the lead in arrival is about the distance to the line where the two met.
    const double fromBoundary = 0.5 * (second.time - first.time);
    const double share = 0.5 + 0.5 * smoothStep(fromBoundary / recipe_.grooveWidth);
    const double depth = fromBoundary / recipe_.grooveWidth;
    return share * own + (1.0 - share) * heightWithin(second, x, y) -
           recipe_.grooveDepth * std::exp(-depth * depth);
}

Spherulites::Arrival Spherulites::arrivalFrom(const Nucleus& nucleus, double x, double y) {
    const double radius = std::hypot(x - nucleus.x, y - nucleus.y);
    return {.nucleus = &nucleus, .radius = radius, .time = radius - nucleus.headStart};
}

double Spherulites::heightWithin(const Arrival& arrival, double x, double y) const {
    const double turn = std::atan2(y - arrival.nucleus->y, x - arrival.nucleus->x);
    const double toEdge = std::max(1.0 - arrival.radius / recipe_.domeRadius, 0.0);
    const double bandPhase = 2.0 * std::numbers::pi * arrival.radius / recipe_.bandPeriod +
                             recipe_.bandWaviness * std::cos(recipe_.bandLobes * turn);
    // Near the nucleus the angle changes too fast for any pixel to follow.
    const double unfolded = smoothStep(arrival.radius / recipe_.bandPeriod);
    return recipe_.domeHeight * toEdge * toEdge +
           unfolded * (recipe_.bandHeight * std::cos(bandPhase) +
                       recipe_.fibrilHeight * fibrilNoise(*arrival.nucleus, arrival.radius, turn));
}

/// Smooth noise on a lattice of radius and angle: long along the radius, narrow across it.
double Spherulites::fibrilNoise(const Nucleus& nucleus, double radius, double turn) const {
    const double along = radius / recipe_.fibrilLength;
    const double around = (turn / (2.0 * std::numbers::pi) + 0.5) * recipe_.fibrils;
    const int ring = static_cast<int>(along);
    const int fibril = std::min(static_cast<int>(around), recipe_.fibrils - 1);
    const int next = (fibril + 1) % recipe_.fibrils;
    const std::uint64_t seed =
        recipe_.seed + 0x10000U * static_cast<std::uint64_t>(&nucleus - nuclei_.data() + 1);
    const double s = smoothStep(along - ring);
    const double t = smoothStep(around - fibril);
    return std::lerp(
        std::lerp(latticeValue(seed, ring, fibril), latticeValue(seed, ring + 1, fibril), s),
        std::lerp(latticeValue(seed, ring, next), latticeValue(seed, ring + 1, next), s), t);
}

}  // namespace asperity
