#pragma once

#include "ui/widgets/InputHelp.h"

#include <QObject>
#include <QPoint>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>
#include <vector>

// Compiled as C++17 too: Qwt's headers are not C++20.
class QImage;
class QWidget;

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

/// Lets a user copy a plot: its context menu has "Copy picture", and "Copy data" where there are
/// numbers. It opens at a click, so that a drag with the same button can do something else. Lives
/// as long as the plot.
class CopyablePlot : public QObject {
    Q_OBJECT

public:
    using Numbers = std::function<PlotTable()>;

    /// @param numbers what the plot shows now; null: it is a picture only
    explicit CopyablePlot(QWidget& plot, Numbers numbers = nullptr);

    /// Returns what the mouse does on the plot, for help.
    [[nodiscard]] static InputHelps help();
    /// The plot that a widget is, or is part of; null: none.
    [[nodiscard]] static CopyablePlot* of(QWidget* widget);

    [[nodiscard]] QWidget& plot() const { return plot_; }
    /// As it is on the screen, in the screen's pixels.
    [[nodiscard]] QImage picture() const;
    /// Tab-separated, with a line of headers; empty: it is a picture only.
    [[nodiscard]] QString data() const;

    void copyPicture() const;
    void copyData() const;
    /// Picture and data at once: each program takes what it can paste.
    void copy() const;

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void showMenu(const QPoint& position);

    std::optional<QPoint> pressed_;  ///< where the right button went down, while it is [screen]
    QWidget& plot_;
    Numbers numbers_;
};

}  // namespace asperity
