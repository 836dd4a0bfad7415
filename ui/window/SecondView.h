#pragma once

#include "core/EnumTable.h"
#include "core/deformation/HalfSpaceAnswer.h"
#include "core/deformation/SurfaceField.h"
#include "core/haptics/Snapshot.h"
#include "ui/SurfaceLook.h"
#include "ui/view/SurfaceReading.h"
#include "ui/view/ViewOptions.h"

#include <QWidget>

#include <memory>
#include <optional>

class QComboBox;
class QHBoxLayout;
class QStackedWidget;

namespace asperity {

class ContactPlot;
class NumberBox;
struct Scene;
class ViewBars;
class ViewOptionsMenu;
class ZoomView;

/// What the second view shows.
enum class SecondContent : std::uint8_t { Space, Section };

template <>
inline constexpr auto kEnumTable<SecondContent> = std::to_array<EnumRow<SecondContent>>(
    {{SecondContent::Space, "space", "3-D view"},
     {SecondContent::Section, "section", "Section through the contact"}});

/// How the second view is set; kept from one session to the next.
struct SecondViewSettings {
    SecondContent content = SecondContent::Section;
    ViewOptions options;        ///< of the 3-D view
    double azimuth = 0.0;       ///< of the section, from x [degree]
    double heightFactor = 1.0;  ///< of the section; 0: as large as heights fit
};

/// A view beside the large one, with a direction, options and zoom of its own: in 3-D, or a section
/// through the contact. While it is hidden it draws nothing and holds no meshes.
class SecondView : public QWidget {
    Q_OBJECT

public:
    explicit SecondView(QWidget* parent = nullptr);

    /// Null: nothing to show. The scene outlives its use here.
    void setScene(const Scene* scene);
    /// How the surface is colored. @param field what the look's quantity is on the surface at rest
    void setLook(const SurfaceLook& look, const SurfaceField& field);
    void setHalfSpace(const std::shared_ptr<const HalfSpaceAnswer>& answer);
    /// Draws a frame of the present scene, unless hidden.
    void showSnapshot(const Snapshot& snapshot);
    /// See ZoomPicture: from the next snapshot on.
    void setWrittenForce(const std::string& force);
    void showCrossHair(const std::optional<Vector2>& place,
                       const std::optional<SurfaceReading>& reading);

    [[nodiscard]] SecondViewSettings settings() const;
    void setSettings(const SecondViewSettings& settings);
    [[nodiscard]] ZoomView& space() { return *space_; }
    [[nodiscard]] ContactPlot& section() { return *section_; }
    /// Those of the 3-D view: its range is that of its own frame.
    [[nodiscard]] const ViewBars& bars() const { return *bars_; }

Q_SIGNALS:
    /// The pointer is over this place of the surface at rest, world x, y [m].
    void placeHovered(double x, double y);
    void placeLeft();

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void addContents();
    void addSpaceControls(QHBoxLayout& row);
    void addSectionControls(QHBoxLayout& row);
    [[nodiscard]] SecondContent content() const;
    void showContent();
    void chooseDirection();
    void useScene(bool visible);

    const Scene* scene_ = nullptr;
    ZoomView* space_;
    ContactPlot* section_;
    ViewBars* bars_;
    QStackedWidget* stack_;
    QComboBox* contents_;
    QWidget* spaceControls_;
    QWidget* sectionControls_;
    ViewOptionsMenu* options_ = nullptr;
    NumberBox* direction_;
    QComboBox* heights_;
};

}  // namespace asperity
