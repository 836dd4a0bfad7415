#include "app/window/live/ViewMemory.h"

#include "app/window/live/LivePanels.h"
#include "ui/view/ColorsMenu.h"
#include "ui/view/SecondView.h"
#include "ui/view/ViewOptionsMenu.h"
#include "ui/view/ZoomView.h"

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
    // Another file has another second channel, and force maps are not kept.
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

void restoreViews(LivePanels& live, const QVariantMap& kept) {
    live.colors().choose(lookIn(kept));
    live.viewOptions().setOptions(optionsIn(kept, kLarge));
    live.view().setOptions(live.viewOptions().options());
    const bool perspective = kept.value(key(kLarge, "perspective"), false).toBool();
    live.directions().setPerspective(perspective);
    live.view().setPerspective(perspective);
    SecondViewSettings second;
    second.content = valueAt(kept, key(kSecond, "content"), second.content);
    second.options = optionsIn(kept, kSecond);
    second.followsContact =
        kept.value(key(kSecond, "followsContact"), second.followsContact).toBool();
    second.azimuth = std::clamp(numberAt(kept, key(kSecond, "azimuth"), 0.0), -180.0, 180.0);
    second.heightFactor = numberAt(kept, key(kSecond, "heightFactor"), second.heightFactor);
    live.second().setSettings(second);
    live.secondEntry().setChecked(kept.value(key(kSecond, "shown"), true).toBool());
}

void keepViews(LivePanels& live, QVariantMap& kept) {
    write(kept, live.colors().look());
    write(kept, kLarge, live.view().options());
    kept.insert(key(kLarge, "perspective"), live.view().camera().hasPerspective());
    const SecondViewSettings second = live.second().settings();
    kept.insert(key(kSecond, "content"), QLatin1String(keyOf(second.content)));
    write(kept, kSecond, second.options);
    kept.insert(key(kSecond, "followsContact"), second.followsContact);
    kept.insert(key(kSecond, "azimuth"), second.azimuth);
    kept.insert(key(kSecond, "heightFactor"), second.heightFactor);
    kept.insert(key(kSecond, "shown"), live.secondEntry().isChecked());
}

void restoreViewpoint(LivePanels& live, const QVariantMap& kept) {
    const ViewCamera& camera = live.view().camera();
    live.view().setDirection(numberAt(kept, kAzimuth, camera.azimuth()),
                             numberAt(kept, kElevation, camera.elevation()));
    SurfaceLook look = live.colors().look();
    for (const SurfaceQuantity quantity : kValues<SurfaceQuantity>) {
        look.of(quantity).pinned =
            kept.value(kPinned).toStringList().contains(QLatin1String(keyOf(quantity)));
    }
    live.colors().choose(look);
    const double halfWidth = numberAt(kept, kHalfWidth, 0.0);
    if (halfWidth > 0.0) {
        live.view().setHalfWidth(halfWidth);
    }
}

void keepViewpoint(LivePanels& live, QVariantMap& kept) {
    kept.insert(kAzimuth, live.view().camera().azimuth());
    kept.insert(kElevation, live.view().camera().elevation());
    kept.insert(kHalfWidth, live.view().halfWidth());
    const SurfaceLook look = live.colors().look();
    QStringList pinned;
    for (const SurfaceQuantity quantity : kValues<SurfaceQuantity>) {
        if (look.of(quantity).pinned) {
            pinned << QLatin1String(keyOf(quantity));
        }
    }
    kept.insert(kPinned, pinned);
}

}  // namespace asperity
