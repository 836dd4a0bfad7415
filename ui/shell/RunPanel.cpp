#include "ui/shell/RunPanel.h"

#include "ui/plot/CopyablePlot.h"

#include <QObject>
#include <QStringList>

namespace asperity {

QString tabSeparated(const ShownNumbers& numbers) {
    QStringList names;
    QStringList values;
    QStringList sigmas;
    QStringList modelSigmas;
    QStringList units;
    const auto cell = [](const std::optional<double>& deviation) {
        return deviation ? numberCell(*deviation) : QString();
    };
    for (const ShownNumber& number : numbers) {
        names << number.name;
        values << numberCell(number.value);
        sigmas << cell(number.sigma);
        modelSigmas << cell(number.modelSigma);
        units << number.unit;
    }
    PlotTable table;
    table.add(QObject::tr("name"), names);
    table.add(QObject::tr("value"), values);
    table.add(QObject::tr("standard deviation by noise"), sigmas);
    table.add(QObject::tr("by model and calibration"), modelSigmas);
    table.add(QObject::tr("unit"), units);
    return table.tabSeparated();
}

}  // namespace asperity
