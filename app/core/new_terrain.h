#pragma once
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "app/core/scene.h"
#include "sim/gpu/texture.h"

namespace talus::app {

/// A terrain that is to be generated: what it is to be, and a small picture of it that follows.
class NewTerrain {
  public:
    NewTerrain();

    bool is_shown() const { return shown_; }
    /// With what was wished for the last time.
    void begin() { shown_ = true; }
    void end() { shown_ = false; }

    const Parameters& wishes() const { return wishes_; }
    /// Throws talus::Error where it cannot be, as Parameters does.
    void set(const std::string& name, const Value& value);
    /// Back to the default. The sea's level is that of a coast or of an island then, where the terrain is
    /// one.
    void unset(const std::string& name);
    /// Names of the wishes that make a difference as the others stand.
    std::vector<std::string> heeded() const;
    /// Why it cannot be generated; empty: it can.
    std::string refusal() const;

    /// Once a frame: draws the picture anew, on a thread, where wishes have changed. True: it is another one.
    bool follow();
    /// True while one is being drawn that is to be shown.
    bool waits() const { return shown_ && drawing_.valid(); }
    const gpu::Texture& picture() const { return picture_; }

    /// What opens it: the settings of the preset blank, with these wishes.
    SceneRequest request() const;

  private:
    struct Drawn {
        std::vector<std::uint8_t> rgba;
        glm::ivec2 size{0};
        std::string failure{};  ///< why there is none
    };
    static Drawn drawn(const Parameters& wishes);
    void suggest_sea();

    bool shown_ = false;
    Parameters wishes_;
    std::optional<Parameters> drawn_wishes_;
    std::future<Drawn> drawing_;
    std::string failure_;
    gpu::Texture picture_;
};

}  // namespace talus::app
