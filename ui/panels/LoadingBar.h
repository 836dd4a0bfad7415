#pragma once

#include <QString>
#include <QWidget>

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

}  // namespace asperity
