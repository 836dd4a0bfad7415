#include "ui/panels/LibraryBar.h"

#include "ui/panels/ChoiceBox.h"
#include "ui/panels/WheelGuard.h"

#include <QGridLayout>
#include <QToolButton>

namespace asperity {

namespace {

constexpr int kLibraryGap = 3;  ///< [px]

}  // namespace

LibraryBar::LibraryBar(const QString& kind, QWidget* parent)
    : QWidget(parent)
    , kind_(kind)
    , list_(new ChoiceBox(this))
    , save_(newButton(QStringLiteral("save"), tr("Save as…")))
    , rename_(newButton(QStringLiteral("rename"), tr("Rename…")))
    , delete_(newButton(QStringLiteral("delete"), tr("Delete"))) {
    list_->setObjectName(kind + QStringLiteral("Library"));
    list_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    guardFromWheel(*list_);
    auto* rows = new QGridLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(kLibraryGap);
    rows->addWidget(list_, 0, 0, 1, 3);
    rows->addWidget(save_, 1, 0);
    rows->addWidget(rename_, 1, 1);
    rows->addWidget(delete_, 1, 2);
    connect(list_, qOverload<int>(&QComboBox::activated), this, &LibraryBar::chosen);
    connect(save_, &QToolButton::clicked, this, &LibraryBar::saveRequested);
    connect(rename_, &QToolButton::clicked, this, &LibraryBar::renameRequested);
    connect(delete_, &QToolButton::clicked, this, &LibraryBar::deleteRequested);
    save_->setToolTip(tr("Keep the %1 of this scene under a name of its own").arg(kind));
    list_->setToolTip(tr("The %1s that come with the program, and your own").arg(kind));
    setOwn(false);
}

QToolButton* LibraryBar::newButton(const QString& name, const QString& text) {
    auto* button = new QToolButton(this);
    button->setObjectName(name + kind_.left(1).toUpper() + kind_.mid(1));
    button->setText(text);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    return button;
}

void LibraryBar::setEntries(const QStringList& names, const QStringList& notes) {
    list_->setNames(names);
    for (int i = 0; i < names.size() && i < notes.size(); ++i) {
        if (!notes.at(i).isEmpty()) {
            list_->setItemData(i, notes.at(i), Qt::ToolTipRole);
        }
    }
}

void LibraryBar::setCurrent(int index) { list_->setCurrentIndex(index); }

void LibraryBar::setOwn(bool own) {
    const QString reason =
        tr("Only a %1 of your own, which is listed here, can be renamed or deleted").arg(kind_);
    rename_->setEnabled(own);
    delete_->setEnabled(own);
    rename_->setToolTip(own ? tr("Give your %1 another name").arg(kind_) : reason);
    delete_->setToolTip(own ? tr("Delete the file of your %1; the scene stays as it is").arg(kind_)
                            : reason);
}

}  // namespace asperity
