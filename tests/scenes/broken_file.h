#pragma once
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace talus::scenes {

/// A TIFF whose samples are zeros, in place, until it is mended: what stands at its two ends stays.
class BrokenFile {
  public:
    explicit BrokenFile(const std::filesystem::path& path) : path_(path) {
        std::ifstream file(path, std::ios::binary);
        whole_.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
        std::string torn = whole_;
        const std::size_t end = torn.size() / 8;
        std::fill(torn.begin() + static_cast<std::ptrdiff_t>(end), torn.end(), '\0');
        write(torn);
    }
    void mend() { write(whole_); }

  private:
    // Whoever has it open sees it.
    void write(const std::string& content) const {
        std::fstream(path_, std::ios::binary | std::ios::in | std::ios::out) << content;
    }

    std::filesystem::path path_;
    std::string whole_;
};

}  // namespace talus::scenes
