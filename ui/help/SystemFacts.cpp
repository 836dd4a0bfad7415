#include "ui/help/SystemFacts.h"

#include <QGuiApplication>
#include <QLocale>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QOpenGLWidget>
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

QString drawingFact(QOpenGLWidget& view) {
    if (view.context() == nullptr) {
        return QObject::tr("OpenGL: nothing is drawn yet");
    }
    view.makeCurrent();
    QOpenGLFunctions& functions = *view.context()->functions();
    const auto text = [&functions](GLenum name) {
        return QString::fromUtf8(reinterpret_cast<const char*>(functions.glGetString(name)));
    };
    const QString fact = QObject::tr("OpenGL: %1, %2, version %3")
                             .arg(text(GL_RENDERER), text(GL_VENDOR), text(GL_VERSION));
    view.doneCurrent();
    return fact;
}

}  // namespace

QStringList systemFacts(QOpenGLWidget& view) {
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
