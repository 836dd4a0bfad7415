#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace asperity {

/// Polynomials of degree `terms` - 1 through values at the Chebyshev nodes of -1 .. 1. Not for the
/// real-time path.
class ChebyshevFit {
public:
    explicit ChebyshevFit(std::size_t terms) : powers_(terms, std::vector<double>(terms, 0.0)) {
        const auto count = static_cast<double>(terms);
        for (std::size_t node = 0; node < terms; ++node) {
            const double angle = std::numbers::pi * (static_cast<double>(node) + 0.5) / count;
            nodes_.push_back(-std::cos(angle));
        }
        std::vector<double> before(terms, 0.0);
        std::vector<double> polynomial(terms, 0.0);
        polynomial[0] = 1.0;
        for (std::size_t degree = 0; degree < terms; ++degree) {
            addPolynomial(polynomial, degree);
            before.swap(polynomial);  // T_n+1 = 2 x T_n - T_n-1, T_1 = x
            for (std::size_t i = 0; i < terms; ++i) {
                const double shifted = i > 0 ? before[i - 1] : 0.0;
                polynomial[i] = degree == 0 ? shifted : (2.0 * shifted) - polynomial[i];
            }
        }
    }

    [[nodiscard]] const std::vector<double>& nodes() const noexcept { return nodes_; }
    /// Contribution of the value at a node to the coefficient of a power.
    [[nodiscard]] double weight(std::size_t power, std::size_t node) const noexcept {
        return powers_[power][node];
    }
    /// Returns where the error of such a polynomial is largest: between the nodes and at both ends.
    [[nodiscard]] std::vector<double> worstPositions() const {
        std::vector<double> positions;
        for (std::size_t i = 0; i <= nodes_.size(); ++i) {
            const double angle =
                std::numbers::pi * static_cast<double>(i) / static_cast<double>(nodes_.size());
            positions.push_back(-std::cos(angle));
        }
        return positions;
    }

private:
    void addPolynomial(const std::vector<double>& polynomial, std::size_t degree) {
        const double norm = (degree == 0 ? 1.0 : 2.0) / static_cast<double>(nodes_.size());
        for (std::size_t node = 0; node < nodes_.size(); ++node) {
            const double angle = std::acos(nodes_[node]) * static_cast<double>(degree);
            for (std::size_t power = 0; power < nodes_.size(); ++power) {
                powers_[power][node] += norm * std::cos(angle) * polynomial[power];
            }
        }
    }

    std::vector<double> nodes_;
    std::vector<std::vector<double>> powers_;
};

}  // namespace asperity
