#include "app/reports/ExtremesMap.h"

#include "core/FormattedText.h"
#include "core/SiFormat.h"
#include "core/contact/laws/ContactLaw.h"

#include <algorithm>
#include <set>

namespace asperity {

namespace {

/// Told apart with any color vision. Source: Okabe and Ito (2008).
std::vector<ShareKey> extremesKeys() {
    return {{{0, 158, 115}, "exact: within 0.1 % of the reference"},
            {{86, 180, 233}, "valid: within 5 %"},
            {{213, 94, 0}, "inaccurate: error above 5 %, not flagged"},
            {{240, 228, 66}, "flagged: not valid, with a flag"},
            {{204, 121, 167}, "unproven: the reference is not valid there"},
            {{110, 110, 110}, "refused, with a reason"}};
}

/// What one map shows.
struct MapChoice {
    std::string model;
    std::string setting;  ///< empty: all
    std::string sample;
    double RegionPlace::*row = &RegionPlace::modulus;
    std::string (*rowName)(double) = [](double modulus) { return formatSi(modulus, "Pa"); };

    [[nodiscard]] bool has(const RegionPlace& place) const {
        return place.model == model && (setting.empty() || place.setting == setting) &&
               place.sample == sample;
    }
};

/// All values of a coordinate, smallest first.
std::vector<double> valuesOf(const std::vector<ExtremesRegion>& regions, const MapChoice& choice,
                             double RegionPlace::*coordinate) {
    std::set<double> values;
    for (const ExtremesRegion& region : regions) {
        if (choice.has(region.place())) {
            values.insert(region.place().*coordinate);
        }
    }
    return {values.begin(), values.end()};
}

std::size_t indexOf(const std::vector<double>& values, double value) {
    return static_cast<std::size_t>(std::lower_bound(values.begin(), values.end(), value) -
                                    values.begin());
}

ShareMap mapOf(const std::vector<ExtremesRegion>& regions, const MapChoice& choice) {
    const std::vector<double> columns = valuesOf(regions, choice, &RegionPlace::tipRadius);
    const std::vector<double> rows = valuesOf(regions, choice, choice.row);
    ShareMap map{.title = choice.model, .xLabel = "tip radius", .yLabel = "reduced modulus E*"};
    for (const double radius : columns) {
        map.columns.push_back(formatSi(radius, "m"));
    }
    for (const double row : rows) {
        map.rows.push_back(choice.rowName(row));
    }
    map.cells.assign(rows.size() * columns.size(),
                     std::vector<double>(kValues<Verdict>.size(), 0.0));
    for (const ExtremesRegion& region : regions) {
        const RegionPlace& place = region.place();
        if (!choice.has(place)) {
            continue;
        }
        auto& cell = map.cells[indexOf(rows, place.*choice.row) * columns.size() +
                               indexOf(columns, place.tipRadius)];
        for (std::size_t i = 0; i < kValues<Verdict>.size(); ++i) {
            cell[i] += static_cast<double>(region.tally(kValues<Verdict>[i]).states);
        }
    }
    return map;
}

ShareMap lawMap(const std::vector<ExtremesRegion>& regions, ContactLaw law) {
    const bool film = isFilm(law);
    ShareMap map =
        mapOf(regions, {.model = keyOf(law), .setting = "", .sample = film ? "film" : "adhesive"});
    map.title = nameOf(law);
    return map;
}

std::string percentOf(double share) { return formatted("%.3g %%", 100.0 * share); }

ShareMap tickMap(const std::vector<ExtremesRegion>& regions) {
    ShareMap map = mapOf(regions, {.model = "tick",
                                   .setting = "certified",
                                   .sample = "rough",
                                   .row = &RegionPlace::roughness,
                                   .rowName = percentOf});
    map.title = "Whole tick, auto law";
    map.yLabel = "rms height over tip radius";
    return map;
}

}  // namespace

ShareMapPage extremesMap(const std::vector<ExtremesRegion>& regions) {
    constexpr int kMapsPerRow = 6;
    ShareMapPage page{.title = "Validity of each contact law: adhesive samples (Hertz on a film: "
                               "films without adhesion), every lever and depth; Maugis-Dugdale on "
                               "the sphere, Hertz on a film and the tick are their own reference",
                      .keys = extremesKeys(),
                      .mapsPerRow = kMapsPerRow};
    for (const ContactLaw law : kValues<ContactLaw>) {
        page.maps.push_back(lawMap(regions, law));
    }
    page.maps.push_back(tickMap(regions));
    return page;
}

}  // namespace asperity
