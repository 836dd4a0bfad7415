#pragma once

#include "core/curves/MeasuredForceCurve.h"
#include "core/io/curves/CurveColumns.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// What a user says about a file of curves in place of what it says itself.
struct CurveReadOptions {
    std::string height;                ///< channel of the base; empty: the best that the file has
    std::vector<GivenColumn> columns;  ///< of a text table; empty: as its line of titles says
    int skippedLines = 0;              ///< of a text table, before its titles or its first row
};

/// One curve, and what else its file says about it.
struct CurveContents {
    MeasuredForceCurve curve;
    std::string heightChannel;         ///< that the base was read from; empty: the file names none
    std::vector<std::string> heights;  ///< all channels that may be the base, the best one first
    std::vector<std::string> notes;    ///< what was left out or assumed
};

/// A position in the instrument's frame [m].
struct CurvePosition {
    double x = 0.0;
    double y = 0.0;
};

/// Size of the grid that the curves of a map lie on; 0: they lie on none.
struct CurveGrid {
    int columns = 0;
    int rows = 0;
};

/// Place of a curve in the grid of its map; row 0 is the bottom one.
struct CurveCell {
    int column = 0;
    int row = 0;
};

/// Curves that still lie in their file, each of which is read when it is asked for. Any threads.
class StoredCurves {
public:
    StoredCurves() = default;
    StoredCurves(const StoredCurves&) = delete;
    StoredCurves& operator=(const StoredCurves&) = delete;
    virtual ~StoredCurves() = default;

    [[nodiscard]] virtual std::size_t count() const = 0;
    /// @param index below count() @throw InputError when it is damaged or does not fit together
    [[nodiscard]] virtual CurveContents read(std::size_t index) const = 0;
    /// Empty: the file does not say it.
    [[nodiscard]] virtual std::optional<CurvePosition> position(std::size_t /*index*/) const {
        return std::nullopt;
    }
    [[nodiscard]] virtual CurveGrid grid() const { return {}; }
    /// Empty: the curves lie on no grid.
    [[nodiscard]] virtual std::optional<CurveCell> cell(std::size_t /*index*/) const {
        return std::nullopt;
    }
    /// Returns whether the file holds an image, too.
    [[nodiscard]] virtual bool hasImage() const { return false; }
    /// Notes on the file as a whole.
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

protected:
    std::vector<std::string> notes_;
};

}  // namespace asperity
