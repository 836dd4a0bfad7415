#include "app/session/ScaleControl.h"

#include "core/PrintableText.h"
#include "core/surface/MergedScale.h"
#include "ui/window/MainWindow.h"

namespace asperity {

void ScaleControl::ask(const std::filesystem::path& file, const ScaleGap& gap) {
    withdraw();
    const Kind kind{file.extension().string(), gap.columns, gap.rows};
    const QString name = QString::fromStdString(printable(file.filename().string()));
    dialog_ = new ScaleDialog(name, gap, &window_);
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    if (const auto known = known_.find(kind); known != known_.end()) {
        dialog_->suggest(known->second);
    }
    connect(dialog_, &ScaleDialog::given, this, [this, kind](const GivenScale& scale) {
        known_[kind] = merged(known_[kind], scale);
        Q_EMIT given(scale);
    });
    connect(dialog_, &QDialog::rejected, this, &ScaleControl::refused);
    dialog_->open();
}

void ScaleControl::withdraw() {
    if (dialog_ != nullptr) {
        disconnect(dialog_, nullptr, this, nullptr);
        dialog_->close();
    }
}

}  // namespace asperity
