#pragma once

#include "core/contact/numerics/GradedCells.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace asperity {

/// What a table has to cover; lambdaLow == lambdaHigh (one radius of curvature) makes it small.
struct MaugisTableRange {
    double lambdaLow = 0.0;           ///< transition parameter
    double lambdaHigh = 0.0;          ///< at least lambdaLow
    double largestIndentation = 0.0;  ///< in the units of MaugisPoint

    // What a table can cover.
    static constexpr double kMinLambda = 1e-4;
    static constexpr double kMaxLambda = 1e4;
    static constexpr double kMaxSpan = 5.0;         ///< of lambda
    static constexpr double kMaxIndentation = 1e6;  ///< in the units of MaugisPoint

    bool operator==(const MaugisTableRange&) const = default;
};

/// Force, contact radius, cohesive radius and stiffness (times the root where there is a fold), in
/// the units of MaugisPoint, as polynomials in rectangular cells: columns over the root of the
/// indentation above the lowest with contact, rows over the transition parameter.
struct MaugisTableData {
    using Quantities = std::array<double, 4>;

    static constexpr std::size_t kQuantities = 4;
    static constexpr std::size_t kColumnTerms = 6;  ///< of a polynomial in the root
    static constexpr std::size_t kRowTerms = 5;     ///< of one in the transition parameter
    static constexpr GradedCells kColumns{4};       ///< on kNear + root
    static constexpr GradedCells kRows{5};          ///< on lambda / kLambdaOfChange
    static constexpr double kNear = 0.25;  ///< up to such a root all columns are equally wide
    static constexpr std::int64_t kFirstColumn = kColumns.cellOf(kNear);
    /// Below this lambda first touch is stable in displacement control, above it there is a fold:
    /// no row may straddle it. Source: docs/theory.md 2.5.
    static constexpr double kLambdaOfChange = 0.93794745698549567;

    double lambdaLow = 0.0;
    double lambdaHigh = 0.0;
    double largestRoot = 0.0;
    std::int64_t firstRow = 0;
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::size_t rowTerms = 1;
    double errorBound = 0.0;
    std::vector<double> coefficients;    ///< by cell, power of root, power of lambda, quantity
    std::vector<std::uint8_t> accurate;  ///< by cell; 0: the exact law has to answer

    /// Whether the stiffness of a row is stored times the root: it is singular at the fold.
    [[nodiscard]] bool hasFold(std::size_t row) const noexcept {
        return firstRow + static_cast<std::int64_t>(row) >= kRows.cellOf(1.0);
    }

    /// The polynomials of a cell at a place in it.
    [[nodiscard]] Quantities evaluate(std::size_t cell, double column, double row) const noexcept {
        return rowTerms == 1 ? sum<1>(cell, column, row) : sum<kRowTerms>(cell, column, row);
    }

private:
    /// Pairs, because every processor adds and multiplies those at once.
    using Pair = double __attribute__((vector_size(16)));

    struct Pairs {
        Pair first;
        Pair second;
    };

    [[nodiscard]] static Pairs load(const double* at) noexcept {
        return {.first = Pair{at[0], at[1]}, .second = Pair{at[2], at[3]}};
    }

    /// Polynomial in lambda whose highest coefficients end before `end`.
    template <std::size_t RowTerms>
    [[nodiscard]] static Pairs alongRow(const double* end, double row) noexcept {
        Pairs total = load(end - kQuantities);
        for (std::size_t i = 2; i <= RowTerms; ++i) {
            const Pairs next = load(end - (i * kQuantities));
            total = {.first = (total.first * row) + next.first,
                     .second = (total.second * row) + next.second};
        }
        return total;
    }

    template <std::size_t RowTerms>
    [[nodiscard]] Quantities sum(std::size_t cell, double column, double row) const noexcept {
        constexpr std::size_t kStride = RowTerms * kQuantities;
        const double* end = coefficients.data() + ((cell + 1) * kColumnTerms * kStride);
        Pairs total = alongRow<RowTerms>(end, row);
        for (std::size_t j = 1; j < kColumnTerms; ++j) {
            const Pairs next = alongRow<RowTerms>(end - (j * kStride), row);
            total = {.first = (total.first * column) + next.first,
                     .second = (total.second * column) + next.second};
        }
        return {total.first[0], total.first[1], total.second[0], total.second[1]};
    }
};

}  // namespace asperity
