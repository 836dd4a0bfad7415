#pragma once

#include <QWidget>

class QSplitter;
class QStackedLayout;
class QVBoxLayout;

namespace asperity {

class EngageBar;
class LoadingBar;
class SecondView;
class StateBanner;
class ViewBars;
class ZoomView;

/// The large view with what belongs to it: above it the banner and Engage, below it the color bars
/// and a line with a hint, or with what is being loaded.
class ViewSide : public QWidget {
public:
    struct Parts {
        StateBanner* banner;
        EngageBar* engage;
        ZoomView* view;
        SecondView* second;  ///< beside it, hidden at first
        LoadingBar* loading;
    };

    explicit ViewSide(const Parts& parts, QWidget* parent = nullptr);

    /// Of the views beside one another.
    [[nodiscard]] QSplitter& views() { return *views_; }
    [[nodiscard]] StateBanner& banner() const { return *parts_.banner; }
    [[nodiscard]] QVBoxLayout& column() { return *column_; }
    [[nodiscard]] const ViewBars& bars() const { return *bars_; }
    void setHint(const QString& hint);
    /// Whether the last line shows the loading, in place of the hint.
    void setLoading(bool loading);

private:
    void addBottomLine();

    Parts parts_;
    QVBoxLayout* column_;
    QSplitter* views_;
    ViewBars* bars_;
    QStackedLayout* bottomLine_ = nullptr;  ///< hint, loading
};

}  // namespace asperity
