#pragma once

#include "app/window/Stage.h"
#include "core/haptics/VirtualRun.h"
#include "core/scene/SettingFields.h"

#include <QWidget>

#include <functional>
#include <map>
#include <optional>

class QLabel;
class QVBoxLayout;

namespace asperity {

class NumberBox;
class Section;

/// The energy at the port of a force-feedback device, see PassivityObserver.
struct PortEnergy {
    double dissipated = 0.0;  ///< less what leaked; below 0: the port gave it [J]
    double spring = 0.0;      ///< in the coupling's spring [J]
    bool warned = false;      ///< the port gives more than is explained
};

/// Every knob of the haptics that a scene or a run has, and how device, force, energy and loop are
/// now. Setters show a state and emit nothing.
class HapticPanel : public QWidget {
    Q_OBJECT

public:
    explicit HapticPanel(QWidget* parent = nullptr);

    void showSettings(const Settings& settings);
    void showRate(double rate);  ///< of the tick [Hz]
    /// @param words what is known of the device and its coupling
    /// @param rendersForce what only a device with motors has works
    void showDevice(const QString& words, bool rendersForce);
    /// @param limit of the device's force, if it renders any [N]
    void showTick(const TickOutput& output, double limit);
    void showLoop(const LoopStatistics& statistics);
    /// None: no force-feedback device drives the tip.
    void showEnergy(const std::optional<PortEnergy>& energy);
    /// Shows why there can be no guide; empty: there can.
    void refuseGuide(const QString& reason);

Q_SIGNALS:
    /// @param column of the knob, see listSettings()
    void settingTurned(const QString& column, double value);
    void rateEntered(double rate);  ///< [Hz]

private:
    [[nodiscard]] Section& addSection(const QString& title, const QString& about);
    void addSettings();
    [[nodiscard]] Section& sectionOf(SettingGroup group);
    void addRow(Section& section, const SettingField& field, QWidget* control);
    [[nodiscard]] QWidget* newControl(const SettingField& field, double value);
    [[nodiscard]] QWidget* newControl(const SettingField& field, int value);
    [[nodiscard]] QWidget* newControl(const SettingField& field, bool value);
    template <HasEnumTable Value>
    [[nodiscard]] QWidget* newControl(const SettingField& field, Value value);
    QLabel* addReading(Section& section, const char* name, const QString& caption,
                       const QString& toolTip);
    void addReadings();

    QVBoxLayout* column_;
    std::map<SettingGroup, Section*> sections_;
    std::map<std::string, std::function<void(double)>> show_;  ///< by column
    Section* energySection_ = nullptr;
    NumberBox* rate_;
    QLabel* device_;
    QLabel* force_;
    QLabel* state_;
    QLabel* energy_;
    QLabel* spring_;
    QLabel* tick_;
    QLabel* late_;
    QLabel* missed_;
};

/// The page that shows all knobs of the haptics with device, force, energy and loop, and turns
/// them.
class HapticControl : public Feature {
    Q_OBJECT

public:
    explicit HapticControl(Stage& stage);

    /// Once a frame. There is a run.
    void show();

private:
    void turn(const QString& column, double value);
    void setRate(double rate);
    void showRate();
    void showDevice(LiveRun& run);

    HapticPanel* panel_;
    Settings shown_;
    int frame_ = 0;  ///< since the readings were shown
};

}  // namespace asperity
