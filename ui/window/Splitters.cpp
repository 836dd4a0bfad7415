#include "ui/window/Splitters.h"

#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>

namespace asperity {

namespace {

/// A splitter whose handles say what they are for.
class PanelSplitter : public QSplitter {
public:
    using QSplitter::QSplitter;

protected:
    QSplitterHandle* createHandle() override {
        QSplitterHandle* handle = QSplitter::createHandle();
        handle->setToolTip(tr("Drag to share out the room"));
        return handle;
    }
};

}  // namespace

QSplitter* newSplitter(Qt::Orientation orientation, const char* objectName, QWidget* parent) {
    auto* splitter = new PanelSplitter(orientation, parent);
    splitter->setObjectName(QString::fromUtf8(objectName));
    splitter->setHandleWidth(kPanelGap);
    splitter->setChildrenCollapsible(false);
    return splitter;
}

QScrollArea* scrolled(QWidget* panel, bool sideways) {
    auto* area = new QScrollArea;
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidget(panel);
    if (!sideways) {
        area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        area->setMinimumWidth(panel->minimumWidth() +
                              area->verticalScrollBar()->sizeHint().width());
    }
    return area;
}

}  // namespace asperity
