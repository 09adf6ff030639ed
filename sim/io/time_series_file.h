#pragma once
#include <filesystem>

#include "sim/terrain/time_series.h"

namespace talus::io {

/// Reads a table against time: rows of time (s) and value with a comma, a semicolon or white space between,
/// as spreadsheets write them. A first row of words is a heading; empty rows and rows that begin with # are
/// left out. Throws talus::Error that names the file and the line where a row is something else, or its time
/// comes before that of the row above.
TimeSeries read_time_series(const std::filesystem::path& path);

}  // namespace talus::io
