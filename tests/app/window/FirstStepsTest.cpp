#include "tests/app/window/ScanWalk.h"
#include "ui/view/ZoomView.h"

#include <QAbstractButton>
#include <QApplication>
#include <QFileDialog>
#include <QImage>
#include <QPushButton>

#include <filesystem>

namespace asperity::test {
namespace {

namespace fs = std::filesystem;

/// The path of docs/first_steps.md, click by click.
class FirstSteps : public ScanWalk {
protected:
    void touch() {
        startRecording();
        engage();
        const QPoint middle = panels.view().rect().center();
        drag(middle, middle + QPoint(30, 0));
        ASSERT_TRUE(runsFor(0.5));
    }

    /// The file dialog runs an event loop of its own.
    void savePicture() {
        const auto chooser = [] {
            return qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        };
        onceReady([=] { return chooser() != nullptr; },
                  [this, chooser] {
                      chooser()->selectFile(QString::fromStdString(picture_.string()));
                      for (QPushButton* button : chooser()->findChildren<QPushButton*>()) {
                          if (QString(button->text()).remove('&') == QStringLiteral("Save")) {
                              user.click(*button);
                              return;
                          }
                      }
                  });
        user.choose(window, {"File", "Save picture"});
        ASSERT_TRUE(eventually([this] { return fs::exists(picture_); }));
    }

    fs::path picture_ = folder.path() / "asperity.png";
};

TEST_F(FirstSteps, LeadFromARealScanToAPictureAndAForceLog) {
    ASSERT_NO_FATAL_FAILURE(openScan("nanoscope/cl_0deg_xcal_v9.70.spm"));
    ASSERT_NO_FATAL_FAILURE(levelAndOpen());
    ASSERT_NO_FATAL_FAILURE(touch());
    ASSERT_NO_FATAL_FAILURE(savePicture());
    ASSERT_NO_FATAL_FAILURE(withdraw());
    const fs::path run = stopRecording();
    EXPECT_EQ(QImage(QString::fromStdString(picture_.string())).size(), window.size());
    EXPECT_GT(fs::file_size(run / "force_log.csv"), 100000U);
    EXPECT_TRUE(fs::exists(run / "summary.json"));
    expectNothingToRead();
    constexpr int kDrags = 1;
    EXPECT_EQ(user.clicks() + kDrags, 14) << "docs/first_steps.md counts them";
}

}  // namespace
}  // namespace asperity::test
