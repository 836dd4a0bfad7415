#include "app/session/QuitOnSignal.h"

#include <QCoreApplication>

#include <array>
#include <fcntl.h>
#include <unistd.h>

namespace asperity {

namespace {

std::array<int, 2> ends{-1, -1};  // of a pipe: all that a signal handler may use

void note(int /*signal*/) {
    const char byte = 1;
    [[maybe_unused]] const ssize_t written = write(ends[1], &byte, 1);
}

int openPipe() { return pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) == 0 ? ends[0] : -1; }

}  // namespace

QuitOnSignal::QuitOnSignal() : arrival_(openPipe(), QSocketNotifier::Read) {
    connect(&arrival_, &QSocketNotifier::activated, this, &QCoreApplication::quit);
    signals_.emplace(note);
}

QuitOnSignal::~QuitOnSignal() {
    signals_.reset();  // before what the handler writes to goes
    close(ends[0]);
    close(ends[1]);
}

}  // namespace asperity
