#include "ui/shell/MainWindow.h"

#include "core/PrintableText.h"
#include "ui/shell/CardColumn.h"
#include "ui/shell/CheatSheet.h"
#include "ui/shell/Dialogs.h"
#include "ui/shell/Menus.h"
#include "ui/shell/PageTabs.h"
#include "ui/shell/WorkInBackground.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/NumberBox.h"

#include <QAction>
#include <QCloseEvent>
#include <QDialog>
#include <QDragEnterEvent>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QShortcut>
#include <QSplitter>
#include <QStatusBar>

#include <utility>

namespace asperity {

namespace {

constexpr int kMessageTime = 8000;  // [ms]
// At first, where the screen has that much: usual screens are filled, and on larger ones panels
// would only grow emptier.
constexpr QSize kWindowSize(2400, 1500);

const QString kFolded = QStringLiteral("window/foldedPanels");
const QString kShown = QStringLiteral("window/shown/");
const QString kSplitter = QStringLiteral("window/splitter/");
const QString kOnTop = QStringLiteral("window/onTop/");

}  // namespace

MainWindow::MainWindow()
    : messages_(new MessageLog(this))
    , menus_(new Menus(*menuBar()))
    , works_(new WorkInBackground(this))
    , cheatSheet_(new CheatSheet([this] { return windowHelp(*menuBar()); }, this)) {
    setAcceptDrops(true);
    addEntries();
    addWindow(*cheatSheet_);
    setTitle({});
    setGeometry(openingGeometry(kWindowSize, screen()->availableGeometry()));
}

/// As it goes, a number half typed loses the focus and is refused: nobody is left to be told.
MainWindow::~MainWindow() {
    for (const NumberBox* box : findChildren<NumberBox*>()) {
        disconnect(box, nullptr, this, nullptr);
    }
}

void MainWindow::setMiddle(const WindowLayout::Middle& middle) {
    layout_ = new WindowLayout(middle, this);
    setCentralWidget(layout_);
    new PanelsMenu(menus_->addMenu({MenuName::View, 4, 10}, "panels", tr("&Panels")), *layout_);
    placeMessages();
    tellRefusals(*layout_);
}

void MainWindow::placeMessages() {
    auto* panel = new MessagesPanel(*messages_, this);
    addTool(panel, tr("Messages"));
    auto* badge = new MessageBadge(*messages_, this);
    statusBar()->addPermanentWidget(badge);
    connect(badge, &MessageBadge::clicked, this, [this, panel] { showTool(panel); });
}

const std::vector<Card*>& MainWindow::cards() const { return layout_->cards().cards(); }

bool MainWindow::isPanelEnlarged() const { return layout_->maximizer().isActive(); }

void MainWindow::addCard(Card& card, int share) {
    layout_->addCard(&card, share);
    tellRefusals(card);
}

void MainWindow::addStatus(QWidget& status) {
    statusBar()->addWidget(&status, 1);  // a message takes the whole line for a while
}

void MainWindow::addTool(QWidget* page, const QString& title) {
    layout_->tools().addPage(page, title, false);
}

void MainWindow::showTool(QWidget* page) {
    layout_->maximizer().restore();
    layout_->tools().showPage(page);
}

void MainWindow::hideTool(QWidget* page) {
    layout_->maximizer().restore();
    layout_->tools().setShown(page, false);
}

void MainWindow::showCards() { layout_->showCards(); }

void MainWindow::addSidePage(QWidget* page, const QString& title) {
    layout_->sidePages().addPage(page, title, true);
    tellRefusals(*page);
    connect(this, &MainWindow::changesAllowed, page, &QWidget::setEnabled);
}

void MainWindow::showSidePage(QWidget* page) {
    layout_->maximizer().restore();
    layout_->sidePages().showPage(page);
}

void MainWindow::toggle(QWidget& panel) {
    if (panel.isVisible()) {
        panel.hide();
        return;
    }
    if (placed_.insert(&panel).second) {
        panel.setGeometry(
            placeBeside(frameGeometry(), panel.size(), screen()->availableGeometry()));
    }
    panel.show();
    panel.raise();
    panel.activateWindow();
}

void MainWindow::addWindow(QWidget& panel) {
    auto* escape = new QShortcut(Qt::Key_Escape, &panel);
    connect(escape, &QShortcut::activated, &panel, [&panel] {
        for (NumberBox* box : panel.findChildren<NumberBox*>()) {
            box->discardTyped();
        }
        panel.hide();
    });
    toolClosers_.push_back(escape);
}

void MainWindow::tellRefusals(const QWidget& area) {
    const auto tellRefusal = [this](const QString& reason) { tell(reason, MessageKind::Warning); };
    for (const NumberBox* box : area.findChildren<NumberBox*>()) {
        if (box->window() == this) {
            connect(box, &NumberBox::refused, this, tellRefusal);
        }
    }
}

void MainWindow::addEntries() {
    const QAction& quit = menus_->add({MenuName::File, 2, 10}, "quit",
                                      {.text = tr("&Quit"),
                                       .tip = tr("End the run and close the window"),
                                       .shortcuts = {QKeySequence::Quit}});
    new ThemeMenu(menus_->addMenu({MenuName::View, 4, 20}, "theme", tr("&Theme")));
    const QAction& controls =
        menus_->add({MenuName::Help, 0, 10}, "controls",
                    {.text = tr("&Keyboard and mouse"),
                     .tip = tr("All keys and all that the mouse does, to be searched and printed"),
                     .shortcuts = {QKeySequence::HelpContents}});
    connect(&quit, &QAction::triggered, this, [this] { close(); });
    connect(&controls, &QAction::triggered, this, [this] { toggle(*cheatSheet_); });
}

void MainWindow::tell(const QString& message, MessageKind kind) {
    statusBar()->showMessage(message, kMessageTime);
    if (!message.isEmpty()) {
        messages_->add(kind, message);
    }
}

void MainWindow::complain(const QString& message) {
    const QString shown =
        QString::fromStdString(shortened(printableLines(message.toStdString()), kMaxMessage));
    messages_->add(MessageKind::Error, shown);
    complainIn(this, shown);
}

void MainWindow::setTitle(const QString& title) {
    setWindowTitle(title.isEmpty() ? tr("Asperity") : tr("%1 – Asperity").arg(title));
}

void MainWindow::onDrop(std::function<void(const QString& file)> open) { drop_ = std::move(open); }

void MainWindow::allowChanges(bool allowed) {
    setAcceptDrops(allowed);
    Q_EMIT changesAllowed(allowed);
}

void MainWindow::keepEscape(bool isKept) {
    for (QShortcut* escape : toolClosers_) {
        escape->setEnabled(!isKept);
    }
    layout_->maximizer().setEscape(!isKept);
}

bool MainWindow::escapeCloses() const { return isPanelEnlarged(); }

void MainWindow::lock() {
    closingReasons_.clear();  // a measurement ends by itself
    allowChanges(false);
    menus_->lock();
    const QAction* const quit = &menus_->entry("quit");
    for (QAction* action : findChildren<QAction*>()) {
        action->setEnabled(action == quit);
    }
}

void MainWindow::keep(QVariantMap& kept) {
    if (isPanelEnlarged()) {
        return;
    }
    QStringList folded;
    for (const Card* card : cards()) {
        if (card->isFolded()) {
            folded << card->title();
        }
    }
    kept.insert(kFolded, folded);
    for (const PanelSwitch& part : layout_->switches()) {
        kept.insert(kShown + part.key, part.isShown());
    }
    for (const QSplitter* splitter : layout_->splitters()) {
        kept.insert(kSplitter + splitter->objectName(),
                    QVariantList{splitter->count(), splitter->saveState()});
    }
    for (const PageTabs* pages : {&layout_->tools(), &layout_->sidePages()}) {
        kept.insert(kOnTop + pages->objectName(), pages->pageOnTop());
    }
}

void MainWindow::restore(const QVariantMap& kept) {
    const QStringList folded = kept.value(kFolded).toStringList();
    for (Card* card : cards()) {
        card->setFolded(folded.contains(card->title()));
    }
    for (const PanelSwitch& part : layout_->switches()) {
        part.setShown(kept.value(kShown + part.key, part.shownAtFirst).toBool());
    }
    for (QSplitter* splitter : layout_->splitters()) {
        // Of as many panels as there are now.
        const QVariantList state = kept.value(kSplitter + splitter->objectName()).toList();
        if (state.size() == 2 && state.front().toInt() == splitter->count()) {
            splitter->restoreState(state.back().toByteArray());
        }
    }
    for (PageTabs* pages : {&layout_->tools(), &layout_->sidePages()}) {
        pages->putOnTop(kept.value(kOnTop + pages->objectName()).toString());
    }
}

void MainWindow::askBeforeClosing(std::function<QString()> reason) {
    closingReasons_.push_back(std::move(reason));
}

void MainWindow::closeEvent(QCloseEvent* event) {
    QStringList reasons;
    for (const auto& reason : closingReasons_) {
        if (const QString words = reason(); !words.isEmpty()) {
            reasons << words;
        }
    }
    if (reasons.isEmpty() || isClosing_) {
        QMainWindow::closeEvent(event);
        return;
    }
    event->ignore();
    if (findChild<QDialog*>(QString::fromUtf8(kAskWhether)) == nullptr) {  // Alt+F4 twice asks once
        askWhether(this, reasons.join(QLatin1Char('\n')), tr("Close"), [this] {
            isClosing_ = true;
            close();
        });
    }
}

/// QStatusBar hides what a message covers only where that is on the screen already.
void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    if (const QString message = statusBar()->currentMessage(); !message.isEmpty()) {
        statusBar()->clearMessage();
        statusBar()->showMessage(message, kMessageTime);
    }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.size() == 1 && urls.front().isLocalFile()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    event->acceptProposedAction();
    // As a file URI: Qt's own texts lose the bytes of a name that is no UTF-8.
    drop_(QString::fromLatin1(event->mimeData()->urls().front().toEncoded()));
}

}  // namespace asperity
