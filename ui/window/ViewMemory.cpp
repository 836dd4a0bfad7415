#include "ui/window/ViewMemory.h"

#include "ui/view/ZoomView.h"
#include "ui/window/ColorsMenu.h"
#include "ui/window/DirectionMenu.h"
#include "ui/window/MainWindow.h"
#include "ui/window/SecondView.h"
#include "ui/window/ViewOptionsMenu.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QSettings>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr std::array<std::pair<const char*, bool ViewOptions::*>, 6> kSwitches = {
    {{"axes", &ViewOptions::axes},
     {"scaleBars", &ViewOptions::scaleBars},
     {"grid", &ViewOptions::grid},
     {"section", &ViewOptions::section},
     {"commandedTip", &ViewOptions::commandedTip},
     {"trueTip", &ViewOptions::trueTip}}};

QString key(const QString& group, const char* name) {
    return group + QLatin1Char('/') + QLatin1String(name);
}

double numberAt(const QSettings& settings, const QString& name, double usual) {
    bool isNumber = false;
    const double number = settings.value(name).toDouble(&isNumber);
    return isNumber && std::isfinite(number) ? number : usual;
}

template <HasEnumTable Value>
Value valueAt(const QSettings& settings, const QString& name, Value usual) {
    return fromKey<Value>(settings.value(name).toString().toStdString()).value_or(usual);
}

ViewOptions optionsIn(const QSettings& settings, const QString& group) {
    ViewOptions options;
    for (const auto& [name, option] : kSwitches) {
        options.*option = settings.value(key(group, name), options.*option).toBool();
    }
    options.heightScale =
        std::clamp(numberAt(settings, key(group, "heightScale"), 1.0), 1.0, kMaxHeightScale);
    options.light.azimuth = numberAt(settings, key(group, "lightAzimuth"), options.light.azimuth);
    options.light.elevation =
        numberAt(settings, key(group, "lightElevation"), options.light.elevation);
    return options;
}

void write(QSettings& settings, const QString& group, const ViewOptions& options) {
    for (const auto& [name, option] : kSwitches) {
        settings.setValue(key(group, name), options.*option);
    }
    settings.setValue(key(group, "heightScale"), options.heightScale);
    settings.setValue(key(group, "lightAzimuth"), options.light.azimuth);
    settings.setValue(key(group, "lightElevation"), options.light.elevation);
}

QString groupOf(SurfaceQuantity quantity) {
    return QStringLiteral("views/colors/") + QLatin1String(keyOf(quantity));
}

SurfaceLook lookIn(const QSettings& settings) {
    SurfaceLook look;
    look.quantity = valueAt(settings, QStringLiteral("views/colorBy"), look.quantity);
    if (look.quantity == SurfaceQuantity::Channel) {  // of another file, it is another one
        look.quantity = SurfaceQuantity::Height;
    }
    for (const SurfaceQuantity quantity : kValues<SurfaceQuantity>) {
        QuantityColors& colors = look.of(quantity);
        const QString group = groupOf(quantity);
        colors.map = valueAt(settings, key(group, "map"), colors.map);
        colors.low = numberAt(settings, key(group, "low"), colors.low);
        colors.high = numberAt(settings, key(group, "high"), colors.high);
        colors.rule = valueAt(settings, key(group, "range"), colors.rule);
        if (colors.rule == RangeRule::Own && !(colors.low < colors.high)) {
            colors.rule = RangeRule::Full;
        }
    }
    return look;
}

void write(QSettings& settings, const SurfaceLook& look) {
    settings.setValue(QStringLiteral("views/colorBy"), QLatin1String(keyOf(look.quantity)));
    for (const SurfaceQuantity quantity : kValues<SurfaceQuantity>) {
        const QuantityColors& colors = look.of(quantity);
        const QString group = groupOf(quantity);
        settings.setValue(key(group, "map"), QLatin1String(keyOf(colors.map)));
        settings.setValue(key(group, "range"), QLatin1String(keyOf(colors.rule)));
        settings.setValue(key(group, "low"), colors.low);
        settings.setValue(key(group, "high"), colors.high);
    }
}

const QString kLarge = QStringLiteral("views/large");
const QString kSecond = QStringLiteral("views/second");

}  // namespace

void restoreViews(MainWindow& window, const QSettings& settings) {
    WindowMenus& menus = window.menus();
    menus.colors().choose(lookIn(settings));
    menus.viewOptions().setOptions(optionsIn(settings, kLarge));
    window.view().setOptions(menus.viewOptions().options());
    const bool perspective = settings.value(key(kLarge, "perspective"), false).toBool();
    menus.directions().setPerspective(perspective);
    window.view().setPerspective(perspective);
    SecondViewSettings second;
    second.content = valueAt(settings, key(kSecond, "content"), second.content);
    second.options = optionsIn(settings, kSecond);
    second.azimuth = std::clamp(numberAt(settings, key(kSecond, "azimuth"), 0.0), -180.0, 180.0);
    second.heightFactor = numberAt(settings, key(kSecond, "heightFactor"), second.heightFactor);
    window.second().setSettings(second);
    menus.secondView->setChecked(settings.value(key(kSecond, "shown"), false).toBool());
}

void saveViews(MainWindow& window, QSettings& settings) {
    WindowMenus& menus = window.menus();
    write(settings, menus.colors().look());
    write(settings, kLarge, window.view().options());
    settings.setValue(key(kLarge, "perspective"), window.view().camera().hasPerspective());
    const SecondViewSettings second = window.second().settings();
    settings.setValue(key(kSecond, "content"), QLatin1String(keyOf(second.content)));
    write(settings, kSecond, second.options);
    settings.setValue(key(kSecond, "azimuth"), second.azimuth);
    settings.setValue(key(kSecond, "heightFactor"), second.heightFactor);
    settings.setValue(key(kSecond, "shown"), menus.secondView->isChecked());
}

}  // namespace asperity
