#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <utility>

#include "app/core/map_mark.h"
#include "app/core/session.h"
#include "app/window/camera_control.h"
#include "app/window/ground_probe.h"
#include "sim/gpu/readback.h"

struct GLFWwindow;

namespace talus::app {

/// What the panels leave to the hand in a frame.
struct HandMay {
    bool use_mouse = true;
    bool use_keys = true;
};

/// A place on the ground that was clicked for what is to stand there.
struct PlacedMark {
    MarkKind kind;
    glm::dvec3 place_m;
};

/// What the hand has done in a frame that others take up.
struct HandDone {
    std::optional<DrawnDrag> drawn{};    ///< a line or a rectangle was drawn
    std::optional<PlacedMark> placed{};  ///< something was placed
    std::optional<MovedMark> moved{};    ///< something was dragged, and let go there
};

/// What the next click or drag is for, until it is done; else it is the brush's.
struct HandErrand {
    std::optional<MarkKind>& placing;
    std::optional<MapDrag>& drawing;      ///< from where a drag begins to where it ends
    bool drawing_path;                    ///< clicks put points, drags move them
    bool& choosing_part;                  ///< over tiles
    std::optional<MarkUnderMouse> under;  ///< what a drag that begins now moves
    HandDone& done;
};

/// A person's hand over the terrain: where the mouse's ray meets the ground, strokes of the brush, and the
/// camera's ways.
class Hand {
  public:
    explicit Hand(GLFWwindow* window) : window_(window) {}

    /// Moves the camera and makes the stroke of `passed_s` seconds; the mouse is in pixels of a picture of
    /// this size.
    void act(Session& session, glm::dvec2 mouse, double passed_s, glm::ivec2 size, const HandMay& may,
             const HandErrand& errand);
    /// After a picture was drawn: asks where the mouse's ray meets it. `drawn`: the picture's size,
    /// `changed`: whether it is another one than before.
    void look(Session& session, glm::dvec2 mouse, glm::ivec2 size, glm::ivec2 drawn, bool changed);
    void turn_wheel(double steps) { wheel_ += steps; }
    /// Where the mouse is on the ground; none: beside it.
    const std::optional<glm::dvec3>& cursor() const { return cursor_; }
    /// What a drag is drawing.
    const std::optional<DrawnDrag>& drawn() const { return drawn_; }
    /// What is being dragged, and where it is.
    const std::optional<MovedMark>& held_mark() const { return held_mark_; }
    /// True while a read-back that it asked for is on its way.
    bool waits() const { return cursor_readback_.pending() || ground_.pending(); }
    bool camera_moved() const { return camera_moved_; }
    /// Whether camera or brush moved something within the last quarter of a second.
    bool moving() const { return moving_s_ > 0; }

  private:
    void read_cursor(const Session& session);
    void move_camera(Session& session, glm::dvec2 mouse, double passed_s, glm::ivec2 size,
                     const HandMay& may);
    void look_over(Session& session, render::Camera& camera, glm::dvec2 drag, double passed_s, int height,
                   const HandMay& may);
    bool follow_mode(Session& session, render::Camera& camera, glm::ivec2 size);
    void meet_ground(Session& session, render::Camera& camera, bool walking, double passed_s);
    void sculpt(Session& session, double passed_s, const HandMay& may, const HandErrand& errand);
    std::optional<glm::dvec3> stroke_place(const Session& session) const;
    void draw_path(Session& session, bool held, bool presses);
    void place_mark(const HandErrand& errand, bool held, bool down);
    void follow_drag(const HandErrand& errand, bool held, bool presses);
    void choose_part(Session& session, const HandMay& may, bool& choosing_part);
    void follow_terrain(const Session& session);

    GLFWwindow* window_;
    int terrain_number_ = 0;
    GroundProbe ground_;
    std::optional<double> last_ground_m_;  // over tiles
    gpu::Readback cursor_readback_;
    glm::dvec2 cursor_mouse_{-1};  // where the last read-back began
    PixelRay cursor_ray_;
    std::optional<glm::dvec3> seen_;  // where the mouse's ray met ground, around the terrain too
    std::optional<glm::dvec3> cursor_;
    glm::dvec2 mouse_{0};
    glm::dvec2 stroke_mouse_{0};  // where a stroke began
    glm::dvec3 pivot_{0};
    bool turning_ = false;
    bool walking_ = false;
    std::optional<render::Camera> before_top_;  // the camera before it looked straight down
    glm::dvec2 top_middle_{0};                  // what that looked at first, m
    double wheel_ = 0;
    double moving_s_ = 0;
    bool camera_moved_ = false;
    std::optional<glm::dvec2> part_from_m_;     // where the drag began that chooses a part
    std::optional<std::size_t> path_point_;     // that is held
    std::optional<MarkUnderMouse> pressed_on_;  // what was under the mouse when the button went down
    std::optional<MovedMark> held_mark_;        // what is dragged
    glm::dvec2 mark_mouse_{0};                  // where it was pressed
    glm::dvec2 to_foot_px_{0};                  // from there to its foot
    bool dragged_ = false;                      // and not only clicked
    int frames_held_ = 0;                       // of the left button
    std::optional<DrawnDrag> drawn_;            // from where a drag began to where it was last over ground
    bool placed_ = false;                       // by the press that is held: it is no stroke
};

}  // namespace talus::app
