#include "app/program/ProgramParts.h"
#include "tests/app/window/WindowFixture.h"
#include "ui/shell/ManualWindow.h"
#include "ui/shell/Menus.h"

#include <QAction>
#include <QDialog>
#include <QFile>
#include <QPlainTextEdit>
#include <QRegularExpression>

#include <regex>

namespace asperity::test {
namespace {

TEST(ProgramParts, NameEachLibraryWithItsVersionAndLicense) {
    const std::regex version("[0-9]+([.][0-9]+)+[a-z]?");
    EXPECT_EQ(libraryParts().size(), 15U);
    for (const LibraryPart& part : libraryParts()) {
        EXPECT_TRUE(std::regex_match(part.version, version)) << part.name << ' ' << part.version;
        EXPECT_FALSE(part.license.empty());
        EXPECT_TRUE(
            QFile::exists(QStringLiteral("/usr/share/doc/%1/copyright").arg(part.package.c_str())))
            << part.package;
    }
    EXPECT_NE(licenseText().find("Redistribution and use"), std::string::npos);
    EXPECT_TRUE(versionWithCommit().starts_with(ASPERITY_VERSION));
    EXPECT_FALSE(compilerName().empty());
}

TEST_F(Window, TheAboutBoxNamesLibrariesAndTheGraphicsDriver) {
    openFlatScene();
    window.menus().entry("about").trigger();
    auto* box = window.findChild<QDialog*>(QStringLiteral("aboutBox"));
    ASSERT_NE(box, nullptr);
    const QString text = box->findChild<QPlainTextEdit*>(QStringLiteral("versions"))->toPlainText();
    for (const char* part : {"Asperity 0", "VTK 9.", "Qwt 6.", "System: ", "Screen "}) {
        EXPECT_TRUE(text.contains(QString::fromUtf8(part))) << part << text.toStdString();
    }
    EXPECT_TRUE(text.contains(QRegularExpression(QStringLiteral("OpenGL: \\w+.*, version \\d"))))
        << text.toStdString();
}

TEST_F(Window, HelpShowsTheFirstStepsAndTheManual) {
    auto* manual = window.findChild<ManualWindow*>();
    window.menus().entry("firstSteps").trigger();
    EXPECT_TRUE(manual->isVisible());
    EXPECT_TRUE(manual->text().startsWith(QStringLiteral("First steps")));
    window.menus().entry("manual").trigger();
    EXPECT_TRUE(manual->isVisible());
    EXPECT_TRUE(manual->text().startsWith(QStringLiteral("Documentation")));
}

}  // namespace
}  // namespace asperity::test
