#include "app/session/ScaleControl.h"

#include "core/surface/MergedScale.h"
#include "ui/ShownPath.h"
#include "ui/window/MainWindow.h"

namespace asperity {

namespace {

ScaleControl::Kind kindOf(const std::filesystem::path& file, const ScaleGap& gap) {
    return {file.extension().string(), gap.columns, gap.rows};
}

}  // namespace

void ScaleControl::ask(const std::filesystem::path& file, const ScaleGap& gap) {
    withdraw();
    const QString name = shownPath(file.filename());
    dialog_ = new ScaleDialog(name, gap, &window_);
    dialog_->setAttribute(Qt::WA_DeleteOnClose);
    if (const auto known = suggestion(file, gap)) {
        dialog_->suggest(*known);
    }
    connect(dialog_, &ScaleDialog::given, this, [this, file, gap](const GivenScale& scale) {
        learn(file, gap, scale);
        Q_EMIT given(scale);
    });
    connect(dialog_, &QDialog::rejected, this, &ScaleControl::refused);
    dialog_->open();
}

std::optional<GivenScale> ScaleControl::suggestion(const std::filesystem::path& file,
                                                   const ScaleGap& gap) const {
    const auto known = known_.find(kindOf(file, gap));
    return known == known_.end() ? std::nullopt : std::optional(known->second);
}

void ScaleControl::learn(const std::filesystem::path& file, const ScaleGap& gap,
                         const GivenScale& scale) {
    GivenScale& known = known_[kindOf(file, gap)];
    known = merged(known, scale);
}

void ScaleControl::withdraw() {
    if (dialog_ != nullptr) {
        disconnect(dialog_, nullptr, this, nullptr);
        dialog_->close();
    }
}

}  // namespace asperity
