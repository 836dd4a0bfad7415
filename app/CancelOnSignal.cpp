#include "app/CancelOnSignal.h"

#include <csignal>

namespace asperity {

namespace {

volatile std::sig_atomic_t arrived = 0;  // all that a signal handler may write

void note(int /*signal*/) { arrived = 1; }

}  // namespace

CancelOnSignal::CancelOnSignal() {
    std::signal(SIGINT, note);
    std::signal(SIGTERM, note);
}

CancelOnSignal::~CancelOnSignal() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

bool CancelOnSignal::hasArrived() { return arrived != 0; }

}  // namespace asperity
