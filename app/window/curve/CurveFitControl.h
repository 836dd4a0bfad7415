#pragma once

#include "app/curves/FitFiles.h"
#include "app/window/LongWork.h"
#include "app/window/Stage.h"
#include "core/io/curves/ForceCurveFile.h"

#include <filesystem>
#include <memory>
#include <string>

namespace asperity {

class CurveFitPage;

/// Opens files of measured force curves, fits one of them off the window's thread, and saves it or
/// opens it as a scene.
class CurveFitControl : public Feature {
    Q_OBJECT

public:
    explicit CurveFitControl(Stage& stage);

    /// Opens a file and fits its first curve.
    void open(const std::filesystem::path& file, const CurveReadOptions& read = {});
    /// Writes the files of the curve that is shown. @param opens the scene, too
    void save(const std::filesystem::path& folder, bool opens);

Q_SIGNALS:
    /// A fit is shown, or the reason why there is none.
    void shown();
    void saved();

private:
    struct Fitted {
        std::shared_ptr<const ForceCurveFile> file;
        FittedCurve curve;
        bool isNew = false;  ///< the file has just been opened
    };

    void ask();
    void askColumns();
    void askFolder(bool opens);
    void fit();
    void show(Fitted& fitted);
    void complain(const std::exception_ptr& reason);

    CurveFitPage* page_;  ///< the window's
    std::filesystem::path path_;
    CurveReadOptions read_;
    std::shared_ptr<const ForceCurveFile> file_;  ///< null: none is open
    FittedCurve curve_;                           ///< that is shown
    LongWork<Fitted> fits_;
    LongWork<std::filesystem::path> saves_;  ///< the scene to be opened; empty: none
};

}  // namespace asperity
