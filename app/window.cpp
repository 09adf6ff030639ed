#include "app/window.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "app/panels/legend.h"
#include "app/panels/panels.h"
#include "app/report.h"
#include "app/session.h"
#include "app/still.h"
#include "app/tools/camera_control.h"
#include "app/tools/ground_probe.h"
#include "sim/gpu/error.h"
#include "sim/gpu/program.h"
#include "sim/gpu/readback.h"
#include "sim/io/image_file.h"

namespace talus {
namespace {

constexpr double frame_goal_s = 1.0 / 30;

std::string glfw_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "no reason given";
}

// GLFW's life: init to terminate.
class Glfw {
  public:
    Glfw() {
        if (!glfwInit()) throw Error(fmt::format("no window can open: {}", glfw_error()));
    }
    ~Glfw() { glfwTerminate(); }
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;

    GLFWwindow* open(glm::ivec2 size, bool visible) const {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
        glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
        GLFWwindow* window = glfwCreateWindow(size.x, size.y, "Talus", nullptr, nullptr);
        if (!window) throw Error(fmt::format("no window with OpenGL 4.5 can open: {}", glfw_error()));
        glfwMakeContextCurrent(window);
        return window;
    }
};

// What a person does with mouse and keys, turned into what the session does.
class Window {
  public:
    Window(const Glfw& glfw, const WindowOptions& options)
        : window_(glfw.open(options.size, true)),
          device_(gpu::adopt_current_context("window")),
          session_(options.scene, device_),
          journal_path_(options.journal) {
        say(gpu::describe(device_));
        for (const std::string& note : session_.scene().document.notes) say("note: " + note);
        gpu::on_shader_message([this](const std::string& message) {
            say(message);
            tell(message);
        });
        glfwSetWindowUserPointer(window_, this);
        glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
            if (count > 0) self(w)->requests_.open = paths[0];
            self(w)->wake();
        });
        glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double y) {
            self(w)->wheel_ += y;
            self(w)->wake();
        });
        glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int mods) {
            self(w)->wake();
            if (action != GLFW_RELEASE) self(w)->key(key, mods);
        });
        // Whatever a person does wakes the window.
        glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double, double) { self(w)->wake(); });
        glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int, int, int) { self(w)->wake(); });
        glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int) { self(w)->wake(); });
        glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int) { self(w)->wake(); });
        glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned) { self(w)->wake(); });
        glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { self(w)->wake(); });
        glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { self(w)->wake(); });
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        ImGui::StyleColorsDark();
        ImGui::GetStyle().WindowRounding = 5;
        ImGui::GetStyle().FrameRounding = 3;
        load_font(15);
        // Chains to the callbacks above.
        ImGui_ImplGlfw_InitForOpenGL(window_, true);
        ImGui_ImplOpenGL3_Init("#version 450 core");
        import_panel_.follow(session_);
        title();
    }
    ~Window() {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
    }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    void loop() {
        last_s_ = glfwGetTime();
        while (!glfwWindowShouldClose(window_)) {
            if (busy())
                glfwPollEvents();
            else
                glfwWaitEventsTimeout(0.3);
            if (gpu::poll_shader_folder()) {
                session_.renderer().forget();
                wake();
            }
            if (!message_.empty() && glfwGetTime() >= message_until_s_) {
                message_.clear();
                wake();
            }
            // At rest nothing is drawn and nothing presented.
            if (busy()) frame();
        }
        session_.pause();
        if (!journal_path_.empty()) session_.write_journal_to(journal_path_);
    }

  private:
    static Window* self(GLFWwindow* window) { return static_cast<Window*>(glfwGetWindowUserPointer(window)); }
    bool busy() const {
        return session_.playing || session_.stroking() || frames_left_ > 0 || moving_s_ > 0 ||
               cursor_readback_.pending() || ground_.pending() || refining_;
    }
    void wake() { frames_left_ = 3; }
    void tell(const std::string& message) {
        message_ = message;
        message_until_s_ = glfwGetTime() + 6;
        wake();
    }
    void title() {
        glfwSetWindowTitle(
            window_,
            fmt::format("{}{} - Talus", session_.scene().title, session_.unsaved() ? " *" : "").c_str());
    }

    // Errors of what a person asked for are told, and everything stays as it was.
    template <typename Act>
    void attempt(Act&& act) {
        try {
            act();
        } catch (const std::exception& error) {
            session_.playing = false;
            say(fmt::format("talus: {}", error.what()));
            tell(error.what());
        }
        wake();
    }

    void key(int key, int mods) {
        wake();
        const bool control = (mods & GLFW_MOD_CONTROL) != 0;
        const bool shift = (mods & GLFW_MOD_SHIFT) != 0;
        if (dialog_.purpose != FileDialog::Purpose::none) {
            // A key pressed and released within one slow frame would escape the panels.
            if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) dialog_.accepted = true;
            if (key == GLFW_KEY_ESCAPE) dialog_.cancelled = true;
            return;
        }
        if (control) {
            if (key == GLFW_KEY_Z) (shift ? requests_.redo : requests_.undo) = true;
            if (key == GLFW_KEY_Y) requests_.redo = true;
            if (key == GLFW_KEY_O) dialog_.begin(FileDialog::Purpose::open, session_.path());
            if (key == GLFW_KEY_S && (shift || session_.path().empty()))
                dialog_.begin(FileDialog::Purpose::save, session_.path());
            else if (key == GLFW_KEY_S)
                requests_.save = session_.path();
            if (key == GLFW_KEY_Q) requests_.quit = true;
            return;
        }
        if (ImGui::GetIO().WantTextInput) return;
        const auto scale = [&](const char* name, double factor) {
            const Parameter& p = session_.declaration(name);
            session_.set(name, std::clamp(session_.view().number(name) * factor, p.low, p.high));
        };
        const std::vector<std::string>& modes = session_.declaration("brush.mode").choices;
        switch (key) {
            case GLFW_KEY_SPACE:
                requests_.acts.emplace_back([](Session& session) { session.toggle_play(); });
                break;
            case GLFW_KEY_PERIOD:
                requests_.acts.emplace_back([](Session& session) { session.step(); });
                break;
            case GLFW_KEY_F:
                requests_.framing = true;
                break;
            case GLFW_KEY_F12:
                requests_.picture = true;
                break;
            case GLFW_KEY_LEFT_BRACKET:
                scale("brush.radius_m", 1 / 1.15);
                break;
            case GLFW_KEY_RIGHT_BRACKET:
                scale("brush.radius_m", 1.15);
                break;
            case GLFW_KEY_MINUS:
                scale("brush.rate_m_per_s", 1 / 1.15);
                break;
            case GLFW_KEY_EQUAL:
                scale("brush.rate_m_per_s", 1.15);
                break;
            default:
                if (key >= GLFW_KEY_1 && key < GLFW_KEY_1 + static_cast<int>(modes.size()))
                    session_.set("brush.mode", modes[static_cast<std::size_t>(key - GLFW_KEY_1)]);
        }
    }

    // Where the mouse's ray met the ground when it was last read.
    void read_cursor() {
        if (const auto texels = cursor_readback_.poll()) {
            const float distance = (*texels)[0];
            cursor_.reset();
            if (std::isfinite(distance))
                cursor_ = cursor_camera_.eye + cursor_direction_ * static_cast<double>(distance);
        }
    }

    void start_cursor_readback(glm::dvec2 mouse, int width, int height, int drawn_width, int drawn_height) {
        if (cursor_readback_.pending()) {
            // The picture has changed since: again, when it has come.
            cursor_mouse_ = glm::dvec2(-1);
            return;
        }
        if (mouse.x < 0 || mouse.y < 0 || mouse.x >= width || mouse.y >= height) return;
        const int x = std::clamp(static_cast<int>(mouse.x * drawn_width / width), 0, drawn_width - 1);
        const int y = std::clamp(static_cast<int>(mouse.y * drawn_height / height), 0, drawn_height - 1);
        cursor_mouse_ = mouse;
        cursor_camera_ = session_.camera();
        cursor_direction_ = pixel_direction(cursor_camera_, x + 0.5, y + 0.5, drawn_width, drawn_height);
        cursor_readback_.start(session_.renderer().hits(), {x, drawn_height - 1 - y, 1, 1});
    }

    void move_camera(glm::dvec2 mouse, double passed_s, int height) {
        Camera& camera = session_.camera();
        const Camera before = camera;
        camera.fov_deg = session_.view().number("camera.fov_deg");
        const glm::dvec2 drag = mouse - mouse_;
        const bool captured = ImGui::GetIO().WantCaptureMouse;
        const std::string& mode = session_.view().choice("camera.mode");
        const bool walking = mode == "walk";
        const bool flying = mode == "fly" || walking;
        const glm::dvec3 ahead = cursor_.value_or(camera.target);
        const auto held = [&](int button) { return glfwGetMouseButton(window_, button) == GLFW_PRESS; };
        const bool turning = held(GLFW_MOUSE_BUTTON_RIGHT) && !captured;
        if (turning && !turning_) pivot_ = ahead;
        turning_ = turning;
        if (turning && drag != glm::dvec2(0)) {
            if (flying)
                look(camera, drag.x, drag.y);
            else
                orbit(camera, pivot_, drag.x, drag.y);
        }
        if (held(GLFW_MOUSE_BUTTON_MIDDLE) && !captured)
            pan(camera, drag.x, drag.y, glm::length(ahead - camera.eye), height);
        if (wheel_ != 0 && !captured) zoom(camera, ahead, wheel_);
        wheel_ = 0;
        if (!ImGui::GetIO().WantTextInput && dialog_.purpose == FileDialog::Purpose::none &&
            !ImGui::GetIO().KeyCtrl) {
            const auto down = [&](int k) { return glfwGetKey(window_, k) == GLFW_PRESS ? 1.0 : 0.0; };
            const double along = down(GLFW_KEY_W) - down(GLFW_KEY_S);
            const double aside = down(GLFW_KEY_D) - down(GLFW_KEY_A);
            if (walking) {
                const double step = session_.view().number("camera.walk_m_per_s") * passed_s;
                walk(camera, step * along, step * aside);
            } else {
                const double step = session_.view().number("camera.speed_m_per_s") * passed_s;
                fly(camera, step * along, step * aside, step * (down(GLFW_KEY_E) - down(GLFW_KEY_Q)));
            }
        }
        meet_ground(camera, walking, passed_s);
        camera_moved_ = !(camera == before);
        if (camera_moved_) moving_s_ = 0.25;
    }

    // What was read of another terrain is not of this one.
    void follow_terrain() {
        if (terrain_number_ == session_.terrain_number()) return;
        terrain_number_ = session_.terrain_number();
        ground_.forget();
        cursor_readback_.cancel();
        cursor_.reset();
        cursor_mouse_ = glm::dvec2(-1);
    }

    // Walking stands on the ground; else the eye stays out of it, where collision is on.
    void meet_ground(Camera& camera, bool walking, double passed_s) {
        const bool collides = session_.view().toggle("camera.collision");
        if (!walking) walking_ = false;
        if (!walking && !collides) {
            ground_.forget();
            return;
        }
        const Grid& grid = session_.grid();
        // Who begins to walk looks ahead.
        if (walking && !walking_) look_level(camera);
        walking_ = walking;
        if (walking) keep_within(camera, grid);
        ground_.follow(session_.simulation().terrain(), camera.eye);
        const std::optional<double> ground_m = ground_.height_m(grid, camera.eye);
        if (!ground_m) return;
        const double eye_m = session_.view().number("camera.eye_height_m");
        if (walking)
            stand(camera, *ground_m + eye_m, *ground_m + 0.2 * eye_m, passed_s);
        else
            keep_above(camera, *ground_m + 0.02 * std::min(grid.dx, grid.dy));
    }

    // The first free name in the folder where Talus was started.
    void save_picture() {
        attempt([&] {
            int width = 0;
            int height = 0;
            glfwGetFramebufferSize(window_, &width, &height);
            int number = 1;
            while (std::filesystem::exists(fmt::format("talus-{:04}.png", number))) ++number;
            const std::string path = fmt::format("talus-{:04}.png", number);
            const ViewSettings settings = view_settings(session_.view());
            const glm::dvec2 bounds = session_.renderer().bounds();
            const Still still =
                draw_still(session_.renderer(), session_.simulation().terrain(), session_.camera(), settings,
                           legend_of(settings, bounds.x, bounds.y), {width, height},
                           session_.view().whole("render.samples"));
            write_rgb(path, width, height, still.rgb);
            tell(fmt::format("saved the picture {}", path));
        });
    }

    void sculpt(double passed_s) {
        const bool held = glfwGetMouseButton(window_, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS &&
                          !ImGui::GetIO().WantCaptureMouse;
        // A press counts from its second frame on: only then does the panel know whether it was meant for it.
        const bool presses = std::exchange(held_before_, held) && held;
        if (presses && placing_gauge_ && cursor_) {
            attempt([&] { session_.gauges().place({cursor_->x, cursor_->y}); });
            placing_gauge_ = false;
            placed_ = true;
        }
        // The click that placed a gauge is no stroke.
        placed_ = placed_ && held;
        if (presses && !placed_ && !session_.stroking() && cursor_) session_.begin_stroke(*cursor_);
        if (!held && session_.stroking()) {
            session_.end_stroke();
            title();
        }
        if (session_.stroking() && cursor_) {
            attempt([&] { session_.stroke(*cursor_, passed_s); });
            moving_s_ = 0.25;
        }
    }

    void serve_requests() {
        PanelRequests asked;
        std::swap(asked, requests_);
        if (asked.open)
            attempt([&] {
                session_.open(*asked.open);
                for (const std::string& note : session_.scene().document.notes) say("note: " + note);
                import_panel_.follow(session_);
            });
        if (asked.save)
            attempt([&] {
                session_.save(*asked.save);
                if (!journal_path_.empty()) session_.write_journal_to(journal_path_);
                tell(fmt::format("saved {}", *asked.save));
            });
        for (const auto& act : asked.acts) attempt([&] { act(session_); });
        if (asked.reset) attempt([&] { session_.reset(); });

        if (asked.undo) attempt([&] { session_.undo(); });
        if (asked.redo) attempt([&] { session_.redo(); });
        if (asked.framing) session_.frame_terrain();
        if (asked.picture) save_picture();
        if (asked.quit) glfwSetWindowShouldClose(window_, GLFW_TRUE);
        if (asked.open || asked.save || asked.reset || asked.undo || asked.redo || asked.framing ||
            !asked.acts.empty()) {
            title();
            wake();
        }
    }

    void frame() {
        const double now = glfwGetTime();
        const double passed_s = std::min(now - last_s_, 0.25);
        last_s_ = now;
        int width = 0;
        int height = 0;
        glfwGetFramebufferSize(window_, &width, &height);
        if (width <= 0 || height <= 0) return;
        glm::dvec2 mouse;
        glfwGetCursorPos(window_, &mouse.x, &mouse.y);

        follow_terrain();
        read_cursor();
        move_camera(mouse, passed_s, height);
        sculpt(passed_s);
        if (mouse != mouse_) wake();
        mouse_ = mouse;
        if (session_.playing) attempt([&] { session_.play(passed_s, frame_goal_s / 2); });
        session_.follow_gauges();

        // While anything moves, the resolution gives way so that frames keep coming; at rest it is full.
        const bool moving = session_.playing || session_.stroking() || moving_s_ > 0;
        moving_s_ = std::max(0.0, moving_s_ - passed_s);
        // A camera at rest keeps its size while it can, so that changes redraw only what they touch.
        const double haste = frame_goal_s / std::max(frame_s_, 1e-3);
        if (moving && moved_before_ && (camera_moved_ || haste < 0.7 || haste > 2))
            scale_ = std::clamp(scale_ * std::sqrt(frame_goal_s / std::max(frame_s_, 1e-3)), 0.9 * scale_,
                                1.05 * scale_);
        moved_before_ = moving;
        scale_ = std::clamp(scale_, 0.3, 1.0);
        const double used = moving ? scale_ : 1.0;
        const int drawn_width = std::max(1, static_cast<int>(width * used));
        const int drawn_height = std::max(1, static_cast<int>(height * used));
        if (!moving && frames_left_ > 0) --frames_left_;
        if (moving) frames_left_ = 2;

        ViewSettings settings = view_settings(session_.view());
        if (cursor_ && !ImGui::GetIO().WantCaptureMouse)
            settings.ring_m = {cursor_->x, cursor_->y, session_.view().number("brush.radius_m")};
        // A shader that does not compile is told, and the last picture stays.
        refining_ = false;
        try {
            Terrain& terrain = session_.simulation().terrain();
            const Drawn drawn =
                session_.renderer().draw(terrain, session_.camera(), settings, drawn_width, drawn_height);
            // Over a picture at rest the cursor is read where it came to, once.
            if (drawn != Drawn::nothing || mouse != cursor_mouse_)
                start_cursor_readback(mouse, width, height, drawn_width, drawn_height);
            // At rest the picture gathers samples, one a frame.
            refining_ =
                !moving && session_.renderer().refine(terrain, session_.view().whole("render.samples"));
        } catch (const std::exception& error) {
            if (message_ != error.what()) {
                say(fmt::format("talus: {}", error.what()));
                tell(error.what());
            }
        }

        gpu::bind_window(width, height);
        session_.renderer().framebuffer().blit_to_window({0, 0, drawn_width, drawn_height},
                                                         {0, 0, width, height});
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        draw_main_panel(session_, dialog_, placing_gauge_, requests_);
        draw_gauge_marks(session_, width, height);
        draw_import_panel(session_, import_panel_, requests_);
        draw_file_dialog(dialog_, requests_);
        draw_legend(legend_of(settings, session_.renderer().bounds().x, session_.renderer().bounds().y),
                    width, height - 26);
        StatusFigures figures{device_.renderer, now < message_until_s_ ? message_ : "", std::nullopt,
                              frame_s_ * 1000, used};
        if (cursor_) figures.cursor_height_m = cursor_->z;
        draw_status_line(session_, figures, width, height);
        ImGui::Render();
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
        glfwSwapBuffers(window_);
        if (!std::exchange(first_picture_shown_, true))
            say(fmt::format("first picture after {:.2f} s", seconds_since_start()));
        serve_requests();
        frame_s_ = glfwGetTime() - now;
    }

    GLFWwindow* window_;
    gpu::Device device_;
    Session session_;
    std::string journal_path_;
    PanelRequests requests_;
    bool placing_gauge_ = false;  // by the next click
    bool placed_ = false;         // by the click that is held
    bool held_before_ = false;    // the left button, in the frame before
    FileDialog dialog_;
    ImportPanel import_panel_;
    bool first_picture_shown_ = false;
    std::string message_;
    double message_until_s_ = 0;

    bool refining_ = false;

    bool walking_ = false;
    int terrain_number_ = 0;
    GroundProbe ground_;
    gpu::Readback cursor_readback_;
    Camera cursor_camera_;
    glm::dvec2 cursor_mouse_{-1};  // where the last read-back began
    glm::dvec3 cursor_direction_{0};
    std::optional<glm::dvec3> cursor_;
    glm::dvec2 mouse_{0};
    glm::dvec3 pivot_{0};
    bool turning_ = false;
    double wheel_ = 0;

    double last_s_ = 0;
    double frame_s_ = frame_goal_s;
    double scale_ = 1.0;
    double moving_s_ = 0;
    bool camera_moved_ = false;
    bool moved_before_ = false;
    int frames_left_ = 3;
};

}  // namespace

std::string why_no_window() {
    try {
        const Glfw glfw;
        glfw.open({64, 64}, false);
        gpu::adopt_current_context("window");
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

void run_window(const WindowOptions& options) {
    const Glfw glfw;
    Window window(glfw, options);
    window.loop();
}

}  // namespace talus
