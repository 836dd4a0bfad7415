#include "ui/widgets/LabStyle.h"

#include "ui/widgets/Theme.h"

#include <QAbstractButton>
#include <QPainter>
#include <QPixmap>
#include <QSplitterHandle>
#include <QStyleOption>
#include <QVariant>

namespace asperity {

namespace {

constexpr double kRadius = 4.0;  // of a button's corners [px]
constexpr int kFrameWidth = 1;   // [px]
constexpr int kBeside = 9;       // left and right of a button's words [px]
constexpr int kAbove = 3;        // and below them [px]
constexpr int kBesideSign = 4;   // of a compact button, and of a sign without words [px]
constexpr int kDarker = 115;     // the accent under the mouse [%]

bool is(const QWidget* widget, const char* property) {
    return widget != nullptr && widget->property(property).toBool();
}

/// In a tool bar and in Qt's own dialogs a button has a frame under the mouse only.
bool isFlat(const QStyleOption& option) {
    return option.state.testFlag(QStyle::State_AutoRaise) &&
           !(option.state & (QStyle::State_MouseOver | QStyle::State_On | QStyle::State_Sunken));
}

QColor faceOf(const QStyleOption& option, const QWidget* widget) {
    const ThemeColors& colors = theme::colors();
    const bool isUnderMouse = option.state.testFlag(QStyle::State_MouseOver);
    const bool isEnabled = option.state.testFlag(QStyle::State_Enabled);
    if (is(widget, "primary") && isEnabled) {
        return isUnderMouse ? colors.accent.darker(kDarker) : colors.accent;
    }
    if (option.state.testFlag(QStyle::State_On)) {
        return colors.wash;
    }
    return option.state.testFlag(QStyle::State_Sunken) ? colors.window : colors.paper;
}

QColor frameOf(const QStyleOption& option, const QWidget* widget) {
    const bool isShown =
        (option.state & (QStyle::State_MouseOver | QStyle::State_On | QStyle::State_HasFocus)) !=
            0 ||
        is(widget, "primary");
    return isShown && option.state.testFlag(QStyle::State_Enabled) ? theme::colors().accent
                                                                   : theme::colors().faint;
}

void paintButton(const QStyleOption& option, QPainter& painter, const QWidget* widget) {
    if (is(widget, "heading") || isFlat(option)) {
        return;
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(frameOf(option, widget), kFrameWidth));
    painter.setBrush(faceOf(option, widget));
    painter.drawRoundedRect(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5), kRadius, kRadius);
    painter.restore();
}

/// A check box's square: in the dark, too, its frame can be seen, and a tick stands out.
void paintCheck(const QStyleOption& option, QPainter& painter) {
    constexpr double kCheckRadius = 2.5;  // [px]
    const ThemeColors& colors = theme::colors();
    const bool isEnabled = option.state.testFlag(QStyle::State_Enabled);
    const bool isOn = option.state.testFlag(QStyle::State_On);
    const bool isPartly = option.state.testFlag(QStyle::State_NoChange);
    const bool isShown =
        (option.state & (QStyle::State_MouseOver | QStyle::State_HasFocus)) != 0 || isOn;
    const QColor accent = isEnabled ? colors.accent : colors.muted;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(isShown ? accent : colors.muted, kFrameWidth));
    painter.setBrush(isOn ? accent : isEnabled ? colors.paper : colors.window);
    const QRectF box = QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5);
    painter.drawRoundedRect(box, kCheckRadius, kCheckRadius);
    painter.setPen(QPen(isOn ? colors.onAccent : accent, 1.8));
    const auto at = [&box](double x, double y) {
        return QPointF(box.left() + x * box.width(), box.top() + y * box.height());
    };
    if (isOn) {
        painter.drawPolyline(QPolygonF{{at(0.22, 0.52), at(0.43, 0.73), at(0.78, 0.3)}});
    } else if (isPartly) {
        painter.drawLine(at(0.25, 0.5), at(0.75, 0.5));
    }
    painter.restore();
}

/// What closes a tab.
void paintCross(const QStyleOption& option, QPainter& painter) {
    constexpr double kHalf = 3.5;  // [px]
    const ThemeColors& colors = theme::colors();
    const bool isUnderMouse = option.state.testFlag(QStyle::State_MouseOver);
    const QPointF middle = QRectF(option.rect).center();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(isUnderMouse ? colors.accent : colors.muted, 1.4));
    painter.drawLine(middle + QPointF(-kHalf, -kHalf), middle + QPointF(kHalf, kHalf));
    painter.drawLine(middle + QPointF(-kHalf, kHalf), middle + QPointF(kHalf, -kHalf));
    painter.restore();
}

/// A tab: the chosen one is of paper, below a line in the accent's color.
void paintTab(const QStyleOptionTab& tab, QPainter& painter) {
    constexpr int kLine = 2;  // [px]
    const ThemeColors& colors = theme::colors();
    const bool isChosen = tab.state.testFlag(QStyle::State_Selected);
    const bool isUnderMouse = tab.state.testFlag(QStyle::State_MouseOver);
    const bool isReached = tab.state.testFlag(QStyle::State_HasFocus);
    painter.save();
    painter.setPen(QPen(colors.faint, kFrameWidth));
    painter.setBrush(isChosen || isUnderMouse ? colors.paper : colors.window);
    painter.drawRect(tab.rect.adjusted(0, 0, -kFrameWidth, -kFrameWidth));
    if (isChosen) {
        const int line = isReached ? 2 * kLine : kLine;
        painter.fillRect(QRect(tab.rect.topLeft(), QSize(tab.rect.width(), line)), colors.accent);
    }
    painter.restore();
}

/// The color of a button's words, invalid: the palette's.
QColor wordsOf(const QStyleOption& option, const QWidget* widget) {
    if (!option.state.testFlag(QStyle::State_Enabled)) {
        return {};
    }
    if (is(widget, "primary")) {
        return theme::colors().onAccent;
    }
    const bool isHeading = is(widget, "heading");
    const bool isShown =
        option.state.testFlag(isHeading ? QStyle::State_MouseOver : QStyle::State_On);
    return isShown ? theme::colors().accent : QColor();
}

/// A copy of an option whose words have a color of their own.
template <class Option>
Option colored(const Option& option, const QColor& color) {
    Option copy = option;
    if (color.isValid()) {
        copy.palette.setColor(QPalette::ButtonText, color);
        copy.palette.setColor(QPalette::WindowText, color);
    }
    return copy;
}

QSize framed(const QSize& contents, const QStyleOption* option, const QWidget* widget) {
    if (is(widget, "heading")) {
        return contents;
    }
    const auto* tool = qstyleoption_cast<const QStyleOptionToolButton*>(option);
    const bool isSign = tool != nullptr &&
                        (tool->text.isEmpty() || tool->toolButtonStyle == Qt::ToolButtonIconOnly);
    const int beside = (is(widget, "compact") || isSign ? kBesideSign : kBeside) + kFrameWidth;
    return contents + QSize(2 * beside, 2 * (kAbove + kFrameWidth));
}

constexpr int kSize = 16;  ///< [px]

void drawStart(QPainter& painter, const QColor& color) {
    painter.setBrush(color);
    painter.drawPolygon(QPolygonF({{4.0, 2.5}, {13.5, 8.0}, {4.0, 13.5}}));
}

void drawPause(QPainter& painter, const QColor& color) {
    painter.setBrush(color);
    painter.drawRect(QRectF(4.0, 3.0, 3.0, 10.0));
    painter.drawRect(QRectF(9.0, 3.0, 3.0, 10.0));
}

/// An arrow that pushes up against a line.
void drawForces(QPainter& painter, const QColor& color) {
    painter.setBrush(color);
    painter.drawRect(QRectF(7.0, 7.0, 2.0, 7.5));
    painter.drawPolygon(QPolygonF({{8.0, 2.5}, {12.0, 8.0}, {4.0, 8.0}}));
    painter.drawRect(QRectF(3.0, 1.0, 10.0, 1.2));
}

void drawRecord(QPainter& painter) {
    painter.setBrush(theme::colors().fault);
    painter.drawEllipse(QPointF(8.0, 8.0), 4.5, 4.5);
}

/// @param onAccent the color of what lies upon the accent
QPixmap drawn(ControlIcon icon, const QColor& onAccent) {
    QPixmap pixmap(kSize, kSize);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    switch (icon) {
    case ControlIcon::Start:
        drawStart(painter, onAccent);
        break;
    case ControlIcon::Pause:
        drawPause(painter, onAccent);
        break;
    case ControlIcon::PauseCurves:
        drawPause(painter, theme::colors().ink);
        break;
    case ControlIcon::ForcesOn:
        drawForces(painter, theme::colors().force);
        break;
    case ControlIcon::ForcesOff:
        drawForces(painter, theme::colors().faint);
        break;
    case ControlIcon::Record:
        drawRecord(painter);
        break;
    }
    return pixmap;
}

}  // namespace

LabStyle::LabStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

// A splitter's handle and a tool button show the mouse over them.
void LabStyle::polish(QWidget* widget) {
    QProxyStyle::polish(widget);
    if (qobject_cast<QSplitterHandle*>(widget) != nullptr ||
        qobject_cast<QAbstractButton*>(widget) != nullptr) {
        widget->setAttribute(Qt::WA_Hover);
    }
}

void LabStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                             QPainter* painter, const QWidget* widget) const {
    switch (element) {
    case PE_PanelButtonCommand:
    case PE_PanelButtonTool:
        paintButton(*option, *painter, widget);
        return;
    case PE_IndicatorCheckBox:
        paintCheck(*option, *painter);
        return;
    case PE_IndicatorTabClose:
        paintCross(*option, *painter);
        return;
    case PE_FrameFocusRect:
        if (qobject_cast<const QAbstractButton*>(widget) != nullptr &&
            (widget->inherits("QPushButton") || widget->inherits("QToolButton"))) {
            return;  // their frame has the accent
        }
        break;
    default:
        break;
    }
    QProxyStyle::drawPrimitive(element, option, painter, widget);
}

void LabStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                           const QWidget* widget) const {
    if (element == CE_Splitter) {
        const bool isUnderMouse = option->state.testFlag(State_MouseOver);
        painter->fillRect(option->rect,
                          isUnderMouse ? theme::colors().faint : theme::colors().window);
        return;
    }
    const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option);
    if (element == CE_TabBarTabShape && tab != nullptr) {
        paintTab(*tab, *painter);
        return;
    }
    const auto* push = qstyleoption_cast<const QStyleOptionButton*>(option);
    if (element == CE_PushButtonLabel && push != nullptr) {
        const QStyleOptionButton words = colored(*push, wordsOf(*option, widget));
        QProxyStyle::drawControl(element, &words, painter, widget);
        return;
    }
    const auto* tool = qstyleoption_cast<const QStyleOptionToolButton*>(option);
    if (element == CE_ToolButtonLabel && tool != nullptr) {
        const QStyleOptionToolButton words = colored(*tool, wordsOf(*option, widget));
        QProxyStyle::drawControl(element, &words, painter, widget);
        return;
    }
    QProxyStyle::drawControl(element, option, painter, widget);
}

QSize LabStyle::sizeFromContents(ContentsType type, const QStyleOption* option,
                                 const QSize& contents, const QWidget* widget) const {
    switch (type) {
    case CT_PushButton:
    case CT_ToolButton:
        return framed(contents, option, widget);
    default:
        return QProxyStyle::sizeFromContents(type, option, contents, widget);
    }
}

QIcon controlIcon(ControlIcon icon) {
    QIcon both(drawn(icon, theme::colors().onAccent));
    if (icon == ControlIcon::Start || icon == ControlIcon::Pause) {
        // Their button has no accent then: what is drawn for it cannot be seen upon paper.
        both.addPixmap(drawn(icon, theme::colors().muted), QIcon::Disabled);
    }
    return both;
}

}  // namespace asperity
