#include "core/surface/nurbs/SquaredDistanceNet.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr int kMaxProductDegree = 2 * kMaxDegree;
using Binomials = std::array<std::array<double, kMaxProductDegree + 1>, kMaxProductDegree + 1>;

constexpr Binomials kBinomials = [] {
    Binomials table{};
    for (std::size_t n = 0; n <= kMaxProductDegree; ++n) {
        table[n][0] = 1.0;
        for (std::size_t k = 1; k <= n; ++k) {
            table[n][k] = table[n - 1][k - 1] + (k < n ? table[n - 1][k] : 0.0);
        }
    }
    return table;
}();

double binomial(int n, int k) {
    return kBinomials[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)];
}

struct Range {
    double least = std::numeric_limits<double>::max();
    double most = std::numeric_limits<double>::lowest();

    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
};

}  // namespace

SquaredDistanceNet::SquaredDistanceNet(const BezierNet& net, double placeNoise) noexcept
    : degreeU_(2 * net.degreeU), degreeV_(2 * net.degreeV), leastWeight_(net.at(0, 0)[3]) {
    double greatest = 0.0;  // the farthest control point tells how large the products are
    double greatestWeight = 0.0;
    // The product of two Bernstein polynomials, the binomial factors taken out.
    std::array<HomogeneousPoint, BezierNet::kMaxPoints> scaled;
    for (int j = 0; j <= net.degreeV; ++j) {
        for (int i = 0; i <= net.degreeU; ++i) {
            greatest = std::max(greatest, net.at(i, j).head<3>().squaredNorm());
            leastWeight_ = std::min(leastWeight_, net.at(i, j)[3]);
            greatestWeight = std::max(greatestWeight, net.at(i, j)[3]);
            scaled[BezierNet::index(i, j)] =
                binomial(net.degreeU, i) * binomial(net.degreeV, j) * net.at(i, j);
        }
    }
    leastWeight_ *= leastWeight_;
    noise_ = 16.0 * std::numeric_limits<double>::epsilon() * greatest +
             4.0 * std::sqrt(greatest) * greatestWeight * placeNoise;
    for (int l = 0; l <= degreeV_; ++l) {
        for (int k = 0; k <= degreeU_; ++k) {
            Eigen::Vector4d sum = Eigen::Vector4d::Zero();
            for (int j = std::max(0, l - net.degreeV); j <= std::min(l, net.degreeV); ++j) {
                for (int i = std::max(0, k - net.degreeU); i <= std::min(k, net.degreeU); ++i) {
                    sum += scaled[BezierNet::index(i, j)].cwiseProduct(
                        scaled[BezierNet::index(k - i, l - j)]);
                }
            }
            const double share = 1.0 / (binomial(degreeU_, k) * binomial(degreeV_, l));
            distance_[index(k, l)] = share * (sum[0] + sum[1] + sum[2]);
            weight_[index(k, l)] = share * sum[3];
        }
    }
}

bool SquaredDistanceNet::isAtLeast(double square) const noexcept {
    for (int l = 0; l <= degreeV_; ++l) {
        for (int k = 0; k <= degreeU_; ++k) {
            if (distance_[index(k, l)] < square * weight_[index(k, l)] + noise_) {
                return false;
            }
        }
    }
    return true;
}

bool SquaredDistanceNet::isConvex(double square, double slack) const noexcept {
    Coefficients excess;
    for (int l = 0; l <= degreeV_; ++l) {
        for (int k = 0; k <= degreeU_; ++k) {
            excess[index(k, l)] = distance_[index(k, l)] - square * weight_[index(k, l)];
        }
    }
    // The coefficients of a derivative are differences of those of the function.
    Range uu;
    Range uv;
    Range vv;
    for (int l = 0; l <= degreeV_; ++l) {
        for (int k = 0; k <= degreeU_; ++k) {
            const double here = excess[index(k, l)];
            if (k + 2 <= degreeU_) {
                uu.add(here - 2.0 * excess[index(k + 1, l)] + excess[index(k + 2, l)]);
            }
            if (l + 2 <= degreeV_) {
                vv.add(here - 2.0 * excess[index(k, l + 1)] + excess[index(k, l + 2)]);
            }
            if (k < degreeU_ && l < degreeV_) {
                uv.add(here - excess[index(k + 1, l)] - excess[index(k, l + 1)] +
                       excess[index(k + 1, l + 1)]);
            }
        }
    }
    // Each difference has coefficients of a total weight of 4.
    const double noise = 4.0 * noise_;
    const double shift = slack * leastWeight_;
    const double leastU = degreeU_ * (degreeU_ - 1) * (uu.least - noise) + shift;
    const double leastV = degreeV_ * (degreeV_ - 1) * (vv.least - noise) + shift;
    const double mixed =
        degreeU_ * degreeV_ * (std::max(std::abs(uv.least), std::abs(uv.most)) + noise);
    return leastU > 0.0 && leastV > 0.0 && leastU * leastV > mixed * mixed;
}

}  // namespace asperity
