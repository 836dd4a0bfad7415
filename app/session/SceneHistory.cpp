#include "app/session/SceneHistory.h"

#include <QUndoCommand>

namespace asperity {

namespace {

constexpr int kMostChanges = 500;  ///< some kilobytes each
constexpr int kNumberId = 1;       ///< of commands that may be one

/// One change. It does nothing itself: a change that takes time is made before it is told here.
class ChangeMade : public QUndoCommand {
public:
    ChangeMade(const QString& name, QString number, PastScene before, PastScene after)
        : QUndoCommand(name)
        , number_(std::move(number))
        , before_(std::move(before))
        , after_(std::move(after)) {}

    [[nodiscard]] const PastScene& before() const { return before_; }
    [[nodiscard]] const PastScene& after() const { return after_; }

    [[nodiscard]] int id() const override { return number_.isEmpty() ? -1 : kNumberId; }
    bool mergeWith(const QUndoCommand* other) override {
        const auto& next = static_cast<const ChangeMade&>(*other);
        if (next.number_ != number_) {
            return false;
        }
        setText(next.text());
        after_ = next.after_;
        setObsolete(after_.description == before_.description);
        return true;
    }

private:
    QString number_;
    PastScene before_;
    PastScene after_;
};

}  // namespace

SceneHistory::SceneHistory() { stack_.setUndoLimit(kMostChanges); }

void SceneHistory::add(const QString& name, const QString& number, const PastScene& before,
                       const PastScene& after) {
    stack_.push(new ChangeMade(name, number, before, after));
}

const PastScene& SceneHistory::after(int changes) const {
    const auto made = [this](int change) -> const ChangeMade& {
        return static_cast<const ChangeMade&>(*stack_.command(change));
    };
    return changes == 0 ? made(0).before() : made(changes - 1).after();
}

}  // namespace asperity
