#include "ui/view/ViewOptionsMenu.h"

#include "ui/widgets/NumberBox.h"

#include <QAction>
#include <QMenu>
#include <QWidget>

#include <gtest/gtest.h>

namespace asperity::test {
namespace {

TEST(ViewOptionsMenu, TakesAnyHeightFactorThatIsTyped) {
    QWidget window;
    auto* menu = new QMenu(&window);
    auto* options = new ViewOptionsMenu(*menu);
    ViewOptions chosen;
    QObject::connect(options, &ViewOptionsMenu::optionsChosen,
                     [&chosen](const ViewOptions& taken) { chosen = taken; });
    auto* own = menu->findChild<QAction*>("ownHeightScale");
    own->trigger();
    EXPECT_EQ(chosen.heightScale, 1.0) << "not before a number is given";
    EXPECT_FALSE(own->isChecked());
    auto* dialog = window.findChild<NumbersDialog*>("heightScaleDialog");
    dialog->findChild<NumberBox*>()->setValue(3.5);
    dialog->finish();
    EXPECT_EQ(chosen.heightScale, 3.5);
    EXPECT_TRUE(own->isChecked());
    EXPECT_EQ(own->text(), QStringLiteral("Own factor: ×3.5…"));
}

TEST(ViewOptionsMenu, ShowsOptionsWithoutAskingForThem) {
    QWidget window;
    auto* menu = new QMenu(&window);
    auto* options = new ViewOptionsMenu(*menu);
    bool asked = false;
    QObject::connect(options, &ViewOptionsMenu::optionsChosen, [&asked] { asked = true; });
    options->setOptions({.heightScale = 5.0, .grid = false, .trueTip = true});
    EXPECT_FALSE(asked);
    int checked = 0;
    for (const QAction* action : menu->actions()) {
        EXPECT_FALSE(action->toolTip().isEmpty());
        checked += action->isChecked() ? 1 : 0;
    }
    EXPECT_EQ(checked, 4) << "axes, scale bars, dent and neck, true tip";
}

}  // namespace
}  // namespace asperity::test
