#include "ui/window/ViewOptionsMenu.h"

#include "ui/panels/NumbersDialog.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

#include <algorithm>
#include <functional>

namespace asperity {

namespace {

/// Entries of which one is chosen.
class Choices {
public:
    explicit Choices(QMenu& menu) : menu_(menu), group_(new QActionGroup(&menu)) {
        menu.setToolTipsVisible(true);
    }

    QAction* add(const QString& text, const QString& toolTip, const std::function<void()>& choose) {
        QAction* action = menu_.addAction(text);
        action->setCheckable(true);
        action->setToolTip(toolTip);
        group_->addAction(action);
        QObject::connect(action, &QAction::triggered, group_, choose);
        return action;
    }

private:
    QMenu& menu_;
    QActionGroup* group_;
};

}  // namespace

ViewOptionsMenu::ViewOptionsMenu(QMenu& menu) : QObject(&menu), menu_(menu) {
    menu.setToolTipsVisible(true);
    addHeightScales(*menu.addMenu(tr("&Height scale")));
    addLights(*menu.addMenu(tr("&Light")));
    addSwitch(menu, tr("&Axes"), &ViewOptions::axes, tr("Positions in the scan along x and y"));
    addSwitch(menu, tr("&Scale bars"), &ViewOptions::scaleBars,
              tr("Lengths across the view and along z"));
    addSwitch(menu, tr("&Grid"), &ViewOptions::grid, tr("Lines on the surface, along x and y"));
    addSwitch(menu, tr("Dent and nec&k"), &ViewOptions::deformation,
              tr("The surface as the tip moves it; without, it is drawn at rest"));
    addSwitch(menu, tr("S&ection through the tip"), &ViewOptions::section,
              tr("Cuts away what lies before the tip, so that the dent is seen from the side"));
    addSwitch(menu, tr("Ghost: co&mmanded tip"), &ViewOptions::commandedTip,
              tr("Outline where the tip would be if no force bent the lever: the base position"));
    addSwitch(menu, tr("Ghost: tr&ue tip"), &ViewOptions::trueTip,
              tr("Outline where the simulated instrument really has its tip; model and estimator "
                 "do not know it"));
    setOptions(options_);
}

void ViewOptionsMenu::addSwitch(QMenu& menu, const QString& text, Switch option,
                                const QString& toolTip) {
    QAction* action = menu.addAction(text);
    action->setCheckable(true);
    action->setToolTip(toolTip);
    switches_.emplace_back(option, action);
    connect(action, &QAction::triggered, this, [this, option](bool on) {
        ViewOptions options = options_;
        options.*option = on;
        choose(options);
    });
}

QAction& ViewOptionsMenu::action(Switch option) const {
    return *std::ranges::find(switches_, option, &std::pair<Switch, QAction*>::first)->second;
}

void ViewOptionsMenu::addHeightScales(QMenu& menu) {
    Choices choices(menu);
    for (const int factor : {1, 2, 5, 10, 20}) {
        const QString text = factor == 1 ? tr("True to scale") : QStringLiteral("×%1").arg(factor);
        const QString toolTip = factor == 1 ? tr("Heights and lengths across have the same scale")
                                            : tr("All heights are drawn so many times larger");
        factors_[factor] = choices.add(text, toolTip, [this, factor] {
            ViewOptions options = options_;
            options.heightScale = factor;
            choose(options);
        });
    }
    ownFactor_ = choices.add(QString(), tr("Type by how much heights are drawn larger"),
                             [this] { askForHeightScale(); });
    ownFactor_->setObjectName(QStringLiteral("ownHeightScale"));
}

void ViewOptionsMenu::addLights(QMenu& menu) {
    Choices choices(menu);
    const auto add = [&](const QString& text, const Light& light) {
        const QString toolTip = tr("Where the light comes from, as seen on the screen");
        lights_.emplace_back(light, choices.add(text, toolTip, [this, light] {
            ViewOptions options = options_;
            options.light = light;
            choose(options);
        }));
    };
    add(tr("From the upper left"), {});
    add(tr("From the upper right"), {.azimuth = 48.0});
    add(tr("From above"), {.azimuth = 90.0, .elevation = 10.0});
    add(tr("From the front"), {.azimuth = 90.0, .elevation = 80.0});
    add(tr("Grazing from the left"), {.azimuth = 175.0, .elevation = 5.0});
}

void ViewOptionsMenu::choose(const ViewOptions& options) {
    setOptions(options);
    Q_EMIT optionsChosen(options_);
}

void ViewOptionsMenu::setOptions(const ViewOptions& options) {
    options_ = options;
    for (const auto& [option, action] : switches_) {
        action->setChecked(options_.*option);
    }
    for (const auto& [light, action] : lights_) {
        action->setChecked(light == options_.light);
    }
    const auto preset = std::ranges::find_if(factors_, [this](const auto& entry) {
        return static_cast<double>(entry.first) == options_.heightScale;
    });
    const bool isOwn = preset == factors_.end();
    (isOwn ? ownFactor_ : preset->second)->setChecked(true);
    ownFactor_->setText(isOwn ? tr("Own factor: ×%1…").arg(options_.heightScale)
                              : tr("Own factor…"));
}

void ViewOptionsMenu::askForHeightScale() {
    setOptions(options_);  // the choice is made when a number is given
    auto* dialog = new NumbersDialog(
        tr("Height scale"),
        {{tr("Heights times"), QString(), options_.heightScale, 1.0, kMaxHeightScale,
          tr("By how much all heights, the tip's too, are drawn larger than lengths across")}},
        [](const std::vector<double>&) { return QString(); }, windowOf(menu_));
    dialog->setObjectName(QStringLiteral("heightScaleDialog"));
    connect(dialog, &NumbersDialog::given, this, [this](const std::vector<double>& values) {
        ViewOptions options = options_;
        options.heightScale = values.front();
        choose(options);
    });
    dialog->open();
}

}  // namespace asperity
