#pragma once

#include <QString>

class QScrollArea;
class QSplitter;
class QWidget;

namespace asperity {

inline constexpr int kPanelGap = 6;  ///< between panels; handles of splitters are as wide [px]

/// Panels with handles between them. None can be dragged away: a menu hides and shows them.
[[nodiscard]] QSplitter* newSplitter(Qt::Orientation orientation, const char* objectName,
                                     QWidget* parent);

/// Has the panel scrolled where it has less room than it needs.
/// @param sideways also where it is too narrow; else the area is as wide as it needs
[[nodiscard]] QScrollArea* scrolled(QWidget* panel, bool sideways);

}  // namespace asperity
