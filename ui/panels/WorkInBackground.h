#pragma once

#include <QObject>
#include <QString>

#include <functional>
#include <vector>

namespace asperity {

/// The pieces of work that go on in the background. One line of the window names the latest of
/// those that are shown; once that ends it names the one before. What a user cancels is what the
/// line names.
class WorkInBackground : public QObject {
    Q_OBJECT

public:
    explicit WorkInBackground(QObject* parent) : QObject(parent) {}

    /// A place for work, that may begin again and again. @return its number
    [[nodiscard]] int place() { return ++places_; }
    /// Work begins: it is the latest. @param cancel ends it, as a user asks for it
    void enter(int place, const std::function<void()>& cancel);
    /// It has lasted so long that it is shown. @param words "Loading steps.gsf …"
    void show(int place, const QString& words);
    /// @param fraction of it that is done, 0..1
    void setFraction(int place, double fraction);
    void leave(int place);
    /// Cancels the work that is named, else the latest.
    void cancel();

Q_SIGNALS:
    /// Empty: no work is.
    void named(const QString& words);
    /// Of the work that is named, 0..1.
    void progressed(double fraction);

private:
    struct Work {
        int place = 0;
        std::function<void()> cancel;
        QString words;  ///< empty: it is not shown yet
        double fraction = 0.0;
    };

    /// Null: there is none.
    Work* at(int place);
    Work* latestShown();
    void tell();

    int places_ = 0;
    std::vector<Work> works_;  ///< the latest comes last
};

}  // namespace asperity
