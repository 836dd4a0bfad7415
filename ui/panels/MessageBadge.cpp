#include "ui/panels/MessageBadge.h"

#include "ui/Theme.h"
#include "ui/panels/MessageLog.h"

namespace asperity {

MessageBadge::MessageBadge(const MessageLog& log, QWidget* parent) : QToolButton(parent) {
    setObjectName(QStringLiteral("messageBadge"));
    setToolTip(tr("Errors that nobody has read yet; a click lists all messages"));
    setFocusPolicy(Qt::TabFocus);  // a click leaves the keys to the view
    // The panel in sight may have read them since this signal was sent.
    connect(&log, &MessageLog::unreadErrorsChanged, this,
            [this, &log] { showCount(log.unreadErrors()); });
    showCount(log.unreadErrors());
    theme::follow(this, [this] {
        QPalette colors = palette();
        colors.setColor(QPalette::ButtonText, theme::colors().fault);
        setPalette(colors);
    });
}

void MessageBadge::showCount(int errors) {
    setText(errors == 1 ? tr("1 error") : tr("%1 errors").arg(errors));
    setVisible(errors > 0);
}

}  // namespace asperity
