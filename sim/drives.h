#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "sim/parameters.h"
#include "sim/terrain/terrain_state.h"

namespace talus {

/// Parameters that follow a table against simulated time, one drive each. In a tick a driven parameter has
/// its table's mean over that tick. Passes read some tables within the tick (`Driven::within_tick`): there
/// every sub-step has what the table says of it.

/// The table that the parameter follows; null: it follows none.
const TimeSeries* series_of(const std::vector<Drive>& drives, std::string_view parameter);

/// Sets it among the drives, in place of one of the same parameter; an empty table takes that away.
void place_drive(std::vector<Drive>& drives, const Drive& drive);

/// Whether the parameter is a number that ticks read, and may be another in each.
bool can_be_driven(const Parameter& parameter);

/// Throws talus::Error where its parameter is not a number that ticks read, or a value lies outside of what
/// the parameter allows.
void check_drive(const Parameters& parameters, const Drive& drive);

/// A table as text, its times and values with spaces between; and back. Throws talus::Error where it is none.
std::string to_text(const TimeSeries& series);
TimeSeries series_from_text(const std::string& text);

}  // namespace talus
