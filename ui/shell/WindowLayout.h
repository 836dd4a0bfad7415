#pragma once

#include <QByteArray>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QWidget>

#include <functional>
#include <vector>

class QBoxLayout;
class QScrollArea;
class QSplitter;
class QShortcut;
class QStackedLayout;
class QVBoxLayout;

namespace asperity {

class Card;
class CardColumn;
class Maximizer;
class PageTabs;

/// A part of the window that can be hidden and shown.
struct PanelSwitch {
    QString key;    ///< in the settings; stays the same
    QString title;  ///< in the menu
    int group;      ///< entries of a group are adjacent
    bool shownAtFirst;
    std::function<bool()> isShown;
    std::function<void(bool)> setShown;
    std::function<void()> toFront = [] {};  ///< of those that share an area
};

/// The middle of the window: controls on top; below them on the left the views over the tool pages,
/// on the right the side pages, whose first one, Live, is a column of cards. Splitters share out
/// the room.
class WindowLayout : public QWidget {
    Q_OBJECT

public:
    /// Widgets in the middle of the window.
    struct Middle {
        QWidget* top;                     ///< above all
        QWidget* views;                   ///< left, over the tools
        QSplitter* split;                 ///< of the views beside one another
        std::function<void()> showViews;  ///< all of them
        QWidget* banner;     ///< in sight whatever is enlarged; the first of its column
        QBoxLayout* column;  ///< of the views
    };

    explicit WindowLayout(const Middle& middle, QWidget* parent = nullptr);

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
    /// Restores what is initially shown, its sizes and what is on top.
    void reset();

Q_SIGNALS:
    /// switches() are others.
    void panelsChanged();

private:
    QSplitter* views_;                 ///< beside one another
    std::function<void()> showViews_;  ///< all of them
    QSplitter* sides_;                 ///< left and right
    QSplitter* rows_;                  ///< of the left: views, tools
    CardColumn* cards_;
    QScrollArea* live_;
    PageTabs* tools_;
    PageTabs* sidePages_;
    Maximizer* maximizer_ = nullptr;
};

/// Puts one panel of a splitter alone into the middle of the window, below the banner, and back to
/// where it was.
class Maximizer : public QObject {
    Q_OBJECT

public:
    /// @param pages the first one is the usual middle of the window; gets another one
    /// @param banner the first of `bannerHome`; it stays in sight
    Maximizer(QStackedLayout& pages, QWidget& banner, QBoxLayout& bannerHome);

    /// Enlarges a child of a splitter, or puts it back if it is the one that is enlarged.
    void toggle(QWidget& panel);
    void restore();
    [[nodiscard]] bool isActive() const { return panel_ != nullptr; }
    /// Sets whether Esc restores the window.
    void setEscape(bool works);

Q_SIGNALS:
    void changed(bool active);

private:
    void enlarge(QWidget& panel, QSplitter& home);

    QStackedLayout& pages_;
    QWidget& banner_;
    QBoxLayout& bannerHome_;
    QWidget* page_;
    QVBoxLayout* column_;  ///< of the page: a way back, banner, panel
    QShortcut* escape_;
    bool escapeWorks_ = true;
    QPointer<QWidget> panel_;    ///< null: none is enlarged
    QSplitter* home_ = nullptr;  ///< of the panel
    int index_ = 0;              ///< in its home
    QByteArray sizes_;           ///< of its home
    bool wasFolded_ = false;
};

}  // namespace asperity
