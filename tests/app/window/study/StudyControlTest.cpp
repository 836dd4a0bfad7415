#include "app/window/study/StudyControl.h"

#include "core/io/experiment/StudyFile.h"
#include "tests/app/window/ControlFixture.h"
#include "tests/app/window/study/ShortStudy.h"
#include "ui/shell/Menus.h"

#include <QAction>
#include <QLabel>
#include <QPushButton>

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::test {
namespace {

/// A study on a stage that nothing else acts on: no device, no keys.
class StudyControlTest : public ControlFixture {
protected:
    QPushButton& button(const char* name) {
        return *window.findChild<QPushButton*>(QString::fromLatin1(name));
    }
    std::string text(const char* label) {
        return window.findChild<QLabel*>(QString::fromLatin1(label))->text().toStdString();
    }
    QAction& entry(const char* name) { return window.menus().entry(name); }
    std::string action() { return button("trialAction").text().toStdString(); }
    /// Does nothing right after a change: for what was before.
    bool pressLeadsTo(const char* next) {
        return eventually([&] {
            entry("trial").trigger();
            return action().starts_with(next);
        });
    }
    [[nodiscard]] std::filesystem::path out() const { return folder.path() / "out"; }
    void choose(const Study& study) {
        studies.choice().chooseStudy(writtenStudy(folder, study));
        studies.choice().chooseFolder(out());
    }
    /// On the flat scene.
    void begin(const Study& study) {
        useFlatScene();
        choose(study);
        button("startStudy").click();
        ASSERT_TRUE(eventually([this] { return !runs.fixedBy().isEmpty(); })) << complaint();
    }

    StudyControl& studies = stage.add<StudyControl>();
    QSignalSpy opened{&studies.choice(), &StudyChoice::opened};
};

TEST_F(StudyControlTest, WithoutARunNoneBegins) {
    choose(shortStudy());
    button("startStudy").click();
    ASSERT_TRUE(eventually([this] { return opened.count() == 1; })) << complaint();
    EXPECT_TRUE(runs.fixedBy().isEmpty());
    window.menus().refresh();
    EXPECT_FALSE(entry("study").isEnabled());
    EXPECT_FALSE(entry("trial").isEnabled());
    useFlatScene();
    window.menus().refresh();
    EXPECT_TRUE(entry("study").isEnabled());
    EXPECT_FALSE(entry("trial").isEnabled());
}

TEST_F(StudyControlTest, FixesSceneAndKnobsUntilItIsLeft) {
    useFlatScene();
    const SceneDescription before = run().scene().description;
    ASSERT_NO_FATAL_FAILURE(begin(shortStudy()));
    EXPECT_TRUE(runs.fixedBy().contains(QStringLiteral("study"))) << runs.fixedBy().toStdString();
    EXPECT_NE(run().scene().description, before) << "the study's own scene";
    EXPECT_TRUE(run().settings().clutched) << "the tip rests until a trial begins";
    EXPECT_EQ(text("trialTask"), "Task B on polystyrene");
    EXPECT_TRUE(entry("trial").isEnabled());
    SceneDescription other = run().scene().description;
    other.tip.radius *= 2.0;
    edits.change("Tip radius", other);
    EXPECT_EQ(*edits.wanted(), run().scene().description);
    button("leaveStudy").click();
    EXPECT_TRUE(runs.fixedBy().isEmpty());
    EXPECT_EQ(run().scene().description, before);
    EXPECT_FALSE(run().settings().clutched);
    EXPECT_FALSE(entry("trial").isEnabled());
}

TEST_F(StudyControlTest, ATrialBeginsAndEndsByTheButtonAndIsKept) {
    const Study study = shortStudy();
    stage.play(20);
    ASSERT_NO_FATAL_FAILURE(begin(study));
    ASSERT_TRUE(pressLeadsTo("Done")) << text("trialInstruction");
    EXPECT_FALSE(run().settings().clutched);
    ASSERT_TRUE(eventually([this] {
        const std::string time = text("trialTime");
        return !time.empty() && time != "0.0 s";
    })) << text("trialTime");
    ASSERT_TRUE(pressLeadsTo("Next")) << action();
    EXPECT_TRUE(run().settings().clutched);
    const std::vector<TrialRecord> trials = readTrials(out() / "trials.csv", study);
    ASSERT_EQ(trials.size(), 1U);
    EXPECT_TRUE(trials.front().counts());
    EXPECT_GT(trials.front().time, 0.0);
    EXPECT_EQ(trials.front().device, "path");
    EXPECT_TRUE(std::filesystem::exists(out() / "trials" / "001" / "trajectory.csv"));
    EXPECT_EQ(complaint(), "");
}

TEST_F(StudyControlTest, WithoutForcesNobodySwitchesThemOnUntilItIsLeft) {
    Study numb = shortStudy();
    numb.aids.forces = false;
    ASSERT_NO_FATAL_FAILURE(begin(numb));
    EXPECT_FALSE(run().settings().forcesOn);
    runs.setForces(true);
    EXPECT_FALSE(run().settings().forcesOn);
    EXPECT_EQ(told(), runs.fixedBy().toStdString());
    button("leaveStudy").click();
    runs.setForces(true);
    EXPECT_TRUE(run().settings().forcesOn);
}

TEST_F(StudyControlTest, AFolderOfAnotherStudyIsRefused) {
    ASSERT_NO_FATAL_FAILURE(begin(shortStudy()));
    button("leaveStudy").click();
    EXPECT_TRUE(button("startStudy").isEnabled());
    Study other = shortStudy();
    other.timeLimit = 30.0;
    choose(other);
    EXPECT_FALSE(button("startStudy").isEnabled());
    EXPECT_NE(text("studyState").find("another study"), std::string::npos) << text("studyState");
}

TEST_F(StudyControlTest, OneForTheOperatorModelAloneIsRefused) {
    useFlatScene();
    Study uncoupled = shortStudy();
    uncoupled.aids.coupling = false;
    choose(uncoupled);
    button("startStudy").click();
    std::string words;
    ASSERT_TRUE(eventually([&] {
        words = complaint();
        return !words.empty();
    }));
    EXPECT_NE(words.find("[aids] coupling"), std::string::npos) << words;
    EXPECT_EQ(opened.count(), 0);
    EXPECT_TRUE(runs.fixedBy().isEmpty());
}

}  // namespace
}  // namespace asperity::test
