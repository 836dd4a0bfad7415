#include "ui/widgets/FlowLayout.h"

#include <QWidget>

#include <algorithm>
#include <numeric>
#include <utility>

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
            const Entry* last = lines.empty() ? nullptr : lines.back().back();
            lines.emplace_back();
            used = -spacing();
            if (last != nullptr && last->item->spacerItem() != nullptr) {
                lines.at(lines.size() - 2).pop_back();
                lines.back().push_back(last);
                used = 0;
            }
        }
        lines.back().push_back(&entry);
        used += spacing() + hint;
    }
    return lines;
}

/// Those that ask for more than their share have it, and stretch no more. @return shares of the
/// rest
int FlowLayout::giveHints(const Line& line, std::vector<int>& widths, std::vector<int>& stretches,
                          int& left) {
    int shares = std::accumulate(stretches.begin(), stretches.end(), 0);
    for (std::size_t i = 0; i < line.size() && shares > 0;) {
        const int hint = line[i]->item->sizeHint().width();
        const int share = std::max(0, left) * stretches[i] / shares;
        if (stretches[i] == 0 || widths[i] + share >= hint) {
            ++i;
            continue;
        }
        left -= hint - widths[i];
        widths[i] = hint;
        shares -= std::exchange(stretches[i], 0);
        i = 0;  // the others' share is smaller now
    }
    return shares;
}

std::vector<int> FlowLayout::widthsIn(const Line& line, int width) const {
    std::vector<int> widths;
    std::vector<int> stretches;
    int left = width + spacing();
    for (const Entry* entry : line) {
        const int hint = entry->item->sizeHint().width();
        const int least = entry->item->minimumSize().width();
        widths.push_back(entry->stretch > 0 ? std::min(least, hint) : hint);
        stretches.push_back(entry->stretch);
        left -= widths.back() + spacing();
    }
    int shares = giveHints(line, widths, stretches, left);
    // One that reaches its maximum leaves more to those after it: spacers come last.
    for (std::size_t i = 0; i < line.size() && left > 0 && shares > 0; ++i) {
        const int largest = line[i]->item->maximumSize().width();
        const int share = left * stretches[i] / shares;
        const int more = std::min(share, std::max(0, largest - widths[i]));
        shares -= stretches[i];
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
