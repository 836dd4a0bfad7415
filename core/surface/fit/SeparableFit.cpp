#include "core/surface/fit/SeparableFit.h"

#include "core/Simd.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <thread>
#include <vector>

// The fit's inner loops, compiled once for any processor and once for AVX2 from the same source:
// the same sums in the same order, so that a scan gives the same bits on both.

// Vectors that are wider than the baseline's registers never leave these inlined functions.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace asperity {

namespace {

/// Columns that are worked on together: the rows between the two line fits then stay in the
/// nearest cache.
constexpr std::ptrdiff_t kStrip = 512;

/// Eight or four heights at once; two registers where the processor has only SSE2.
template <class Height>
struct LanesOf;
template <>
struct LanesOf<float> {
    using Type = float __attribute__((vector_size(32)));
};
template <>
struct LanesOf<double> {
    using Type = double __attribute__((vector_size(32)));
};
template <class Height>
using Lanes = typename LanesOf<Height>::Type;
template <class Height>
constexpr std::ptrdiff_t kHeightLanes = sizeof(Lanes<Height>) / sizeof(Height);

template <class Height>
ASPERITY_INLINE Lanes<Height> load(const Height* from) {
    Lanes<Height> lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

template <class Height>
ASPERITY_INLINE void store(Height* to, const Lanes<Height>& lanes) {
    std::memcpy(to, &lanes, sizeof lanes);
}

template <class Height>
struct Job {
    const Height* heights;  ///< of the map, top row first
    const BasicLineFit<Height>& alongX;
    const BasicLineFit<Height>& alongY;
    Height* controls;

    /// Heights of a row of pixels, counted from the bottom.
    [[nodiscard]] const Height* samples(std::ptrdiff_t row) const {
        return heights + (alongY.samples() - 1 - row) * alongX.samples();
    }
};

/// The columns of control heights that belong to one strip.
struct Strip {
    std::ptrdiff_t first = 0;
    std::ptrdiff_t count = 0;
};

/// Rows of one strip after the fit along x, the newest `capacity` of them.
template <class Height>
class Ring {
public:
    explicit Ring(std::ptrdiff_t capacity)
        : capacity_(capacity), values_(static_cast<std::size_t>(capacity * kStrip), Height{}) {}

    [[nodiscard]] Height* row(std::ptrdiff_t index) {
        return values_.data() + index % capacity_ * kStrip;
    }

private:
    std::ptrdiff_t capacity_;
    std::vector<Height> values_;
};

/// Memory of one thread.
template <class Height>
struct Scratch {
    explicit Scratch(const BasicLineFit<Height>& alongY)
        : ring(alongY.span())
        , window(2 * static_cast<std::size_t>(alongY.reach()) + 1)
        , sums(static_cast<std::size_t>(kStrip)) {}

    Ring<Height> ring;
    std::vector<const Height*> window;
    std::vector<double> sums;
};

/// Convolution with the kernel around the height at(0), as what the neighbors' distances from it
/// add to it: rounding then follows the roughness of the scan, not its height, and a plane comes
/// back as it was.
template <class Height, class At>
ASPERITY_INLINE Lanes<Height> convolved(const std::vector<Height>& kernel, const At& at) {
    const Lanes<Height> middle = at(0);
    Lanes<Height> sum{};
    // The small weights first: their rounding is the smallest.
    for (std::ptrdiff_t k = std::ssize(kernel); k > 0; --k) {
        sum += kernel[static_cast<std::size_t>(k - 1)] * ((at(k) - middle) + (at(-k) - middle));
    }
    return middle + sum;
}

/// Control heights `begin`..`end` of a line, none of them in its borders, to out[0]...
template <class Height>
ASPERITY_INLINE void convolveRow(const BasicLineFit<Height>& fit, const Height* samples,
                                 std::ptrdiff_t begin, std::ptrdiff_t end, Height* out) {
    constexpr std::ptrdiff_t kStep = kHeightLanes<Height>;
    const std::vector<Height>& kernel = fit.kernel();
    for (std::ptrdiff_t control = begin; control < end; control += kStep) {
        // The last step starts early rather than end late.
        const std::ptrdiff_t start =
            std::min(control, std::max<std::ptrdiff_t>(end - kStep, fit.border()));
        const Height* center = samples + start - 1;
        const Lanes<Height> lanes =
            convolved(kernel, [center](std::ptrdiff_t k) { return load(center + k); });
        if (start >= begin && start + kStep <= end) {
            store(out + (start - begin), lanes);
            continue;
        }
        for (std::ptrdiff_t i = std::max(begin, start); i < std::min(end, start + kStep); ++i) {
            out[i - begin] = lanes[i - start];
        }
    }
}

/// Control heights `begin`..`end` of a line's first border, or of its last: `step` is then -1 and
/// `samples` points at the last sample.
template <class Height>
ASPERITY_INLINE void fitBorder(const BasicLineFit<Height>& fit, const Height* samples,
                               std::ptrdiff_t step, Strip controls, Height* out) {
    for (std::ptrdiff_t i = 0; i < controls.count; ++i) {
        const double* weights = fit.borderWeights(static_cast<int>(controls.first + i));
        double sum = 0.0;
        for (std::ptrdiff_t j = 0; j < fit.span(); ++j) {
            sum += weights[j] * static_cast<double>(samples[step * j]);
        }
        out[step * i] = static_cast<Height>(sum);
    }
}

/// The strip's part of one row of pixels, fitted along x.
template <class Height>
ASPERITY_INLINE void fitAlongX(const BasicLineFit<Height>& fit, const Height* samples,
                               const Strip& strip, Height* out) {
    const std::ptrdiff_t end = strip.first + strip.count;
    const std::ptrdiff_t border = fit.border();
    const std::ptrdiff_t lastBorder = fit.isAllBorder() ? border : fit.controls() - border;
    if (strip.first < border) {
        fitBorder(fit, samples, 1, {strip.first, std::min(end, border) - strip.first}, out);
    }
    const std::ptrdiff_t begin = std::max(strip.first, border);
    if (begin < std::min(end, lastBorder)) {
        convolveRow(fit, samples, begin, std::min(end, lastBorder), out + (begin - strip.first));
    }
    if (!fit.isAllBorder() && end > lastBorder) {
        const std::ptrdiff_t first = std::max(strip.first, lastBorder);
        fitBorder(fit, samples + fit.samples() - 1, -1, {fit.controls() - end, end - first},
                  out + (end - 1 - strip.first));
    }
}

/// One row of control heights from rows that follow the kernel.
template <class Height>
ASPERITY_INLINE void convolveRows(const std::vector<Height>& kernel, const Height* const* middle,
                                  std::ptrdiff_t count, Height* out) {
    for (std::ptrdiff_t x = 0; x < count; x += kHeightLanes<Height>) {
        const Lanes<Height> lanes =
            convolved(kernel, [middle, x](std::ptrdiff_t k) { return load(middle[k] + x); });
        if (x + kHeightLanes<Height> <= count) {
            store(out + x, lanes);
        } else {
            std::memcpy(out + x, &lanes, static_cast<std::size_t>(count - x) * sizeof(Height));
        }
    }
}

/// One row of control heights in a border; `index` counts from there.
template <class Height>
ASPERITY_INLINE void fitBorderRow(const Job<Height>& job, std::ptrdiff_t index, bool atEnd,
                                  std::ptrdiff_t count, Scratch<Height>& scratch, Height* out) {
    const BasicLineFit<Height>& fit = job.alongY;
    const double* weights = fit.borderWeights(static_cast<int>(index));
    std::fill_n(scratch.sums.begin(), count, 0.0);
    double* sums = scratch.sums.data();
    for (std::ptrdiff_t j = 0; j < fit.span(); ++j) {
        const Height* row = scratch.ring.row(atEnd ? fit.samples() - 1 - j : j);
        for (std::ptrdiff_t x = 0; x < count; ++x) {
            sums[x] += weights[j] * static_cast<double>(row[x]);
        }
    }
    for (std::ptrdiff_t x = 0; x < count; ++x) {
        out[x] = static_cast<Height>(sums[x]);
    }
}

/// Fits rows of pixels along x up to `end`.
template <class Height>
ASPERITY_INLINE void fitRows(const Job<Height>& job, const Strip& strip, std::ptrdiff_t end,
                             std::ptrdiff_t& fitted, Ring<Height>& ring) {
    for (; fitted < end; ++fitted) {
        fitAlongX(job.alongX, job.samples(fitted), strip, ring.row(fitted));
    }
}

template <class Height>
ASPERITY_INLINE void fitStrip(const Job<Height>& job, const Strip& strip,
                              Scratch<Height>& scratch) {
    const BasicLineFit<Height>& fit = job.alongY;
    const std::ptrdiff_t stride = job.alongX.controls();
    std::ptrdiff_t fitted = 0;  // rows of pixels so far
    for (std::ptrdiff_t control = 0; control < fit.controls(); ++control) {
        Height* out = job.controls + control * stride + strip.first;
        const std::ptrdiff_t fromEnd = fit.controls() - 1 - control;
        const bool isInside = control >= fit.border() && fromEnd >= fit.border();
        const bool atEnd = !isInside && control >= fit.border();
        const std::ptrdiff_t firstBorder = atEnd ? fit.samples() : fit.span();
        fitRows(job, strip, isInside ? control + fit.reach() : firstBorder, fitted, scratch.ring);
        if (!isInside) {
            fitBorderRow(job, atEnd ? fromEnd : control, atEnd, strip.count, scratch, out);
            continue;
        }
        const std::ptrdiff_t first = control - 1 - fit.reach();
        for (std::size_t i = 0; i < scratch.window.size(); ++i) {
            scratch.window[i] = scratch.ring.row(first + static_cast<std::ptrdiff_t>(i));
        }
        convolveRows(fit.kernel(), scratch.window.data() + fit.reach(), strip.count, out);
    }
}

void fitStripBaseline(const Job<float>& job, const Strip& strip, Scratch<float>& scratch) {
    fitStrip(job, strip, scratch);
}
void fitStripBaseline(const Job<double>& job, const Strip& strip, Scratch<double>& scratch) {
    fitStrip(job, strip, scratch);
}

#ifdef __x86_64__
[[gnu::target("avx2")]] void fitStripAvx2(const Job<float>& job, const Strip& strip,
                                          Scratch<float>& scratch) {
    fitStrip(job, strip, scratch);
}
[[gnu::target("avx2")]] void fitStripAvx2(const Job<double>& job, const Strip& strip,
                                          Scratch<double>& scratch) {
    fitStrip(job, strip, scratch);
}
#endif

template <class Height>
void fitStripWith(VectorUnit unit, const Job<Height>& job, const Strip& strip,
                  Scratch<Height>& scratch) {
#ifdef __x86_64__
    if (unit == VectorUnit::Avx2) {
        fitStripAvx2(job, strip, scratch);
        return;
    }
#endif
    (void)unit;
    fitStripBaseline(job, strip, scratch);
}

template <class Height>
PixelVector<Height> fitted(const Height* heights, const BasicLineFit<Height>& alongX,
                           const BasicLineFit<Height>& alongY, Progress* progress,
                           const FitResources& resources) {
    const std::ptrdiff_t columns = alongX.controls();
    PixelVector<Height> controls(static_cast<std::size_t>(columns) *
                                 static_cast<std::size_t>(alongY.controls()));
    const Job<Height> job{heights, alongX, alongY, controls.data()};
    const std::ptrdiff_t strips = (columns + kStrip - 1) / kStrip;
    std::atomic<std::ptrdiff_t> next = 0;
    const auto fitNext = [&](Scratch<Height>& scratch) {
        const std::ptrdiff_t first = next++ * kStrip;
        if (first >= columns) {
            return false;
        }
        const Strip strip{first, std::min(kStrip, columns - first)};
        fitStripWith(resources.unit, job, strip, scratch);
        return true;
    };
    std::vector<std::jthread> helpers;
    for (std::ptrdiff_t i = 1; i < std::min<std::ptrdiff_t>(resources.threads, strips); ++i) {
        helpers.emplace_back([&](const std::stop_token& stop) {
            Scratch<Height> scratch(alongY);
            while (!stop.stop_requested() && fitNext(scratch)) {
            }
        });
    }
    Scratch<Height> scratch(alongY);
    while (fitNext(scratch)) {
        const auto begun = std::min<std::ptrdiff_t>(next, strips);
        reportTo(progress, static_cast<double>(begun) / static_cast<double>(strips + 1));
    }
    helpers.clear();  // waits for them
    reportTo(progress, 1.0);
    return controls;
}

}  // namespace

VectorUnit widestVectorUnit() {
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx2") != 0) {
        return VectorUnit::Avx2;
    }
#endif
    return VectorUnit::Baseline;
}

PixelVector<float> separableFit(const ScanMap& map, const LineFit& alongX, const LineFit& alongY,
                                Progress* progress, const FitResources& resources) {
    return fitted(map.heights.data(), alongX, alongY, progress, resources);
}

PixelVector<double> separableFit(const HeightMap& map, const FineLineFit& alongX,
                                 const FineLineFit& alongY, Progress* progress,
                                 const FitResources& resources) {
    return fitted(map.heights.data(), alongX, alongY, progress, resources);
}

}  // namespace asperity
