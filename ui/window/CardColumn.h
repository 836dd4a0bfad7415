#pragma once

#include <QWidget>

#include <vector>

class QSplitter;

namespace asperity {

class Card;

/// Cards one below the other: the handles between them share out the height, a folded or hidden
/// card leaves its height to the others, and if none is open all stand at the top.
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

}  // namespace asperity
