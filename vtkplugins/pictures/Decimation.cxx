#include "vtkplugins/pictures/Decimation.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace asperity {

Series decimateMinMax(const Series& series, std::size_t buckets) {
    constexpr std::size_t kKept = 4;  // first, lowest, highest, last
    const std::size_t count = series.y.size();
    if (buckets == 0 || count <= kKept * buckets) {
        return series;
    }
    Series thinned;
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
        const std::size_t begin = bucket * count / buckets;
        const std::size_t end = (bucket + 1) * count / buckets;
        const auto first = series.y.begin() + static_cast<std::ptrdiff_t>(begin);
        const auto last = series.y.begin() + static_cast<std::ptrdiff_t>(end);
        const auto [lowest, highest] = std::minmax_element(first, last);
        std::array<std::ptrdiff_t, kKept> kept{
            std::distance(series.y.begin(), first), std::distance(series.y.begin(), lowest),
            std::distance(series.y.begin(), highest), std::distance(series.y.begin(), last) - 1};
        std::sort(kept.begin(), kept.end());
        const auto keptEnd = std::unique(kept.begin(), kept.end());
        for (auto place = kept.begin(); place != keptEnd; ++place) {
            thinned.x.push_back(series.x[static_cast<std::size_t>(*place)]);
            thinned.y.push_back(series.y[static_cast<std::size_t>(*place)]);
        }
    }
    return thinned;
}

}  // namespace asperity
