#pragma once

#include "core/contact/maugis/MaugisDugdale.h"
#include "core/contact/numerics/ChebyshevFit.h"
#include "core/contact/numerics/GaussLegendre.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace asperity {

/// Range that a table has to cover; lambdaLow == lambdaHigh (one radius of curvature) makes it
/// small.
struct MaugisTableRange {
    double lambdaLow = 0.0;           ///< transition parameter
    double lambdaHigh = 0.0;          ///< at least lambdaLow
    double largestIndentation = 0.0;  ///< in the units of MaugisPoint

    // Limits of what a table can cover.
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

    /// Returns whether the stiffness of a row is stored times the root: it is singular at the fold.
    [[nodiscard]] bool hasFold(std::size_t row) const noexcept {
        return firstRow + static_cast<std::int64_t>(row) >= kRows.cellOf(1.0);
    }

    /// The polynomials of a cell at a position in it.
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

/// A stable state of the Maugis-Dugdale law in the units of MaugisPoint.
struct MaugisState {
    double indentation = 0.0;     ///< < 0: a gap
    double force = 0.0;           ///< > 0 repulsive
    double stiffness = 0.0;       ///< d force / d indentation; the lowest double at a fold
    double contactRadius = 0.0;   ///< 0: the cohesive zone has no contact in it
    double cohesiveRadius = 0.0;  ///< outer radius of the cohesive zone
};

/// Stable states with contact, tabulated over the transition parameter and the root of the
/// indentation above the lowest with contact, a fold or first touch: there nothing but the
/// indentation is singular. The error is measured at build. Folds, states without contact, what
/// lies outside the range and cells that did not come out accurate are left to the exact law, so
/// that the bound holds everywhere. Constant after construction; its use neither allocates nor
/// throws. Source: docs/theory.md 2.3-2.7.
class MaugisTable {
public:
    /// @throw Error when lambda is outside 1e-4 .. 1e4 or spans more than a factor of 5, or the
    ///        largest indentation is outside 0 .. 1e6
    explicit MaugisTable(const MaugisTableRange& range);

    /// Largest error of force, radii, indentation (and of the stiffness at a given indentation),
    /// each relative to its size or to one, whichever is larger.
    [[nodiscard]] double errorBound() const noexcept { return data_.errorBound; }
    /// Share of the cells that are left to the exact law.
    [[nodiscard]] double exactShare() const noexcept;
    [[nodiscard]] std::size_t bytes() const noexcept;

    /// The stable state at an indentation (finite); none below the fold of the law.
    [[nodiscard]] std::optional<MaugisState> at(const MaugisDugdale& law,
                                                double indentation) const noexcept;
    /// The stable state where indentation + compliance x force = value; none below the fold of the
    /// law on such a spring, nor for a value or a compliance >= 0 that is no number or beyond 1e40.
    /// `start` is an indentation near that of the state, such as the one before; any other only
    /// costs time.
    [[nodiscard]] std::optional<MaugisState> stable(const MaugisDugdale& law, double compliance,
                                                    double value, double start) const noexcept;

private:
    /// Entry of the table, accurate or not.
    struct Entry {
        MaugisState state;
        double root = 0.0;  ///< of the indentation above the lowest with contact
        bool accurate = false;
    };

    [[nodiscard]] std::optional<Entry> entry(const MaugisDugdale& law,
                                             double indentation) const noexcept;
    [[nodiscard]] std::optional<MaugisState> exactAt(const MaugisDugdale& law,
                                                     double indentation) const noexcept;

    MaugisTableData data_;
};

/// A table of this range, which takes some 0.2 s to build: the last few ranges asked for are kept,
/// since fitting a model goes back and forth between laws. For any thread.
/// @throw Error as MaugisTable
[[nodiscard]] std::shared_ptr<const MaugisTable> sharedMaugisTable(const MaugisTableRange& range);

// In the header because a look-up is so short that a caller should pay only for what it uses.

inline std::optional<MaugisTable::Entry> MaugisTable::entry(const MaugisDugdale& law,
                                                            double indentation) const noexcept {
    using Data = MaugisTableData;
    const double lambda = law.curve().lambda();
    const double square = indentation - law.lowestContact().indentation;
    if (!(lambda >= data_.lambdaLow && lambda <= data_.lambdaHigh && square > 0.0)) {
        return std::nullopt;
    }
    const double root = std::sqrt(square);
    if (root > data_.largestRoot) {
        return std::nullopt;
    }
    const double ratio = lambda * (1.0 / Data::kLambdaOfChange);
    const auto row = static_cast<std::size_t>(Data::kRows.cellOf(ratio) - data_.firstRow);
    const auto column =
        static_cast<std::size_t>(Data::kColumns.cellOf(Data::kNear + root) - Data::kFirstColumn);
    const std::size_t cell = (row * data_.columns) + column;
    const auto [force, contactRadius, cohesiveRadius, slope] = data_.evaluate(
        cell, Data::kColumns.positionOf(Data::kNear + root), Data::kRows.positionOf(ratio));
    return Entry{.state = {.indentation = indentation,
                           .force = force,
                           .stiffness = data_.hasFold(row) ? slope / root : slope,
                           .contactRadius = contactRadius,
                           .cohesiveRadius = cohesiveRadius},
                 .root = root,
                 .accurate = data_.accurate[cell] != 0};
}

inline std::optional<MaugisState> MaugisTable::at(const MaugisDugdale& law,
                                                  double indentation) const noexcept {
    const auto found = entry(law, indentation);
    return found && found->accurate ? std::optional(found->state) : exactAt(law, indentation);
}

/// Fills a table from exact solutions and measures what it gets wrong between them.
class MaugisTableBuilder {
public:
    /// @throw Error as MaugisTable
    explicit MaugisTableBuilder(const MaugisTableRange& range);

    [[nodiscard]] MaugisTableData build();

private:
    struct Sample {
        double row;  ///< position in its row of cells
        MaugisDugdale law;
        double coordinate = 0.0;  ///< of the state solved last
    };

    [[nodiscard]] std::vector<Sample> samplesOf(std::size_t row,
                                                const std::vector<double>& positions) const;
    [[nodiscard]] MaugisTableData::Quantities solve(Sample& sample, double root, bool fold) const;
    void fit(std::size_t row, std::size_t column, std::vector<Sample>& samples);
    [[nodiscard]] double measure(std::size_t row, std::size_t column,
                                 std::vector<Sample>& samples) const;

    MaugisTableData data_;
    ChebyshevFit columnFit_;
    ChebyshevFit rowFit_;
};

}  // namespace asperity
