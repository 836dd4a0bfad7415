#pragma once

#include <QString>
#include <QTabWidget>

#include <vector>

class QScrollArea;

namespace asperity {

/// Panels that share one area by tabs. Each can be hidden; the area is hidden while it is closed
/// or has no page to show.
class PageTabs : public QTabWidget {
    Q_OBJECT

public:
    struct Page {
        QWidget* panel;
        QScrollArea* area;  ///< scrolls it
        QString title;
        bool shownAtFirst;
    };

    explicit PageTabs(const char* objectName, QWidget* parent = nullptr);

    /// Adds a panel as the last page. It is scrolled where it has less room than it needs; one that
    /// is a scroll area already scrolls itself.
    void addPage(QWidget* panel, const QString& title, bool shownAtFirst);
    [[nodiscard]] const std::vector<Page>& pages() const { return pages_; }

    [[nodiscard]] bool isShown(const QWidget* panel) const;
    /// Hides a page, or shows it and opens the area.
    void setShown(const QWidget* panel, bool shown);
    void showPage(const QWidget* panel);
    [[nodiscard]] bool isOpen() const { return open_ && count() > 0; }
    /// Opens the area, with its first page where none is shown, or closes it.
    void setOpen(bool open);

    /// The title of the page on top; empty: there is none.
    [[nodiscard]] QString pageOnTop() const;
    void putOnTop(const QString& title);
    void reset();

Q_SIGNALS:
    void pageAdded();
    /// The user double clicked a tab.
    void enlargeRequested();

private:
    [[nodiscard]] const Page& pageOf(const QWidget* panel) const;
    [[nodiscard]] int tabIndexOf(const Page& page) const;
    [[nodiscard]] static QString toolTipOf(const Page& page);
    void settle();

    std::vector<Page> pages_;
    bool open_ = true;
};

}  // namespace asperity
