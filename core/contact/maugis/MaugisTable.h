#pragma once

#include "core/contact/maugis/MaugisDugdale.h"
#include "core/contact/maugis/MaugisTableData.h"

#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>

namespace asperity {

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
    /// What the table says, accurate or not.
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
        cell, Data::kColumns.placeOf(Data::kNear + root), Data::kRows.placeOf(ratio));
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

}  // namespace asperity
