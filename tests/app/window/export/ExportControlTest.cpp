#include "app/window/export/ExportControl.h"

#include "app/window/export/ExportDialog.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/tables/CsvTable.h"
#include "tests/app/window/ControlFixture.h"
#include "ui/shell/Menus.h"
#include "ui/view/ZoomView.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QImage>
#include <QImageReader>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSpinBox>

#include <cmath>
#include <cstddef>
#include <map>
#include <string>

namespace asperity::test {
namespace {

class ExportControlTest : public ControlFixture {
protected:
    void SetUp() override {
        exports.remember(settings());
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
        useFlatScene();
        ASSERT_TRUE(eventually([this] { return run().loop().snapshot().statistics.ticks > 50; }));
        runs.fetch();
        views.show(0.0);
    }
    std::unique_ptr<QSettings> settings() {
        return std::make_unique<QSettings>(QString::fromStdString(folder.file("a.ini").string()),
                                           QSettings::IniFormat);
    }
    template <typename Widget>
    Widget* child(const char* name) {
        auto* found = exports.dialog()->findChild<Widget*>(QString::fromLatin1(name));
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    /// Opens the dialog on a subject that goes into the test's folder.
    void ask(ExportSubject subject, const QString& format) {
        exports.ask();
        ASSERT_NE(exports.dialog(), nullptr);
        child<QLineEdit>("exportFolder")->setText(QString::fromStdString(folder.path().string()));
        child<QComboBox>("exportSubject")->setCurrentIndex(static_cast<int>(subject));
        auto* formats = child<QComboBox>("exportFormat");
        ASSERT_GE(formats->findData(format), 0);
        formats->setCurrentIndex(formats->findData(format));
    }
    void write() { child<QPushButton>("exportWrite")->click(); }
    /// Writes, and waits until the bottom line names the file.
    ::testing::AssertionResult isWritten(const std::string& name) {
        write();
        const std::string wanted = "Exported to " + folder.file(name).string();
        return eventually([&] { return told() == wanted; })
                   ? ::testing::AssertionSuccess()
                   : ::testing::AssertionFailure() << "told: " << told();
    }
    QImage read(const std::string& name) {
        return QImage(QString::fromStdString(folder.file(name).string()));
    }
    void setSize(int width, int height) {
        child<QSpinBox>("exportWidth")->setValue(width);
        child<QSpinBox>("exportHeight")->setValue(height);
    }
    ExportPicture& preview() { return *child<ExportPicture>("exportPreview"); }

    ViewControl& views = stage.add<ViewControl>();
    ExportControl& exports = stage.add<ExportControl>();
};

TEST_F(ExportControlTest, TheLargeViewHasTheSizeThatIsChosen) {
    ask(ExportSubject::View, "png");
    setSize(400, 300);
    child<QLineEdit>("exportName")->setText("a_{view}_{n}");
    ASSERT_TRUE(isWritten("a_view_1.png"));
    const QImage picture = read("a_view_1.png");
    EXPECT_EQ(picture.size(), QSize(400, 300));
    EXPECT_NE(picture.pixelColor(200, 170), picture.pixelColor(2, 2)) << "there is a surface";
    ask(ExportSubject::View, "tif");
    child<QCheckBox>("exportTransparent")->setChecked(true);
    child<QCheckBox>("exportClean")->setChecked(true);
    ASSERT_TRUE(isWritten("a_view_1.tif"));
}

TEST_F(ExportControlTest, PlotsAreWrittenAsTheyArePreviewed) {
    ask(ExportSubject::Forces, "png");
    setSize(900, 600);
    ASSERT_TRUE(eventually([this] { return !preview().picture().isNull(); }));
    child<QLineEdit>("exportName")->setText("plot");
    ASSERT_TRUE(isWritten("plot.png"));
    EXPECT_EQ(read("plot.png").size(), QSize(900, 600));
}

TEST_F(ExportControlTest, ForcesAreATableOfTheLastSeconds) {
    ask(ExportSubject::Forces, "csv");
    child<QLineEdit>("exportName")->setText("forces");
    ASSERT_TRUE(isWritten("forces.csv"));
    const CsvTable table = readCsv(folder.file("forces.csv"));
    ASSERT_GT(table.rows(), 50U);
    EXPECT_GT(table.number(table.rows() - 1, "time_s"), table.number(0, "time_s"));
}

TEST_F(ExportControlTest, NoPreviewIsOfAnotherSubject) {
    ask(ExportSubject::Forces, "png");
    ASSERT_TRUE(eventually([this] { return !preview().picture().isNull(); }));
    child<QComboBox>("exportSubject")->setCurrentIndex(static_cast<int>(ExportSubject::Cycle));
    ASSERT_TRUE(eventually(
        [this] { return child<QLabel>("exportMessage")->text().startsWith("There is no force"); }));
    EXPECT_TRUE(preview().picture().isNull());
}

TEST_F(ExportControlTest, ALargeViewAsksFirstWhileARecordingRuns) {
    ask(ExportSubject::View, "png");
    setSize(4096, 2048);
    runs.setRecorded(true);
    write();
    auto* question = exports.dialog()->findChild<QMessageBox*>();
    ASSERT_NE(question, nullptr);
    EXPECT_TRUE(question->text().contains("recording"));
    question->reject();
    EXPECT_NE(exports.dialog(), nullptr) << "nothing is written";
}

TEST_F(ExportControlTest, ThereIsNoCycleBeforeTheTipHasMoved) {
    ask(ExportSubject::Cycle, "png");
    EXPECT_TRUE(eventually(
        [this] { return child<QLabel>("exportMessage")->text().startsWith("There is no force"); }));
    EXPECT_FALSE(child<QPushButton>("exportWrite")->isEnabled());
    child<QComboBox>("exportSubject")->setCurrentIndex(static_cast<int>(ExportSubject::Surface));
    EXPECT_TRUE(eventually([this] { return child<QPushButton>("exportWrite")->isEnabled(); }));
}

TEST_F(ExportControlTest, TheSurfaceReadsBack) {
    for (const QString& format : {QStringLiteral("gwy"), QStringLiteral("gsf")}) {
        ask(ExportSubject::Surface, format);
        child<QLineEdit>("exportName")->setText("surface");
        const std::string name = "surface." + format.toStdString();
        ASSERT_TRUE(isWritten(name));
        const HeightMapFile file = readHeightMapFile(folder.file(name));
        const ScanChannel& channel = heightChannel(file, folder.file(name), {});
        EXPECT_EQ(channel.map.columns, run().scene().surface.grid().columns);
        EXPECT_DOUBLE_EQ(channel.map.pitchX, run().scene().surface.grid().pitchX);
    }
}

TEST_F(ExportControlTest, TheDeformedSurfaceIsAField) {
    for (const char* format : {"exr", "vtp", "vts", "csv"}) {
        ask(ExportSubject::Deformation, format);
        child<QLineEdit>("exportName")->setText("field");
        ASSERT_TRUE(isWritten(std::string("field.") + format));
    }
    const CsvTable table = readCsv(folder.file("field.csv"));
    EXPECT_GT(table.rows(), 1000U);
    EXPECT_LT(std::abs(table.number(0, "displacement_z_m")), 1e-12);
}

TEST_F(ExportControlTest, TheSectionThroughTheContactIsATable) {
    ask(ExportSubject::Section, "csv");
    child<QLineEdit>("exportName")->setText("section");
    ASSERT_TRUE(isWritten("section.csv"));
    const CsvTable table = readCsv(folder.file("section.csv"));
    std::map<std::string, std::size_t> points;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        ++points[table.text(row, "curve")];
    }
    const std::size_t rest = points["rest"];
    EXPECT_GT(rest, 100U);
    EXPECT_EQ(points["deformed"], rest);
    EXPECT_GT(points["tip"], 20U);
    EXPECT_EQ(points.size(), 3U);
    EXPECT_NEAR(table.number(rest - 1, "x_m") - table.number(0, "x_m"),
                table.number(rest - 1, "along_m") - table.number(0, "along_m"), 1e-18)
        << "a section along x";
    EXPECT_EQ(table.number(rest - 1, "y_m"), table.number(0, "y_m"));
    EXPECT_NEAR(table.number(rest / 2, "z_m"), 0.0, 1e-12) << "the sample is flat";
}

TEST_F(ExportControlTest, NothingIsReplacedUnasked) {
    const std::filesystem::path there = folder.write("there.csv", "mine");
    ask(ExportSubject::Forces, "csv");
    child<QLineEdit>("exportName")->setText("there");
    write();
    auto* box = exports.dialog()->findChild<QMessageBox*>("askWhether");
    ASSERT_NE(box, nullptr);
    EXPECT_TRUE(box->text().contains("there.csv is there already"));
    QTest::keyClick(box, Qt::Key_Escape);
    EXPECT_EQ(std::filesystem::file_size(there), 4U);
    ASSERT_TRUE(eventually(
        [this] { return exports.dialog()->findChild<QMessageBox*>("askWhether") == nullptr; }));
    write();
    box = exports.dialog()->findChild<QMessageBox*>("askWhether");
    ASSERT_NE(box, nullptr);
    for (QAbstractButton* const button : box->buttons()) {
        if (box->buttonRole(button) == QMessageBox::AcceptRole) {
            button->click();
        }
    }
    EXPECT_TRUE(eventually([&] { return std::filesystem::file_size(there) > 1000U; }));
}

TEST_F(ExportControlTest, ABadNameIsSaidInTheDialog) {
    ask(ExportSubject::Forces, "csv");
    child<QLineEdit>("exportName")->setText("{time}");
    EXPECT_TRUE(child<QLabel>("exportMessage")->text().contains("{time}"));
    EXPECT_FALSE(child<QPushButton>("exportWrite")->isEnabled());
    child<QLineEdit>("exportName")->setText("{n}");
    EXPECT_EQ(child<QLabel>("exportMessage")->text(), QString());
    EXPECT_TRUE(child<QPushButton>("exportWrite")->isEnabled());
}

TEST_F(ExportControlTest, AFolderThatCannotBeWrittenIsSaidInTheDialog) {
    (void)folder.write("file", "x");
    ask(ExportSubject::Forces, "csv");
    child<QLineEdit>("exportFolder")
        ->setText(QString::fromStdString(folder.file("file").string()) + "/below");
    write();
    EXPECT_NE(exports.dialog(), nullptr);
    EXPECT_NE(child<QLabel>("exportMessage")->text(), QString());
}

TEST_F(ExportControlTest, AColumnOfAJournalSaysTheWidth) {
    ask(ExportSubject::View, "png");
    auto* columns = child<QComboBox>("exportColumn");
    columns->setCurrentIndex(columns->findData("single"));
    EXPECT_EQ(child<QSpinBox>("exportDpi")->value(), 300);
    EXPECT_EQ(child<QSpinBox>("exportWidth")->value(), 1004);  // 85 mm
    EXPECT_FALSE(child<QSpinBox>("exportWidth")->isEnabled());
    child<QSpinBox>("exportDpi")->setValue(600);
    EXPECT_EQ(child<QSpinBox>("exportWidth")->value(), 2008);
    columns->setCurrentIndex(columns->findData("double"));
    child<QSpinBox>("exportDpi")->setValue(2400);  // more than the widest picture has
    const double inches = child<QSpinBox>("exportWidth")->value() /
                          static_cast<double>(child<QSpinBox>("exportDpi")->value());
    EXPECT_NEAR(inches, 174.0 / 25.4, 0.01) << "fewer dots, not a narrower picture";
}

TEST_F(ExportControlTest, CopyPutsThePictureOnTheClipboard) {
    QApplication::clipboard()->setText("nothing");
    ask(ExportSubject::View, "png");
    setSize(320, 240);
    child<QPushButton>("exportCopy")->click();
    EXPECT_EQ(QApplication::clipboard()->image().size(), QSize(320, 240));
    EXPECT_EQ(told(), "The picture is on the clipboard");
}

TEST_F(ExportControlTest, ChoicesStayFromOneSessionToTheNext) {
    ask(ExportSubject::Surface, "vtp");
    child<QLineEdit>("exportName")->setText("mine");
    child<QCheckBox>("exportClean")->setChecked(true);
    EXPECT_TRUE(exports.dialog()->choices().dent) << "contacts are colored by displacement";
    child<QCheckBox>("exportDent")->setChecked(false);
    exports.dialog()->reject();
    ExportControl next(stage);
    next.remember(settings());
    next.ask();
    const ExportChoices& choices = next.dialog()->choices();
    EXPECT_EQ(choices.subject, ExportSubject::Surface);
    EXPECT_EQ(next.dialog()->format(), "vtp");
    EXPECT_EQ(choices.name, "mine");
    EXPECT_TRUE(choices.clean);
    EXPECT_FALSE(choices.dent);
    EXPECT_EQ(choices.folder.toStdString(), folder.path().string());
}

/// What has no effect on a file is gray.
TEST_F(ExportControlTest, OffersTheFormatsOfTheTableAndASizeWhereTheyHaveOne) {
    const auto offered = [this](ExportSubject subject) {
        child<QComboBox>("exportSubject")->setCurrentIndex(static_cast<int>(subject));
        auto* formats = child<QComboBox>("exportFormat");
        std::string list;
        for (int i = 0; i < formats->count(); ++i) {
            formats->setCurrentIndex(i);
            const bool isSized = child<QSpinBox>("exportHeight")->isEnabled();
            list += formats->itemData(i).toString().toStdString() + (isSized ? "+ " : " ");
        }
        return list;
    };
    ask(ExportSubject::View, "png");
    EXPECT_EQ(offered(ExportSubject::View), "png+ tif+ ");
    EXPECT_EQ(offered(ExportSubject::Window), "png tif ");
    EXPECT_EQ(offered(ExportSubject::Forces), "png+ tif+ svg+ pdf+ csv ");
    EXPECT_EQ(offered(ExportSubject::Cycle), "png+ tif+ svg+ pdf+ csv ");
    EXPECT_EQ(offered(ExportSubject::Deformation), "exr vtp vts csv ");
    EXPECT_TRUE(offered(ExportSubject::Surface).starts_with("gwy "));
    EXPECT_TRUE(offered(ExportSubject::Film).starts_with("frames+ "));
}

TEST_F(ExportControlTest, AFilmNeedsARecording) {
    ask(ExportSubject::Film, "frames");
    EXPECT_FALSE(child<QPushButton>("exportWrite")->isEnabled());
    EXPECT_TRUE(child<QLabel>("exportMessage")->text().contains("recording"));
    EXPECT_FALSE(child<QPushButton>("exportCopy")->isEnabled());
}

}  // namespace
}  // namespace asperity::test
