#pragma once

#include "ui/shell/Host.h"
#include "ui/shell/Menus.h"
#include "ui/shell/WorkInBackground.h"
#include "ui/widgets/Card.h"

#include <QGridLayout>
#include <QMenuBar>
#include <QTabWidget>
#include <QVBoxLayout>
#include <QVariantMap>
#include <QWidget>

#include <functional>
#include <utility>

namespace asperity::test {

/// Stands in for the main window: all that features add is in one plain widget, and what they say
/// is kept.
class HostStandIn : public QWidget, public Host {
public:
    HostStandIn() {
        grid_->addWidget(bar_, 0, 0, 1, 2);
        grid_->addLayout(cards_, 2, 1);
        grid_->addWidget(pages_, 3, 0, 1, 2);
        grid_->setRowStretch(2, 1);
        resize(1600, 1200);
    }

    QWidget& widget() override { return *this; }
    Menus& menus() override { return *menus_; }
    WorkInBackground& works() override { return *works_; }
    MessageLog& messages() override { return *messages_; }

    void setMiddle(const WindowLayout::Middle& middle) override {
        grid_->addWidget(middle.top, 1, 0, 1, 2);
        grid_->addWidget(middle.views, 2, 0);
    }
    void addCard(Card& card, int share) override { cards_->addWidget(&card, share); }
    void addStatus(QWidget& status) override { grid_->addWidget(&status, 4, 0, 1, 2); }
    void addTool(QWidget* page, const QString& title) override { pages_->addTab(page, title); }
    void showTool(QWidget* page) override { pages_->setCurrentWidget(page); }
    void hideTool(QWidget* /*page*/) override {}
    void showCards() override {}
    void addSidePage(QWidget* page, const QString& title) override { addTool(page, title); }
    void showSidePage(QWidget* page) override { showTool(page); }
    void addWindow(QWidget& /*panel*/) override {}
    void toggle(QWidget& panel) override { panel.setVisible(!panel.isVisible()); }

    using Host::tell;
    void tell(const QString& message, MessageKind kind) override {
        told_ = message;
        if (!message.isEmpty()) {
            messages_->add(kind, message);
        }
    }
    void complain(const QString& message) override {
        complaint_ = message;
        messages_->add(MessageKind::Error, message);
    }
    void setTitle(const QString& title) override { setWindowTitle(title); }
    void askBeforeClosing(std::function<QString()> /*reason*/) override {}
    void onDrop(std::function<void(const QString& file)> open) override { drop = std::move(open); }
    void allowChanges(bool /*allowed*/) override {}
    void keepEscape(bool /*isKept*/) override {}
    bool escapeCloses() const override { return false; }
    void keep(QVariantMap& /*kept*/) override {}
    void restore(const QVariantMap& /*kept*/) override {}

    /// Returns the page on top of the tabs.
    [[nodiscard]] QWidget* shownTool() const { return pages_->currentWidget(); }
    /// Returns the last short message.
    [[nodiscard]] const QString& told() const { return told_; }
    /// Returns what must be read, and forgets it. Empty: nothing.
    QString takeComplaint() { return std::exchange(complaint_, {}); }

    std::function<void(const QString& file)> drop;  ///< a file on the window

private:
    QGridLayout* grid_ = new QGridLayout(this);
    QVBoxLayout* cards_ = new QVBoxLayout;
    QMenuBar* bar_ = new QMenuBar(this);
    Menus* menus_ = new Menus(*bar_);
    QTabWidget* pages_ = new QTabWidget(this);
    WorkInBackground* works_ = new WorkInBackground(this);
    MessageLog* messages_ = new MessageLog(this);
    QString told_;
    QString complaint_;
};

}  // namespace asperity::test
