#pragma once

#include <QString>
#include <QWidget>

#include <vector>

class QSplitter;
class QScrollArea;

namespace asperity {

class Card;

/// Cards one below the other: the handles between them share out the height, a folded or hidden
/// card leaves its height to the others, and if none is open all are at the top.
class CardColumn : public QWidget {
public:
    explicit CardColumn(QWidget* parent = nullptr);

    /// @param share of the height, against those of the other cards
    void add(Card* card, int share);
    [[nodiscard]] const std::vector<Card*>& cards() const { return cards_; }
    [[nodiscard]] QSplitter& splitter() { return *splitter_; }
    void setShown(Card& card, bool shown);
    [[nodiscard]] static bool isShown(const Card& card);
    /// All cards unfolded, each with its share.
    void reset();

private:
    void settle();

    QSplitter* splitter_;
    std::vector<Card*> cards_;
    std::vector<int> shares_;
};

inline constexpr int kPanelGap = 6;  ///< between panels; handles of splitters are as wide [px]

/// Panels with handles between them. None can be dragged away: a menu hides and shows them.
[[nodiscard]] QSplitter* newSplitter(Qt::Orientation orientation, const char* objectName,
                                     QWidget* parent);

/// Has the panel scrolled where it has less room than it needs.
/// @param sideways also where it is too narrow; else the area is as wide as it needs
[[nodiscard]] QScrollArea* scrolled(QWidget* panel, bool sideways);

}  // namespace asperity
