#include "app/commands/VirtualDisplay.h"

#include "core/Error.h"
#include "vtkplugins/pictures/Display.h"

#include <QGuiApplication>

#include <clocale>
#include <csignal>
#include <cstdlib>
#include <iostream>

namespace asperity {

namespace {

[[noreturn]] void refuse(const std::string& why) {
    throw Error("no display: none answers at DISPLAY and " + why);
}

/// The server replies with its display number.
ProgramCall serverCall() {
    const std::filesystem::path program = findProgram("Xvfb");
    if (program.empty()) {
        refuse("Xvfb is not installed (Debian package xvfb)");
    }
    ProgramCall call = trustedCall(program, {"-displayfd", "3", "-screen", "0", "1600x1000x24",
                                             "-nolisten", "tcp", "-noreset"});
    call.output = ProgramStream::Dropped;
    call.errors = ProgramStream::Dropped;
    call.hasReplies = true;
    call.endSignal = SIGTERM;  // it removes its lock and its socket
    return call;
}

/// Waits for the display number that the server announces.
std::string displayNumber(RunningProgram& server) {
    while (server.output().find('\n') == std::string::npos) {
        if (server.look()) {
            refuse("Xvfb ended as soon as it was started");
        }
    }
    return server.output().substr(0, server.output().find('\n'));
}

char kProgram[] = "asperity";
char kPlatformOption[] = "-platform";
char kPlatform[] = "offscreen";

void showIfFatal(QtMsgType type, const QMessageLogContext& /*context*/, const QString& message) {
    if (type == QtFatalMsg) {
        std::cerr << message.toStdString() << '\n';
    }
}

}  // namespace

VirtualDisplay::VirtualDisplay() {
    const char* display = std::getenv("DISPLAY");  // NOLINT(concurrency-mt-unsafe): at start
    before_ = display == nullptr ? "" : display;
    if (!before_.empty() && haveDisplay()) {
        return;
    }
    const ProgramCall call = serverCall();
    try {
        server_.emplace(call);
    } catch (const Error& error) {
        refuse(error.what());
    }
    // NOLINTNEXTLINE(concurrency-mt-unsafe): at start
    setenv("DISPLAY", (":" + displayNumber(*server_)).c_str(), 1);
}

VirtualDisplay::~VirtualDisplay() {
    if (!server_) {
        return;
    }
    server_.reset();
    before_.empty() ? unsetenv("DISPLAY")                     // NOLINT(concurrency-mt-unsafe)
                    : setenv("DISPLAY", before_.c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
}

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
