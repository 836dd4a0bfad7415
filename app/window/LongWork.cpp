#include "app/window/LongWork.h"

#include "app/program/EndSignals.h"
#include "ui/shell/Host.h"
#include "ui/shell/WorkInBackground.h"

#include <new>

namespace asperity {

QString reasonOf(const std::exception_ptr& error) {
    try {
        std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
        return QObject::tr("out of memory");
    } catch (const std::exception& known) {
        return QString::fromStdString(messageOf(known));
    }
}

std::function<void(const std::exception_ptr& reason)> complaintIn(Host& host) {
    return [&host](const std::exception_ptr& reason) { host.complain(reasonOf(reason)); };
}

WorkLine loadingLine(Host& host) {
    WorkInBackground& works = host.works();
    const int ticket = works.ticket();
    return {.begin = [&works, ticket](const QString& words) { works.show(ticket, words); },
            .setFraction = [&works, ticket](double share) { works.setFraction(ticket, share); },
            .end = [] {},
            .enter = [&works,
                      ticket](const std::function<void()>& cancel) { works.enter(ticket, cancel); },
            .leave = [&works, ticket] { works.leave(ticket); }};
}

}  // namespace asperity
