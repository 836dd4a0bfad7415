#include "app/commands/OffscreenApplication.h"

#include <QGuiApplication>

#include <clocale>
#include <iostream>

namespace asperity {

namespace {

char kProgram[] = "asperity";
char kPlatformOption[] = "-platform";
char kPlatform[] = "offscreen";

void showIfFatal(QtMsgType type, const QMessageLogContext& /*context*/, const QString& message) {
    if (type == QtFatalMsg) {
        std::cerr << message.toStdString() << '\n';
    }
}

}  // namespace

OffscreenApplication::OffscreenApplication()
    : argumentCount_(3), arguments_{kProgram, kPlatformOption, kPlatform, nullptr} {
    // It complains of folders of a desktop session, which drawing does not need.
    const QtMessageHandler before = qInstallMessageHandler(showIfFatal);
    application_ = std::make_unique<QGuiApplication>(argumentCount_, arguments_);
    qInstallMessageHandler(before);
    std::setlocale(LC_NUMERIC, "C");  // NOLINT(concurrency-mt-unsafe): Qt has set the user's
}

OffscreenApplication::~OffscreenApplication() = default;

}  // namespace asperity
