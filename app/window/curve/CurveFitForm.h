#pragma once

#include "core/identify/cycle/CycleIdentification.h"

#include <QWidget>

#include <array>
#include <optional>

class QCheckBox;
class QComboBox;
class QGridLayout;

namespace asperity {

class NumberBox;

/// Tip, model and lever that measured curves are fitted with.
class CurveFitForm : public QWidget {
    Q_OBJECT

public:
    explicit CurveFitForm(QWidget* parent = nullptr);

    [[nodiscard]] CycleFitOptions options() const;

Q_SIGNALS:
    /// options() are other ones.
    void changed();

private:
    void addTip(QGridLayout& grid);
    void addModel(QGridLayout& grid);
    void addLever(QGridLayout& grid);
    void addSteps(QGridLayout& grid);
    void connectParts();
    /// Enables what goes with the rest.
    void showPossible();
    [[nodiscard]] std::optional<TipForm> tip() const;
    [[nodiscard]] SampleLaw law() const;

    QComboBox* tip_;
    NumberBox* radius_;  ///< [nm]
    NumberBox* angle_;   ///< [degree]
    NumberBox* poisson_;
    NumberBox* film_;  ///< [nm]; 0: a half-space
    QComboBox* law_;
    QComboBox* works_;
    QCheckBox* relaxation_;
    QCheckBox* drag_;
    QComboBox* branch_;
    QComboBox* contact_;
    QComboBox* lever_;
    NumberBox* stiffness_;  ///< [N/m]; 0: the file's
    NumberBox* invols_;     ///< [nm/V]; 0: the file's
    std::array<QCheckBox*, 4> steps_;
};

}  // namespace asperity
