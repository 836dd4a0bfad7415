#pragma once

#include "app/program/EndSignals.h"

#include <QObject>
#include <QSocketNotifier>

#include <optional>

namespace asperity {

/// Ends the event loop in good order on SIGINT, SIGTERM and SIGHUP, so that recordings are kept and
/// the operator feels nothing any more. One of them at a time.
class QuitOnSignal : public QObject {
public:
    QuitOnSignal();
    ~QuitOnSignal() override;
    QuitOnSignal(const QuitOnSignal&) = delete;
    QuitOnSignal& operator=(const QuitOnSignal&) = delete;

private:
    QSocketNotifier arrival_;
    std::optional<EndSignals> signals_;
};

}  // namespace asperity
