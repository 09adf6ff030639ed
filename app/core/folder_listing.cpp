#include "app/core/folder_listing.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "sim/io/endings.h"

namespace talus::app {
namespace {

namespace fs = std::filesystem;

bool is_digit(char letter) {
    return std::isdigit(static_cast<unsigned char>(letter)) != 0;
}

// The digits from a place on, without zeros before them; the place goes behind them.
std::string digits_at(const std::string& text, std::size_t& at) {
    const std::size_t begin = at;
    while (at < text.size() && is_digit(text[at])) ++at;
    const std::string digits = text.substr(begin, at - begin);
    const auto first = digits.find_first_not_of('0');
    return first == std::string::npos ? "0" : digits.substr(first);
}

bool stands_before(const std::string& a, const std::string& b) {
    std::size_t i = 0;
    std::size_t k = 0;
    while (i < a.size() && k < b.size()) {
        if (is_digit(a[i]) && is_digit(b[k])) {
            const std::string x = digits_at(a, i);
            const std::string y = digits_at(b, k);
            if (x != y) return x.size() != y.size() ? x.size() < y.size() : x < y;
            continue;
        }
        const int x = std::tolower(static_cast<unsigned char>(a[i++]));
        const int y = std::tolower(static_cast<unsigned char>(b[k++]));
        if (x != y) return x < y;
    }
    if (i == a.size() && k == b.size()) return a < b;
    return i == a.size();
}

}  // namespace

std::vector<FolderEntry> entries_of(const std::string& folder) {
    std::vector<FolderEntry> entries;
    std::error_code failed;
    for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
        FolderEntry entry;
        entry.name = at->path().filename().string();
        if (entry.name.starts_with(".")) continue;
        entry.ending = io::ending_of(entry.name);
        // What one of them does not say stays out of the list, and the others in it.
        std::error_code ignored;
        entry.is_folder = at->is_directory(ignored);
        if (!entry.is_folder) entry.bytes = at->file_size(ignored);
        if (ignored) entry.bytes = 0;
        const fs::file_time_type changed = at->last_write_time(ignored);
        if (!ignored)
            entry.changed = std::chrono::time_point_cast<std::chrono::system_clock::duration>(
                fs::file_time_type::clock::to_sys(changed));
        entries.push_back(std::move(entry));
    }
    return entries;
}

void sort_entries(std::vector<FolderEntry>& entries, ListedBy by, bool descending) {
    std::sort(entries.begin(), entries.end(), [&](const FolderEntry& one, const FolderEntry& other) {
        if (one.is_folder != other.is_folder) return one.is_folder;
        const FolderEntry& a = descending ? other : one;
        const FolderEntry& b = descending ? one : other;
        if (by == ListedBy::size && a.bytes != b.bytes) return a.bytes < b.bytes;
        if (by == ListedBy::changed && a.changed != b.changed) return a.changed < b.changed;
        return stands_before(a.name, b.name);
    });
}

std::string size_text(std::uintmax_t bytes) {
    if (bytes < 1000) return fmt::format("{} B", bytes);
    constexpr std::array<const char*, 4> units = {"kB", "MB", "GB", "TB"};
    auto size = static_cast<double>(bytes) / 1000;
    std::size_t unit = 0;
    while (size >= 999.5 && unit + 1 < units.size()) {
        size /= 1000;
        ++unit;
    }
    return size < 9.95 ? fmt::format("{:.1f} {}", size, units.at(unit))
                       : fmt::format("{:.0f} {}", size, units.at(unit));
}

std::string time_text(std::chrono::system_clock::time_point time) {
    if (time == std::chrono::system_clock::time_point()) return "–";
    return fmt::format("{:%Y-%m-%d %H:%M}", fmt::localtime(std::chrono::system_clock::to_time_t(time)));
}

}  // namespace talus::app
