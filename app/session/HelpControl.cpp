#include "app/session/HelpControl.h"

#include "app/program/ProgramParts.h"
#include "ui/help/AboutBox.h"
#include "ui/help/SystemFacts.h"
#include "ui/view/ZoomView.h"
#include "ui/window/MainWindow.h"
#include "ui/window/WindowMenus.h"

#include <QAction>

namespace asperity {

namespace {

ProgramFacts factsOf(MainWindow& window) {
    ProgramFacts facts{.version = QString::fromStdString(versionWithCommit()),
                       .compiler = QString::fromStdString(compilerName()),
                       .license = QString::fromStdString(licenseText()),
                       .libraries = {},
                       .system = systemFacts(window.view())};
    for (const LibraryPart& part : libraryParts()) {
        facts.libraries.push_back({QString::fromStdString(part.name),
                                   QString::fromStdString(part.version),
                                   QString::fromStdString(part.license),
                                   QStringLiteral("/usr/share/doc/%1/copyright")
                                       .arg(QString::fromStdString(part.package))});
    }
    return facts;
}

}  // namespace

HelpControl::HelpControl(MainWindow& window) : window_(window) {
    connect(window.menus().about, &QAction::triggered, this, &HelpControl::showAbout);
}

void HelpControl::showAbout() { (new AboutBox(factsOf(window_), &window_))->show(); }

}  // namespace asperity
