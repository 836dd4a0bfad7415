#pragma once

#include "ui/InputHelp.h"

#include <QString>
#include <QWidget>

#include <functional>
#include <vector>

class QLineEdit;
class QPagedPaintDevice;
class QTextBrowser;

namespace asperity {

/// A part of the cheat sheet.
struct HelpSection {
    QString title;
    InputHelps lines;
};

/// A window of its own that lists all keys and all that the mouse does, to be searched, copied and
/// printed. The list is made when it opens: it is that of the window as it is then.
class CheatSheet : public QWidget {
    Q_OBJECT

public:
    using MakeSections = std::function<std::vector<HelpSection>()>;

    CheatSheet(MakeSections makeSections, QWidget* parent);

    /// What is listed.
    [[nodiscard]] QString text() const;
    void print(QPagedPaintDevice& paper) const;

protected:
    void showEvent(QShowEvent* event) override;

private:
    void list();
    void askAndPrint();

    MakeSections makeSections_;
    QLineEdit* search_;
    QTextBrowser* list_;
};

}  // namespace asperity
