#include "core/Units.h"
#include "core/io/experiment/TrialTable.h"
#include "tests/app/ProgramRun.h"
#include "tests/app/window/ShortStudy.h"
#include "tests/app/window/WindowFixture.h"
#include "ui/experiment/StudyResultsDialog.h"
#include "ui/view/ZoomView.h"
#include "ui/window/SecondView.h"
#include "ui/window/ViewOptionsMenu.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QComboBox>
#include <QInputDialog>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>
#include <QToolButton>
#include <QtTest>

#include <cmath>

namespace asperity::test {
namespace {

/// A device that can be pulled out.
class LooseDevice final : public HapticDevice {
public:
    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return kSensesOnly;
    }
    DeviceState advance(double /*timeStep*/) noexcept override { return {.connected = false}; }
};

constexpr int kSettle = 600;  // [ms]: a press right after a change is for what was before

/// The window with a short study, done by mouse and keys.
class WindowWithStudy : public Window {
protected:
    void start(const Study& wanted) {
        study = wanted;
        if (session.run() == nullptr) {
            openFlatScene();
        }
        window.menus().study->trigger();
        session.studies().choice().chooseStudy(writtenStudy(folder, study));
        session.studies().choice().chooseFolder(out());
        QTest::mouseClick(child<QPushButton>("startStudy"), Qt::LeftButton);
        ASSERT_TRUE(eventually([this] { return window.menus().trial->isEnabled(); }));
    }
    [[nodiscard]] std::filesystem::path out() { return folder.path() / "out"; }
    std::string action() { return child<QPushButton>("trialAction")->text().toStdString(); }
    /// As a person does, who sees the tip first.
    void pressButton() {
        EXPECT_TRUE(
            eventually([this] { return session.run()->loop().snapshot().statistics.ticks > 0; }));
        live(kSettle);
        QTest::keyClick(&window.view(), Qt::Key_Return);
    }
    bool isInTrial() { return action().starts_with("Done"); }
    bool isReady() { return action().starts_with("Begin"); }

    Vector3 tip() { return session.run()->loop().snapshot().sample.output.model.tip; }
    Vector3 target() {
        const Vector2 place =
            0.5 * Vector2(study.scene.sample.shape->size, study.scene.sample.shape->size) +
            study.targets.front();
        return {place.x(), place.y(), 0.0};
    }
    double missing() { return (tip() - target()).head<2>().norm(); }

    /// Drags the tip above the target, as seen on the screen.
    void dragAcross() {
        for (int i = 0; i < 8 && missing() > 1.0_nm; ++i) {
            const Vector3 here = tip();
            const QPointF from = window.view().onScreen(here);
            const QPointF to = window.view().onScreen({target().x(), target().y(), here.z()});
            const QPoint start = window.view().rect().center();
            drag(start, start + (to - from).toPoint());
            live(500);
        }
        EXPECT_LT(missing(), 1.5_nm);
    }
    /// Turns the wheel until the tip touches.
    void goDown() {
        for (int i = 0; i < 60 && !inContact(); ++i) {
            turnWheel(-1);
            live(150);
        }
        EXPECT_TRUE(inContact()) << state();
    }
    bool isAtStart() {
        return eventually([this] { return std::abs(tip().z() - study.startHeight) < 1.0_nm; });
    }
    void doTrial() {
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
    std::vector<TrialRecord> trials() { return readTrials(out() / "trials.csv", study); }
    std::string readingOf(const char* name) { return text(name); }

    Study study;
};

TEST_F(WindowWithStudy, IsDoneFromBeginningToEndByMouseAndEnter) {
    openFlatScene();
    const SceneDescription before = session.run()->scene().description;
    start(shortStudy());
    EXPECT_EQ(text("trialTask"), "Task B on polystyrene");
    doTrial();
    ASSERT_EQ(trials().size(), 1U);
    const TrialRecord first = trials().front();
    EXPECT_TRUE(first.counts());
    EXPECT_EQ(first.device, "window");
    EXPECT_LT(first.error, 3.0_nm);
    EXPECT_LT(first.errorPercent, 6.0);
    EXPECT_GT(first.time, 1.0);
    EXPECT_GT(first.largestForce, 1.0_nN) << "the snap-in is felt";
    EXPECT_NE(readingOf("trialError"), "–");
    pressButton();
    doTrial();
    pressButton();
    EXPECT_TRUE(action().starts_with("Leave")) << action();
    pressButton();
    EXPECT_FALSE(window.menus().trial->isEnabled());
    EXPECT_EQ(session.run()->scene().description, before);
    EXPECT_TRUE(child<QComboBox>("material")->isEnabled());
}

TEST_F(WindowWithStudy, ItsTrialsReplayToTheBit) {
    start(shortStudy());
    doTrial();
    const std::string trial = (out() / "trials" / "001").string();
    EXPECT_TRUE(std::filesystem::exists(trial + "/trajectory.csv"));
    const ProgramRun replay =
        runProgram("replay " + trial + " --out " + (folder.path() / "replayed").string());
    EXPECT_EQ(replay.exitCode, 0) << replay.output;
    EXPECT_NE(replay.output.find("identical"), std::string::npos) << replay.output;
}

TEST_F(WindowWithStudy, OnTheSimulatedDeviceHasItsScaleAndTheDeviceStays) {
    openFlatScene();
    choose("hand", "Simulated device");
    start(shortStudy());
    const auto isAtScale = [this] {
        const Settings& knobs = session.run()->settings();
        return knobs.positionGain == study.scale.positionGain &&
               knobs.forceGain == study.scale.forceGain && knobs.coupling.couples();
    };
    EXPECT_TRUE(isAtScale());
    doTrial();
    pressButton();
    EXPECT_TRUE(isAtScale());
    EXPECT_EQ(child<QComboBox>("hand")->currentText(), QStringLiteral("Simulated device"));
    const TrialRecord first = trials().front();
    EXPECT_TRUE(first.counts());
    EXPECT_LT(first.error, 3.0_nm);
    EXPECT_EQ(first.scale.positionGain, study.scale.positionGain);
    EXPECT_GT(first.coupling.stiffness, 0.0);
}

TEST_F(WindowWithStudy, ItsKnobsAreLockedAndTheTipRestsUntilATrialBegins) {
    start(shortStudy());
    for (const char* const name : {"material", "hand", "path"}) {
        EXPECT_FALSE(child<QComboBox>(name)->isEnabled()) << name;
        EXPECT_NE(child<QComboBox>(name)->toolTip().indexOf("study"), -1) << name;
    }
    live(50);
    for (const QAction* const entry :
         {window.menus().open, window.menus().record, window.menus().startPause,
          window.menus().tipControl, window.menus().clutch, window.menus().undo}) {
        EXPECT_FALSE(entry->isEnabled()) << entry->text().toStdString();
    }
    const Vector3 before = tip();
    drag(window.view().rect().center(), window.view().rect().center() + QPoint(60, 0));
    turnWheel(-3);
    live(600);
    EXPECT_LT((tip() - before).norm(), 0.1_nm);
    SceneDescription other = session.run()->scene().description;
    other.tip.radius *= 2.0;
    session.edits().change("Tip radius", other);
    live(600);
    EXPECT_NE(session.run()->scene().description.tip.radius, other.tip.radius);
}

TEST_F(WindowWithStudy, AStruckOutTrialIsKeptWithItsReasonAndComesAgain) {
    start(shortStudy());
    pressButton();
    live(200);
    pressButton();
    QTest::mouseClick(child<QPushButton>("strikeOut"), Qt::LeftButton);
    auto* dialog = window.findChild<QInputDialog*>("strikeOutDialog");
    ASSERT_NE(dialog, nullptr);
    dialog->setTextValue("the phone, it \"rang\"");
    dialog->accept();
    ASSERT_EQ(trials().size(), 1U);
    EXPECT_EQ(trials()[0].struckOut, "the phone, it \"rang\"");
    EXPECT_NE(text("trialNote").find("rang"), std::string::npos);
    pressButton();
    EXPECT_NE(text("trialPlace").find("attempt 2"), std::string::npos) << text("trialPlace");
    pressButton();
    live(200);
    pressButton();
    ASSERT_EQ(trials().size(), 2U);
    EXPECT_TRUE(trials()[1].counts());
    EXPECT_EQ(trials()[1].plan.attempt, 2);
    EXPECT_TRUE(std::filesystem::exists(out() / "trials" / "001_2" / "trajectory.csv"));
}

TEST_F(WindowWithStudy, ASecondPressRightAfterTheFirstDoesNothing) {
    start(shortStudy());
    pressButton();
    for (int i = 0; i < 5; ++i) {
        QTest::keyClick(&window.view(), Qt::Key_Return);
    }
    EXPECT_TRUE(isInTrial()) << action();
    pressButton();
    EXPECT_GT(trials().at(0).time, 0.5);
}

TEST_F(WindowWithStudy, TheLastTrialCanBeStruckOutUntilTheNextOneBegins) {
    start(shortStudy());
    pressButton();
    pressButton();
    pressButton();
    ASSERT_TRUE(isReady()) << action();
    ASSERT_TRUE(child<QPushButton>("strikeOut")->isEnabled());
    QTest::mouseClick(child<QPushButton>("strikeOut"), Qt::LeftButton);
    auto* dialog = window.findChild<QInputDialog*>("strikeOutDialog");
    ASSERT_NE(dialog, nullptr);
    dialog->setTextValue("too soon");
    dialog->accept();
    EXPECT_NE(text("trialPlace").find("trial 1 of 2"), std::string::npos) << text("trialPlace");
    EXPECT_NE(text("trialPlace").find("attempt 2"), std::string::npos) << text("trialPlace");
    EXPECT_FALSE(child<QPushButton>("strikeOut")->isEnabled());
}

TEST_F(WindowWithStudy, ItsFormThatALayoutBringsBackOffersTheShippedStudy) {
    openFlatScene();
    window.showTool(child<QPushButton>("startStudy")->parentWidget()->parentWidget());
    EXPECT_FALSE(text("studyName").empty());
    EXPECT_TRUE(child<QPushButton>("startStudy")->isEnabled());
}

TEST_F(WindowWithStudy, AFolderOfAnotherStudyIsRefused) {
    start(shortStudy());
    QTest::mouseClick(child<QPushButton>("leaveStudy"), Qt::LeftButton);
    Study other = shortStudy();
    other.timeLimit = 30.0;
    session.studies().choice().chooseStudy(writtenStudy(folder, other));
    session.studies().choice().chooseFolder(out());
    EXPECT_FALSE(child<QPushButton>("startStudy")->isEnabled());
    EXPECT_NE(text("studyState").find("another study"), std::string::npos) << text("studyState");
}

TEST_F(WindowWithStudy, StartAndTargetAreInThePicture) {
    Study high = shortStudy();
    high.tasks = {{TaskKind::Above, 49.0_nm, 50.0_nm, {0}}};
    for (const QSize size : {QSize(1280, 800), QSize(1500, 950)}) {
        window.resize(size);
        start(high);
        ASSERT_TRUE(isAtStart());
        live(300);
        const QRectF seen = window.view().rect();
        EXPECT_TRUE(seen.contains(window.view().onScreen(tip())))
            << ::testing::PrintToString(window.view().onScreen(tip()).y());
        EXPECT_TRUE(seen.contains(window.view().onScreen({target().x(), target().y(), 50.0_nm})));
        QTest::mouseClick(child<QPushButton>("leaveStudy"), Qt::LeftButton);
    }
}

TEST_F(WindowWithStudy, AFaultEndsItsTrialIsKeptAndTheTrialComesAgain) {
    start(shortStudy());
    pressButton();
    live(100);
    session.run()->takeDevice([] { return std::make_unique<LooseDevice>(); });
    ASSERT_TRUE(eventually([this] { return action().starts_with("Next"); })) << action();
    ASSERT_EQ(trials().size(), 1U);
    EXPECT_EQ(trials()[0].fault, Fault::DeviceLost);
    pressButton();
    EXPECT_TRUE(isReady()) << action();
    EXPECT_NE(text("trialPlace").find("attempt 2"), std::string::npos) << text("trialPlace");
}

TEST_F(WindowWithStudy, APauseEndsTheTrialAndGoingOnBringsItAgain) {
    start(shortStudy());
    pressButton();
    live(100);
    QTest::mouseClick(child<QPushButton>("pauseStudy"), Qt::LeftButton);
    EXPECT_TRUE(action().starts_with("Go on")) << action();
    ASSERT_EQ(trials().size(), 1U);
    EXPECT_EQ(trials()[0].struckOut, "paused");
    QTest::mouseClick(child<QPushButton>("pauseStudy"), Qt::LeftButton);
    EXPECT_TRUE(isReady()) << action();
}

TEST_F(WindowWithStudy, ForcesThatAreSwitchedOffEndTheTrial) {
    openFlatScene();
    choose("hand", "Simulated device");
    start(shortStudy());
    pressButton();
    live(200);
    press(Qt::Key_Escape);
    ASSERT_TRUE(eventually([this] { return action().starts_with("Next"); })) << action();
    EXPECT_EQ(trials().at(0).struckOut, "forces were switched off");
    EXPECT_FALSE(session.run()->settings().forcesOn);
    pressButton();
    EXPECT_TRUE(isReady()) << action();
    EXPECT_FALSE(session.run()->settings().forcesOn) << "nobody has switched them on";
    pressButton();
    EXPECT_TRUE(isReady()) << action();
    EXPECT_NE(text("trialInstruction").find("Forces are off"), std::string::npos);
    QTest::mouseClick(child<QPushButton>("forces"), Qt::LeftButton);
    pressButton();
    EXPECT_TRUE(isInTrial()) << action();
    press(Qt::Key_Escape);
    QTest::mouseClick(child<QPushButton>("leaveStudy"), Qt::LeftButton);
    EXPECT_FALSE(session.run()->settings().forcesOn) << "after the study neither";
}

TEST_F(WindowWithStudy, WithoutForcesNobodySwitchesThemOn) {
    openFlatScene();
    choose("hand", "Simulated device");
    Study numb = shortStudy();
    numb.aids.forces = false;
    start(numb);
    EXPECT_FALSE(session.run()->settings().forcesOn);
    QTest::mouseClick(child<QPushButton>("forces"), Qt::LeftButton);
    EXPECT_FALSE(session.run()->settings().forcesOn);
    pressButton();
    live(300);
    EXPECT_TRUE(isInTrial()) << "that they are off is no reason to end it";
    EXPECT_EQ(session.run()->loop().snapshot().sample.output.deviceForce, Vector3::Zero());
}

TEST_F(WindowWithStudy, TheTimeLimitEndsATrialThatCounts) {
    Study quick = shortStudy();
    quick.timeLimit = 1.0;
    start(quick);
    pressButton();
    ASSERT_TRUE(eventually([this] { return action().starts_with("Next"); })) << action();
    EXPECT_TRUE(trials().at(0).timedOut);
    EXPECT_TRUE(trials().at(0).counts());
    EXPECT_NEAR(trials().at(0).time, 1.0, 0.3);
}

TEST_F(WindowWithStudy, ItBeginsWithATrainingThatKeepsNothingAndEndsByItself) {
    Study trained = shortStudy();
    trained.training = 1.5;
    start(trained);
    EXPECT_EQ(text("trialTask"), "Try the program");
    const double before = tip().z();
    turnWheel(-3);
    EXPECT_TRUE(eventually([&] { return tip().z() < before - 1.0_nm; }, 1000)) << "it moves";
    ASSERT_TRUE(eventually([this] { return isReady(); }, 5000)) << action();
    EXPECT_TRUE(isAtStart());
    EXPECT_FALSE(std::filesystem::exists(out() / "trials.csv"));
}

TEST_F(WindowWithStudy, GoesOnWhereItWasLeft) {
    start(shortStudy());
    doTrial();
    pressButton();
    pressButton();
    ASSERT_TRUE(isInTrial());
    QTest::mouseClick(child<QPushButton>("leaveStudy"), Qt::LeftButton);
    ASSERT_EQ(trials().size(), 2U);
    EXPECT_EQ(trials()[1].struckOut, "left");
    EXPECT_NE(text("studyState").find("count: 1"), std::string::npos) << text("studyState");
    EXPECT_EQ(child<QSpinBox>("studyParticipant")->value(), 1);
    start(study);
    EXPECT_NE(text("trialPlace").find("trial 2 of 2"), std::string::npos) << text("trialPlace");
    EXPECT_NE(text("trialPlace").find("attempt 2"), std::string::npos) << text("trialPlace");
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
    const ProgramRun check =
        runCommand("python3 " ASPERITY_RECOMPUTE_STUDY " --folder " + out().string());
    EXPECT_EQ(check.exitCode, 0) << check.output;
}

TEST_F(WindowWithStudy, WithoutThePictureOfTheDeformationTheSurfaceIsDrawnAtRest) {
    Study blind = shortStudy();
    blind.aids.deformation = false;
    openFlatScene();
    window.menus().secondView->setChecked(true);
    start(blind);
    EXPECT_FALSE(window.second().isVisible()) << "it draws the deformation";
    EXPECT_FALSE(window.view().options().deformation);
    EXPECT_FALSE(window.menus().viewOptions().action(&ViewOptions::deformation).isEnabled());
    QTest::mouseClick(child<QPushButton>("leaveStudy"), Qt::LeftButton);
    live(50);
    EXPECT_TRUE(window.view().options().deformation);
    EXPECT_TRUE(window.second().isVisible());
    EXPECT_TRUE(window.menus().viewOptions().action(&ViewOptions::deformation).isEnabled());
}

TEST_F(WindowWithStudy, ArrowsTurnTheView) {
    start(shortStudy());
    const double azimuth = window.view().camera().azimuth();
    const double elevation = window.view().camera().elevation();
    QTest::mouseClick(child<QToolButton>("turnRight"), Qt::LeftButton);
    QTest::mouseClick(child<QToolButton>("turnUp"), Qt::LeftButton);
    EXPECT_NE(window.view().camera().azimuth(), azimuth);
    EXPECT_GT(window.view().camera().elevation(), elevation);
}

}  // namespace
}  // namespace asperity::test
