#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace asperity {

/// Returns the weights from the samples of a line of pixels to the control heights of its spline,
/// by definition, one row of weights a control height: (samples + 2) x samples, the padding first
/// and last.
///
/// First a Gaussian low-pass with a standard deviation of `sigma` (halfGaussian(), and
/// reflectedSample() beyond the ends): a straight line comes back unchanged. Then the cubic spline
/// through the smoothed samples whose end spans are quadratics: without smoothing a quadratic comes
/// back unchanged.
/// @param sigma [pixel]
/// @throw Error when there is no sample or sigma is not in 0..kMaxSmoothing
[[nodiscard]] std::vector<double> lineFitWeights(int samples, double sigma);

/// The same as a convolution with border rules, for lines of any length.
///
/// Smoothing and spline are both convolutions away from the ends of a line, so one kernel does
/// both; control heights near an end have weights of their own. Weights that add up to less than
/// kNeglected are left out: below the rounding of a height.
/// @tparam Height float or double, what heights are computed in
template <class Height>
class BasicLineFit {
public:
    static constexpr double kNeglected = std::numeric_limits<Height>::epsilon() / 8.0;

    /// @param sigma [pixel]
    /// @throw Error when there is no sample or sigma is not in 0..kMaxSmoothing
    BasicLineFit(int samples, double sigma);

    [[nodiscard]] int samples() const { return samples_; }
    [[nodiscard]] int controls() const { return samples_ + 2; }

    /// Weights of the samples at distance 1, 2, .. on either side of the middle one; that one has
    /// what is missing from a sum of 1.
    [[nodiscard]] const std::vector<Height>& kernel() const { return kernel_; }
    [[nodiscard]] int reach() const { return static_cast<int>(kernel_.size()); }

    /// Number of control heights at the first end, the padding among them, that do not follow the
    /// kernel. As many do not at the last end, in mirror image, unless this is controls(): all of
    /// them.
    [[nodiscard]] int border() const { return border_; }
    /// Number of samples from the end that shape them.
    [[nodiscard]] int span() const { return span_; }
    /// Weights of sample 0..span()-1 for control height `index` < border(), counted from the end.
    [[nodiscard]] const double* borderWeights(int index) const {
        return borderWeights_.data() +
               static_cast<std::size_t>(index) * static_cast<std::size_t>(span_);
    }
    [[nodiscard]] bool isAllBorder() const { return border_ == controls(); }

private:
    int samples_;
    int border_ = 0;
    int span_ = 0;
    std::vector<Height> kernel_;
    std::vector<double> borderWeights_;  ///< border x span
};

using LineFit = BasicLineFit<float>;
using FineLineFit = BasicLineFit<double>;

}  // namespace asperity
