#pragma once

#include "vtkplugins/pictures/Palette.h"

#include <QColor>
#include <QFont>
#include <QObject>

#include <cstdint>
#include <functional>

class QLabel;

namespace asperity {

/// The window's colors as Qt paints with them.
using ThemeColors = PaletteOf<QColor>;

[[nodiscard]] QColor toQColor(const Color& color);

enum class ThemeChoice : std::uint8_t {
    Desktop,  ///< light or dark as the desktop is when the program starts
    Light,
    Dark
};

/// The window's colors and letters, of all panels. The colors change while the program
/// runs: whoever keeps one gets the new ones by follow().
namespace theme {

[[nodiscard]] const ThemeColors& colors();
/// The same colors for VTK.
[[nodiscard]] const Palette& palette();
[[nodiscard]] bool isDark();

[[nodiscard]] ThemeChoice choice();
/// Repaints all windows in other colors.
void choose(ThemeChoice choice);

/// RAII: light palette while in scope, for exports. Nothing is repainted; no event may be handled
/// during it.
class LightColors {
public:
    LightColors();
    ~LightColors();
    LightColors(const LightColors&) = delete;
    LightColors& operator=(const LightColors&) = delete;

private:
    bool wasDark_;
};

/// Calls `show` now, and each time that colors() have changed as long as `owner` lives.
void follow(QObject* owner, const std::function<void()>& show);
/// The letters of a label have this color of colors(), whatever the theme.
void colorText(QLabel& label, QColor ThemeColors::*color);

inline constexpr double kTextSize = 9.0;   ///< [pt]
inline constexpr double kSmallSize = 8.0;  ///< captions, legends [pt]
inline constexpr double kTickSize = 7.5;   ///< numbers at axes [pt]

/// Digits of this font are all equally wide: numbers stay where they are.
[[nodiscard]] QFont textFont(double points = kTextSize);
[[nodiscard]] QFont boldFont(double points = kTextSize);

/// A length that suits letters of 96 dots an inch, for the letters that there are. @return [px]
[[nodiscard]] int scaled(int pixels);

}  // namespace theme

/// Sets the whole program's palette, font and style; call once, when there is a QApplication and
/// before the first window.
void applyTheme();

/// Emitted when the theme's colors changed. Panels use theme::follow().
class ThemeChange : public QObject {
    Q_OBJECT

Q_SIGNALS:
    void happened();
};

}  // namespace asperity
