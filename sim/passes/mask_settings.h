#pragma once
#include <string>
#include <vector>

namespace talus {

/// What a mask is made of: height (m), slope (degrees), curvature (1/km: crests positive, hollows negative),
/// depth of water (m), itself (to invert it), everything.
enum class MaskSource { height = 0, slope, curvature, depth, itself, everything };
const std::vector<std::string>& mask_source_names();
/// How it meets what is painted: takes its place, adds to it, keeps what both have, takes it away.
enum class MaskJoin { replace = 0, add, intersect, subtract };
const std::vector<std::string>& mask_join_names();

/// The mask is 1 from `low` to `high` and falls to 0 over `fade` beyond each.
struct MaskSettings {
    MaskSource source = MaskSource::slope;
    double low = 0;
    double high = 0;
    double fade = 0;
    MaskJoin join = MaskJoin::replace;
    bool inverted = false;
    bool operator==(const MaskSettings&) const = default;
};
/// Throws talus::Error that names the field when no mask can be made so.
void check_mask(const MaskSettings& settings);

}  // namespace talus
