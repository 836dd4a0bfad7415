#pragma once

#include <QIcon>
#include <QProxyStyle>

namespace asperity {

/// Qt's Fusion with flat buttons and menus in the colors of theme::colors(). It asks for them when
/// it paints, so that another theme costs a repaint alone: a style sheet would polish each widget
/// again, a quarter of a second for the whole window.
///
/// Properties of a button: `primary` (filled with the accent), `compact` (little room around its
/// words), `heading` (words alone, without a frame).
class LabStyle : public QProxyStyle {
public:
    LabStyle();

    void polish(QWidget* widget) override;
    using QProxyStyle::polish;
    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
    [[nodiscard]] QSize sizeFromContents(ContentsType type, const QStyleOption* option,
                                         const QSize& contents,
                                         const QWidget* widget) const override;
};

enum class ControlIcon { Start, Pause, PauseCurves, ForcesOn, ForcesOff, Record };

/// The signs on the control bar's buttons, drawn: no font is sure to have them.
[[nodiscard]] QIcon controlIcon(ControlIcon icon);

}  // namespace asperity
