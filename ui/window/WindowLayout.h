#pragma once

#include <QString>
#include <QWidget>

#include <functional>
#include <vector>

class QScrollArea;
class QSplitter;

namespace asperity {

class Card;
class CardColumn;
class Maximizer;
class PageTabs;
class ViewSide;

/// A part of the window that can be hidden and shown.
struct PanelSwitch {
    QString key;    ///< in the settings; stays the same
    QString title;  ///< in the menu
    int group;      ///< entries of a group stand together
    bool shownAtFirst;
    std::function<bool()> isShown;
    std::function<void(bool)> setShown;
    std::function<void()> toFront = [] {};  ///< of those that share a place
};

/// The middle of the window: controls on top; below them on the left the views over the tool pages,
/// on the right the side pages, whose first one, Live, is a column of cards. Splitters share out
/// the room.
class WindowLayout : public QWidget {
    Q_OBJECT

public:
    WindowLayout(QWidget* controls, ViewSide* viewSide, QWidget* parent = nullptr);

    [[nodiscard]] CardColumn& cards() { return *cards_; }
    void addCard(Card* card, int share);
    /// Below the views.
    [[nodiscard]] PageTabs& tools() { return *tools_; }
    /// Right of the views.
    [[nodiscard]] PageTabs& sidePages() { return *sidePages_; }
    /// Puts the page Live, the column of cards, on top.
    void showCards();
    [[nodiscard]] Maximizer& maximizer() { return *maximizer_; }

    [[nodiscard]] std::vector<PanelSwitch> switches();
    /// With their names as objects.
    [[nodiscard]] std::vector<QSplitter*> splitters();
    /// Everything shown, sized and on top as at first.
    void reset();

Q_SIGNALS:
    /// switches() are others.
    void panelsChanged();

private:
    ViewSide* viewSide_;
    QSplitter* sides_;  ///< left and right
    QSplitter* rows_;   ///< of the left: views, tools
    CardColumn* cards_;
    QScrollArea* live_;
    PageTabs* tools_;
    PageTabs* sidePages_;
    Maximizer* maximizer_ = nullptr;
};

}  // namespace asperity
