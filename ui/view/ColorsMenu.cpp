#include "ui/view/ColorsMenu.h"

#include "ui/widgets/NumberBox.h"

#include <QAction>
#include <QActionGroup>
#include <QIcon>
#include <QLinearGradient>
#include <QMenu>
#include <QPainter>
#include <QPixmap>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// The colors of a map, from low to high.
QIcon iconOf(ColorMap map) {
    constexpr QSize kSize(40, 12);
    QPixmap pixmap(kSize);
    QPainter painter(&pixmap);
    const ColorTable table(map, 0.0, kSize.width() - 1.0);
    for (int x = 0; x < kSize.width(); ++x) {
        const Color color = table.of(x);
        painter.setPen(QColor(color.red, color.green, color.blue));
        painter.drawLine(x, 0, x, kSize.height());
    }
    return pixmap;
}

QString meaningOf(SurfaceQuantity quantity) {
    switch (quantity) {
    case SurfaceQuantity::Height:
        return QObject::tr("Height of the undeformed surface; near the tip, its displacement");
    case SurfaceQuantity::Slope:
        return QObject::tr("Angle of the undeformed surface to the horizontal");
    case SurfaceQuantity::Gap:
        return QObject::tr("Distance between deformed surface and tip, along the contact's normal");
    case SurfaceQuantity::Pressure:
        return QObject::tr("Pressure on the surface by the contact law in use, or by the "
                           "half-space where that is shown; positive: compression");
    case SurfaceQuantity::Displacement:
        return QObject::tr("Displacement of the surface by the tip, positive into the sample");
    case SurfaceQuantity::Residual:
        return QObject::tr("Data minus surface: the part removed by smoothing and fit");
    case SurfaceQuantity::Certainty:
        return QObject::tr("1 where the imaging tip has certainly touched the surface, else 0");
    case SurfaceQuantity::YoungsModulus:
        return QObject::tr("Young's modulus of a sample that is not the same everywhere");
    case SurfaceQuantity::WorkOfAdhesion:
        return QObject::tr("Work of adhesion of a sample that is not the same everywhere");
    case SurfaceQuantity::FrictionCoefficient:
        return QObject::tr("Friction coefficient of a sample that is not the same everywhere");
    case SurfaceQuantity::Channel:
        return QObject::tr("Another image of the same file, in its own unit");
    case SurfaceQuantity::ForceMap:
        return QObject::tr("A quantity of the force map, in its region");
    }
    return {};
}

QString titleOf(SurfaceQuantity quantity) {
    QString title = QObject::tr(nameOf(quantity));
    title[0] = title[0].toUpper();
    return title;
}

}  // namespace

ColorsMenu::ColorsMenu(QMenu& menu) : QObject(&menu), menu_(menu) {
    menu.setToolTipsVisible(true);
    addQuantities();
    menu.addSeparator();
    addMaps();
    menu.addSeparator();
    addRanges();
    setChannels({});
    show();
}

void ColorsMenu::addQuantities() {
    menu_.addSection(tr("Color by"));
    quantityGroup_ = new QActionGroup(&menu_);
    for (const SurfaceQuantity quantity : kValues<SurfaceQuantity>) {
        if (quantity == SurfaceQuantity::Channel) {
            channels_ = menu_.addMenu(tr("Another channel"));
            channels_->setToolTipsVisible(true);
            channels_->setObjectName(QStringLiteral("colorChannels"));
            quantities_[quantity] = channels_->menuAction();
            continue;
        }
        QAction* action = menu_.addAction(titleOf(quantity));
        action->setCheckable(true);
        action->setObjectName(QStringLiteral("colorBy.") + QString::fromLatin1(keyOf(quantity)));
        quantityGroup_->addAction(action);
        quantities_[quantity] = action;
        refuse(quantity, {});
        connect(action, &QAction::triggered, this, [this, quantity] {
            SurfaceLook look = look_;
            look.quantity = quantity;
            look.channel.clear();
            choose(look);
        });
    }
}

void ColorsMenu::addMaps() {
    menu_.addSection(tr("Color map"));
    auto* group = new QActionGroup(&menu_);
    for (const ColorMap map : kValues<ColorMap>) {
        QAction* action = menu_.addAction(iconOf(map), tr(nameOf(map)));
        action->setCheckable(true);
        action->setIconVisibleInMenu(true);
        action->setObjectName(QStringLiteral("colorMap.") + QString::fromLatin1(keyOf(map)));
        action->setToolTip(map == ColorMap::Diverging
                               ? tr("Zero in the middle: for values of either sign")
                               : tr("Lighter colors are larger values"));
        group->addAction(action);
        maps_[map] = action;
        connect(action, &QAction::triggered, this, [this, map] {
            SurfaceLook look = look_;
            look.of(look.quantity).map = map;
            choose(look);
        });
    }
}

void ColorsMenu::addRanges() {
    menu_.addSection(tr("Range"));
    auto* group = new QActionGroup(&menu_);
    const auto add = [&](RangeRule rule, const QString& toolTip) {
        const QString dots = rule == RangeRule::Own ? QStringLiteral("…") : QString();
        QAction* action = menu_.addAction(tr(nameOf(rule)) + dots);
        action->setCheckable(true);
        action->setObjectName(QStringLiteral("colorRange.") + QString::fromLatin1(keyOf(rule)));
        action->setToolTip(toolTip);
        group->addAction(action);
        rules_[rule] = action;
        return action;
    };
    const auto choosing = [this](RangeRule rule) {
        return [this, rule] {
            SurfaceLook look = look_;
            look.of(look.quantity).rule = rule;
            look.of(look.quantity).pinned = false;
            choose(look);
        };
    };
    connect(add(RangeRule::Full, tr("From the lowest value shown to the highest")),
            &QAction::triggered, this, choosing(RangeRule::Full));
    connect(add(RangeRule::Percent, tr("Without the lowest and the highest percent of the values")),
            &QAction::triggered, this, choosing(RangeRule::Percent));
    connect(
        add(RangeRule::Permille, tr("Without the lowest and the highest per mille of the values")),
        &QAction::triggered, this, choosing(RangeRule::Permille));
    connect(add(RangeRule::Own, tr("Type the values of the first and the last color")),
            &QAction::triggered, this, &ColorsMenu::askForRange);
    pin_ = menu_.addAction(tr("&Pin the range"));
    pin_->setCheckable(true);
    pin_->setObjectName(QStringLiteral("colorRange.pin"));
    pin_->setToolTip(tr("The range stays when scan, leveling, channel or view change"));
    connect(pin_, &QAction::triggered, this, [this](bool pinned) {
        SurfaceLook look = look_;
        look.of(look.quantity).pinned = pinned;
        choose(look);
    });
}

void ColorsMenu::choose(const SurfaceLook& look) {
    setLook(look);
    Q_EMIT lookChosen(look_);
}

void ColorsMenu::setLook(const SurfaceLook& look) {
    look_ = look;
    show();
}

void ColorsMenu::show() {
    if (look_.quantity != SurfaceQuantity::Channel) {
        quantities_.at(look_.quantity)->setChecked(true);
    }
    for (QAction* entry : channels_->actions()) {
        entry->setChecked(look_.quantity == SurfaceQuantity::Channel &&
                          entry->data().toString() == look_.channel);
    }
    maps_.at(present().map)->setChecked(true);
    rules_.at(present().rule)->setChecked(true);
    pin_->setChecked(present().pinned);
}

void ColorsMenu::setChannels(const QStringList& names) {
    channelNames_ = names;
    channels_->clear();
    for (const QString& name : names) {
        QAction* entry = channels_->addAction(QString(name).replace('&', QStringLiteral("&&")));
        entry->setData(name);
        entry->setCheckable(true);
        entry->setToolTip(tr("Colors the surface by this image of the file"));
        quantityGroup_->addAction(entry);
        connect(entry, &QAction::triggered, this, [this, name] {
            SurfaceLook look = look_;
            look.quantity = SurfaceQuantity::Channel;
            look.channel = name;
            choose(look);
        });
    }
    refuse(SurfaceQuantity::Channel,
           names.isEmpty() ? tr("The file has no other image of the same pixels") : QString());
    show();
}

void ColorsMenu::refuse(SurfaceQuantity quantity, const QString& reason) {
    QAction* action = quantities_.at(quantity);
    action->setEnabled(reason.isEmpty());
    action->setToolTip(reason.isEmpty() ? meaningOf(quantity) : reason);
}

void ColorsMenu::setShown(const QString& unit, double low, double high) {
    shownUnit_ = unit;
    shownLow_ = low;
    shownHigh_ = high;
}

void ColorsMenu::askForRange() {
    show();  // the choice is made when numbers are given
    const SiScale scale =
        shownScale(std::max(std::abs(shownLow_), std::abs(shownHigh_)), shownUnit_);
    const QString unit = QString::fromStdString(scale.unit);
    constexpr double kLimit = 1e9;
    const auto number = [&](const QString& label, double value, const QString& toolTip) {
        return NumbersDialog::Number{label, unit, value * scale.factor, -kLimit, kLimit, toolTip};
    };
    auto* dialog = new NumbersDialog(
        tr("Range of the colors"),
        {number(tr("Lowest"), shownLow_, tr("Value of the first color [%1]").arg(unit)),
         number(tr("Highest"), shownHigh_, tr("Value of the last color [%1]").arg(unit))},
        [](const std::vector<double>& values) {
            return values[0] < values[1] ? QString()
                                         : tr("The highest value must exceed the lowest one");
        },
        windowOf(menu_));
    dialog->setObjectName(QStringLiteral("colorRangeDialog"));
    connect(dialog, &NumbersDialog::given, this,
            [this, factor = scale.factor](const std::vector<double>& values) {
                SurfaceLook look = look_;
                QuantityColors& colors = look.of(look.quantity);
                colors.rule = RangeRule::Own;
                colors.low = values[0] / factor;
                colors.high = values[1] / factor;
                colors.pinned = false;
                choose(look);
            });
    dialog->open();
}

}  // namespace asperity
