#pragma once

#include "core/surface/GivenScale.h"
#include "core/surface/ScaleGap.h"
#include "ui/window/ScaleDialog.h"

#include <QPointer>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>

namespace asperity {

class MainWindow;

/// Asks the user for the scale that a file does not hold, and suggests for the next scan of the
/// same type and pixels what was given for the last one, while the session lasts.
class ScaleControl : public QObject {
    Q_OBJECT

public:
    using Kind = std::tuple<std::string, int, int>;  ///< extension, columns, rows

    explicit ScaleControl(MainWindow& window) : window_(window) {}

    /// Opens the dialog; the window goes on meanwhile. One that is open closes.
    void ask(const std::filesystem::path& file, const ScaleGap& gap);
    /// What was given for the last scan of this type and these pixels; none: there was none.
    [[nodiscard]] std::optional<GivenScale> suggestion(const std::filesystem::path& file,
                                                       const ScaleGap& gap) const;
    /// To be suggested for the next one.
    void learn(const std::filesystem::path& file, const ScaleGap& gap, const GivenScale& scale);
    /// Nothing comes of the dialog that is open.
    void withdraw();

Q_SIGNALS:
    void given(GivenScale scale);
    void refused();

private:
    MainWindow& window_;
    QPointer<ScaleDialog> dialog_;
    std::map<Kind, GivenScale> known_;
};

}  // namespace asperity
