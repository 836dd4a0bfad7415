#pragma once

#include <QStringList>
#include <QWidget>

#include <map>
#include <string>

class QPushButton;
class QToolButton;

namespace asperity {

class ChoiceBox;
class FlowLayout;
class GainSpinBox;
struct SettingField;
struct Settings;

/// The knobs above the views, in two lines where the window is narrow. Setters show a state and
/// emit nothing; signals tell what the user changed.
class ControlBar : public QWidget {
    Q_OBJECT

public:
    explicit ControlBar(QWidget* parent = nullptr);

    void setMaterials(const QStringList& names);
    void setDevices(const QStringList& names);
    void setPaths(const QStringList& names);

    /// @param index into the names set before; -1: none of them
    void setMaterial(int index);
    void setDevice(int index);
    void setPath(int index);
    void setRunning(bool running);
    void setForcesOn(bool on);
    [[nodiscard]] bool forcesOn() const;
    void setKnobs(const Settings& settings);
    /// Disables a knob that cannot be turned now. @param column of its setting
    /// @param reason that its tool tip says; empty: it can
    void refuseKnob(const std::string& column, const QString& reason);
    /// Disables what moves the tip: device and path. @param reason as above
    void refuseTip(const QString& reason);
    /// Disables all but the forces' button. @param reason as above
    void fix(const QString& reason);
    void setRecording(bool recording);

Q_SIGNALS:
    void runningChosen(bool running);
    void forcesChosen(bool on);
    void materialChosen(int index);
    void deviceChosen(int index);
    void pathChosen(int index);
    void pathFileRequested();  ///< a path shall be read from a file
    /// @param column of the knob, see listSettings()
    void knobTurned(const QString& column, double value);
    void recordingChosen(bool recording);

private:
    void refuse(QWidget& control, const QString& reason);
    void showRefusals();
    QPushButton* addButton(const char* objectName, const QString& widest);
    ChoiceBox* addCombo(const char* objectName, const QString& caption);
    void addKnobs();
    void addKnob(const SettingField& field);
    void connectInputs();

    FlowLayout* row_;
    QPushButton* startPause_;
    QPushButton* forces_;
    ChoiceBox* material_;
    ChoiceBox* device_;
    ChoiceBox* path_;
    QToolButton* pathFile_;
    std::map<std::string, GainSpinBox*> knobs_;  ///< by column
    QPushButton* record_;
    QString fixedBy_;  ///< empty: what follows counts
    QString tipRefusal_;
    std::map<std::string, QString> knobRefusals_;  ///< by column
};

}  // namespace asperity
