#pragma once

#include <QObject>
#include <QString>
#include <QWidget>

#include <functional>
#include <vector>

class QLabel;
class QProgressBar;

namespace asperity {

/// A thin line that shows what is being done and how far it is, with a button to stop it.
class LoadingBar : public QWidget {
    Q_OBJECT

public:
    explicit LoadingBar(QWidget* parent = nullptr);

    /// Other work, at its beginning. @param words "Loading steps.gsf …"
    void begin(const QString& words);
    /// @param fraction of the work that is done, 0..1
    void setFraction(double fraction);

Q_SIGNALS:
    void cancelRequested();

private:
    QLabel* words_;
    QProgressBar* bar_;
};

/// The pieces of work that go on in the background. One line of the window names the latest of
/// those that are shown; once that ends it names the one before. What a user cancels is what the
/// line names.
class WorkInBackground : public QObject {
    Q_OBJECT

public:
    explicit WorkInBackground(QObject* parent) : QObject(parent) {}

    /// Returns a ticket for work that may begin again and again.
    [[nodiscard]] int ticket() { return ++tickets_; }
    /// Work begins: it is the latest. @param cancel ends it, as a user asks for it
    void enter(int ticket, const std::function<void()>& cancel);
    /// It has lasted so long that it is shown. @param words "Loading steps.gsf …"
    void show(int ticket, const QString& words);
    /// @param fraction of it that is done, 0..1
    void setFraction(int ticket, double fraction);
    void leave(int ticket);
    /// Cancels the work that is named, else the latest.
    void cancel();

Q_SIGNALS:
    /// Empty: no work is.
    void named(const QString& words);
    /// Progress of the work that is named, 0..1.
    void progressed(double fraction);

private:
    struct Work {
        int ticket = 0;
        std::function<void()> cancel;
        QString words;  ///< empty: it is not shown yet
        double fraction = 0.0;
    };

    /// Null: there is none.
    Work* at(int ticket);
    Work* latestShown();
    void tell();

    int tickets_ = 0;
    std::vector<Work> works_;  ///< the latest comes last
};

}  // namespace asperity
