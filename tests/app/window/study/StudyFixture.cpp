#include "tests/app/window/study/StudyFixture.h"

#include "app/window/study/StudyControl.h"
#include "core/Units.h"
#include "core/io/experiment/StudyFile.h"
#include "ui/shell/Menus.h"
#include "ui/view/ZoomView.h"

#include <QAction>
#include <QPushButton>
#include <QtTest>

#include <cmath>

namespace asperity::test {

namespace {

/// Longer than a study takes no press: one right after a change is for what was before [ms].
constexpr int kSettle = 600;

}  // namespace

void WindowWithStudy::start(const Study& wanted) {
    study = wanted;
    if (stage.run() == nullptr) {
        openFlatScene();
    }
    window.menus().entry("study").trigger();
    stage.get<StudyControl>().choice().chooseStudy(writtenStudy(folder, study));
    stage.get<StudyControl>().choice().chooseFolder(out());
    QTest::mouseClick(child<QPushButton>("startStudy"), Qt::LeftButton);
    ASSERT_TRUE(eventually([this] { return window.menus().entry("trial").isEnabled(); }));
}

std::string WindowWithStudy::action() {
    return child<QPushButton>("trialAction")->text().toStdString();
}

void WindowWithStudy::pressButton() {
    EXPECT_TRUE(eventually([this] { return stage.run()->loop().snapshot().statistics.ticks > 0; }));
    live(kSettle);
    QTest::keyClick(&panels.view(), Qt::Key_Return);
}

Vector3 WindowWithStudy::tip() { return stage.run()->loop().snapshot().sample.output.model.tip; }

Vector3 WindowWithStudy::target() {
    const Vector2 position =
        0.5 * Vector2(study.scene.sample.shape->size, study.scene.sample.shape->size) +
        study.targets.front();
    return {position.x(), position.y(), 0.0};
}

bool WindowWithStudy::isAtStart() {
    return eventually([this] { return std::abs(tip().z() - study.startHeight) < 1.0_nm; });
}

void WindowWithStudy::dragAcross() {
    for (int i = 0; i < 8 && missing() > 1.0_nm; ++i) {
        const Vector3 here = tip();
        const QPointF from = panels.view().onScreen(here);
        const QPointF to = panels.view().onScreen({target().x(), target().y(), here.z()});
        const QPoint start = panels.view().rect().center();
        drag(start, start + (to - from).toPoint());
        ASSERT_TRUE(runsFor(0.5));
    }
    EXPECT_LT(missing(), 1.5_nm);
}

void WindowWithStudy::goDown() {
    for (int i = 0; i < 20 && !inContact(); ++i) {
        turnWheel(-3);
        ASSERT_TRUE(runsFor(0.15));
    }
    EXPECT_TRUE(inContact()) << state();
}

void WindowWithStudy::doTrial() {
    ASSERT_TRUE(isReady()) << action();
    ASSERT_TRUE(isAtStart());
    pressButton();
    ASSERT_TRUE(isInTrial()) << action();
    EXPECT_FALSE(child<QPushButton>("studyResults")->isEnabled());
    dragAcross();
    goDown();
    pressButton();
    ASSERT_TRUE(action().starts_with("Next")) << action();
}

std::vector<TrialRecord> WindowWithStudy::trials() {
    return readTrials(out() / "trials.csv", study);
}

}  // namespace asperity::test
