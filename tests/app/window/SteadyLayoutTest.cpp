#include "tests/app/window/WindowFixture.h"
#include "ui/shell/PageTabs.h"
#include "ui/shell/WindowLayout.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/Card.h"

#include <QEvent>
#include <QPushButton>
#include <QSplitter>

namespace asperity::test {
namespace {

/// Counts what makes a window slow: panels that are laid out or sized anew.
class LayoutCounter : public QObject {
public:
    LayoutCounter(MainWindow& window, LivePanels& panels) {
        for (QWidget* panel :
             {static_cast<QWidget*>(&window.layout()), static_cast<QWidget*>(&panels.view()),
              static_cast<QWidget*>(&window.layout().sidePages())}) {
            panel->installEventFilter(this);
        }
        for (QSplitter* splitter : window.layout().splitters()) {
            splitter->installEventFilter(this);
        }
        for (Card* card : window.cards()) {
            card->installEventFilter(this);
        }
        QObject::connect(&panels.view(), &ZoomView::frameRendered, this, [this] { ++frames; });
    }

    bool eventFilter(QObject* watched, QEvent* event) override {
        resizes += event->type() == QEvent::Resize ? 1 : 0;
        const bool isSplitter = qobject_cast<QSplitter*>(watched) != nullptr;
        layouts += isSplitter && event->type() == QEvent::LayoutRequest ? 1 : 0;
        return false;
    }

    int frames = 0;
    int resizes = 0;
    int layouts = 0;  ///< of splitters
};

class SteadyLayout : public Window {};

TEST_F(SteadyLayout, ARunWithAllItsNumbersAndCurvesLaysNoPanelOutInEachFrame) {
    openFlatScene();
    ASSERT_TRUE(runsFor(0.5));
    LayoutCounter count(window, panels);
    child<QPushButton>("engage")->click();
    ASSERT_TRUE(eventually([this] { return inContact(); })) << state();
    // A slow machine draws few frames a second, and a run has some layouts of its own: wider texts.
    ASSERT_TRUE(eventually([&count] { return count.frames > 64; }));
    ASSERT_TRUE(runsFor(1.0));
    child<QPushButton>("withdraw")->click();
    ASSERT_TRUE(eventually([this] { return far(); })) << state();
    EXPECT_GT(count.frames, 20);
    EXPECT_EQ(count.resizes, 0);
    EXPECT_LT(count.layouts, count.frames / 4) << "of " << count.frames << " frames";
}

}  // namespace
}  // namespace asperity::test
