#include "app/window/window.h"

#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "app/core/frame_log.h"
#include "app/core/frame_pacing.h"
#include "app/core/pass_times.h"
#include "app/core/picture_file.h"
#include "app/core/preparation.h"
#include "app/core/project.h"
#include "app/core/report.h"
#include "app/core/scene_events.h"
#include "app/core/session.h"
#include "app/core/window_layout.h"
#include "app/panels/legend.h"
#include "app/panels/marks.h"
#include "app/panels/panels.h"
#include "app/panels/rects_file.h"
#include "app/panels/style.h"
#include "app/window/glfw.h"
#include "app/window/hand.h"
#include "app/window/panel_input.h"
#include "app/window/recorder.h"
#include "app/window/shortcuts.h"
#include "app/window/tick_wait.h"
#include "sim/error.h"
#include "sim/gpu/shader_text.h"
#include "sim/gpu/window.h"
#include "sim/io/atomic_file.h"
#include "sim/terrain/state_hash.h"

namespace talus::app {
namespace {

// The window: its events, its frames, and what panels and keys ask of it.
class Window {
  public:
    Window(const Glfw& glfw, const WindowOptions& options, const WindowLayout& layout)
        : window_(glfw.open(options.size.value_or(layout.size), true)),
          device_(gpu::adopt_current_context("window")),
          session_(options.scene, device_),
          hand_(window_),
          input_(window_,
                 [this](const InputEvents::Key& key) {
                     // A dialog would be about a scene that may be another one when the work ends.
                     if ((key.mods & GLFW_MOD_CONTROL) != 0 && waits_for_work()) return;
                     press_key({key.key, key.mods, key.action == GLFW_REPEAT}, session_, state_, requests_);
                 }),
          project_(session_, state_, options.journal,
                   {[this](const std::string& message) { tell(message); },
                    [this](const std::string& message) { note(message); },
                    [this] {
                        title();
                        wake();
                    },
                    [this] {
                        picture_drawn_ = false;
                        state_.write.settings.path.clear();
                        // Other panels may be there now.
                        state_.only_looks = session_.overflight() != nullptr;
                        glm::ivec2 size(0);
                        glfwGetFramebufferSize(window_, &size.x, &size.y);
                        follow_area(size);
                        if (!session_.keeps_camera()) session_.frame_terrain();
                        resume_panels();
                        note_start();
                    }}),
          preparation_(session_, [this](const std::string& message) { note(message); }),
          frame_log_path_(options.frame_log),
          rects_{options.ui_rects} {
        note(gpu::describe(device_));
        for (const std::string& guess : session_.scene().document.notes) note("note: " + guess);
        gpu::on_shader_message([this](const std::string& message) { tell(message); });
        listen();
        begin_panels(options.ui_scale);
        state_.keys = key_lines();
        set_theme(options.theme.empty() ? layout.theme : options.theme);
        const std::vector<std::string> panels = panel_names();
        if (std::find(panels.begin(), panels.end(), layout.panel) != panels.end())
            state_.shown = layout.panel;
        state_.panels_shown = layout.panels_shown;
        state_.tools_side = layout.tools_side;
        state_.panels_side = layout.panels_side;
        // The start page opens where nothing was named; a file that was named is not covered by it.
        state_.start_page = options.scene.input.empty() && options.scene.preset.empty();
        if (!state_.start_page && !state_.left.empty())
            tell("an earlier session ended with unsaved work: File > Start page offers it");
        glm::ivec2 size(0);
        glfwGetFramebufferSize(window_, &size.x, &size.y);
        state_.only_looks = session_.overflight() != nullptr;
        resume_panels();
        follow_area(size);
        if (!session_.keeps_camera()) session_.frame_terrain();
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
            // Before busy(), which sees a tile that comes between the two calls.
            const bool awaits_tiles = session_.awaits_tiles();
            if (busy())
                glfwPollEvents();
            else
                glfwWaitEventsTimeout(awaits_tiles ? 0.01 : 0.3);
            if (gpu::poll_shader_folder()) {
                session_.forget_picture();
                wake();
            }
            if (!message_.empty() && glfwGetTime() >= message_until_s_) {
                message_.clear();
                wake();
            }
            // What fails costs a frame, never the work: it is told, and the window goes on.
            attempt([&] { session_.poll(); });
            attempt([&] { project_.poll(); });
            follow_preparation();
            if (const auto message = session_.take_message()) tell(*message);
            if (const auto message = recorder_.take_message()) tell(*message);
            // At rest nothing is drawn and nothing presented.
            if (busy()) frame();
            if (glfwWindowShouldClose(window_) && !closing_) {
                glfwSetWindowShouldClose(window_, GLFW_FALSE);
                quit();
            }
        }
        recorder_.finish();
        if (const auto message = recorder_.take_message()) note(*message);
        // A tick that is half done is not waited for, and in no journal.
        session_.playing = false;
        project_.write_journal();
        if (!frame_log_path_.empty()) io::write_atomically(frame_log_path_, to_csv(frames_));
        WindowLayout layout;
        glfwGetWindowSize(window_, &layout.size.x, &layout.size.y);
        layout.panel = state_.shown;
        layout.panels_shown = state_.panels_shown;
        layout.tools_side = state_.tools_side;
        layout.panels_side = state_.panels_side;
        layout.theme = theme().name;
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
            const bool typing = is_dialog_open(self(w)->state_) || ImGui::GetIO().WantTextInput;
            self(w)->input_.hear_key({key, code, action, mods}, typing);
        });
        glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int mouse_button, int action, int) {
            self(w)->wake();
            self(w)->input_.hear_button(mouse_button, action);
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
            self(w)->input_.hear_letter(letter);
        });
        glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double, double) { self(w)->wake(); });
        glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { self(w)->wake(); });
        glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) { self(w)->wake(); });
        glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { self(w)->wake(); });
    }

    void begin_panels(double scale) {
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        ImGui::GetIO().ConfigWindowsMoveFromTitleBarOnly = true;
        ImGui::GetIO().ConfigDragClickToInputText = true;
        float asked = 1;
        glfwGetWindowContentScale(window_, &asked, nullptr);
        const float used = scale > 0 ? static_cast<float>(scale) : std::clamp(asked, 1.0F, 4.0F);
        set_style(used);
        // The callbacks above pass on what it needs.
        ImGui_ImplGlfw_InitForOpenGL(window_, false);
        ImGui_ImplOpenGL3_Init("#version 450 core");
    }

    // Those that the project was saved with.
    void resume_panels() {
        const Workspace& kept = session_.scene().workspace;
        if (kept.panel.empty()) return;
        state_.shown = kept.panel;
        state_.panels_shown = kept.panels_shown;
    }
    // What the panels leave to the picture.
    void follow_area(glm::ivec2 size) {
        area_ = picture_area(state_, size);
        session_.picture_aspect = static_cast<double>(area_.size.x) / area_.size.y;
    }

    bool busy() const {
        return session_.playing || session_.mid_tick() || session_.stroking() || pacing_.is_awake() ||
               hand_.moving() || state_.fresh.waits() || hand_.waits() || refining_ ||
               (state_.dialog.desktop && state_.dialog.desktop->is_heard()) || project_.busy() ||
               session_.has_tiles() || session_.awaits_readbacks();
    }
    void wake() { pacing_.wake(); }
    void note(const std::string& message) {
        say(message);
        constexpr std::size_t most = 1000;
        if (state_.log.size() >= most) state_.log.erase(state_.log.begin());
        state_.log.push_back(message);
    }
    // Test scripts that drive the window by widget names check that undo restores this hash.
    void note_start() {
        if (rects_.path.empty()) return;
        note(fmt::format("begun with hash {:016x}", state_hash(session_.simulation().read())));
    }
    void tell(const std::string& message) {
        note(message);
        message_ = message;
        message_until_s_ = glfwGetTime() + 6;
        wake();
    }
    void title() {
        titled_unsaved_ = session_.unsaved();
        glfwSetWindowTitle(
            window_,
            fmt::format("{}{} - Talus", session_.scene().title, titled_unsaved_ ? " *" : "").c_str());
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

    // What fails behind somebody's back does not stop what he does.
    void follow_preparation() {
        try {
            preparation_.poll();
        } catch (const std::exception& error) {
            tell(fmt::format("talus: {}", error.what()));
        }
        if (preparation_.take_progress()) wake();
    }

    void quit() {
        project_.when_saved([this] {
            closing_ = true;
            glfwSetWindowShouldClose(window_, GLFW_TRUE);
        });
    }

    // Says so where it does.
    bool waits_for_work() {
        const bool busy = project_.work().busy();
        if (busy) tell(fmt::format("{} goes on: wait for it", project_.work().name()));
        return busy;
    }

    // What needs no whole tick.
    void serve_at_once() {
        for (auto next = requests_.parameters.begin(); next != requests_.parameters.end();) {
            if (session_.is_simulated(next->first)) {
                ++next;
                continue;
            }
            attempt([&] { set(next->first, next->second.value); });
            next = requests_.parameters.erase(next);
            wake();
        }
        if (std::exchange(requests_.framing, false)) session_.frame_terrain();
        if (std::exchange(requests_.picture, false))
            attempt([&] { tell(fmt::format("saved the picture {}", save_picture(session_, area_.size))); });
        if (std::exchange(requests_.record, false)) attempt([&] { recorder_.toggle(session_, area_.size); });
        if (requests_.answer && requests_.answer_at_once) {
            const auto answer = std::exchange(requests_.answer, nullptr);
            attempt(answer);
            title();
            wake();
        }
    }

    void set(const std::string& name, const std::optional<Value>& value) {
        if (value)
            session_.set(name, *value);
        else
            session_.unset(name);
    }

    void serve_requests() {
        const bool works = project_.work().busy();
        if (!works) serve_at_once();
        if (!requests_.any() && !tick_wait_.holds_undo()) tick_wait_.forget();
        if (!works && (requests_.any() || tick_wait_.holds_undo()) &&
            !tick_wait_.is_over(session_, requests_)) {
            if (std::exchange(requests_.quit, false)) quit();
            return;
        }
        PanelRequests asked;
        std::swap(asked, requests_);
        // Long work has the session to itself.
        if (asked.any() ? waits_for_work() : project_.work().busy()) return;
        if (!serve_acts(asked)) {
            requests_ = std::move(asked);
            return title();
        }
        if (asked.answer) attempt(asked.answer);
        attempt([&] { project_.serve(asked); });
        if (project_.work().busy()) return title();
        if (asked.quit) quit();
        if (asked.any()) {
            title();
            wake();
        }
    }

    // Acts in their order, with what was set between them. False: one began a tick, and what is behind it
    // waits for its end.
    bool serve_acts(PanelRequests& asked) {
        std::size_t done = 0;
        const auto set_until = [&](std::size_t acts) {
            for (auto next = asked.parameters.begin(); next != asked.parameters.end();) {
                if (next->second.after_acts > acts) {
                    ++next;
                    continue;
                }
                attempt([&] { set(next->first, next->second.value); });
                next = asked.parameters.erase(next);
            }
        };
        const auto comes_to_end = [&] { return done == asked.acts.size(); };
        while (!session_.mid_tick() && !comes_to_end()) {
            set_until(done);
            attempt([&] { asked.acts[done](session_); });
            ++done;
        }
        if (session_.mid_tick()) {
            asked.acts.erase(asked.acts.begin(), asked.acts.begin() + static_cast<std::ptrdiff_t>(done));
            for (auto& one : asked.parameters) one.second.after_acts -= std::min(done, one.second.after_acts);
            return false;
        }
        set_until(std::numeric_limits<std::size_t>::max());
        if (asked.undo) attempt([&] { session_.undo(); });
        if (asked.redo) attempt([&] { session_.redo(); });
        return true;
    }

    // Milliseconds.
    bool shows(const char* panel) const {
        return state_.panels_shown && !state_.panels_side.folded && state_.shown == panel;
    }
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
        state_.only_looks = session_.overflight() != nullptr;
        if (state_.placing && (state_.only_looks || !shows(panel_of(*state_.placing))))
            state_.placing.reset();
        if (state_.drawing && (state_.only_looks || !shows_what_draws(*state_.drawing)))
            state_.drawing.reset();
        const bool draws_path = state_.drawing_path && !state_.only_looks && shows("Paths");
        state_.choosing_part = state_.choosing_part && state_.only_looks && shows("Cut out");
        follow_area(size);

        const ImGuiIO& io = ImGui::GetIO();
        const bool dialog = is_dialog_open(state_) || project_.work().busy();
        const bool stroked = session_.stroking();
        // A stroke, or a drag, goes on while keys are heard.
        const HandMay may{
            !io.WantCaptureMouse && !dialog && (stroked || !input_.waits()),
            !io.WantTextInput && !io.KeyCtrl && !dialog && state_.keyboard_in == KeyboardIn::picture};
        FrameTimes times{now};
        const int dabs_before = session_.sculpting().dabs();
        HandDone done;
        attempt([&] {
            hand_.act(
                session_, mouse - glm::dvec2(area_.corner), passed_s, area_.size, may,
                {state_.placing, state_.drawing, draws_path, state_.choosing_part, mark_under_mouse(), done});
        });
        take_up(done);
        if (stroked && !session_.stroking()) title();
        times.act_ms = since(now);
        times.dabs = session_.sculpting().dabs() - dabs_before;
        if (times.dabs > 0) times.waited_ms = 1000 * session_.sculpting().dabs_waited_s();
        if (session_.playing && !tick_wait_.waits())
            attempt([&] { session_.play(passed_s, pacing_.ticks_budget_s()); });
        else if (session_.mid_tick() && !tick_wait_.waits())
            tick_wait_.go_on(session_, pacing_.ticks_budget_s());
        // A tick that ends by itself is unsaved work too.
        if (std::exchange(titled_revision_, session_.revision()) != session_.revision() && !titled_unsaved_)
            title();
        session_.follow_gauges();
        if (shows("Paths")) attempt([&] { session_.follow_path(); });
        if (auto times_of = pass_times_.follow(shows("Profiler"), passed_s)) {
            state_.passes = std::move(times_of->passes);
            state_.passes_s = times_of->span_s;
        }

        const bool moving = session_.playing || session_.stroking() || hand_.moving();
        const double used = pacing_.picture_scale(moving, hand_.camera_moved());
        const glm::ivec2 drawn_size = glm::max(glm::ivec2(glm::dvec2(area_.size) * used), 1);
        pacing_.begin(moving);
        times.scale = used;
        times.play_ms = since(now) - times.act_ms;
        draw_picture(mouse - glm::dvec2(area_.corner), area_.size, drawn_size, moving);
        times.picture_ms = since(now) - times.total_ms();
        draw_window(size, drawn_size, used);
        times.panels_ms = since(now) - times.total_ms();
        glfwSwapBuffers(window_);
        times.present_ms = since(now) - times.total_ms();
        pacing_.took((times.total_ms() - times.play_ms) / 1000);
        if (!frame_log_path_.empty()) frames_.push_back(times);
        if (!std::exchange(first_picture_shown_, true))
            note(fmt::format("first picture after {:.2f} s", seconds_since_start()));
        rects_.keep();
        serve_requests();
        frame_s_ = glfwGetTime() - now;
    }

    // What a drag moves that begins where the mouse is: of what the panel lists that is open.
    std::optional<MarkUnderMouse> mark_under_mouse() const {
        const std::optional<MarkUnderMouse> mark = marks_.under(mouse_, session_.camera(), hand_.cursor());
        const bool is_listed = mark && shows(panel_of(mark->at.mark.kind));
        return is_listed && !state_.only_looks ? mark : std::nullopt;
    }
    // That lists what is of this kind.
    static const char* panel_of(MarkKind kind) { return kind == MarkKind::gauge ? "Gauges" : "Water"; }

    // Whether a panel is open that has it drawn.
    bool shows_what_draws(MapDrag what) const {
        if (what == MapDrag::mask) return shows("Mask") || shows("Erosion");
        return shows(what == MapDrag::section ? "Gauges" : "Tables");
    }

    // As acts, which wait for the end of a tick.
    void take_up(const HandDone& done) {
        auto& acts = requests_.acts;
        if (done.drawn)
            acts.emplace_back([drawn = *done.drawn, limits = shows("Erosion")](Session& s) {
                const auto& [from, to] = drawn.corners;
                if (drawn.what == MapDrag::mask)
                    s.mask_rectangle(from, to, limits);
                else if (drawn.what == MapDrag::section)
                    s.place_section(from, to);
                else
                    add_breach(s, from, to);
            });
        if (done.placed)
            acts.emplace_back([placed = *done.placed](Session& s) {
                if (placed.kind == MarkKind::gauge)
                    s.gauges().place(placed.place_m);
                else
                    place_spring(s, placed.place_m);
            });
        if (!done.moved) return;
        const std::size_t index = done.moved->mark.index;
        const std::vector<Spring>& springs = session_.simulation().springs();
        if (done.moved->mark.kind == MarkKind::gauge)
            acts.emplace_back([index, to = done.moved->place_m](Session& s) { s.gauges().move(index, to); });
        else if (index < springs.size())
            acts.emplace_back([spring = springs[index], to = done.moved->place_m](Session& s) {
                move_spring(s, spring, to);
            });
    }

    void draw_picture(glm::dvec2 mouse, glm::ivec2 size, glm::ivec2 drawn_size, bool moving) {
        attempt([&] { session_.follow_scale(); });
        settings_ = render::view_settings(session_.view(), session_.simulation().parameters());
        settings_.quick = moving && pacing_.is_late();
        // Parallel rays are cast whatever the method is (render/methods/parallel.h), and the legend says so.
        if (session_.camera().is_parallel()) settings_.method = "exact";
        // A shader that does not compile is told, and the last picture stays.
        try {
            render::Ring ring;
            const bool sculpts = !state_.placing && !state_.drawing &&
                                 !(state_.drawing_path && shows("Paths")) && !mark_under_mouse() &&
                                 !hand_.held_mark();
            if (hand_.cursor() && sculpts && !ImGui::GetIO().WantCaptureMouse && !session_.overflight())
                ring = session_.ring(*hand_.cursor());
            const render::Drawn drawn = session_.draw(settings_, drawn_size, ring);
            picture_drawn_ = true;
            hand_.look(session_, mouse, size, drawn_size, drawn != render::Drawn::nothing);
            // At rest the picture gathers samples, one a frame; while somebody works at the panels they come
            // first.
            if (!moving && !pacing_.is_awake() && !session_.awaits_tiles() && !ImGui::IsAnyItemActive())
                refining_ = session_.refine();
            else
                refining_ =
                    !pacing_.is_awake() && refining_ && !session_.awaits_tiles() && !ImGui::IsAnyItemActive();
            session_.outline_part(shows("Cut out"), drawn_size);
        } catch (const std::exception& error) {
            refining_ = false;
            if (message_ != error.what()) tell(error.what());
        }
    }

    void draw_window(glm::ivec2 size, glm::ivec2 drawn_size, double used) {
        gpu::bind_window({0, 0, size.x, size.y});
        // The window counts rows from below.
        if (picture_drawn_)
            session_.framebuffer().blit_to_window(
                {0, 0, drawn_size.x, drawn_size.y},
                {area_.corner.x, size.y - area_.corner.y - area_.size.y, area_.size.x, area_.size.y});
        if (picture_drawn_)
            recorder_.follow(
                session_, settings_,
                {area_.corner.x, size.y - area_.corner.y - area_.size.y, area_.size.x, area_.size.y});
        state_.recording = recorder_.state();
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        if (input_.pass()) wake();
        ImGui::NewFrame();
        marks_.draw(session_, area_, drawn_size, size,
                    {hand_.drawn(), shows("Paths"), shows("Tables"), hand_.held_mark()});
        draw_scale_bar(session_.camera(), area_);
        // Over a panel or a dialog the mouse is nowhere on the ground.
        const bool points = !ImGui::GetIO().WantCaptureMouse && !is_dialog_open(state_);
        StatusFigures figures{device_.renderer, glfwGetTime() < message_until_s_ ? message_ : "",
                              points ? hand_.cursor() : std::nullopt, frame_s_ * 1000, used};
        draw_legend(session_.legends(settings_), area_.corner.x + area_.size.x,
                    area_.corner.y + area_.size.y);
        PanelContext context{session_, state_, requests_, project_.work()};
        draw_panels(context, figures, size);
        bool cancelled = false;
        draw_work(project_.work(), cancelled);
        bool stopped = false;
        draw_preparation(preparation_.work(), area_, stopped);
        if (stopped) preparation_.give_up();
        if (cancelled || std::exchange(requests_.cancel_work, false)) project_.cancel();
        ImGui::Render();
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    }

    GLFWwindow* window_;
    gpu::Device device_;
    Session session_;
    Hand hand_;
    PanelInput input_;
    PanelState state_;
    std::string message_;
    double message_until_s_ = 0;
    FramePacing pacing_;
    Recorder recorder_;
    Project project_;
    Preparation preparation_;
    std::string frame_log_path_;
    std::vector<FrameTimes> frames_;
    RectsFile rects_;
    PanelRequests requests_;
    TickWait tick_wait_{[this](const std::string& message) { tell(message); }};
    std::size_t titled_revision_ = 0;
    bool titled_unsaved_ = false;
    bool closing_ = false;
    render::ViewSettings settings_;
    PictureArea area_;  // what the panels leave to the picture
    Marks marks_;
    PassTimes pass_times_;
    bool first_picture_shown_ = false;
    bool picture_drawn_ = false;  // of the scene that is open

    glm::dvec2 mouse_{0};
    bool refining_ = false;
    double last_s_ = 0;
    double frame_s_ = 1.0 / 30;
};

}  // namespace

void run_window(const WindowOptions& options) {
    const Glfw glfw;
    Window window(glfw, options, read_window_layout());
    window.loop();
}

}  // namespace talus::app
