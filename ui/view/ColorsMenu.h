#pragma once

#include "ui/view/ColorScale.h"

#include <QObject>
#include <QStringList>

#include <array>
#include <map>

class QAction;
class QActionGroup;
class QMenu;

namespace asperity {

/// Menu entries that choose how the surface is colored: by which quantity, with which colors and
/// over which range.
class ColorsMenu : public QObject {
    Q_OBJECT

public:
    /// Adds its entries to the menu, which owns it.
    explicit ColorsMenu(QMenu& menu);

    /// Returns the menu, to be opened elsewhere.
    [[nodiscard]] QMenu& menu() const { return menu_; }
    [[nodiscard]] const SurfaceLook& look() const { return look_; }
    /// Shows a look without asking for it.
    void setLook(const SurfaceLook& look);
    /// Shows a look and asks for it.
    void choose(const SurfaceLook& look);
    /// Other images of the file with the same pixels.
    void setChannels(const QStringList& names);
    /// Disables a quantity that cannot be shown. @param reason that its tool tip says; empty: it
    /// can
    void refuse(SurfaceQuantity quantity, const QString& reason);
    /// The unit that an own range of a channel is typed in, and what ranges are shown now.
    void setShown(const QString& unit, double low, double high);

Q_SIGNALS:
    void lookChosen(const asperity::SurfaceLook& look);

private:
    void addQuantities();
    void addMaps();
    void addRanges();
    void askForRange();
    void show();
    [[nodiscard]] QuantityColors& present() { return look_.of(look_.quantity); }

    QMenu& menu_;
    SurfaceLook look_;
    std::map<SurfaceQuantity, QAction*> quantities_;
    std::map<ColorMap, QAction*> maps_;
    std::map<RangeRule, QAction*> rules_;
    QAction* pin_ = nullptr;
    QMenu* channels_ = nullptr;
    QActionGroup* quantityGroup_ = nullptr;
    QStringList channelNames_;
    QString shownUnit_;
    double shownLow_ = 0.0;   ///< [shownUnit_]
    double shownHigh_ = 1.0;  ///< [shownUnit_]
};

}  // namespace asperity
