#include "ui/widgets/ReadingBudget.h"

#include "core/scene/Scene.h"
#include "core/words/BudgetWords.h"

#include <QStringList>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace asperity {

Budget shownForce(const Scene* scene, double force, double sigma) noexcept {
    return scene != nullptr ? forceBudget(scene->description.uncertainty, force, sigma)
                            : Budget{.value = force, .noise = sigma};
}

QString namedBudget(const QString& name, const Budget& budget, const char* unit) {
    return name + QStringLiteral(": ") + QString::fromStdString(budgetText(budget, unit));
}

QString contactDetails(const Scene& scene, const TickOutput& output) {
    const ContactState& contact = output.model.contact;
    if (!(contact.indentation > 0.0) || !(output.model.normalForce > 0.0)) {
        return {};
    }
    const LandmarkBudgets budgets = budgetsAt(scene, output.model, output.model.normalForce);
    QStringList lines;
    const auto add = [&](Landmark landmark, double value) {
        const Budget& ofLaw = budgetOf(budgets, landmark);
        if (std::isfinite(ofLaw.value)) {
            const LandmarkRow& row = *rowOf(landmark);
            lines << namedBudget(QString::fromUtf8(row.name), ofLaw.of(value, 0.0), row.unit);
        }
    };
    add(Landmark::Indentation, contact.indentation);
    add(Landmark::ContactRadius, contact.contactRadius);
    add(Landmark::Stiffness, contact.stiffness);
    return lines.join(QLatin1Char('\n'));
}

QString budgetedReading(const std::vector<CycleBudget>& budgets, const char* key,
                        const QString& otherwise) {
    const auto found = std::ranges::find(budgets, std::string_view(key), &CycleBudget::key);
    return found == budgets.end() ? otherwise
                                  : QString::fromStdString(budgetText(found->budget, found->unit));
}

}  // namespace asperity
