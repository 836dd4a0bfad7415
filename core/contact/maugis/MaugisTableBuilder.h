#pragma once

#include "core/contact/maugis/MaugisDugdale.h"
#include "core/contact/maugis/MaugisTableData.h"
#include "core/contact/numerics/ChebyshevFit.h"

#include <cstddef>
#include <vector>

namespace asperity {

/// Fills a table from exact solutions and measures what it gets wrong between them.
class MaugisTableBuilder {
public:
    /// @throw Error as MaugisTable
    explicit MaugisTableBuilder(const MaugisTableRange& range);

    [[nodiscard]] MaugisTableData build();

private:
    struct Sample {
        double row;  ///< place in its row of cells
        MaugisDugdale law;
        double coordinate = 0.0;  ///< of the state solved last
    };

    [[nodiscard]] std::vector<Sample> samplesOf(std::size_t row,
                                                const std::vector<double>& places) const;
    [[nodiscard]] MaugisTableData::Quantities solve(Sample& sample, double root, bool fold) const;
    void fit(std::size_t row, std::size_t column, std::vector<Sample>& samples);
    [[nodiscard]] double measure(std::size_t row, std::size_t column,
                                 std::vector<Sample>& samples) const;

    MaugisTableData data_;
    ChebyshevFit columnFit_;
    ChebyshevFit rowFit_;
};

}  // namespace asperity
