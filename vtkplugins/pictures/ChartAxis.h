#pragma once

#include <span>
#include <string>
#include <vector>

namespace asperity {

/// How values lie along an axis of a chart: unit prefix, logarithm, range and ticks.
class ChartAxis {
public:
    struct Request {
        std::string label;
        std::string unit;
        bool logarithmic = false;
        int mostTicks = 8;
        std::vector<std::string> names = {};  ///< of the values 0, 1, ...: ticks are these
    };

    /// Fits the axis to all values that it can show.
    ChartAxis(const Request& request, std::span<const double> values);

    /// Where a value lies on the axis, in the axis's own numbers; NaN when it has no place there.
    [[nodiscard]] double place(double value) const;

    [[nodiscard]] const std::string& title() const { return title_; }
    [[nodiscard]] double low() const { return low_; }
    [[nodiscard]] double high() const { return high_; }
    [[nodiscard]] const std::vector<double>& ticks() const { return ticks_; }
    [[nodiscard]] const std::vector<std::string>& labels() const { return labels_; }

private:
    void setNames(const std::vector<std::string>& names);
    void setLinearTicks(int most);
    void setDecades(int most);

    bool logarithmic_;
    double factor_ = 1.0;
    std::string title_;
    double low_ = 0.0;
    double high_ = 1.0;
    std::vector<double> ticks_;  ///< in the axis's own numbers
    std::vector<std::string> labels_;
};

}  // namespace asperity
