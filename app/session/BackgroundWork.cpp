#include "app/session/BackgroundWork.h"

#include "app/program/ToldError.h"

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

}  // namespace asperity
