#pragma once
#include <optional>
#include <string>
#include <vector>

#include "sim/operation.h"
#include "sim/parameters.h"
#include "sim/terrain/grid.h"

namespace talus::app {

/// One control of erosion in an artist's words. Its position is that of its first parameter between two
/// values, on a logarithmic scale; the other parameters change by the same factor.
struct ErosionControl {
    std::string name;
    std::string low;   ///< what position 0 is
    std::string high;  ///< what position 1 is
    std::string help;
    std::vector<std::string> parameters;
    double from = 0;  ///< of the first one
    double to = 1;
};
/// Strength, age, scale of valleys, sediment.
const std::vector<ErosionControl>& erosion_controls();
/// Where it stands, from 0 to 1.
double position_of(const ErosionControl& control, const Parameters& parameters);
/// What is to be set for it to stand there.
std::vector<SetParameter> moved_to(const ErosionControl& control, double position,
                                   const Parameters& parameters);

/// Settings by a word: a climate, or a rock.
struct ErosionPreset {
    std::string name;
    std::string help;
    std::vector<std::string> assignments;
};
/// Storms: rain, what of it seeps away, and frost that loosens rock. They are ten times as heavy as in
/// nature, for their work to be seen while one plays.
const std::vector<ErosionPreset>& climates();
/// How easily it erodes, how steep it stands, and what its debris is like. Erodibilities keep the order of
/// what was measured (Sklar & Dietrich 2001, rock; Hanson & Simon 2001, soil), for a storm's work to be seen.
const std::vector<ErosionPreset>& rocks();
/// What is to be set for it to hold. For a climate water erodes then; what nobody set of erosion, and the
/// length of ticks, get values with which one sees it.
std::vector<SetParameter> settings_of(const ErosionPreset& preset, const Parameters& parameters,
                                      const Grid& grid);
/// The one whose assignments all hold; null: none.
const ErosionPreset* present_of(const std::vector<ErosionPreset>& presets, const Parameters& parameters);

/// Why water erodes nothing now, in a sentence; empty: it does, or erosion is off. `is_wet`: there is water,
/// or springs and painted rain bring some. `is_painted`: there is a layer of what was painted, the mask's
/// too.
std::string why_nothing_erodes(const Parameters& parameters, bool is_wet, bool is_painted);

}  // namespace talus::app
