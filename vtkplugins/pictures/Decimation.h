#pragma once

#include <cstddef>
#include <vector>

namespace asperity {

/// Samples of a curve, one x for each y.
struct Series {
    std::vector<double> x;
    std::vector<double> y;
};

/// The series thinned for drawing: of each of `buckets` equal runs of samples the first, the
/// lowest, the highest and the last stay, in their order. Short series stay as they are.
[[nodiscard]] Series decimateMinMax(const Series& series, std::size_t buckets);

}  // namespace asperity
