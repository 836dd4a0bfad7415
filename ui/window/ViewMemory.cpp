#include "ui/window/ViewMemory.h"

#include "ui/view/ZoomView.h"
#include "ui/window/ColorsMenu.h"
#include "ui/window/DirectionMenu.h"
#include "ui/window/MainWindow.h"
#include "ui/window/SecondView.h"
#include "ui/window/ViewOptionsMenu.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr std::array<std::pair<const char*, bool ViewOptions::*>, 7> kSwitches = {
    {{"axes", &ViewOptions::axes},
     {"scaleBars", &ViewOptions::scaleBars},
     {"grid", &ViewOptions::grid},
     {"deformation", &ViewOptions::deformation},
     {"section", &ViewOptions::section},
     {"commandedTip", &ViewOptions::commandedTip},
     {"trueTip", &ViewOptions::trueTip}}};

QString key(const QString& group, const char* name) {
    return group + QLatin1Char('/') + QLatin1String(name);
}

double numberAt(const QVariantMap& kept, const QString& name, double usual) {
    bool isNumber = false;
    const double number = kept.value(name).toDouble(&isNumber);
    return isNumber && std::isfinite(number) ? number : usual;
}

template <HasEnumTable Value>
Value valueAt(const QVariantMap& kept, const QString& name, Value usual) {
    return fromKey<Value>(kept.value(name).toString().toStdString()).value_or(usual);
}

ViewOptions optionsIn(const QVariantMap& kept, const QString& group) {
    ViewOptions options;
    for (const auto& [name, option] : kSwitches) {
        options.*option = kept.value(key(group, name), options.*option).toBool();
    }
    options.heightScale =
        std::clamp(numberAt(kept, key(group, "heightScale"), 1.0), 1.0, kMaxHeightScale);
    options.light.azimuth = numberAt(kept, key(group, "lightAzimuth"), options.light.azimuth);
    options.light.elevation = numberAt(kept, key(group, "lightElevation"), options.light.elevation);
    return options;
}

void write(QVariantMap& kept, const QString& group, const ViewOptions& options) {
    for (const auto& [name, option] : kSwitches) {
        kept.insert(key(group, name), options.*option);
    }
    kept.insert(key(group, "heightScale"), options.heightScale);
    kept.insert(key(group, "lightAzimuth"), options.light.azimuth);
    kept.insert(key(group, "lightElevation"), options.light.elevation);
}

QString groupOf(SurfaceQuantity quantity) {
    return QStringLiteral("views/colors/") + QLatin1String(keyOf(quantity));
}

SurfaceLook lookIn(const QVariantMap& kept) {
    SurfaceLook look;
    look.quantity = valueAt(kept, QStringLiteral("views/colorBy"), look.quantity);
    // Of another file it is another one, and a map is not kept.
    if (look.quantity == SurfaceQuantity::Channel || look.quantity == SurfaceQuantity::ForceMap) {
        look.quantity = SurfaceQuantity::Height;
    }
    for (const SurfaceQuantity quantity : kValues<SurfaceQuantity>) {
        QuantityColors& colors = look.of(quantity);
        const QString group = groupOf(quantity);
        colors.map = valueAt(kept, key(group, "map"), colors.map);
        colors.low = numberAt(kept, key(group, "low"), colors.low);
        colors.high = numberAt(kept, key(group, "high"), colors.high);
        colors.rule = valueAt(kept, key(group, "range"), colors.rule);
        if (colors.rule == RangeRule::Own && !(colors.low < colors.high)) {
            colors.rule = RangeRule::Full;
        }
    }
    return look;
}

void write(QVariantMap& kept, const SurfaceLook& look) {
    kept.insert(QStringLiteral("views/colorBy"), QLatin1String(keyOf(look.quantity)));
    for (const SurfaceQuantity quantity : kValues<SurfaceQuantity>) {
        const QuantityColors& colors = look.of(quantity);
        const QString group = groupOf(quantity);
        kept.insert(key(group, "map"), QLatin1String(keyOf(colors.map)));
        kept.insert(key(group, "range"), QLatin1String(keyOf(colors.rule)));
        kept.insert(key(group, "low"), colors.low);
        kept.insert(key(group, "high"), colors.high);
    }
}

const QString kLarge = QStringLiteral("views/large");
const QString kSecond = QStringLiteral("views/second");
const QString kAzimuth = QStringLiteral("stand/azimuth_rad");
const QString kElevation = QStringLiteral("stand/elevation_rad");
const QString kPinned = QStringLiteral("stand/pinned");
const QString kHalfWidth = QStringLiteral("stand/half_width_m");

}  // namespace

void restoreViews(MainWindow& window, const QVariantMap& kept) {
    WindowMenus& menus = window.menus();
    menus.colors().choose(lookIn(kept));
    menus.viewOptions().setOptions(optionsIn(kept, kLarge));
    window.view().setOptions(menus.viewOptions().options());
    const bool perspective = kept.value(key(kLarge, "perspective"), false).toBool();
    menus.directions().setPerspective(perspective);
    window.view().setPerspective(perspective);
    SecondViewSettings second;
    second.content = valueAt(kept, key(kSecond, "content"), second.content);
    second.options = optionsIn(kept, kSecond);
    second.azimuth = std::clamp(numberAt(kept, key(kSecond, "azimuth"), 0.0), -180.0, 180.0);
    second.heightFactor = numberAt(kept, key(kSecond, "heightFactor"), second.heightFactor);
    window.second().setSettings(second);
    menus.secondView->setChecked(kept.value(key(kSecond, "shown"), false).toBool());
}

void keepViews(MainWindow& window, QVariantMap& kept) {
    WindowMenus& menus = window.menus();
    write(kept, menus.colors().look());
    write(kept, kLarge, window.view().options());
    kept.insert(key(kLarge, "perspective"), window.view().camera().hasPerspective());
    const SecondViewSettings second = window.second().settings();
    kept.insert(key(kSecond, "content"), QLatin1String(keyOf(second.content)));
    write(kept, kSecond, second.options);
    kept.insert(key(kSecond, "azimuth"), second.azimuth);
    kept.insert(key(kSecond, "heightFactor"), second.heightFactor);
    kept.insert(key(kSecond, "shown"), menus.secondView->isChecked());
}

void restoreStand(MainWindow& window, const QVariantMap& kept) {
    const ViewCamera& camera = window.view().camera();
    window.view().setDirection(numberAt(kept, kAzimuth, camera.azimuth()),
                               numberAt(kept, kElevation, camera.elevation()));
    SurfaceLook look = window.menus().colors().look();
    for (const SurfaceQuantity quantity : kValues<SurfaceQuantity>) {
        look.of(quantity).pinned =
            kept.value(kPinned).toStringList().contains(QLatin1String(keyOf(quantity)));
    }
    window.menus().colors().choose(look);
    const double halfWidth = numberAt(kept, kHalfWidth, 0.0);
    if (halfWidth > 0.0) {
        window.view().setHalfWidth(halfWidth);
    }
}

void keepStand(MainWindow& window, QVariantMap& kept) {
    kept.insert(kAzimuth, window.view().camera().azimuth());
    kept.insert(kElevation, window.view().camera().elevation());
    kept.insert(kHalfWidth, window.view().halfWidth());
    const SurfaceLook look = window.menus().colors().look();
    QStringList pinned;
    for (const SurfaceQuantity quantity : kValues<SurfaceQuantity>) {
        if (look.of(quantity).pinned) {
            pinned << QLatin1String(keyOf(quantity));
        }
    }
    kept.insert(kPinned, pinned);
}

}  // namespace asperity
