#include "ui/window/MeasureMenu.h"

#include <QAction>
#include <QCoreApplication>
#include <QMenu>

namespace asperity {

namespace {

QString words(const char* text) { return QCoreApplication::translate("MeasureMenu", text); }

QAction* newEntry(QMenu& menu, const char* text, const char* key, const char* toolTip) {
    QAction* entry = menu.addAction(words(text));
    entry->setShortcut(QKeySequence(QLatin1String(key)));
    entry->setToolTip(words(toolTip));
    return entry;
}

}  // namespace

MeasureMenu::MeasureMenu(QMenu& menu)
    : profile(newEntry(menu, QT_TRANSLATE_NOOP("MeasureMenu", "&Profile line"), "Ctrl+L",
                       QT_TRANSLATE_NOOP("MeasureMenu",
                                         "Draw a line on the whole scan: heights, distance, angle, "
                                         "step height")))
    , roughness(newEntry(
          menu, QT_TRANSLATE_NOOP("MeasureMenu", "&Roughness"), "Ctrl+U",
          QT_TRANSLATE_NOOP("MeasureMenu", "Sa, Sq, Sz and Sdr of the scan or a rectangle")))
    , markers(newEntry(menu, QT_TRANSLATE_NOOP("MeasureMenu", "&Markers"), "Ctrl+M",
                       QT_TRANSLATE_NOOP("MeasureMenu", "Named places to travel to")))
    , markerHere(newEntry(
          menu, QT_TRANSLATE_NOOP("MeasureMenu", "Marker at the cross-&hair"), "Ctrl+Shift+M",
          QT_TRANSLATE_NOOP("MeasureMenu", "By its key: sets a marker where the pointer is, in "
                                           "any view")))
    , touches(newEntry(
          menu, QT_TRANSLATE_NOOP("MeasureMenu", "&Touches"), "Ctrl+T",
          QT_TRANSLATE_NOOP("MeasureMenu", "Table of all touches of the session, for export")))
    , forceMap(newEntry(menu, QT_TRANSLATE_NOOP("MeasureMenu", "&Force map"), "Ctrl+F",
                        QT_TRANSLATE_NOOP("MeasureMenu",
                                          "Adhesion, stiffness, deformation and friction over the "
                                          "scan or a part of it; a force curve at each pixel")))
    , curve(newEntry(menu, QT_TRANSLATE_NOOP("MeasureMenu", "Draw a measured &curve…"), "Ctrl+D",
                     QT_TRANSLATE_NOOP("MeasureMenu",
                                       "A measured force–distance curve over those of the run"))) {
    menu.setToolTipsVisible(true);
}

}  // namespace asperity
