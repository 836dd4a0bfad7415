#include "ui/help/SystemFacts.h"

#include "ui/view/PixelView.h"

#include <vtkOpenGLRenderWindow.h>

#include <QGuiApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QScreen>
#include <QSysInfo>
#include <QThread>

namespace asperity {

namespace {

QString screenFact(const QScreen& screen) {
    return QObject::tr("Screen %1: %2 × %3 points, %4 pixels a point, %5 dots an inch")
        .arg(screen.name())
        .arg(screen.geometry().width())
        .arg(screen.geometry().height())
        .arg(screen.devicePixelRatio())
        .arg(screen.logicalDotsPerInch(), 0, 'f', 0);
}

/// From what VTK reports: "OpenGL vendor string:  Mesa", a line each.
QString drawingFact(const PixelView& view) {
    if (view.frame().isNull()) {
        return QObject::tr("OpenGL: nothing is drawn yet");
    }
    const QString report = QString::fromUtf8(view.renderWindow().ReportCapabilities());
    const auto text = [&report](const char* name) {
        const QRegularExpression line(QStringLiteral("OpenGL %1 string: *([^\n]*)").arg(name));
        return line.match(report).captured(1);
    };
    return QObject::tr("OpenGL: %1, %2, version %3")
        .arg(text("renderer"), text("vendor"), text("version"));
}

}  // namespace

QStringList systemFacts(const PixelView& view) {
    QStringList facts{
        QObject::tr("System: %1, kernel %2 %3")
            .arg(QSysInfo::prettyProductName(), QSysInfo::kernelType(), QSysInfo::kernelVersion()),
        QObject::tr("Processor: %1, %2 threads")
            .arg(QSysInfo::currentCpuArchitecture())
            .arg(QThread::idealThreadCount()),
        QObject::tr("Qt in use: %1, platform %2, language %3")
            .arg(QString::fromUtf8(qVersion()), QGuiApplication::platformName(),
                 QLocale().bcp47Name())};
    for (const QScreen* const screen : QGuiApplication::screens()) {
        facts << screenFact(*screen);
    }
    return facts << drawingFact(view);
}

}  // namespace asperity
