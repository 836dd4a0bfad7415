#pragma once

#include "core/Progress.h"

#include <QObject>

#include <functional>

namespace asperity {

/// Has the thread that made this object do pieces of the work of another one, each in an event of
/// its own: OpenGL beside the window's is safe on the window's thread alone. It outlives that work.
class PiecesHere {
public:
    /// Called by the other thread, which waits until the piece is done. Work that is canceled waits
    /// no longer, and the piece is left out: this object's thread may be waiting for its end.
    /// @throw what the piece throws; Canceled
    void run(const std::function<void()>& piece, const Progress& progress);
    /// The same without waiting, whatever becomes of the work: to let go of what lives there.
    template <typename Piece>
    void later(Piece piece) {
        QMetaObject::invokeMethod(&here_, std::move(piece), Qt::QueuedConnection);
    }

private:
    QObject here_;
};

}  // namespace asperity
