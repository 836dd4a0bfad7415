#pragma once

// Compiled as C++17 too: Qwt's headers are not C++20.
#include <QString>
#include <QStringList>

#include <vector>

namespace asperity {

/// The numbers of a plot, as a table that spreadsheets and scripts read: SI units, decimal points.
class PlotTable {
public:
    /// @param header names quantity and unit: "Fz [N]"
    void add(const QString& header, const std::vector<double>& values);
    void add(const QString& header, const QStringList& cells);

    [[nodiscard]] bool isEmpty() const { return headers_.isEmpty(); }
    /// One line of headers, then one per row; a number that is not finite is an empty cell, and so
    /// is what a short column lacks.
    [[nodiscard]] QString tabSeparated() const;

private:
    QStringList headers_;
    std::vector<QStringList> columns_;
};

/// All digits of a number, with a decimal point in every language; empty: it is not finite.
[[nodiscard]] QString numberCell(double value);

}  // namespace asperity
