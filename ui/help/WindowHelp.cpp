#include "ui/help/WindowHelp.h"

#include "ui/HeldKeys.h"
#include "ui/help/ActionHelp.h"
#include "ui/panels/CopyablePlot.h"
#include "ui/panels/OverviewMap.h"
#include "ui/panels/PlotNavigation.h"
#include "ui/view/GestureWidget.h"

#include <QObject>

namespace asperity {

namespace {

void append(InputHelps& all, const InputHelps& some) {
    all.insert(all.end(), some.begin(), some.end());
}

/// The one key whose effect is that of whatever is open.
InputHelps escapeHelp() {
    return {{QObject::tr("Esc"),
             QObject::tr("closes a menu, a message, an enlarged panel or a window beside this one, "
                         "else ends the measuring tool on the whole scan, else stops loading; with "
                         "a force-feedback device: switches off its forces")}};
}

}  // namespace

std::vector<HelpSection> windowHelp(const QMenuBar& bar) {
    std::vector<HelpSection> sections{
        {QObject::tr("Mouse in the large view"), GestureWidget::help()},
        {QObject::tr("Keys that move the tip, held in the large view"), HeldKeys::help()},
        {QObject::tr("Everywhere"), escapeHelp()}};
    InputHelps ofPanels = OverviewMap::help();
    append(ofPanels, CopyablePlot::help());
    ofPanels.push_back({QObject::tr("In a plot"), PlotNavigation::help()});
    sections.push_back({QObject::tr("Mouse in the panels"), ofPanels});
    for (const MenuHelp& menu : helpOf(bar)) {
        InputHelps lines;
        for (const ActionHelp& entry : menu.entries) {
            lines.push_back({entry.keys, entry.tip.isEmpty() ? entry.text
                                                             : QStringLiteral("%1: %2").arg(
                                                                   entry.text, entry.tip)});
        }
        sections.push_back({QObject::tr("Menu %1").arg(menu.menu), lines});
    }
    return sections;
}

}  // namespace asperity
