#include "ui/experiment/StudyResultsDialog.h"

#include "ui/Theme.h"

#include <QFontDatabase>
#include <QLabel>
#include <QPainter>
#include <QPlainTextEdit>
#include <QTabWidget>
#include <QVBoxLayout>

namespace asperity {

namespace {

constexpr QSize kUsualSize(1040, 640);  // [px]

/// A picture as large as its place, its sides in proportion.
class FittedPicture : public QWidget {
public:
    explicit FittedPicture(QPixmap picture) : picture_(std::move(picture)) {}

protected:
    void paintEvent(QPaintEvent* /*event*/) override {
        const double ratio = devicePixelRatioF();
        QPixmap fitted =
            picture_.scaled(ratio * size(), Qt::KeepAspectRatio, Qt::SmoothTransformation);
        fitted.setDevicePixelRatio(ratio);
        const QSizeF drawn = QSizeF(fitted.size()) / ratio;
        QPainter painter(this);
        painter.drawPixmap(
            QPointF(0.5 * (width() - drawn.width()), 0.5 * (height() - drawn.height())), fitted);
    }

private:
    QPixmap picture_;
};

}  // namespace

StudyResultsDialog::StudyResultsDialog(QWidget* window)
    : QDialog(window), folder_(new QLabel(this)), tabs_(new QTabWidget(this)) {
    setObjectName(QStringLiteral("studyResultsDialog"));
    setWindowTitle(tr("Results of the study"));
    folder_->setObjectName(QStringLiteral("resultsFolder"));
    folder_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    folder_->setToolTip(tr("Where figures and tables lie"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(tabs_, 1);
    column->addWidget(folder_);
    resize(theme::scaled(kUsualSize.width()), theme::scaled(kUsualSize.height()));
}

void StudyResultsDialog::showResults(const QString& folder, const QString& text,
                                     const std::vector<StudyFigure>& figures) {
    const int index = std::max(tabs_->currentIndex(), 0);
    tabs_->clear();
    for (const StudyFigure& figure : figures) {
        tabs_->addTab(new FittedPicture(figure.picture), figure.name);
    }
    auto* numbers = new QPlainTextEdit(text);
    numbers->setObjectName(QStringLiteral("resultsText"));
    numbers->setReadOnly(true);
    numbers->setLineWrapMode(QPlainTextEdit::NoWrap);
    numbers->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    tabs_->addTab(numbers, tr("Means and findings"));
    tabs_->setCurrentIndex(std::min(index, tabs_->count() - 1));
    folder_->setText(folder);
    show();
    raise();
    activateWindow();
}

}  // namespace asperity
