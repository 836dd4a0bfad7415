#include "ui/window/ViewOptionsMenu.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

#include <functional>

namespace asperity {

namespace {

/// Entries of which one is chosen.
class Choices {
public:
    explicit Choices(QMenu& menu) : menu_(menu), group_(new QActionGroup(&menu)) {}

    QAction* add(const QString& text, const std::function<void()>& choose) {
        QAction* action = menu_.addAction(text);
        action->setCheckable(true);
        group_->addAction(action);
        QObject::connect(action, &QAction::triggered, group_, choose);
        return action;
    }

private:
    QMenu& menu_;
    QActionGroup* group_;
};

}  // namespace

ViewOptionsMenu::ViewOptionsMenu(QMenu& menu) : QObject(&menu) {
    addHeightScales(*menu.addMenu(tr("&Height scale")));
    addLights(*menu.addMenu(tr("&Light")));
    addSwitch(menu, tr("&Axes"), &ViewOptions::axes)
        ->setToolTip(tr("x and y in the scan, with units, along the edges of the block"));
    addSwitch(menu, tr("&Scale bars"), &ViewOptions::scaleBars)
        ->setToolTip(tr("Lengths across and along z in the corner of the view"));
    addSwitch(menu, tr("&Grid"), &ViewOptions::grid)
        ->setToolTip(tr("Lines of equal x and y on the surface"));
    addSwitch(menu, tr("S&ection through the tip"), &ViewOptions::section)
        ->setToolTip(tr("Cut the sample at the tip and look at the cut"));
}

QAction* ViewOptionsMenu::addSwitch(QMenu& menu, const QString& text, bool ViewOptions::*option) {
    QAction* action = menu.addAction(text);
    action->setCheckable(true);
    action->setChecked(options_.*option);
    connect(action, &QAction::toggled, this, [this, option](bool on) {
        options_.*option = on;
        Q_EMIT optionsChosen(options_);
    });
    return action;
}

void ViewOptionsMenu::addHeightScales(QMenu& menu) {
    menu.setToolTipsVisible(true);
    Choices choices(menu);
    for (const int factor : {1, 2, 5, 10, 20}) {
        const QString text = factor == 1 ? tr("True to scale") : QStringLiteral("×%1").arg(factor);
        QAction* action = choices.add(text, [this, factor] {
            options_.heightScale = factor;
            Q_EMIT optionsChosen(options_);
        });
        action->setChecked(factor == 1);
        action->setToolTip(factor == 1 ? tr("One scale in all directions")
                                       : tr("All heights drawn %1 times as large").arg(factor));
    }
}

void ViewOptionsMenu::addLights(QMenu& menu) {
    menu.setToolTipsVisible(true);
    Choices choices(menu);
    const auto add = [&](const QString& text, const Light& light) {
        QAction* action = choices.add(text, [this, light] {
            options_.light = light;
            Q_EMIT optionsChosen(options_);
        });
        action->setChecked(light == options_.light);
        action->setToolTip(tr("Direction from which the light falls on the surface"));
    };
    add(tr("From the upper left"), {});
    add(tr("From the upper right"), {.azimuth = 48.0});
    add(tr("From above"), {.azimuth = 90.0, .elevation = 10.0});
    add(tr("From the front"), {.azimuth = 90.0, .elevation = 80.0});
    add(tr("Grazing from the left"), {.azimuth = 175.0, .elevation = 5.0});
}

}  // namespace asperity
