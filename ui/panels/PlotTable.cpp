#include "ui/panels/PlotTable.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// A cell stays one cell whatever it holds.
QString oneCell(QString text) {
    return text.replace(QLatin1Char('\t'), QLatin1Char(' '))
        .replace(QLatin1Char('\n'), QLatin1Char(' '));
}

}  // namespace

QString numberCell(double value) {
    return std::isfinite(value) ? QString::number(value, 'g', QLocale::FloatingPointShortest)
                                : QString();
}

void PlotTable::add(const QString& header, const std::vector<double>& values) {
    QStringList cells;
    for (const double value : values) {
        cells << numberCell(value);
    }
    add(header, cells);
}

void PlotTable::add(const QString& header, const QStringList& cells) {
    headers_ << oneCell(header);
    columns_.push_back(cells);
}

QString PlotTable::tabSeparated() const {
    int rows = 0;
    for (const QStringList& column : columns_) {
        rows = std::max(rows, static_cast<int>(column.size()));
    }
    QString text = headers_.join(QLatin1Char('\t')) + QLatin1Char('\n');
    for (int row = 0; row < rows; ++row) {
        QStringList cells;
        for (const QStringList& column : columns_) {
            cells << oneCell(column.value(row));
        }
        text += cells.join(QLatin1Char('\t')) + QLatin1Char('\n');
    }
    return text;
}

}  // namespace asperity
