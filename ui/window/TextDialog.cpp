#include "ui/window/TextDialog.h"

#include "ui/Theme.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace asperity {

namespace {

constexpr int kTextGap = 8;            // [px]
constexpr int kTextDialogWidth = 720;  // [px, as theme::scaled() takes them]
constexpr int kTextHeight = 460;       // likewise

}  // namespace

TextDialog::TextDialog(const QString& title, const QString& tip, QWidget* window)
    : QDialog(window), text_(new QPlainTextEdit(this)) {
    setWindowTitle(title);
    setModal(false);
    text_->setObjectName(QStringLiteral("text"));
    text_->setReadOnly(true);
    text_->setToolTip(tip);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton* copy = buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
    copy->setObjectName(QStringLiteral("copyText"));
    copy->setToolTip(tr("Copy all of the text to the clipboard"));
    QPushButton* close = buttons->button(QDialogButtonBox::Close);
    close->setIcon({});  // no other button has one
    close->setToolTip(tr("Close this window"));
    connect(copy, &QPushButton::clicked, this,
            [this] { QGuiApplication::clipboard()->setText(text()); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kTextGap, kTextGap, kTextGap, kTextGap);
    column->setSpacing(kTextGap);
    column->addWidget(text_, 1);
    column->addWidget(buttons);
    resize(theme::scaled(kTextDialogWidth), theme::scaled(kTextHeight));
}

void TextDialog::setText(const QString& text) { text_->setPlainText(text); }

QString TextDialog::text() const { return text_->toPlainText(); }

}  // namespace asperity
