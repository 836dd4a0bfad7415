#include "app/window/study/StudyResultsControl.h"
#include "core/Units.h"
#include "tests/app/ProgramRun.h"
#include "tests/app/window/study/StudyFixture.h"
#include "tests/support/Places.h"
#include "ui/shell/Dialogs.h"
#include "ui/shell/Menus.h"
#include "ui/view/SecondView.h"
#include "ui/view/ViewOptionsMenu.h"
#include "ui/view/ZoomView.h"

#include <QAction>
#include <QComboBox>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QToolButton>
#include <QtTest>

// What a study shows and locks in the window.

namespace asperity::test {
namespace {

TEST_F(WindowWithStudy, ItsKnobsAreLockedAndTheTipRestsUntilATrialBegins) {
    start(shortStudy());
    for (const char* const name : {"material", "device", "path"}) {
        EXPECT_FALSE(child<QComboBox>(name)->isEnabled()) << name;
        EXPECT_NE(child<QComboBox>(name)->toolTip().indexOf("study"), -1) << name;
    }
    for (const QAction* const entry :
         {&window.menus().entry("open"), &window.menus().entry("record"),
          &window.menus().entry("startPause"), &window.menus().entry("tipControl"),
          &window.menus().entry("clutch"), &window.menus().entry("undo")}) {
        EXPECT_TRUE(eventually([entry] { return !entry->isEnabled(); }))
            << entry->text().toStdString();
    }
    const Vector3 before = tip();
    drag(panels.view().rect().center(), panels.view().rect().center() + QPoint(60, 0));
    turnWheel(-3);
    ASSERT_TRUE(runsFor(0.6));
    EXPECT_LT((tip() - before).norm(), 0.1_nm);
    SceneDescription other = stage.run()->scene().description;
    other.tip.radius *= 2.0;
    stage.edits().change("Tip radius", other);
    ASSERT_TRUE(runsFor(0.6));
    EXPECT_NE(stage.run()->scene().description.tip.radius, other.tip.radius);
}

TEST_F(WindowWithStudy, ClosingTheWindowAsksAndLosesNoTrial) {
    start(shortStudy());
    EXPECT_FALSE(window.close());
    auto* question = window.findChild<QMessageBox*>(QString::fromUtf8(kAskWhether));
    ASSERT_NE(question, nullptr);
    EXPECT_TRUE(question->text().contains(QStringLiteral("A study is under way")));
    question->reject();
    EXPECT_TRUE(window.isVisible());
    EXPECT_TRUE(isReady()) << "the study goes on";
}

TEST_F(WindowWithStudy, ItsFormThatALayoutBringsBackOffersTheShippedStudy) {
    openFlatScene();
    window.showTool(child<QPushButton>("startStudy")->parentWidget()->parentWidget());
    EXPECT_FALSE(text("studyName").empty());
    EXPECT_TRUE(child<QPushButton>("startStudy")->isEnabled());
}

TEST_F(WindowWithStudy, StartAndTargetAreInThePicture) {
    Study high = shortStudy();
    high.tasks = {{TaskKind::Above, 49.0_nm, 50.0_nm, {0}}};
    for (const QSize size : {QSize(1280, 800), QSize(1500, 950)}) {
        window.resize(size);
        start(high);
        ASSERT_TRUE(isAtStart());
        ASSERT_TRUE(runsFor(0.3));
        const QRectF seen = panels.view().rect();
        EXPECT_TRUE(seen.contains(panels.view().onScreen(tip())))
            << ::testing::PrintToString(panels.view().onScreen(tip()).y());
        EXPECT_TRUE(seen.contains(panels.view().onScreen({target().x(), target().y(), 50.0_nm})));
        QTest::mouseClick(child<QPushButton>("leaveStudy"), Qt::LeftButton);
    }
}

TEST_F(WindowWithStudy, WithoutThePictureOfTheDeformationTheSurfaceIsDrawnAtRest) {
    Study blind = shortStudy();
    blind.aids.deformation = false;
    openFlatScene();
    window.menus().entry("secondView").setChecked(true);
    start(blind);
    EXPECT_FALSE(panels.second().isVisible()) << "it draws the deformation";
    EXPECT_FALSE(panels.view().options().deformation);
    EXPECT_TRUE(eventually(
        [this] { return !panels.viewOptions().action(&ViewOptions::deformation).isEnabled(); }));
    QTest::mouseClick(child<QPushButton>("leaveStudy"), Qt::LeftButton);
    EXPECT_TRUE(eventually(
        [this] { return panels.viewOptions().action(&ViewOptions::deformation).isEnabled(); }));
    EXPECT_TRUE(panels.view().options().deformation);
    EXPECT_TRUE(panels.second().isVisible());
}

TEST_F(WindowWithStudy, ArrowsTurnTheView) {
    start(shortStudy());
    const double azimuth = panels.view().camera().azimuth();
    const double elevation = panels.view().camera().elevation();
    QTest::mouseClick(child<QToolButton>("turnRight"), Qt::LeftButton);
    QTest::mouseClick(child<QToolButton>("turnUp"), Qt::LeftButton);
    EXPECT_NE(panels.view().camera().azimuth(), azimuth);
    EXPECT_GT(panels.view().camera().elevation(), elevation);
}

TEST_F(WindowWithStudy, ShowsItsFiguresAndFindings) {
    start(shortStudy());
    doTrial();
    QTest::mouseClick(child<QPushButton>("studyResults"), Qt::LeftButton);
    StudyResultsDialog* dialog = nullptr;
    ASSERT_TRUE(eventually([&] {
        dialog = window.findChild<StudyResultsDialog*>();
        return dialog != nullptr && dialog->isVisible();
    }));
    EXPECT_EQ(dialog->findChild<QTabWidget*>()->count(), 4);
    const QString text = dialog->findChild<QPlainTextEdit*>("resultsText")->toPlainText();
    EXPECT_TRUE(text.contains("polystyrene")) << text.toStdString();
    EXPECT_TRUE(text.contains("findings"));
    EXPECT_TRUE(std::filesystem::exists(out() / "figure_13.svg"));
    EXPECT_TRUE(std::filesystem::exists(out() / "statistics.csv"));
    const ProgramRun check = runCommand(
        "python3 " + (test::checkout() / "tests/app/experiment/recompute_study.py").string() +
        " --folder " + out().string());
    EXPECT_EQ(check.exitCode, 0) << check.output;
}

TEST_F(WindowWithStudy, WithoutForcesNobodySwitchesThemOn) {
    openFlatScene();
    choose("device", "Simulated device");
    Study numb = shortStudy();
    numb.aids.forces = false;
    start(numb);
    EXPECT_FALSE(stage.run()->settings().forcesOn);
    QTest::mouseClick(child<QPushButton>("forces"), Qt::LeftButton);
    EXPECT_FALSE(stage.run()->settings().forcesOn);
    pressButton();
    ASSERT_TRUE(runsFor(0.3));
    EXPECT_TRUE(isInTrial()) << "that they are off is no reason to end it";
    EXPECT_EQ(stage.run()->loop().snapshot().sample.output.deviceForce, Vector3::Zero());
}

TEST_F(WindowWithStudy, ASecondViewThatIsOpenedLaterShowsTheTarget) {
    start(shortStudy());
    window.menus().entry("secondView").setChecked(true);
    ASSERT_TRUE(eventually([this] { return panels.second().space().target().has_value(); }));
    EXPECT_EQ(panels.second().space().target()->head<2>(), target().head<2>());
    QTest::mouseClick(child<QPushButton>("leaveStudy"), Qt::LeftButton);
    EXPECT_FALSE(panels.second().space().target().has_value());
    EXPECT_FALSE(panels.view().target().has_value());
}

}  // namespace
}  // namespace asperity::test
