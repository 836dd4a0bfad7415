#include "app/program/EndSignals.h"

namespace asperity {

namespace {

/// @return what was there before
struct sigaction replaced(int signal, void (*handler)(int)) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler == SIG_IGN) {
        return before;
    }
    struct sigaction ours {};
    ours.sa_handler = handler;
    ours.sa_flags = SA_RESTART;
    sigaction(signal, &ours, nullptr);
    return before;
}

}  // namespace

EndSignals::EndSignals(void (*handler)(int))
    : interrupt_(replaced(SIGINT, handler))
    , terminate_(replaced(SIGTERM, handler))
    , hangUp_(replaced(SIGHUP, handler)) {}

EndSignals::~EndSignals() {
    sigaction(SIGINT, &interrupt_, nullptr);
    sigaction(SIGTERM, &terminate_, nullptr);
    sigaction(SIGHUP, &hangUp_, nullptr);
}

}  // namespace asperity
