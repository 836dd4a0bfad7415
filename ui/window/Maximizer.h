#pragma once

#include <QByteArray>
#include <QObject>
#include <QPointer>

class QBoxLayout;
class QShortcut;
class QSplitter;
class QStackedLayout;
class QVBoxLayout;

namespace asperity {

/// Puts one panel of a splitter alone into the middle of the window, below the banner, and back to
/// where it was.
class Maximizer : public QObject {
    Q_OBJECT

public:
    /// @param pages the first one is the usual middle of the window; gets another one
    /// @param banner the first of `bannerHome`; it stays in sight
    Maximizer(QStackedLayout& pages, QWidget& banner, QBoxLayout& bannerHome);

    /// Enlarges a child of a splitter, or puts it back if it is the one that is enlarged.
    void toggle(QWidget& panel);
    void restore();
    [[nodiscard]] bool isActive() const { return panel_ != nullptr; }
    /// Whether Esc brings the window back.
    void setEscape(bool works);

Q_SIGNALS:
    void changed(bool active);

private:
    void enlarge(QWidget& panel, QSplitter& home);

    QStackedLayout& pages_;
    QWidget& banner_;
    QBoxLayout& bannerHome_;
    QWidget* page_;
    QVBoxLayout* column_;  ///< of the page: a way back, banner, panel
    QShortcut* escape_;
    bool escapeWorks_ = true;
    QPointer<QWidget> panel_;    ///< null: none is enlarged
    QSplitter* home_ = nullptr;  ///< of the panel
    int place_ = 0;              ///< in its home
    QByteArray sizes_;           ///< of its home
    bool wasFolded_ = false;
};

}  // namespace asperity
