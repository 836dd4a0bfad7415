#include "ui/view/ViewOptionsMenu.h"

#include "ui/widgets/NumberBox.h"

#include <QAction>
#include <QActionGroup>
#include <QKeySequence>
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
              tr("The deformed surface; off: the undeformed surface"));
    addSwitch(menu, tr("S&ection through the tip"), &ViewOptions::section,
              tr("Cuts away the part in front of the tip, to show the dent from the side"));
    addSwitch(menu, tr("Ghost: co&mmanded tip"), &ViewOptions::commandedTip,
              tr("Outline of the tip at the base position, as if no force bent the lever"));
    addSwitch(menu, tr("Ghost: tr&ue tip"), &ViewOptions::trueTip,
              tr("Outline of the simulated instrument's true tip, which model and estimator do "
                 "not know"));
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
                                            : tr("Vertical exaggeration of all heights");
        factors_[factor] = choices.add(text, toolTip, [this, factor] {
            ViewOptions options = options_;
            options.heightScale = factor;
            choose(options);
        });
    }
    ownFactor_ = choices.add(QString(), tr("Type a factor for the heights"),
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
          tr("Factor by which all heights, including the tip's, are exaggerated")}},
        [](const std::vector<double>&) { return QString(); }, windowOf(menu_));
    dialog->setObjectName(QStringLiteral("heightScaleDialog"));
    connect(dialog, &NumbersDialog::given, this, [this](const std::vector<double>& values) {
        ViewOptions options = options_;
        options.heightScale = values.front();
        choose(options);
    });
    dialog->open();
}

DirectionMenu::DirectionMenu(QMenu& menu, Keys keys) : QObject(&menu) {
    menu.setToolTipsVisible(true);
    const auto add = [&](ViewDirection side, const QString& text, const QString& key,
                         const QString& toolTip) {
        QAction* action = menu.addAction(text);
        if (keys == Keys::Digits) {
            action->setShortcut(QKeySequence(key));
        }
        action->setToolTip(toolTip);
        connect(action, &QAction::triggered, this, [this, side] { Q_EMIT sideChosen(side); });
    };
    add(ViewDirection::Front, tr("&Front"), QStringLiteral("1"),
        tr("From small y along the ground: x to the right, z up"));
    add(ViewDirection::Back, tr("&Back"), QStringLiteral("Ctrl+1"),
        tr("From large y along the ground: x to the left, z up"));
    add(ViewDirection::Right, tr("&Right"), QStringLiteral("3"),
        tr("From large x along the ground: y to the right, z up"));
    add(ViewDirection::Left, tr("&Left"), QStringLiteral("Ctrl+3"),
        tr("From small x along the ground: y to the left, z up"));
    add(ViewDirection::Top, tr("&Top"), QStringLiteral("7"),
        tr("From above: x to the right, y up"));
    add(ViewDirection::Bottom, tr("B&ottom"), QStringLiteral("Ctrl+7"),
        tr("From below, through the block: x to the right, y down"));
    menu.addSeparator();
    perspective_ = menu.addAction(tr("&Perspective"));
    perspective_->setCheckable(true);
    if (keys == Keys::Digits) {
        perspective_->setShortcut(QKeySequence(QStringLiteral("5")));
    }
    perspective_->setToolTip(
        tr("Near things look larger; without, lengths across the view are to scale"));
    connect(perspective_, &QAction::triggered, this, &DirectionMenu::perspectiveChosen);
}

void DirectionMenu::setPerspective(bool perspective) { perspective_->setChecked(perspective); }

}  // namespace asperity
