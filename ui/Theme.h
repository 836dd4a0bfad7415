#pragma once

#include <QColor>
#include <QFont>

class QApplication;

namespace asperity {

/// The window's colors and letters: one place for all panels. Ink on white paper, muted grays,
/// red for forces: the colors of the pictures (vtkplugins/pictures/Palette.h).
namespace theme {

inline constexpr QRgb kPaper = qRgb(255, 255, 255);   ///< behind panels and plots
inline constexpr QRgb kWindow = qRgb(243, 245, 247);  ///< between the panels
inline constexpr QRgb kInk = qRgb(31, 41, 51);        ///< text
inline constexpr QRgb kMuted = qRgb(95, 107, 118);    ///< captions, axes
inline constexpr QRgb kFaint = qRgb(216, 222, 228);   ///< frames, grids
inline constexpr QRgb kTip = qRgb(96, 112, 128);      ///< tip and cantilever
inline constexpr QRgb kForce = qRgb(200, 40, 60);     ///< forces
inline constexpr QRgb kMarker = qRgb(222, 30, 90);    ///< the tip's place
inline constexpr QRgb kZoom = qRgb(213, 94, 0);       ///< frame of the zoomed view
inline constexpr QRgb kAccent = qRgb(0, 114, 178);    ///< what is chosen or running
inline constexpr QRgb kFault = qRgb(186, 26, 46);     ///< forces are off because of a fault
inline constexpr QRgb kCaution = qRgb(150, 88, 0);    ///< a result holds with a reservation

/// Colors of curves, told apart with any color vision. Source: Okabe and Ito (2008).
inline constexpr QRgb kBlue = qRgb(0, 114, 178);
inline constexpr QRgb kOrange = qRgb(213, 94, 0);
inline constexpr QRgb kGreen = qRgb(0, 158, 115);

inline constexpr int kTextSize = 12;   ///< [px]
inline constexpr int kSmallSize = 11;  ///< captions, axes [px]

/// Digits of this font are all equally wide: numbers stay where they are.
[[nodiscard]] QFont textFont(int pixelSize = kTextSize);
[[nodiscard]] QFont boldFont(int pixelSize = kTextSize);

}  // namespace theme

/// Sets the whole program's palette, font and style sheet; call once, before the first window.
void applyTheme(QApplication& application);

}  // namespace asperity
