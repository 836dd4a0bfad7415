#pragma once

#include <QMap>
#include <QString>
#include <QWidget>

class QGridLayout;
class QLabel;

namespace asperity {

/// Names and values below one another; a value can be selected and copied.
class ReadingGrid : public QWidget {
    Q_OBJECT

public:
    explicit ReadingGrid(QWidget* parent = nullptr);

    /// @param objectName of the value's label
    void add(const char* objectName, const QString& name, const QString& meaning);
    /// Shows a dash for an empty text.
    void set(const char* objectName, const QString& text);
    [[nodiscard]] QString text(const char* objectName) const;

private:
    QGridLayout* grid_;
    QMap<QString, QLabel*> values_;
};

}  // namespace asperity
