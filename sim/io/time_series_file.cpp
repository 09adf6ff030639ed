#include "sim/io/time_series_file.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "sim/error.h"

namespace talus::io {
namespace {

constexpr std::size_t most_bytes = 64U << 20U;
constexpr std::size_t most_rows = 1000000;

bool separates(char c) {
    return c == ',' || c == ';' || c == ' ' || c == '\t';
}

// Cells of a row. White space around a comma or semicolon is none of its own.
std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    bool open = false;    // a cell is being read
    bool marked = false;  // since the last cell a comma or semicolon came
    for (const char c : line) {
        if (!separates(c)) {
            if (!open) cells.emplace_back();
            cells.back() += c;
            open = true;
            marked = false;
            continue;
        }
        open = false;
        if (c != ',' && c != ';') continue;
        if (marked || cells.empty()) cells.emplace_back();
        marked = true;
    }
    return cells;
}

std::optional<double> number_in(std::string cell) {
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
    if (cell.size() >= 2 && cell.front() == '+' && cell[1] != '-') cell.erase(0, 1);
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

// Words alone: no row of numbers that has a slip in it.
bool is_heading(const std::vector<std::string>& cells) {
    for (const std::string& cell : cells)
        if (number_in(cell)) return false;
    return true;
}

// A line as a message may show it.
std::string shown_of(const std::string& line) {
    constexpr std::size_t most = 60;
    std::string shown = line.substr(0, most);
    for (char& c : shown)
        if (static_cast<unsigned char>(c) < ' ') c = ' ';
    if (line.size() <= most) return shown;
    // A letter is its first byte and those that follow it: one that was cut goes.
    const auto follows = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
    if (follows(line[most])) {
        while (!shown.empty() && follows(shown.back())) shown.pop_back();
        if (!shown.empty()) shown.pop_back();
    }
    return shown + "…";
}

// Of a pipe too, whose size nobody knows before.
std::string read_bounded(const std::filesystem::path& path) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        throw Error(fmt::format("'{}' is a folder, a table of times and values is needed", path.string()));
    std::ifstream file(path, std::ios::binary);
    if (!file)
        throw Error(fmt::format("'{}' cannot be read, a table of times and values is needed", path.string()));
    std::string text;
    std::vector<char> chunk(1U << 16U);
    do {
        file.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
        text.append(chunk.data(), static_cast<std::size_t>(file.gcount()));
        if (text.size() > most_bytes)
            throw Error(
                fmt::format("'{}' is larger than {} MiB, the most that a table of times and values may be",
                            path.string(), most_bytes >> 20U));
    } while (file);
    if (text.find('\0') != std::string::npos)
        throw Error(fmt::format("'{}' is no text, a table of times and values is needed", path.string()));
    return text;
}

}  // namespace

TimeSeries read_time_series(const std::filesystem::path& path) {
    std::istringstream lines(read_bounded(path));
    std::vector<TimeSeries::Row> rows;
    std::string line;
    bool first = true;
    for (int at = 1; std::getline(lines, line); ++at) {
        if (at == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ' || line.back() == '\t'))
            line.pop_back();
        const std::vector<std::string> cells = cells_of(line);
        if (cells.empty() || cells.front().starts_with('#')) continue;
        const bool heading = first && is_heading(cells);
        first = false;
        if (heading) continue;
        const std::optional<double> time_s = number_in(cells.front());
        const std::optional<double> value = cells.size() == 2 ? number_in(cells.back()) : std::nullopt;
        if (!time_s || !value)
            throw Error(
                fmt::format("'{}': line {} is '{}', it must be a time in seconds and a value, e.g. 600,12.5",
                            path.string(), at, shown_of(line)));
        if (!rows.empty() && *time_s < rows.back().time_s)
            throw Error(fmt::format("'{}': line {} is of {} s and comes after {} s, times must not fall",
                                    path.string(), at, *time_s, rows.back().time_s));
        if (std::abs(*time_s) > 1e15 || std::abs(*value) > 1e15)
            throw Error(fmt::format("'{}': line {} is '{}', no number may be above 1e15", path.string(), at,
                                    shown_of(line)));
        if (rows.size() == most_rows)
            throw Error(
                fmt::format("'{}' has more than {} rows, the most that a table of times and values may have",
                            path.string(), most_rows));
        rows.push_back({*time_s, *value});
    }
    if (rows.empty())
        throw Error(fmt::format("'{}' holds no row of a time in seconds and a value", path.string()));
    return TimeSeries(std::move(rows));
}

}  // namespace talus::io
