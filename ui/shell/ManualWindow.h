#pragma once

#include <QString>
#include <QWidget>

#include <filesystem>

class QTextBrowser;
class QUrl;

namespace asperity {

/// A window of its own with the pages of the manual, which link to each other.
class ManualWindow : public QWidget {
    Q_OBJECT

public:
    /// @param folder of the pages; it need not be there
    ManualWindow(const std::filesystem::path& folder, QWidget* parent);

    /// Shows a page of the folder. @return whether it is there; else missing() says so
    bool open(const QString& page);
    /// Returns the text of the page that is shown.
    [[nodiscard]] QString text() const;

Q_SIGNALS:
    /// A page that was asked for is not there. @param why a sentence
    void missing(const QString& why);

private:
    void follow(const QUrl& link);

    QString folder_;
    QTextBrowser* page_;
};

}  // namespace asperity
