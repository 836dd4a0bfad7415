#include "ui/shell/CheatSheet.h"

#include "ui/plot/CopyablePlot.h"
#include "ui/plot/PlotNavigation.h"
#include "ui/view/OverviewMap.h"
#include "ui/view/PixelView.h"
#include "ui/widgets/HeldKeys.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QObject>
#include <QPrintDialog>
#include <QPrinter>
#include <QPushButton>
#include <QStringList>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <algorithm>
#include <functional>
#include <utility>

namespace asperity {

namespace {

constexpr QSize kSheetSize(640, 720);

/// Returns whether each word of the search is somewhere in the line.
bool matches(const InputHelp& line, const QString& search) {
    const QString all = line.input + QLatin1Char(' ') + line.effect;
    const QStringList words = search.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    return std::all_of(words.begin(), words.end(), [&all](const QString& word) {
        return all.contains(word, Qt::CaseInsensitive);
    });
}

QString rowsOf(const HelpSection& section, const QString& search) {
    const bool all = section.title.contains(search, Qt::CaseInsensitive);
    QString rows;
    for (const InputHelp& line : section.lines) {
        if (all || matches(line, search)) {
            rows += QStringLiteral("<tr><td width='34%'><b>%1</b></td><td>%2</td></tr>")
                        .arg(line.input.toHtmlEscaped(), line.effect.toHtmlEscaped());
        }
    }
    return rows;
}

/// Calls `visit` with each entry below an action and the texts of the menus that lead to it.
void visitEntries(QAction& action, const QStringList& path,
                  const std::function<void(QAction&, const QStringList&)>& visit) {
    if (action.isSeparator()) {
        return;
    }
    if (action.menu() == nullptr) {
        visit(action, path);
        return;
    }
    for (QAction* const entry : action.menu()->actions()) {
        visitEntries(*entry, path + QStringList(plainText(action.text())), visit);
    }
}

QString keysOf(const QAction& action) {
    QStringList keys;
    for (const QKeySequence& shortcut : action.shortcuts()) {
        keys << shortcut.toString(QKeySequence::NativeText);
    }
    return keys.join(QStringLiteral(", "));
}

void append(InputHelps& all, const InputHelps& some) {
    all.insert(all.end(), some.begin(), some.end());
}

/// The one key whose effect is that of whatever is open.
InputHelps escapeHelp() {
    return {{QObject::tr("Esc"),
             QObject::tr("closes a menu, a message, an enlarged panel or a window beside this one, "
                         "else ends the measuring tool on the whole scan, else stops loading; with "
                         "a force-feedback device: switches off its forces")}};
}

}  // namespace

CheatSheet::CheatSheet(MakeSections makeSections, QWidget* parent)
    : QWidget(parent, Qt::Tool)
    , makeSections_(std::move(makeSections))
    , search_(new QLineEdit(this))
    , list_(new QTextBrowser(this)) {
    setWindowTitle(tr("Keyboard and mouse"));
    setObjectName(QStringLiteral("cheatSheet"));
    search_->setObjectName(QStringLiteral("searchKeys"));
    search_->setPlaceholderText(tr("Search"));
    search_->setToolTip(tr("Lists only entries with these words"));
    search_->setClearButtonEnabled(true);
    list_->setObjectName(QStringLiteral("keyList"));
    list_->setToolTip(tr("All keys and mouse actions, menu by menu"));
    auto* print = new QPushButton(tr("Print…"), this);
    print->setToolTip(tr("Prints the list"));
    auto* top = new QHBoxLayout;
    top->addWidget(search_, 1);
    top->addWidget(print);
    auto* column = new QVBoxLayout(this);
    column->addLayout(top);
    column->addWidget(list_, 1);
    connect(search_, &QLineEdit::textChanged, this, &CheatSheet::list);
    connect(print, &QPushButton::clicked, this, &CheatSheet::askAndPrint);
    resize(kSheetSize);
}

QString CheatSheet::text() const { return list_->toPlainText(); }

void CheatSheet::print(QPagedPaintDevice& paper) const { list_->print(&paper); }

void CheatSheet::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    list();
    search_->setFocus();
}

void CheatSheet::list() {
    QString html;
    const QString search = search_->text().trimmed();
    for (const HelpSection& section : makeSections_()) {
        const QString rows = rowsOf(section, search);
        if (!rows.isEmpty()) {
            html += QStringLiteral("<h3>%1</h3><table width='100%' cellpadding='3'>%2</table>")
                        .arg(section.title.toHtmlEscaped(), rows);
        }
    }
    list_->setHtml(html.isEmpty() ? tr("No entry contains “%1”.").arg(search.toHtmlEscaped())
                                  : html);
}

void CheatSheet::askAndPrint() {
    QPrinter printer(QPrinter::HighResolution);
    QPrintDialog dialog(&printer, this);
    if (dialog.exec() == QDialog::Accepted) {
        print(printer);
    }
}

QString plainText(const QString& text) {
    const QString ampersand(QChar(0));  // what "&&" stands for
    return QString(text)
        .replace(QStringLiteral("&&"), ampersand)
        .remove(QLatin1Char('&'))
        .replace(ampersand, QStringLiteral("&"));
}

std::vector<MenuHelp> helpOf(const QMenuBar& bar) {
    std::vector<MenuHelp> menus;
    for (QAction* const menu : bar.actions()) {
        MenuHelp help{plainText(menu->text()), {}};
        visitEntries(*menu, {}, [&help](const QAction& entry, const QStringList& path) {
            if (!entry.shortcut().isEmpty()) {
                const QString text = plainText(entry.text());
                const QString tip = entry.toolTip();
                const QStringList below = path.mid(1) + QStringList(text);
                // Qt makes a tip of the text where none is set.
                const bool isSame = tip.startsWith(QString(text).remove(QStringLiteral("…"))) &&
                                    tip.size() <= text.size();
                help.entries.push_back(
                    {keysOf(entry), below.join(QStringLiteral(" › ")), isSame ? QString() : tip});
            }
        });
        if (!help.entries.empty()) {
            menus.push_back(help);
        }
    }
    return menus;
}

std::vector<QAction*> entriesOf(const QMenuBar& bar) {
    std::vector<QAction*> entries;
    for (QAction* const menu : bar.actions()) {
        visitEntries(*menu, {},
                     [&entries](QAction& entry, const QStringList&) { entries.push_back(&entry); });
    }
    return entries;
}

std::vector<HelpSection> windowHelp(const QMenuBar& bar) {
    std::vector<HelpSection> sections{
        {QObject::tr("Mouse in the large view"), GestureWidget::help()},
        {QObject::tr("Keys that move the tip, held in the large view"), HeldKeys::help()},
        {QObject::tr("Everywhere"), escapeHelp()}};
    InputHelps ofPanels = OverviewMap::help();
    append(ofPanels, CopyablePlot::help());
    ofPanels.push_back({QObject::tr("In a plot"), PlotNavigation::help()});
    sections.push_back({QObject::tr("Mouse in the panels"), ofPanels});
    for (const MenuHelp& menu : helpOf(bar)) {
        InputHelps lines;
        for (const ActionHelp& entry : menu.entries) {
            lines.push_back({entry.keys, entry.tip.isEmpty() ? entry.text
                                                             : QStringLiteral("%1: %2").arg(
                                                                   entry.text, entry.tip)});
        }
        sections.push_back({QObject::tr("Menu %1").arg(menu.menu), lines});
    }
    return sections;
}

}  // namespace asperity
