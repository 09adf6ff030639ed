#include "app/window/hand.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/core/part.h"
#include "render/overview.h"

namespace talus::app {
namespace {

// Whether a point is between edges and not on them.
bool is_within(glm::dvec3 point, const Rectangle& edges, const Grid& grid) {
    const double x_m = 1e-3 * grid.dx;
    const double y_m = 1e-3 * grid.dy;
    return point.x > edges.west_m + x_m && point.y > edges.south_m + y_m && point.x < edges.east_m - x_m &&
           point.y < edges.north_m - y_m;
}

}  // namespace

void Hand::act(Session& session, glm::dvec2 mouse, double passed_s, glm::ivec2 size, const HandMay& may,
               const HandErrand& errand) {
    moving_s_ = std::max(0.0, moving_s_ - passed_s);
    follow_terrain(session);
    read_cursor(session);
    move_camera(session, mouse, passed_s, size, may);
    mouse_ = mouse;
    if (session.overflight())
        choose_part(session, may, errand.choosing_part);
    else
        sculpt(session, passed_s, may, errand);
}

// What was read of another terrain is not of this one.
void Hand::follow_terrain(const Session& session) {
    if (terrain_number_ == session.terrain_number()) return;
    terrain_number_ = session.terrain_number();
    ground_.forget();
    last_ground_m_.reset();
    drawn_.reset();
    before_top_.reset();
    path_point_.reset();
    held_mark_.reset();
    cursor_readback_.cancel();
    cursor_.reset();
    seen_.reset();
    cursor_mouse_ = glm::dvec2(-1);
}

// Where the mouse's ray met the ground when it was last read.
void Hand::read_cursor(const Session& session) {
    const auto texels = cursor_readback_.poll();
    if (!texels) return;
    const float distance = (*texels)[0];
    cursor_.reset();
    seen_.reset();
    if (!std::isfinite(distance)) return;
    const glm::dvec3 point = cursor_ray_.start + cursor_ray_.direction * static_cast<double>(distance);
    // Sides where all ground ends are none, and around the terrain there is nothing to sculpt.
    const Grid& grid = session.grid();
    if (is_within(point, session.ground_edges(), grid)) seen_ = point;
    if (is_within(point, {0, 0, grid.width_m(), grid.height_m()}, grid)) cursor_ = point;
}

void Hand::look(Session& session, glm::dvec2 mouse, glm::ivec2 size, glm::ivec2 drawn, bool changed) {
    if (held_mark_) mouse += to_foot_px_;
    // If neither picture nor mouse has changed, the last read-back holds.
    if (!changed && mouse == cursor_mouse_) return;
    if (cursor_readback_.pending()) {
        // The picture has changed since: again, when it has come.
        cursor_mouse_ = glm::dvec2(-1);
        return;
    }
    if (mouse.x < 0 || mouse.y < 0 || mouse.x >= size.x || mouse.y >= size.y) return;
    const int x = std::clamp(static_cast<int>(mouse.x * drawn.x / size.x), 0, drawn.x - 1);
    const int y = std::clamp(static_cast<int>(mouse.y * drawn.y / size.y), 0, drawn.y - 1);
    cursor_mouse_ = mouse;
    cursor_ray_ = pixel_ray(session.camera(), x + 0.5, y + 0.5, drawn.x, drawn.y);
    cursor_readback_.start(session.hits(), {x, drawn.y - 1 - y, 1, 1});
}

// Whether the view is the one from the top, as its parameter says: the camera follows that.
bool Hand::follow_mode(Session& session, render::Camera& camera, glm::ivec2 size) {
    const std::string& mode = session.view().choice("camera.mode");
    const bool from_top = mode == "top";
    glm::dvec2 heights_m = glm::max(session.bounds(), session.heights_m());
    // What stands around may be higher.
    if (const Surroundings* around = session.surroundings())
        heights_m.y = std::max(heights_m.y, around->backdrop().range_m().y);
    if (from_top && !camera.is_parallel()) {
        before_top_ = camera;
        // Who walks stays where he is.
        const glm::dvec3 ground = walking_ ? camera.eye : seen_.value_or(camera.target);
        look_from_top(camera, session.grid(), heights_m.y, static_cast<double>(size.x) / size.y, ground);
        top_middle_ = glm::dvec2(camera.eye);
    }
    if (!from_top && camera.is_parallel()) {
        // A map that was not shifted leads back to where one was. Who walks comes down from over all ground.
        const bool walks = mode == "walk";
        const glm::dvec3 ahead(0.38, 0.80, -0.60);
        if (before_top_ && top_middle_ == glm::dvec2(camera.eye))
            camera = *before_top_;
        else
            leave_top(camera, glm::normalize(before_top_ ? before_top_->target - before_top_->eye : ahead),
                      walks   ? heights_m.y
                      : seen_ ? seen_->z
                              : heights_m.x,
                      walks);
    }
    if (from_top) keep_over(camera, session.grid(), heights_m.y);
    return from_top;
}

// All that moves the view from the top shifts it, but the wheel, Q and E.
void Hand::look_over(Session& session, render::Camera& camera, glm::dvec2 drag, double passed_s, int height,
                     const HandMay& may) {
    const auto held = [&](int button) { return glfwGetMouseButton(window_, button) == GLFW_PRESS; };
    if (may.use_mouse && (held(GLFW_MOUSE_BUTTON_RIGHT) || held(GLFW_MOUSE_BUTTON_MIDDLE)))
        pan(camera, drag.x, drag.y, 0, height);
    if (wheel_ != 0 && may.use_mouse)
        zoom_from_top(camera, seen_.value_or(camera.eye), wheel_, session.grid());
    wheel_ = 0;
    if (!may.use_keys) return;
    const auto down = [&](int k) { return glfwGetKey(window_, k) == GLFW_PRESS ? 1.0 : 0.0; };
    const glm::dvec2 way(down(GLFW_KEY_D) - down(GLFW_KEY_A), down(GLFW_KEY_W) - down(GLFW_KEY_S));
    // Most of the picture's height a second.
    const double pixels = 0.7 * height * passed_s;
    if (way != glm::dvec2(0)) pan(camera, -way.x * pixels, way.y * pixels, 0, height);
    const double nearer = down(GLFW_KEY_Q) - down(GLFW_KEY_E);
    if (nearer != 0) zoom_from_top(camera, camera.eye, 6 * nearer * passed_s, session.grid());
}

void Hand::move_camera(Session& session, glm::dvec2 mouse, double passed_s, glm::ivec2 size,
                       const HandMay& may) {
    render::Camera& camera = session.camera();
    const render::Camera before = camera;
    camera.fov_deg = session.view().number("camera.fov_deg");
    const glm::dvec2 drag = mouse - mouse_;
    if (follow_mode(session, camera, size)) {
        look_over(session, camera, drag, passed_s, size.y, may);
        walking_ = turning_ = false;
        ground_.forget();
        camera_moved_ = !(camera == before);
        if (camera_moved_) moving_s_ = 0.25;
        return;
    }
    const std::string& mode = session.view().choice("camera.mode");
    const bool walking = mode == "walk";
    const bool flying = mode == "fly" || walking;
    const glm::dvec3 ahead = seen_.value_or(camera.target);
    const auto held = [&](int button) { return glfwGetMouseButton(window_, button) == GLFW_PRESS; };
    const bool turning = held(GLFW_MOUSE_BUTTON_RIGHT) && may.use_mouse;
    if (turning && !turning_) pivot_ = ahead;
    turning_ = turning;
    if (turning && drag != glm::dvec2(0)) {
        if (flying)
            app::look(camera, drag.x, drag.y);
        else
            orbit(camera, pivot_, drag.x, drag.y);
    }
    if (held(GLFW_MOUSE_BUTTON_MIDDLE) && may.use_mouse)
        pan(camera, drag.x, drag.y, glm::length(ahead - camera.eye), size.y);
    if (wheel_ != 0 && may.use_mouse) zoom(camera, ahead, wheel_);
    wheel_ = 0;
    if (may.use_keys) {
        const auto down = [&](int k) { return glfwGetKey(window_, k) == GLFW_PRESS ? 1.0 : 0.0; };
        const double along = down(GLFW_KEY_W) - down(GLFW_KEY_S);
        const double aside = down(GLFW_KEY_D) - down(GLFW_KEY_A);
        if (walking) {
            const double step = session.view().number("camera.walk_m_per_s") * passed_s;
            walk(camera, step * along, step * aside);
        } else {
            const double step = session.view().number("camera.speed_m_per_s") * passed_s;
            fly(camera, step * along, step * aside, step * (down(GLFW_KEY_E) - down(GLFW_KEY_Q)));
        }
    }
    meet_ground(session, camera, walking, passed_s);
    camera_moved_ = !(camera == before);
    if (camera_moved_) moving_s_ = 0.25;
}

// Walking stands on the ground; else the eye stays out of it, where collision is on.
void Hand::meet_ground(Session& session, render::Camera& camera, bool walking, double passed_s) {
    const bool collides = session.view().toggle("camera.collision");
    if (!walking) walking_ = false;
    const bool in_tiles = session.overflight() != nullptr;
    if (!walking && !collides && !in_tiles) {
        ground_.forget();
        return;
    }
    const Grid& grid = session.grid();
    // Who begins to walk looks ahead.
    if (walking && !walking_) look_level(camera);
    walking_ = walking;
    if (walking) keep_within(camera, session.ground_edges());
    const std::optional<GroundSamples> ground = session.ground_samples(camera.eye);
    ground_.follow(ground);
    const std::optional<double> ground_m = ground_.height_m(ground);
    // Until the samples of another tile have come, the speed is that over the height before.
    if (ground_m || !ground) last_ground_m_ = ground_m;
    session.follow_height(last_ground_m_);
    if (!ground_m) return;
    const double eye_m = session.view().number("camera.eye_height_m");
    if (walking)
        stand(camera, *ground_m + eye_m, *ground_m + 0.2 * eye_m, passed_s);
    else if (collides)
        keep_above(camera, *ground_m + 0.02 * std::min(grid.dx, grid.dy));
}

// From where the button was pressed to where it is let go.
void Hand::choose_part(Session& session, const HandMay& may, bool& choosing_part) {
    const bool held = glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS && may.use_mouse;
    frames_held_ = held ? frames_held_ + 1 : 0;
    const bool presses = frames_held_ > 1;
    if (!choosing_part) part_from_m_.reset();
    if (!choosing_part) return;
    if (presses && !part_from_m_ && cursor_) part_from_m_ = glm::dvec2(*cursor_);
    if (!part_from_m_) return;
    moving_s_ = 0.25;
    if (cursor_) {
        const glm::dvec2 low = glm::min(*part_from_m_, glm::dvec2(*cursor_));
        const glm::dvec2 high = glm::max(*part_from_m_, glm::dvec2(*cursor_));
        set_part(session.view(), {low.x, low.y, high.x, high.y});
    }
    if (held) return;
    // A click alone chooses nothing.
    const Rectangle part = part_of(session.view());
    choosing_part = std::min(part.east_m - part.west_m, part.north_m - part.south_m) <= 0;
    part_from_m_.reset();
}

void Hand::draw_path(Session& session, bool held, bool presses) {
    PathDraft& path = session.path_draft();
    if (presses && cursor_) {
        // Some pixels around a point are its own.
        const render::Camera& camera = session.camera();
        const double reach_m = 12 * pixel_width_m(camera, 720, glm::distance(camera.eye, *cursor_));
        path_point_ = path.point_near(*cursor_, reach_m);
        if (!path_point_) {
            path.add(*cursor_);
            path_point_ = path.points_m().size() - 1;
        }
        placed_ = true;
    }
    if (!held) path_point_.reset();
    if (path_point_ && *path_point_ < path.points_m().size() && cursor_) path.move(*path_point_, *cursor_);
}

// Something new where it is clicked, or what stands there moved to where it is let go.
void Hand::place_mark(const HandErrand& errand, bool held, bool down) {
    // A press counts in its second frame; what was under the mouse then may have slipped from it.
    if (frames_held_ == 1) {
        pressed_on_ = errand.under;
        mark_mouse_ = mouse_;
    }
    const bool begins = frames_held_ == 2 && !placed_;
    if (begins && errand.placing && cursor_) {
        errand.done.placed = {*std::exchange(errand.placing, std::nullopt), *cursor_};
        placed_ = true;
    } else if (begins && pressed_on_ && !errand.placing) {
        held_mark_ = pressed_on_->at;
        to_foot_px_ = pressed_on_->to_foot_px;
        dragged_ = false;
        // From now on its foot is looked for.
        cursor_.reset();
        cursor_mouse_ = glm::dvec2(-1);
        placed_ = true;
    }
    if (!held_mark_) return;
    moving_s_ = 0.25;
    // A click alone moves nothing.
    if (glm::distance(mouse_, mark_mouse_) > 3 && cursor_) {
        held_mark_->place_m = *cursor_;
        dragged_ = true;
    }
    if (held) return;
    // Over no ground it stays where it was last over some. A dialog that comes between leaves it where it
    // was.
    if (dragged_ && !down) errand.done.moved = held_mark_;
    held_mark_.reset();
    cursor_mouse_ = glm::dvec2(-1);
}

// Draws what is to be drawn, from where a drag begins to where it ends; a click alone draws nothing.
void Hand::follow_drag(const HandErrand& errand, bool held, bool presses) {
    if (!errand.drawing) {
        drawn_.reset();
        return;
    }
    if (presses && cursor_ && !drawn_ && !placed_) {
        drawn_ = {*errand.drawing, {*cursor_, *cursor_}};
        placed_ = true;
    }
    if (!drawn_) return;
    // Over no ground it stays where it was last over some.
    if (cursor_) drawn_->corners.second = *cursor_;
    if (held) return;
    const DrawnDrag done = *std::exchange(drawn_, std::nullopt);
    const glm::bvec2 same = glm::equal(glm::dvec2(done.corners.first), glm::dvec2(done.corners.second));
    if (done.what == MapDrag::mask ? glm::any(same) : glm::all(same)) return;
    errand.done.drawn = done;
    errand.drawing.reset();
}

// Where the stroke goes on: none where the mouse is beside the ground. While the mouse stays where it was
// pressed a stamp does too: what it raises comes towards the eye, and would be stamped again.
std::optional<glm::dvec3> Hand::stroke_place(const Session& session) const {
    const std::optional<BrushStroke>& stroke = session.sculpting().stroke();
    const bool stamps = tool_named(session.view().choice("brush.tool")).course == StrokeCourse::stamps;
    if (stroke && stamps && mouse_ == stroke_mouse_) return stroke->begin();
    return cursor_;
}

void Hand::sculpt(Session& session, double passed_s, const HandMay& may, const HandErrand& errand) {
    const bool pressed = glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
    const bool held = pressed && may.use_mouse;
    const auto down = [&](int left, int right) {
        return glfwGetKey(window_, left) == GLFW_PRESS || glfwGetKey(window_, right) == GLFW_PRESS;
    };
    const Modifiers modifiers{down(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL),
                              down(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT)};
    // A press counts from its second frame on: only then does the panel know whether it was meant for it.
    frames_held_ = held ? frames_held_ + 1 : 0;
    const bool presses = frames_held_ > 1;
    place_mark(errand, held, pressed);
    if (may.use_mouse)
        follow_drag(errand, held, presses);
    else
        drawn_.reset();
    if (errand.drawing_path && !errand.placing && !errand.drawing)
        draw_path(session, held, presses && !placed_);
    else
        path_point_.reset();
    // The click that placed or moved something, draws a section or a mask, or picked a height, is no stroke.
    placed_ = placed_ && pressed;
    if (presses && !session.stroking() && cursor_ && modifiers.inverted && !modifiers.smooth &&
        tool_named(session.view().choice("brush.tool")).picks_height) {
        session.set("brush.height_m", cursor_->z);
        placed_ = true;
    }
    if (presses && !placed_ && !session.stroking() && cursor_) {
        session.begin_stroke(*cursor_, modifiers);
        stroke_mouse_ = mouse_;
    }
    if (!session.stroking()) return;
    moving_s_ = 0.25;
    if (!held)
        session.let_go_of_stroke();
    else if (const auto at = stroke_place(session))
        session.stroke(*at, passed_s);
}

}  // namespace talus::app
