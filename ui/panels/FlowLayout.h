#pragma once

#include <QLayout>

#include <vector>

namespace asperity {

/// Puts widgets beside one another, and in further lines where the width is used up. What is left
/// of a line's width goes to those that stretch, up to their maximum width. Widgets of a line are
/// aligned at its bottom.
class FlowLayout : public QLayout {
public:
    using QLayout::QLayout;
    ~FlowLayout() override;

    /// @param stretch 0: keeps the width of its size hint; else takes this share of what is left
    void addWidget(QWidget* widget, int stretch = 0);
    /// Room that separates what is before it from what is after it.
    void addStretch();

    void addItem(QLayoutItem* item) override;
    [[nodiscard]] int count() const override { return static_cast<int>(items_.size()); }
    [[nodiscard]] QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    [[nodiscard]] Qt::Orientations expandingDirections() const override { return {}; }
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] QSize sizeHint() const override;     ///< all in one line
    [[nodiscard]] QSize minimumSize() const override;  ///< each in a line of its own
    void setGeometry(const QRect& rect) override;

private:
    struct Entry {
        QLayoutItem* item;  ///< owned
        int stretch;
    };
    using Line = std::vector<const Entry*>;

    [[nodiscard]] std::vector<Line> linesFor(int width) const;
    [[nodiscard]] std::vector<int> widthsIn(const Line& line, int width) const;

    std::vector<Entry> items_;
};

}  // namespace asperity
