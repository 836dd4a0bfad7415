#include "ui/plot/CopyablePlot.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QImage>
#include <QLocale>
#include <QMenu>
#include <QMimeData>
#include <QMouseEvent>
#include <QPixmap>
#include <QTimer>
#include <QWidget>

#include <algorithm>
#include <cmath>
#include <utility>

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

CopyablePlot::CopyablePlot(QWidget& plot, Numbers numbers)
    : QObject(&plot), plot_(plot), numbers_(std::move(numbers)) {
    plot.installEventFilter(this);
    auto* asPicture = new QAction(tr("Copy &picture"), &plot);
    asPicture->setObjectName(QStringLiteral("copyPicture"));
    asPicture->setToolTip(tr("Puts the picture of this plot on the clipboard"));
    connect(asPicture, &QAction::triggered, this, &CopyablePlot::copyPicture);
    plot.addAction(asPicture);
    if (numbers_) {
        auto* asData = new QAction(tr("Copy &data"), &plot);
        asData->setObjectName(QStringLiteral("copyData"));
        asData->setToolTip(
            tr("Puts the numbers of this plot on the clipboard: tab-separated text, in SI units"));
        connect(asData, &QAction::triggered, this, &CopyablePlot::copyData);
        plot.addAction(asData);
    }
}

InputHelps CopyablePlot::help() {
    return {{tr("Right click on a plot"), tr("copies its picture or its numbers")}};
}

/// A press asks for the menu; whether it is a click shows when the button comes up.
bool CopyablePlot::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &plot_ && event->type() == QEvent::ContextMenu) {
        const auto* const asked = static_cast<QContextMenuEvent*>(event);
        if (QApplication::mouseButtons().testFlag(Qt::RightButton)) {
            pressed_ = asked->globalPos();
            qApp->installEventFilter(this);
        } else {
            showMenu(asked->globalPos());
        }
        return true;
    }
    if (pressed_ && event->type() == QEvent::MouseButtonRelease) {
        qApp->removeEventFilter(this);
        const QPoint position = static_cast<QMouseEvent*>(event)->globalPos();
        if ((position - *std::exchange(pressed_, {})).manhattanLength() <
            QApplication::startDragDistance()) {
            QTimer::singleShot(0, this, [this, position] { showMenu(position); });
        }
    }
    return QObject::eventFilter(watched, event);
}

void CopyablePlot::showMenu(const QPoint& position) {
    auto* menu = new QMenu(&plot_);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    menu->addActions(plot_.actions());
    menu->popup(position);
}

CopyablePlot* CopyablePlot::of(QWidget* widget) {
    for (QWidget* part = widget; part != nullptr; part = part->parentWidget()) {
        if (auto* plot = part->findChild<CopyablePlot*>(QString(), Qt::FindDirectChildrenOnly)) {
            return plot;
        }
    }
    return nullptr;
}

QImage CopyablePlot::picture() const { return plot_.grab().toImage(); }

QString CopyablePlot::data() const {
    const PlotTable table = numbers_ ? numbers_() : PlotTable();
    return table.isEmpty() ? QString() : table.tabSeparated();
}

void CopyablePlot::copyPicture() const { QApplication::clipboard()->setImage(picture()); }

void CopyablePlot::copyData() const { QApplication::clipboard()->setText(data()); }

void CopyablePlot::copy() const {
    auto* both = new QMimeData;  // the clipboard takes it over
    both->setImageData(picture());
    if (const QString numbers = data(); !numbers.isEmpty()) {
        both->setText(numbers);
    }
    QApplication::clipboard()->setMimeData(both);
}

}  // namespace asperity
