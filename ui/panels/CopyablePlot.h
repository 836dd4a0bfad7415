#pragma once

// Compiled as C++17 too: Qwt's headers are not C++20.
#include "ui/InputHelp.h"
#include "ui/panels/PlotTable.h"

#include <QObject>
#include <QPoint>

#include <functional>
#include <optional>

class QImage;
class QWidget;

namespace asperity {

/// Lets a user copy a plot: its context menu has "Copy picture", and "Copy data" where there are
/// numbers. It opens at a click, so that a drag with the same button can do something else. Lives
/// as long as the plot.
class CopyablePlot : public QObject {
    Q_OBJECT

public:
    using Numbers = std::function<PlotTable()>;

    /// @param numbers what the plot shows now; null: it is a picture only
    explicit CopyablePlot(QWidget& plot, Numbers numbers = nullptr);

    /// What the mouse does to it.
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
    void showMenu(const QPoint& place);

    std::optional<QPoint> pressed_;  ///< where the right button went down, while it is [screen]
    QWidget& plot_;
    Numbers numbers_;
};

}  // namespace asperity
