#include "ui/shell/AboutBox.h"

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTemporaryFile>

#include <gtest/gtest.h>

namespace asperity {
namespace {

class AboutBoxTest : public ::testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(text.open());
        text.write("Permission is granted");
        text.flush();
        box = new AboutBox({.version = QStringLiteral("1.2 (abc)"),
                            .compiler = QStringLiteral("g++ 12"),
                            .license = QStringLiteral("our license"),
                            .libraries = {{"Qwt", "6.1", "Qwt License", text.fileName()},
                                          {"Gone", "1.0", "MIT", "/no/such/file"}},
                            .system = {QStringLiteral("OpenGL: llvmpipe")}},
                           nullptr);
    }
    void TearDown() override { delete box; }
    QString shown(const char* name) {
        return box->findChild<QPlainTextEdit*>(QString::fromUtf8(name))->toPlainText();
    }

    QTemporaryFile text;
    AboutBox* box = nullptr;
};

TEST_F(AboutBoxTest, SaysFirstWhatTheProgramIsForAndTheRestOnRequest) {
    const auto* about = box->findChild<QLabel*>(QStringLiteral("aboutText"));
    for (const char* part : {"1.2 (abc)", "atomic force microscope", "BSD-3-Clause"}) {
        EXPECT_TRUE(about->text().contains(QString::fromUtf8(part))) << part;
    }
    box->show();
    auto* details = box->findChild<QWidget*>(QStringLiteral("aboutDetails"));
    EXPECT_FALSE(details->isVisible());
    box->findChild<QPushButton*>(QStringLiteral("aboutMore"))->click();
    EXPECT_TRUE(details->isVisible());
}

TEST_F(AboutBoxTest, ShowsVersionsAndTheSystem) {
    for (const char* part : {"Asperity 1.2 (abc)", "g++ 12", "Qwt 6.1 (Qwt License)", "llvmpipe"}) {
        EXPECT_TRUE(shown("versions").contains(QString::fromUtf8(part))) << part;
    }
}

TEST_F(AboutBoxTest, ShowsTheTextOfEachLicenseOrWhereItShouldBe) {
    EXPECT_EQ(shown("licenseText"), QStringLiteral("our license"));
    auto* names = box->findChild<QListWidget*>(QStringLiteral("licenseNames"));
    names->setCurrentRow(1);
    EXPECT_TRUE(shown("licenseText").endsWith(QStringLiteral("Permission is granted")));
    names->setCurrentRow(2);
    EXPECT_TRUE(shown("licenseText").contains(QStringLiteral("/no/such/file")));
    EXPECT_TRUE(shown("licenseText").contains(QStringLiteral("not on this machine")));
}

TEST_F(AboutBoxTest, CopiesWhatABugReportShouldSay) {
    box->findChild<QPushButton*>(QStringLiteral("copyReport"))->click();
    EXPECT_EQ(QApplication::clipboard()->text(),
              QStringLiteral("Asperity 1.2 (abc)\nCompiler: g++ 12\nBuilt with: Qwt 6.1, Gone 1.0\n"
                             "OpenGL: llvmpipe\n"));
}

}  // namespace
}  // namespace asperity
