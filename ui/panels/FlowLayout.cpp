#include "ui/panels/FlowLayout.h"

#include <QWidget>

#include <algorithm>

namespace asperity {

namespace {

int inner(int width, const QMargins& margins) { return width - margins.left() - margins.right(); }

}  // namespace

FlowLayout::~FlowLayout() {
    for (const Entry& entry : items_) {
        delete entry.item;
    }
}

void FlowLayout::addWidget(QWidget* widget, int stretch) {
    addChildWidget(widget);
    items_.push_back({new QWidgetItem(widget), stretch});
    invalidate();
}

void FlowLayout::addStretch() {
    items_.push_back({new QSpacerItem(0, 0, QSizePolicy::Expanding), 1});
    invalidate();
}

void FlowLayout::addItem(QLayoutItem* item) {
    items_.push_back({item, 0});
    invalidate();
}

QLayoutItem* FlowLayout::itemAt(int index) const {
    const bool isThere = index >= 0 && index < count();
    return isThere ? items_[static_cast<std::size_t>(index)].item : nullptr;
}

QLayoutItem* FlowLayout::takeAt(int index) {
    QLayoutItem* const taken = itemAt(index);
    if (taken != nullptr) {
        items_.erase(items_.begin() + index);
        invalidate();
    }
    return taken;
}

std::vector<FlowLayout::Line> FlowLayout::linesFor(int width) const {
    std::vector<Line> lines;
    int used = 0;
    for (const Entry& entry : items_) {
        if (entry.item->widget() != nullptr && entry.item->isEmpty()) {
            continue;  // hidden
        }
        const int hint = entry.item->sizeHint().width();
        if (lines.empty() || used + spacing() + hint > width) {
            lines.emplace_back();
            used = -spacing();
        }
        lines.back().push_back(&entry);
        used += spacing() + hint;
    }
    return lines;
}

std::vector<int> FlowLayout::widthsIn(const Line& line, int width) const {
    std::vector<int> widths;
    int left = width + spacing();
    int shares = 0;
    for (const Entry* entry : line) {
        widths.push_back(entry->item->sizeHint().width());
        left -= widths.back() + spacing();
        shares += entry->stretch;
    }
    // One that reaches its maximum leaves more to those after it: spacers stand last.
    for (std::size_t i = 0; i < line.size() && left > 0 && shares > 0; ++i) {
        const int largest = line[i]->item->maximumSize().width();
        const int share = left * line[i]->stretch / shares;
        const int more = std::min(share, std::max(0, largest - widths[i]));
        shares -= line[i]->stretch;
        widths[i] += more;
        left -= more;
    }
    return widths;
}

int FlowLayout::heightForWidth(int width) const {
    const QMargins margins = contentsMargins();
    int height = margins.top() + margins.bottom() - spacing();
    for (const Line& line : linesFor(inner(width, margins))) {
        int tallest = 0;
        for (const Entry* entry : line) {
            tallest = std::max(tallest, entry->item->sizeHint().height());
        }
        height += tallest + spacing();
    }
    return height;
}

QSize FlowLayout::sizeHint() const {
    const QMargins margins = contentsMargins();
    int width = margins.left() + margins.right() - spacing();
    for (const Entry& entry : items_) {
        width += entry.item->sizeHint().width() + spacing();
    }
    return {width, heightForWidth(width)};
}

QSize FlowLayout::minimumSize() const {
    const QMargins margins = contentsMargins();
    QSize least;
    for (const Entry& entry : items_) {
        least = least.expandedTo(entry.item->sizeHint());
    }
    return {least.width() + margins.left() + margins.right(),
            least.height() + margins.top() + margins.bottom()};
}

void FlowLayout::setGeometry(const QRect& rect) {
    QLayout::setGeometry(rect);
    const QRect room = rect.marginsRemoved(contentsMargins());
    int top = room.top();
    for (const Line& line : linesFor(room.width())) {
        int tallest = 0;
        for (const Entry* entry : line) {
            tallest = std::max(tallest, entry->item->sizeHint().height());
        }
        const std::vector<int> widths = widthsIn(line, room.width());
        int left = room.left();
        for (std::size_t i = 0; i < line.size(); ++i) {
            const int height = line[i]->item->sizeHint().height();
            line[i]->item->setGeometry({left, top + tallest - height, widths[i], height});
            left += widths[i] + spacing();
        }
        top += tallest + spacing();
    }
}

}  // namespace asperity
