#include "ui/shell/Dialogs.h"

#include <QMessageBox>
#include <QWidget>

#include <gtest/gtest.h>

namespace asperity::test {
namespace {

/// The one that a dialog opened over the window.
QMessageBox& boxIn(const QWidget& window) {
    const auto boxes = window.findChildren<QMessageBox*>();
    EXPECT_EQ(boxes.size(), 1);
    return *boxes.front();
}

TEST(Dialogs, AComplaintIsReadAsItIsAndTheWindowGoesOn) {
    QWidget window;
    complainIn(&window, "<b>bold</b>.gsf cannot be read");
    const QMessageBox& box = boxIn(window);
    EXPECT_EQ(box.icon(), QMessageBox::Warning);
    EXPECT_EQ(box.textFormat(), Qt::PlainText) << "a name of a file may look like markup";
    EXPECT_TRUE(box.text().startsWith("<b>"));
    EXPECT_TRUE(box.testAttribute(Qt::WA_DeleteOnClose));
}

TEST(Dialogs, AllThatIsReadComesFirstThenEachTypeThenAnyFile) {
    const QStringList filters = scanFilters({{"Gwyddion .gwy", {"*.gwy"}},
                                             {"TIFF", {"*.tiff", "*.tif"}},
                                             {"text matrix", {"*.txt", "*.tif"}}});
    EXPECT_EQ(filters,
              (QStringList{"Scans and scenes (*.toml *.zip *.gwy *.tiff *.tif *.txt)",
                           "Scenes (*.toml)", "Bundles (*.zip)", "Gwyddion .gwy (*.gwy)",
                           "TIFF (*.tiff *.tif)", "Text matrix (*.txt *.tif)", "All files (*)"}));
}

}  // namespace
}  // namespace asperity::test
