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

#include "app/frame_log.h"
#include "app/panels/legend.h"
#include "app/panels/panels.h"
#include "app/project.h"
#include "app/report.h"
#include "app/session.h"
#include "app/shortcuts.h"
#include "app/still.h"
#include "app/tools/hand.h"
#include "app/window_layout.h"
#include "sim/error.h"
#include "sim/gpu/shader_text.h"
#include "sim/io/atomic_file.h"
#include "sim/io/image_file.h"
#include "sim/terrain/state_hash.h"

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
        gpu::work_around_drivers();
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

// The window: its events, its frames, and what panels and keys ask of it.
class Window {
  public:
    Window(const Glfw& glfw, const WindowOptions& options, const WindowLayout& layout)
        : window_(glfw.open(options.size.value_or(layout.size), true)),
          device_(gpu::adopt_current_context("window")),
          session_(options.scene, device_),
          hand_(window_),
          project_(session_, state_, options.journal,
                   {[this](const std::string& message) { tell(message); },
                    [this](const std::string& message) { note(message); },
                    [this] {
                        title();
                        wake();
                    },
                    [this] { note_start(); }}),
          frame_log_path_(options.frame_log),
          rects_path_(options.ui_rects) {
        note(gpu::describe(device_));
        for (const std::string& guess : session_.scene().document.notes) note("note: " + guess);
        gpu::on_shader_message([this](const std::string& message) { tell(message); });
        listen();
        begin_panels(options.ui_scale);
        const std::vector<std::string> panels = panel_names();
        if (std::find(panels.begin(), panels.end(), layout.panel) != panels.end())
            state_.shown = layout.panel;
        state_.panels_shown = layout.panels_shown;
        // The start page opens where nothing was named; a file that was named is not covered by it.
        state_.start_page = options.scene.input.empty() && options.scene.preset.empty();
        if (!state_.start_page && !state_.left.empty())
            tell("an earlier session ended with unsaved work: File > Start page offers it");
        glm::ivec2 size(0);
        glfwGetFramebufferSize(window_, &size.x, &size.y);
        follow_area(size);
        session_.frame_terrain();
        title();
        note_start();
    }
    ~Window() {
        // What hangs on OpenGL goes before it.
        state_ = {};
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
            // What fails costs a frame, never the work: it is told, and the window goes on.
            attempt([&] { session_.poll(); });
            attempt([&] { project_.poll(); });
            // At rest nothing is drawn and nothing presented.
            if (busy()) frame();
            if (glfwWindowShouldClose(window_) && !closing_) {
                glfwSetWindowShouldClose(window_, GLFW_FALSE);
                quit();
            }
        }
        session_.pause();
        project_.write_journal();
        if (!frame_log_path_.empty()) write_atomically(frame_log_path_, to_csv(frames_));
        WindowLayout layout;
        glfwGetWindowSize(window_, &layout.size.x, &layout.size.y);
        layout.panel = state_.shown;
        layout.panels_shown = state_.panels_shown;
        keep_window_layout(layout);
        project_.end();
    }

  private:
    static Window* self(GLFWwindow* window) { return static_cast<Window*>(glfwGetWindowUserPointer(window)); }

    void listen() {
        glfwSetWindowUserPointer(window_, this);
        glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
            if (count > 0) self(w)->requests_.import = paths[0];
            self(w)->wake();
        });
        // Whatever a person does wakes the window, and goes to the panels too.
        glfwSetScrollCallback(window_, [](GLFWwindow* w, double x, double y) {
            self(w)->hand_.turn_wheel(y);
            self(w)->wake();
            ImGui_ImplGlfw_ScrollCallback(w, x, y);
        });
        glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int code, int action, int mods) {
            self(w)->wake();
            self(w)->hear_key(key, code, action, mods);
        });
        glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int mouse_button, int action, int mods) {
            self(w)->wake();
            ImGui_ImplGlfw_MouseButtonCallback(w, mouse_button, action, mods);
        });
        glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int focused) {
            self(w)->wake();
            ImGui_ImplGlfw_WindowFocusCallback(w, focused);
        });
        glfwSetCursorEnterCallback(window_, [](GLFWwindow* w, int entered) {
            self(w)->wake();
            ImGui_ImplGlfw_CursorEnterCallback(w, entered);
        });
        glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned letter) {
            self(w)->wake();
            self(w)->typed_.push_back({0, 0, 0, 0, letter, false});
        });
        glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double, double) { self(w)->wake(); });
        glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { self(w)->wake(); });
        glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) { self(w)->wake(); });
        glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { self(w)->wake(); });
    }

    // A shortcut acts at once; where something is typed, Enter and Escape come after what was typed before
    // them.
    void hear_key(int key, int code, int action, int mods) {
        const bool typing =
            is_dialog_open(state_) || ImGui::GetIO().WantTextInput ||
            std::any_of(typed_.begin(), typed_.end(), [](const Typed& one) { return one.waits; });
        const bool presses = action != GLFW_RELEASE;
        if (presses && !typing) press_key(key, mods, session_, state_, requests_);
        typed_.push_back({key, code, action, mods, 0, presses && typing});
    }

    // Panels look at keys once a frame: one that is let go in the frame in which another was pressed would
    // never have been down with it. So a release after a press waits for the next frame, and all that comes
    // behind it.
    void pass_typed() {
        bool pressed = false;
        std::size_t passed = 0;
        for (const Typed& typed : typed_) {
            if (pressed && typed.letter == 0 && typed.action == GLFW_RELEASE) break;
            if (typed.letter != 0) {
                ImGui_ImplGlfw_CharCallback(window_, typed.letter);
            } else {
                pressed = pressed || typed.action == GLFW_PRESS;
                if (typed.waits) press_key(typed.key, typed.mods, session_, state_, requests_);
                ImGui_ImplGlfw_KeyCallback(window_, typed.key, typed.code, typed.action, typed.mods);
            }
            ++passed;
        }
        typed_.erase(typed_.begin(), typed_.begin() + static_cast<std::ptrdiff_t>(passed));
        if (!typed_.empty()) wake();
    }

    void begin_panels(double scale) {
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        ImGui::GetIO().ConfigWindowsMoveFromTitleBarOnly = true;
        float asked = 1;
        glfwGetWindowContentScale(window_, &asked, nullptr);
        const float used = scale > 0 ? static_cast<float>(scale) : std::clamp(asked, 1.0F, 4.0F);
        ImGui::StyleColorsDark();
        ImGuiStyle& style = ImGui::GetStyle();
        style.WindowRounding = 0;
        style.FrameRounding = 3;
        style.WindowBorderSize = 0;
        style.Colors[ImGuiCol_WindowBg] = {0.085F, 0.095F, 0.11F, 0.97F};
        style.Colors[ImGuiCol_Button] = {0.20F, 0.24F, 0.30F, 1};
        style.Colors[ImGuiCol_ButtonActive] = {0.16F, 0.45F, 0.75F, 1};
        style.Colors[ImGuiCol_PlotHistogram] = {0.16F, 0.45F, 0.75F, 1};  // white words can be read on it
        style.Colors[ImGuiCol_ModalWindowDimBg] = {0, 0, 0, 0.45F};
        style.ScaleAllSizes(used);
        load_font(15 * used);
        // The callbacks above pass on what it needs.
        ImGui_ImplGlfw_InitForOpenGL(window_, false);
        ImGui_ImplOpenGL3_Init("#version 450 core");
    }

    // What the panels leave to the picture.
    PictureArea follow_area(glm::ivec2 size) {
        const PictureArea area = picture_area(state_, size);
        session_.picture_aspect = static_cast<double>(area.size.x) / area.size.y;
        return area;
    }

    bool busy() const {
        return session_.playing || session_.stroking() || frames_left_ > 0 || hand_.moving() ||
               hand_.waits() || refining_ || project_.busy();
    }
    void wake() { frames_left_ = 3; }
    void note(const std::string& message) {
        say(message);
        constexpr std::size_t most = 1000;
        if (state_.log.size() >= most) state_.log.erase(state_.log.begin());
        state_.log.push_back(message);
    }
    // For who drives the window by name, and wants to know whether undo leads back to it.
    void note_start() {
        if (rects_path_.empty()) return;
        note(fmt::format("begun with hash {:016x}", state_hash(session_.simulation().read())));
    }
    void tell(const std::string& message) {
        note(message);
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
            tell(fmt::format("talus: {}", error.what()));
        }
    }

    void quit() {
        project_.when_saved([this] {
            closing_ = true;
            glfwSetWindowShouldClose(window_, GLFW_TRUE);
        });
    }

    // The first free name in the folder where Talus was started.
    void save_picture() {
        glm::ivec2 window(0);
        glfwGetFramebufferSize(window_, &window.x, &window.y);
        const glm::ivec2 size = picture_area(state_, window).size;
        int number = 1;
        while (std::filesystem::exists(fmt::format("talus-{:04}.png", number))) ++number;
        const std::string path = fmt::format("talus-{:04}.png", number);
        const ViewSettings settings = view_settings(session_.view(), session_.simulation().parameters());
        const glm::dvec2 bounds = session_.renderer().bounds();
        const Still still = draw_still(session_.renderer(), session_.simulation().terrain(),
                                       session_.camera(), settings, legend_of(settings, bounds.x, bounds.y),
                                       size, session_.view().whole("render.samples"));
        write_rgb(path, size.x, size.y, still.rgb);
        tell(fmt::format("saved the picture {}", path));
    }

    void serve_requests() {
        PanelRequests asked;
        std::swap(asked, requests_);
        // Long work has the session to itself.
        const auto waits = [&] {
            const bool busy = project_.work().busy();
            if (busy && asked.any()) tell(fmt::format("{} goes on: wait for it", project_.work().name()));
            return busy;
        };
        if (waits()) return;
        if (asked.answer) attempt(asked.answer);
        attempt([&] { project_.serve(asked); });
        if (project_.work().busy()) return title();
        for (const auto& act : asked.acts) attempt([&] { act(session_); });
        if (asked.undo) attempt([&] { session_.undo(); });
        if (asked.redo) attempt([&] { session_.redo(); });
        if (asked.framing) session_.frame_terrain();
        if (asked.picture) attempt([&] { save_picture(); });
        if (asked.quit) quit();
        if (asked.any()) {
            title();
            wake();
        }
    }

    // What passes took, told twice a second while somebody looks at it.
    void follow_passes(double passed_s) {
        const bool shown = state_.panels_shown && state_.shown == "Profiler";
        if (shown != profiling_) gpu::profile_passes(shown);
        profiling_ = shown;
        if (!shown) return;
        passes_s_ += passed_s;
        for (const gpu::PassTime& time : gpu::take_pass_times()) {
            auto found = std::find_if(passes_.begin(), passes_.end(),
                                      [&](const gpu::PassTime& pass) { return pass.name == time.name; });
            if (found == passes_.end()) found = passes_.insert(passes_.end(), gpu::PassTime{time.name});
            found->calls += time.calls;
            found->cpu_ms += time.cpu_ms;
            found->device_ms += time.device_ms;
        }
        if (passes_s_ < 0.5) return;
        state_.passes = std::exchange(passes_, {});
        state_.passes_s = std::exchange(passes_s_, 0);
    }

    // While anything moves, the resolution gives way so that frames keep coming; at rest it is full.
    double picture_scale(bool moving) {
        // A camera at rest keeps its size while it can, so that changes redraw only what they touch.
        const double haste = frame_goal_s / std::max(rest_s_ + frame_goal_s / 8, 1e-3);
        if (moving && moved_before_ && (hand_.camera_moved() || haste < 0.92 || haste > 1.6))
            scale_ = std::clamp(scale_ * std::sqrt(haste), 0.9 * scale_, 1.05 * scale_);
        moved_before_ = moving;
        scale_ = std::clamp(scale_, 0.3, 1.0);
        return moving ? scale_ : 1.0;
    }

    // Ticks get what the rest of a frame leaves of its goal, an eighth at least and half at most.
    double ticks_budget_s() const {
        return std::clamp(frame_goal_s - rest_s_, frame_goal_s / 8, frame_goal_s / 2);
    }

    // Milliseconds.
    static double since(double begin_s) { return 1000 * (glfwGetTime() - begin_s); }

    void frame() {
        const double now = glfwGetTime();
        const double passed_s = std::min(now - last_s_, 0.25);
        last_s_ = now;
        glm::ivec2 size(0);
        glfwGetFramebufferSize(window_, &size.x, &size.y);
        if (size.x <= 0 || size.y <= 0) return;
        glm::dvec2 mouse;
        glfwGetCursorPos(window_, &mouse.x, &mouse.y);
        if (mouse != mouse_) wake();
        mouse_ = mouse;
        const PictureArea area = follow_area(size);

        const ImGuiIO& io = ImGui::GetIO();
        const bool dialog = is_dialog_open(state_) || project_.work().busy();
        const HandMay may{!io.WantCaptureMouse && !dialog, !io.WantTextInput && !io.KeyCtrl && !dialog};
        const bool stroked = session_.stroking();
        FrameTimes times{now};
        const int dabs_before = session_.dabs();
        attempt([&] {
            hand_.act(session_, mouse - glm::dvec2(area.corner), passed_s, area.size, may,
                      state_.placing_gauge);
        });
        if (stroked && !session_.stroking()) title();
        times.act_ms = since(now);
        times.dabs = session_.dabs() - dabs_before;
        if (times.dabs > 0) times.waited_ms = 1000 * session_.dabs_waited_s();
        if (session_.playing) attempt([&] { session_.play(passed_s, ticks_budget_s()); });
        session_.follow_gauges();
        follow_passes(passed_s);

        const bool moving = session_.playing || session_.stroking() || hand_.moving();
        const double used = picture_scale(moving);
        const glm::ivec2 drawn_size = glm::max(glm::ivec2(glm::dvec2(area.size) * used), 1);
        if (!moving && frames_left_ > 0) --frames_left_;
        if (moving) frames_left_ = 2;
        times.scale = used;
        times.play_ms = since(now) - times.act_ms;
        draw_picture(mouse - glm::dvec2(area.corner), area.size, drawn_size, moving);
        times.picture_ms = since(now) - times.total_ms();
        draw_window(size, area, drawn_size, used);
        times.panels_ms = since(now) - times.total_ms();
        glfwSwapBuffers(window_);
        times.present_ms = since(now) - times.total_ms();
        rest_s_ += 0.2 * ((times.total_ms() - times.play_ms) / 1000 - rest_s_);
        if (!frame_log_path_.empty()) frames_.push_back(times);
        if (!std::exchange(first_picture_shown_, true))
            note(fmt::format("first picture after {:.2f} s", seconds_since_start()));
        keep_rects();
        serve_requests();
        frame_s_ = glfwGetTime() - now;
    }

    void draw_picture(glm::dvec2 mouse, glm::ivec2 size, glm::ivec2 drawn_size, bool moving) {
        settings_ = view_settings(session_.view(), session_.simulation().parameters());
        settings_.quick = moving && scale_ < 0.6;
        // A shader that does not compile is told, and the last picture stays.
        try {
            Ring ring;
            if (hand_.cursor() && !ImGui::GetIO().WantCaptureMouse) ring = session_.ring(*hand_.cursor());
            Terrain& terrain = session_.simulation().terrain();
            const Drawn drawn = session_.renderer().draw(terrain, session_.camera(), settings_, drawn_size.x,
                                                         drawn_size.y, ring);
            hand_.look(session_, mouse, size, drawn_size, drawn != Drawn::nothing);
            // At rest the picture gathers samples, one a frame; while somebody works at the panels they come
            // first.
            if (!moving && frames_left_ == 0 && !ImGui::IsAnyItemActive())
                refining_ = session_.renderer().refine(terrain, session_.view().whole("render.samples"));
            else
                refining_ = frames_left_ == 0 && refining_ && !ImGui::IsAnyItemActive();
        } catch (const std::exception& error) {
            refining_ = false;
            if (message_ != error.what()) tell(error.what());
        }
    }

    void draw_window(glm::ivec2 size, const PictureArea& area, glm::ivec2 drawn_size, double used) {
        gpu::bind_window(size.x, size.y);
        // The window counts rows from below.
        session_.renderer().framebuffer().blit_to_window(
            {0, 0, drawn_size.x, drawn_size.y},
            {area.corner.x, size.y - area.corner.y - area.size.y, area.size.x, area.size.y});
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        pass_typed();
        ImGui::NewFrame();
        draw_marks(session_, area);
        StatusFigures figures{device_.renderer, glfwGetTime() < message_until_s_ ? message_ : "",
                              std::nullopt, frame_s_ * 1000, used};
        if (hand_.cursor()) figures.cursor_height_m = hand_.cursor()->z;
        draw_legend(legend_of(settings_, session_.renderer().bounds().x, session_.renderer().bounds().y),
                    area.corner.x + area.size.x, area.corner.y + area.size.y);
        PanelContext context{session_, state_, requests_, project_.work()};
        draw_panels(context, figures, size);
        bool cancelled = false;
        draw_work(project_.work(), cancelled);
        if (cancelled || std::exchange(requests_.cancel_work, false)) project_.cancel();
        ImGui::Render();
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    }

    // Where the widgets are, for who drives the window by name.
    void keep_rects() {
        if (rects_path_.empty() || widget_rects() == rects_) return;
        rects_ = widget_rects();
        std::string text;
        for (const WidgetRect& r : rects_)
            text += fmt::format("{:.0f} {:.0f} {:.0f} {:.0f} {}\n", r.left, r.top, r.right, r.bottom, r.name);
        write_atomically(rects_path_, text);
    }

    GLFWwindow* window_;
    gpu::Device device_;
    Session session_;
    Hand hand_;
    PanelState state_;
    std::string message_;
    double message_until_s_ = 0;
    int frames_left_ = 3;
    Project project_;
    std::string frame_log_path_;
    std::vector<FrameTimes> frames_;
    std::string rects_path_;
    std::vector<WidgetRect> rects_;
    PanelRequests requests_;
    bool closing_ = false;
    ViewSettings settings_;
    bool profiling_ = false;
    std::vector<gpu::PassTime> passes_;
    double passes_s_ = 0;
    bool first_picture_shown_ = false;

    glm::dvec2 mouse_{0};
    struct Typed {
        int key;
        int code;
        int action;
        int mods;
        unsigned letter;  // 0: it is a key
        bool waits;       // its shortcut was not looked at yet
    };
    std::vector<Typed> typed_;  // since the last frame
    bool refining_ = false;
    double last_s_ = 0;
    double frame_s_ = frame_goal_s;
    double rest_s_ = frame_goal_s / 2;  // a frame without its ticks, lately
    double scale_ = 1.0;
    bool moved_before_ = false;
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
    Window window(glfw, options, read_window_layout());
    window.loop();
}

}  // namespace talus
