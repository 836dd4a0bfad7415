#include "ui/window/LayoutMemory.h"

#include "ui/panels/Card.h"
#include "ui/window/MainWindow.h"
#include "ui/window/PageTabs.h"
#include "ui/window/WindowLayout.h"

#include <QSplitter>
#include <QStringList>
#include <QVariantList>

#include <vector>

namespace asperity {

namespace {

const QString kFolded = QStringLiteral("window/foldedPanels");
const QString kShown = QStringLiteral("window/shown/");
const QString kSplitter = QStringLiteral("window/splitter/");
const QString kOnTop = QStringLiteral("window/onTop/");

}  // namespace

void restoreLayout(MainWindow& window, const QVariantMap& kept) {
    const QStringList folded = kept.value(kFolded).toStringList();
    for (Card* card : window.cards()) {
        card->setFolded(folded.contains(card->title()));
    }
    WindowLayout& layout = window.layout();
    for (const PanelSwitch& part : layout.switches()) {
        part.setShown(kept.value(kShown + part.key, part.shownAtFirst).toBool());
    }
    for (QSplitter* splitter : layout.splitters()) {
        // Of as many panels as there are now.
        const QVariantList state = kept.value(kSplitter + splitter->objectName()).toList();
        if (state.size() == 2 && state.front().toInt() == splitter->count()) {
            splitter->restoreState(state.back().toByteArray());
        }
    }
    for (PageTabs* pages : {&layout.tools(), &layout.sidePages()}) {
        pages->putOnTop(kept.value(kOnTop + pages->objectName()).toString());
    }
}

void keepLayout(MainWindow& window, QVariantMap& kept) {
    if (window.isPanelEnlarged()) {
        return;
    }
    QStringList folded;
    for (const Card* card : window.cards()) {
        if (card->isFolded()) {
            folded << card->title();
        }
    }
    kept.insert(kFolded, folded);
    WindowLayout& layout = window.layout();
    for (const PanelSwitch& part : layout.switches()) {
        kept.insert(kShown + part.key, part.isShown());
    }
    for (const QSplitter* splitter : layout.splitters()) {
        kept.insert(kSplitter + splitter->objectName(),
                    QVariantList{splitter->count(), splitter->saveState()});
    }
    for (const PageTabs* pages : {&layout.tools(), &layout.sidePages()}) {
        kept.insert(kOnTop + pages->objectName(), pages->pageOnTop());
    }
}

}  // namespace asperity
