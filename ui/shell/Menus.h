#pragma once

#include "core/EnumTable.h"

#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>

#include <cstdint>
#include <functional>
#include <map>

class QAction;
class QMenu;
class QMenuBar;

namespace asperity {

class WindowLayout;

/// The menus of the window, in the order of its bar.
enum class MenuName : std::uint8_t { File, Edit, Run, Device, View, Measure, Help };

template <>
inline constexpr auto kEnumTable<MenuName> =
    std::to_array<EnumRow<MenuName>>({{MenuName::File, "file", "&File"},
                                      {MenuName::Edit, "edit", "&Edit"},
                                      {MenuName::Run, "run", "&Run"},
                                      {MenuName::Device, "device", "&Device"},
                                      {MenuName::View, "view", "&View"},
                                      {MenuName::Measure, "measure", "&Measure"},
                                      {MenuName::Help, "help", "&Help"}});

/// A position in a menu. Sections are divided by lines; within one, ranks order the entries.
struct MenuPosition {
    MenuName menu;
    int section = 0;
    int rank = 0;
};

/// An entry of a menu.
struct MenuEntry {
    QString text;
    QString tip;  ///< what it does
    QList<QKeySequence> shortcuts = {};
    bool isCheckable = false;
    QString keptAs = {};  ///< under which settings keep whether it is checked; empty: they do not
    /// Returns why it cannot work now; empty: it can.
    std::function<QString()> refusal = {};
};

/// The menus of the window: whoever does something adds its entry, with the reason for which it may
/// be off.
class Menus : public QObject {
public:
    explicit Menus(QMenuBar& bar);

    /// Adds an entry. @param name as an object
    QAction& add(const MenuPosition& position, const char* name, const MenuEntry& entry);
    /// Adds a menu. @param name as an object
    QMenu& addMenu(const MenuPosition& position, const char* name, const QString& title);
    /// Adds the entries of a menu that stays their owner, one after the other.
    void addEntriesOf(QMenu& menu, const MenuPosition& position);
    /// Disables an entry while there is a reason, which its tool tip shows.
    /// @param refusal the reason; empty: it is on
    void refuseBy(QAction& entry, const std::function<QString()>& refusal);
    /// The entry, or the menu's entry, of this name; there is one.
    [[nodiscard]] QAction& entry(const char* name) const;

    /// Returns the entries that settings keep, by their keys there.
    [[nodiscard]] const std::map<QString, QAction*>& kept() const { return kept_; }

    /// Asks for every reason again.
    void refresh();
    /// From now on every entry stays as it is.
    void lock() { isLocked_ = true; }

private:
    void insert(QMenu& menu, const MenuPosition& position, QAction& action);

    struct Refusal {
        std::function<QString()> reason;
        QString shown;  ///< empty: the entry is on
        QString tip;    ///< of the entry where it is on
    };

    std::map<MenuName, QMenu*> menus_;
    std::map<QAction*, Refusal> refusals_;
    std::map<QString, QAction*> kept_;
    bool isLocked_ = false;
};

/// Entries of the menu that hides and shows the parts of the window.
class PanelsMenu : public QObject {
    Q_OBJECT

public:
    /// Keeps the entries of the menu, which owns it, as the parts of the window are.
    PanelsMenu(QMenu& menu, WindowLayout& layout);

private:
    void fill();
    void check();

    QMenu& menu_;
    WindowLayout& layout_;
};

/// Theme of the windows: one of a menu's entries.
class ThemeMenu : public QObject {
    Q_OBJECT

public:
    /// Adds its entries to the menu, which owns it.
    explicit ThemeMenu(QMenu& menu);
};

}  // namespace asperity
