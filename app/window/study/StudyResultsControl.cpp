#include "app/window/study/StudyResultsControl.h"

#include "app/experiment/StudyResults.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "ui/shell/Host.h"
#include "ui/widgets/Theme.h"

#include <QFile>
#include <QFontDatabase>
#include <QLabel>
#include <QPainter>
#include <QPlainTextEdit>
#include <QTabWidget>
#include <QVBoxLayout>

namespace asperity {

namespace {

constexpr QSize kUsualSize(1040, 640);  // [px]

/// A picture as large as its room, its sides in proportion.
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

StudyResultsControl::StudyResultsControl(Host& host)
    : host_(host)
    , work_(loadingLine(host_),
            {.finished = [this](Drawn& drawn) { show(drawn); }, .failed = complaintIn(host_)}) {}

void StudyResultsControl::show(const WithFolder& withFolder) {
    work_.start(QObject::tr("Drawing the results …"), [withFolder](Progress& /*progress*/) {
        Drawn drawn;
        withFolder([&drawn](const ExperimentFolder& folder) {
            if (folder.trials().empty()) {
                throw Error("No trial of this study is done yet");
            }
            writeStudyResults(folder);
            writeStudyFigures(folder);
            drawn.folder = folder.path().string();
            drawn.text = studyText(folder);
            for (const auto& [name, file] :
                 {std::pair("Error", "figure_12.png"), std::pair("Time", "figure_13.png"),
                  std::pair("Force against time", "figure_11.png")}) {
                drawn.figures.emplace_back(name, (folder.path() / file).string());
            }
        });
        return drawn;
    });
}

void StudyResultsControl::show(const Drawn& drawn) {
    if (dialog_ == nullptr) {
        dialog_ = new StudyResultsDialog(&host_.widget());
    }
    std::vector<StudyFigure> figures;
    for (const auto& [name, file] : drawn.figures) {
        figures.push_back({.name = QObject::tr(name.c_str()),
                           .picture = QPixmap(QFile::decodeName(file.c_str()))});
    }
    dialog_->showResults(QString::fromStdString(printable(drawn.folder)),
                         QString::fromStdString(drawn.text), figures);
}

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
