#include "ui/shell/FileDialogs.h"

#include "tests/support/ScratchFolder.h"

#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QTimer>

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

namespace asperity::test {
namespace {

class FileDialogsTest : public ::testing::Test {
protected:
    FileDialogsTest() {
        std::filesystem::create_directory(folder.file("curves"));
        std::filesystem::create_directory(folder.file("maps"));
    }
    ~FileDialogsTest() override { restoreFolders({}); }

    QString at(const char* name) { return QString::fromStdString(folder.file(name).string()); }

    /// Does something to the dialog that the next question opens.
    static void inDialog(const std::function<void(QFileDialog&)>& act) {
        QTimer::singleShot(0, [act] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            ASSERT_NE(dialog, nullptr);
            act(*dialog);
        });
    }

    ScratchFolder folder;
};

TEST_F(FileDialogsTest, EachKindOpensWhereTheUserLastWasForIt) {
    inDialog([this](QFileDialog& dialog) {
        dialog.setDirectory(at("maps"));
        dialog.selectFile(QStringLiteral("a.gwy"));
        static_cast<QDialog&>(dialog).accept();
    });
    EXPECT_EQ(askWhereToSave(nullptr, {.kind = FileKind::Map, .suggestion = "m.gwy"}),
              at("maps/a.gwy"));
    rememberFolderOf(FileKind::Curve, at("curves/a.csv"));
    QString shown;
    QStringList names;
    const auto look = [&](QFileDialog& dialog) {
        shown = dialog.directory().absolutePath();
        names = dialog.selectedFiles();
        dialog.reject();
    };
    inDialog(look);
    EXPECT_TRUE(askWhatToOpen(nullptr, {.kind = FileKind::Curve}).isEmpty());
    EXPECT_EQ(shown, at("curves"));
    inDialog(look);
    EXPECT_TRUE(askWhereToSave(nullptr, {.kind = FileKind::Map, .suggestion = "b.gwy"}).isEmpty());
    EXPECT_EQ(shown, at("maps"));
    EXPECT_EQ(names, QStringList{at("maps/b.gwy")});
    inDialog(look);
    EXPECT_TRUE(askWhereToSave(nullptr, {.kind = FileKind::Map, .suggestion = at("curves/b.gwy")})
                    .isEmpty());
    EXPECT_EQ(shown, at("curves")) << "a suggestion with a folder";
}

TEST_F(FileDialogsTest, SettingsKeepTheFolders) {
    rememberFolderOf(FileKind::Curve, at("curves/a.csv"));
    rememberFolderOf(FileKind::Map, at("maps/a.gwy"));
    QVariantMap kept;
    keepFolders(kept);
    restoreFolders({});
    EXPECT_TRUE(lastFolder(FileKind::Curve).isEmpty());
    restoreFolders(kept);
    EXPECT_EQ(lastFolder(FileKind::Curve), at("curves"));
    EXPECT_EQ(lastFolder(FileKind::Map), at("maps"));
    EXPECT_TRUE(lastFolder(FileKind::Study).isEmpty());
}

}  // namespace
}  // namespace asperity::test
