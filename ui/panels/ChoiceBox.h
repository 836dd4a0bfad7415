#pragma once

#include <QComboBox>

namespace asperity {

/// A list of choices that asks for as much width as its present text takes, up to 24 letters; a
/// longer text ends in "…". It may be narrower where nobody heeds what it asks for.
class ChoiceBox : public QComboBox {
public:
    explicit ChoiceBox(QWidget* parent = nullptr);

    void setNames(const QStringList& names);
    /// What is drawn of the present text.
    [[nodiscard]] QString shownText() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return QComboBox::sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// For letters, in a box of this width [px].
    [[nodiscard]] int textRoom(int width) const;
};

}  // namespace asperity
