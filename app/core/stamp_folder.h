#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace talus::app {

/// A person's own stamps: heightmaps in the folder `stamps` of what Talus keeps for him.
class StampFolder {
  public:
    static std::filesystem::path path();
    /// Looks again where that was a while ago, and makes the folder where there is none. Once a frame, while
    /// somebody looks.
    void follow();
    /// Names of files, sorted.
    const std::vector<std::string>& files() const { return files_; }

  private:
    std::vector<std::string> files_;
    double looked_at_s_ = -1e9;
};

}  // namespace talus::app
