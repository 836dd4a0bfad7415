#pragma once

#include "core/scene/SceneDescription.h"

#include <QString>
#include <QUndoStack>

namespace asperity {

/// A scene of the history.
struct PastScene {
    SceneDescription description;
    int origin = 0;  ///< number of the opening that it came by; changes keep it
};

/// The changes of the scene that can be undone, as descriptions: never as surfaces. A change comes
/// here once it is made; moving in the history makes none.
class SceneHistory {
public:
    SceneHistory();

    /// A change that is made. @param number what it turns, where such changes in a row are one;
    /// empty: it stands alone
    void add(const QString& name, const QString& number, const PastScene& before,
             const PastScene& after);
    /// So many changes are made; the others are undone.
    void moveTo(int index) { stack_.setIndex(index); }
    void clear() { stack_.clear(); }

    [[nodiscard]] int count() const { return stack_.count(); }
    /// How many changes are made.
    [[nodiscard]] int index() const { return stack_.index(); }
    /// The scene after so many changes; there are some.
    [[nodiscard]] const PastScene& after(int changes) const;
    /// Of the change with this number, from 0.
    [[nodiscard]] QString nameOf(int change) const { return stack_.text(change); }

private:
    QUndoStack stack_;
};

}  // namespace asperity
