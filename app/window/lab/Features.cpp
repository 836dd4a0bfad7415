#include "app/window/lab/Features.h"

#include "app/program/DataFolder.h"
#include "app/program/ProgramParts.h"
#include "app/window/Stage.h"
#include "app/window/ViewControl.h"
#include "app/window/curve/CurveFitControl.h"
#include "app/window/curve/MeasuredCurveControl.h"
#include "app/window/device/DemonstrationControl.h"
#include "app/window/device/DeviceControl.h"
#include "app/window/device/EngageControl.h"
#include "app/window/device/HapticControl.h"
#include "app/window/device/PathControl.h"
#include "app/window/export/ExportControl.h"
#include "app/window/fidelity/FidelityControl.h"
#include "app/window/live/LivePanels.h"
#include "app/window/map/ForceMapControl.h"
#include "app/window/measure/ForceCycleControl.h"
#include "app/window/measure/MarkerControl.h"
#include "app/window/measure/MeasuredHeights.h"
#include "app/window/measure/ProfileControl.h"
#include "app/window/measure/RoughnessControl.h"
#include "app/window/recording/PlaybackControl.h"
#include "app/window/recording/RecordingControl.h"
#include "app/window/recording/ReportControl.h"
#include "app/window/scene/ColorControl.h"
#include "app/window/scene/LibraryControl.h"
#include "app/window/scene/OpenControl.h"
#include "app/window/scene/SceneControl.h"
#include "app/window/scene/ScenePanel.h"
#include "app/window/session/SessionControl.h"
#include "app/window/study/StudyControl.h"
#include "ui/shell/AboutBox.h"
#include "ui/shell/ManualWindow.h"
#include "ui/view/ZoomView.h"

#include <QAction>

#include <filesystem>
#include <memory>

namespace asperity {

namespace {

ProgramFacts factsOf(ZoomView& view) {
    ProgramFacts facts{.version = QString::fromStdString(versionWithCommit()),
                       .compiler = QString::fromStdString(compilerName()),
                       .license = QString::fromStdString(licenseText()),
                       .libraries = {},
                       .system = systemFacts(view)};
    for (const LibraryPart& part : libraryParts()) {
        facts.libraries.push_back({QString::fromStdString(part.name),
                                   QString::fromStdString(part.version),
                                   QString::fromStdString(part.license),
                                   QStringLiteral("/usr/share/doc/%1/copyright")
                                       .arg(QString::fromStdString(part.package))});
    }
    return facts;
}

/// The pages of the manual: beside the data, in the sources as where the program is installed.
std::filesystem::path manualFolder() { return dataFolder().parent_path() / "docs"; }

class HelpControl : public Feature {
public:
    explicit HelpControl(Stage& stage)
        : Feature(stage), manual_(new ManualWindow(manualFolder(), &host_.widget())) {
        host_.addWindow(*manual_);
        addPage(1, "firstSteps", "first_steps.md",
                {.text = tr("&First steps"),
                 .tip = tr("From a file to a picture and a force log, click by click")});
        addPage(2, "manual", "README.md",
                {.text = tr("&Manual"), .tip = tr("All pages of the documentation")});
        connect(manual_, &ManualWindow::missing, this,
                [this](const QString& why) { host_.complain(why); });
        const QAction& entry =
            host_.menus().add({MenuName::Help, 1, 10}, "about",
                              {.text = tr("&About Asperity"),
                               .tip = tr("What the program is, its version and its license")});
        connect(&entry, &QAction::triggered, this,
                [this] { (new AboutBox(factsOf(live_.view()), &host_.widget()))->show(); });
    }

private:
    void addPage(int rank, const char* name, const char* page, const MenuEntry& words) {
        const QAction& entry = host_.menus().add({MenuName::Help, 0, rank}, name, words);
        connect(&entry, &QAction::triggered, this, [this, page] {
            if (manual_->open(QString::fromUtf8(page)) && !manual_->isVisible()) {
                host_.toggle(*manual_);
            }
        });
    }

    ManualWindow* manual_;  ///< the window's
};

template <class... Features>
void addAll(Stage& stage) {
    (stage.add<Features>(), ...);
}

}  // namespace

void addFeatures(Stage& stage) {
    addAll<RecordingControl,      //
           ModelFitControl,       //
           DeviceControl,         //
           SceneControl,          //
           OpenControl,           //
           ScanReportControl,     //
           ScenePanelControl,     //
           MaterialControl,       //
           ProbeControl,          //
           FidelityControl,       //
           EngageControl,         //
           PathControl,           //
           DemonstrationControl,  //
           StudyControl,          //
           HapticControl,         //
           ViewControl,           //
           MeasuredHeights,       //
           ProfileControl,        //
           RoughnessControl,      //
           MarkerControl,         //
           ForceCycleControl,     //
           ForceMapControl,       //
           MeasuredCurveControl,  //
           CurveFitControl,       //
           PlaybackControl,       //
           ComparisonControl,     //
           ReportControl,         //
           ColorControl,          //
           MessageControl,        //
           ClipboardControl,      //
           ExportControl,         //
           HelpControl,           //
           SessionControl,        //
           BundleControl>(stage);
}

void keepSession(Stage& stage, const std::filesystem::path& folder) {
    stage.get<SessionControl>().keepIn(folder);
    stage.get<OpenControl>().recent().leaveOut(folder);
}

void showShippedInstead(Stage& stage) {
    SceneControl& scenes = stage.get<SceneControl>();
    auto* const once = new QObject(&stage);
    const auto show = [&stage, once] {
        once->deleteLater();
        const std::filesystem::path shipped = defaultSceneFile();
        if (stage.run() == nullptr && !shipped.empty()) {
            stage.get<SceneControl>().open(shipped);
        }
    };
    // A file that fails without a question ends the program.
    const auto isAsked = std::make_shared<bool>(false);
    QObject::connect(&scenes, &SceneControl::scaleAsked, once, [isAsked] { *isAsked = true; });
    QObject::connect(&scenes, &SceneControl::openCanceled, once, show);
    QObject::connect(&scenes, &SceneControl::openFailed, once, [isAsked, show] {
        if (*isAsked) {
            show();
        }
    });
    QObject::connect(&stage.runs(), &RunControl::begun, once, &QObject::deleteLater);
}

}  // namespace asperity
