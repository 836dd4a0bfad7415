#pragma once

#include <QLayout>

#include <vector>

namespace asperity {

/// Puts widgets beside one another, and in further lines where the width that they ask for is used
/// up. Those of a line that stretch share its width beyond their minimum widths, up to their
/// maximum width; one that asks for more than its share has that first. Widgets of a line are
/// aligned at its bottom.
class FlowLayout : public QLayout {
public:
    using QLayout::QLayout;
    ~FlowLayout() override;
    FlowLayout(const FlowLayout&) = delete;
    FlowLayout& operator=(const FlowLayout&) = delete;

    /// @param stretch 0: keeps the width of its size hint; else takes this share of what is left
    /// beyond minimum widths, and no less than its size hint
    void addWidget(QWidget* widget, int stretch = 0);
    /// Room that separates what is before it from what is after it, in whose line it is.
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

    static int giveHints(const Line& line, std::vector<int>& widths, std::vector<int>& stretches,
                         int& left);

    [[nodiscard]] std::vector<Line> linesFor(int width) const;
    [[nodiscard]] std::vector<int> widthsIn(const Line& line, int width) const;

    std::vector<Entry> items_;
};

}  // namespace asperity
