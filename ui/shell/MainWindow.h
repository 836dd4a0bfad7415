#pragma once

#include "ui/shell/Host.h"

#include <QMainWindow>

#include <set>
#include <vector>

class QShortcut;

namespace asperity {

class CheatSheet;

/// The empty main window: a layout for what fills it, menus above, messages and a line for the
/// loop's timing below. Opens in the middle of the screen, no larger than it.
class MainWindow : public QMainWindow, public Host {
    Q_OBJECT

public:
    MainWindow();
    ~MainWindow() override;
    MainWindow(const MainWindow&) = delete;
    MainWindow& operator=(const MainWindow&) = delete;

    [[nodiscard]] QWidget& widget() override { return *this; }
    [[nodiscard]] Menus& menus() override { return *menus_; }
    [[nodiscard]] WorkInBackground& works() override { return *works_; }
    [[nodiscard]] MessageLog& messages() override { return *messages_; }

    void setMiddle(const WindowLayout::Middle& middle) override;
    void addCard(Card& card, int share) override;
    void addStatus(QWidget& status) override;
    void addTool(QWidget* page, const QString& title) override;
    void showTool(QWidget* page) override;
    void hideTool(QWidget* page) override;
    void showCards() override;
    void addSidePage(QWidget* page, const QString& title) override;
    void showSidePage(QWidget* page) override;
    void addWindow(QWidget& panel) override;
    void toggle(QWidget& panel) override;

    using Host::tell;
    void tell(const QString& message, MessageKind kind) override;
    void complain(const QString& message) override;
    void setTitle(const QString& title) override;

    void askBeforeClosing(std::function<QString()> reason) override;
    void onDrop(std::function<void(const QString& file)> open) override;
    void allowChanges(bool allowed) override;
    void keepEscape(bool isKept) override;
    [[nodiscard]] bool escapeCloses() const override;
    void keep(QVariantMap& kept) override;
    void restore(const QVariantMap& kept) override;

    /// Returns the layout; there is a middle.
    [[nodiscard]] WindowLayout& layout() { return *layout_; }
    /// Returns the cards of the column on the right, from the top.
    [[nodiscard]] const std::vector<Card*>& cards() const;
    /// Returns whether one panel fills the middle of the window.
    [[nodiscard]] bool isPanelEnlarged() const;
    /// Disables every action but Quit: for measurements.
    void lock();

Q_SIGNALS:
    /// Scene and knobs can be changed, or no longer.
    void changesAllowed(bool allowed);

protected:
    void showEvent(QShowEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    /// The list of messages and what counts its errors.
    void placeMessages();
    /// The bottom line says why a number is refused; windows of their own have lines of their own.
    void tellRefusals(const QWidget& area);
    void addEntries();

    MessageLog* messages_;
    Menus* menus_;
    WorkInBackground* works_;
    WindowLayout* layout_ = nullptr;  ///< null: there is no middle yet
    CheatSheet* cheatSheet_;
    std::function<void(const QString& file)> drop_ = [](const QString& /*file*/) {};
    std::vector<std::function<QString()>> closingReasons_;
    bool isClosing_ = false;               ///< the user agreed to it
    std::set<QWidget*> placed_;            ///< panels once placed beside this window
    std::vector<QShortcut*> toolClosers_;  ///< Esc, where it is no emergency stop
};

}  // namespace asperity
