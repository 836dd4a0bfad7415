#include "core/identify/cycle/ContactSamples.h"

#include <algorithm>

namespace asperity {

namespace {

double meanOf(const std::vector<double>& values, std::size_t from, std::size_t to) {
    double sum = 0.0;
    for (std::size_t i = from; i < to; ++i) {
        sum += values[i];
    }
    return sum / static_cast<double>(to - from);
}

}  // namespace

ContactSamples binned(const CycleBranch& branch, std::size_t from, std::size_t to,
                      std::size_t bins) {
    const std::size_t count = std::min(bins, to - from);
    ContactSamples samples;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t begin = from + (i * (to - from) / count);
        const std::size_t end = from + ((i + 1) * (to - from) / count);
        samples.base.push_back(meanOf(branch.base, begin, end));
        samples.force.push_back(meanOf(branch.force, begin, end));
        if (!branch.time.empty()) {
            samples.time.push_back(meanOf(branch.time, begin, end));
        }
    }
    return samples;
}

double contactSlope(const ContactSamples& samples) {
    const auto [low, high] = std::minmax_element(samples.force.begin(), samples.force.end());
    const double half = std::max(0.5 * (*low + *high), 0.5 * *high);
    double count = 0.0;
    double base = 0.0;
    double force = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (samples.force[i] >= half) {
            count += 1.0;
            base += samples.base[i];
            force += samples.force[i];
        }
    }
    double square = 0.0;
    double product = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (samples.force[i] >= half) {
            const double offset = samples.base[i] - (base / count);
            square += offset * offset;
            product += offset * (samples.force[i] - (force / count));
        }
    }
    return product / square;
}

}  // namespace asperity
