#include "ui/help/CheatSheet.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QPrintDialog>
#include <QPrinter>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace asperity {

namespace {

constexpr QSize kSheetSize(640, 720);

/// Whether each word of the search is somewhere in the line.
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
    search_->setToolTip(tr("Lists only what holds these words"));
    search_->setClearButtonEnabled(true);
    list_->setObjectName(QStringLiteral("keyList"));
    list_->setToolTip(tr("All keys and all that the mouse does, menu by menu"));
    auto* print = new QPushButton(tr("Print…"), this);
    print->setToolTip(tr("Prints what is listed"));
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
    list_->setHtml(html.isEmpty() ? tr("Nothing holds “%1”.").arg(search.toHtmlEscaped()) : html);
}

void CheatSheet::askAndPrint() {
    QPrinter printer(QPrinter::HighResolution);
    QPrintDialog dialog(&printer, this);
    if (dialog.exec() == QDialog::Accepted) {
        print(printer);
    }
}

}  // namespace asperity
