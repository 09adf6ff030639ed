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
#include "app/outputs.h"
#include "app/panels/legend.h"
#include "app/panels/panels.h"
#include "app/recovery.h"
#include "app/report.h"
#include "app/session.h"
#include "app/shortcuts.h"
#include "app/sources.h"
#include "app/still.h"
#include "app/tools/hand.h"
#include "app/window_layout.h"
#include "app/work.h"
#include "sim/gpu/error.h"
#include "sim/gpu/program.h"
#include "sim/io/atomic_file.h"
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

// The window: its events, its frames, and what panels and keys ask of it.
class Window {
  public:
    Window(const Glfw& glfw, const WindowOptions& options, const WindowLayout& layout)
        : window_(glfw.open(options.size.value_or(layout.size), true)),
          device_(gpu::adopt_current_context("window")),
          session_(options.scene, device_),
          hand_(window_),
          journal_path_(options.journal),
          frame_log_path_(options.frame_log),
          rects_path_(options.ui_rects) {
        note(gpu::describe(device_));
        for (const std::string& guess : session_.scene().document.notes) note("note: " + guess);
        if (!recovery_.why().empty()) tell(recovery_.why());
        gpu::on_shader_message([this](const std::string& message) { tell(message); });
        listen();
        begin_panels(options.ui_scale);
        const std::vector<std::string> panels = panel_names();
        if (std::find(panels.begin(), panels.end(), layout.panel) != panels.end())
            state_.shown = layout.panel;
        state_.panels_shown = layout.panels_shown;
        state_.left = left_behind();
        // Who asks for nothing in particular is shown what there is; and unsaved work is offered to
        // everybody.
        state_.start_page =
            (options.scene.input.empty() && options.scene.preset.empty()) || !state_.left.empty();
        glm::ivec2 size(0);
        glfwGetFramebufferSize(window_, &size.x, &size.y);
        follow_area(size);
        session_.frame_terrain();
        title();
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
            attempt([&] { follow_recovery(); });
            attempt([&] { work_.poll(); });
            // At rest nothing is drawn and nothing presented.
            if (busy()) frame();
            if (glfwWindowShouldClose(window_) && !closing_) {
                glfwSetWindowShouldClose(window_, GLFW_FALSE);
                quit();
            }
        }
        session_.pause();
        if (!journal_path_.empty()) session_.write_journal_to(journal_path_);
        if (!frame_log_path_.empty()) write_atomically(frame_log_path_, to_csv(frames_));
        WindowLayout layout;
        glfwGetWindowSize(window_, &layout.size.x, &layout.size.y);
        layout.panel = state_.shown;
        layout.panels_shown = state_.panels_shown;
        keep_window_layout(layout);
        recovery_.end();
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
            if (action != GLFW_RELEASE)
                press_key(key, mods, self(w)->session_, self(w)->state_, self(w)->requests_);
            self(w)->typed_.push_back({key, code, action, mods, 0});
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
            self(w)->typed_.push_back({0, 0, 0, 0, letter});
        });
        glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double, double) { self(w)->wake(); });
        glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { self(w)->wake(); });
        glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) { self(w)->wake(); });
        glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { self(w)->wake(); });
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
               hand_.waits() || refining_ || work_.busy() || recovery_.busy();
    }
    void wake() { frames_left_ = 3; }
    void note(const std::string& message) {
        say(message);
        constexpr std::size_t most = 1000;
        if (state_.log.size() >= most) state_.log.erase(state_.log.begin());
        state_.log.push_back(message);
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

    void follow_recovery() {
        attempt([&] {
            recovery_.follow(session_.simulation(), session_.scene(), session_.path(), session_.unsaved(),
                             session_.revision(), session_.view().number("autosave.interval_s"));
        });
        if (const auto message = recovery_.take_message()) tell(*message);
    }

    // Does it, once unsaved work is saved or given up.
    void when_saved(const std::function<void()>& act) {
        if (work_.busy()) return tell(fmt::format("{} goes on: wait for it", work_.name()));
        if (!session_.unsaved()) return act();
        Question question;
        question.text = fmt::format("'{}' was changed and not saved. Save it first?", session_.scene().title);
        question.answers.emplace_back("Save", [this, act] {
            if (session_.path().empty()) {
                state_.dialog.begin(FileDialog::Purpose::save, "");
                after_saving_ = act;
                return;
            }
            save(session_.path(), act);
        });
        // What is dropped goes once the act has succeeded.
        question.answers.emplace_back("Drop the changes", act);
        question.answers.emplace_back("Cancel", [] {});
        state_.question = std::move(question);
        wake();
    }

    // Does it, once a file that is there and not the session's own may be replaced.
    void when_replaceable(const std::string& path, std::function<void()> act) {
        std::error_code ignored;
        if (path == session_.path() || !std::filesystem::exists(path, ignored)) return act();
        Question question;
        question.text = fmt::format("'{}' is there already. Replace it?", path);
        question.answers.emplace_back("Replace it", std::move(act));
        question.answers.emplace_back("Cancel", [] {});
        state_.question = std::move(question);
        wake();
    }

    void forget_recovered() {
        if (recovering_) forget(*recovering_);
        recovering_.reset();
        recovery_.forget_work();
    }

    // The layers are read now and written on a thread of their own; what is done meanwhile stays unsaved.
    void save(const std::string& path, const std::function<void()>& then) {
        session_.pause();
        auto document = std::make_shared<Document>(session_.document());
        const std::size_t revision = session_.revision();
        work_.start(
            fmt::format("Saving {}", path),
            [this, path, document, revision, then]() -> Work::Then {
                write_terrain(path, *document, "", std::nullopt);
                return [this, path, revision, then] {
                    session_.saved(path, revision);
                    forget_recovered();
                    if (!journal_path_.empty()) session_.write_journal_to(journal_path_);
                    tell(fmt::format("saved {}", path));
                    title();
                    if (then) then();
                };
            },
            false);
    }

    void open(const SceneRequest& wish) {
        const SceneRequest request = session_.request_for(wish);
        const auto left = std::find_if(state_.left.begin(), state_.left.end(),
                                       [&](const LeftBehind& one) { return one.document == request.input; });
        std::optional<LeftBehind> recovering;
        if (left != state_.left.end()) {
            recovering = *left;
        }
        const std::string name = request.input.empty() ? request.preset : request.input;
        work_.start(fmt::format("Opening {}", name), [this, request, recovering]() -> Work::Then {
            auto scene = std::make_shared<Scene>(make_scene(request));
            return [this, request, scene, recovering] {
                session_.open(request, std::move(*scene), !recovering);
                forget_recovered();
                if (recovering) session_.recovered(recovering->project, recovering->title);
                recovering_ = recovering;
                std::erase_if(state_.left, [&](const LeftBehind& one) {
                    return recovering && one.folder == recovering->folder;
                });
                for (const std::string& guess : session_.scene().document.notes) note("note: " + guess);
                title();
                wake();
            };
        });
    }

    void export_files(const ExportSettings& settings) {
        session_.pause();
        auto document = std::make_shared<Document>(session_.document());
        work_.start(fmt::format("Writing {}", settings.path.string()),
                    [this, settings, document]() -> Work::Then {
                        const Exported exported = export_terrain(*document, settings);
                        return [this, exported] {
                            tell(fmt::format("wrote {}{}", exported.files.front().string(),
                                             exported.files.size() > 1
                                                 ? fmt::format(" and {} more", exported.files.size() - 1)
                                                 : ""));
                            for (const auto& [name, value] : exported.values)
                                note(fmt::format("{}: {}", name, value));
                        };
                    });
    }

    // Acts on the whole map; those that take long are made ready on a thread.
    void act_on_map(const Operation& operation) {
        const auto* to = std::get_if<Resample>(&operation);
        if (!to) return session_.apply(operation);
        session_.pause();
        auto state = std::make_shared<TerrainState>(session_.simulation().read());
        work_.start(name_of(operation), [this, state, resample = *to]() mutable -> Work::Then {
            resample.made = std::make_shared<TerrainState>(resampled(*state, resample.nx, resample.ny));
            return [this, resample] {
                session_.apply(resample);
                title();
                wake();
            };
        });
    }

    void quit() {
        when_saved([this] {
            forget_recovered();
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
        const ViewSettings settings = view_settings(session_.view());
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
        if (work_.busy()) return;
        if (asked.import) {
            state_.import.offers_import = true;
            attempt([&] {
                if (is_document(*asked.import))
                    when_saved([this, path = *asked.import] {
                        SceneRequest request;
                        request.input = path;
                        state_.start_page = false;
                        open(request);
                    });
                else
                    state_.import.read(*asked.import);
            });
        }
        if (asked.import_into) attempt([&] { state_.import.read(*asked.import_into); });
        if (asked.open) when_saved([this, request = *asked.open] { open(request); });
        if (asked.save) {
            auto then = std::exchange(after_saving_, nullptr);
            when_replaceable(*asked.save,
                             [this, path = *asked.save, then] { attempt([&] { save(path, then); }); });
        }
        if (asked.stamp) attempt([&] { session_.apply(read_stamp(*asked.stamp, {})); });
        if (asked.write)
            when_replaceable(asked.write->path.string(),
                             [this, settings = *asked.write] { attempt([&] { export_files(settings); }); });
        if (asked.map) attempt([&] { act_on_map(*asked.map); });
        for (const auto& act : asked.acts) attempt([&] { act(session_); });
        if (asked.reset)
            when_saved([this] {
                attempt([&] {
                    session_.reset();
                    forget_recovered();
                    title();
                });
            });
        if (asked.undo) attempt([&] { session_.undo(); });
        if (asked.redo) attempt([&] { session_.redo(); });
        if (asked.framing) session_.frame_terrain();
        if (asked.picture) attempt([&] { save_picture(); });
        if (asked.quit) quit();
        if (asked.open || asked.save || asked.import_into || asked.reset || asked.undo || asked.redo ||
            asked.framing || asked.map || asked.import || asked.stamp || asked.write || !asked.acts.empty()) {
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
        const bool dialog = is_dialog_open(state_) || work_.busy();
        const HandMay may{!io.WantCaptureMouse && !dialog, !io.WantTextInput && !io.KeyCtrl && !dialog};
        const bool stroked = session_.stroking();
        FrameTimes times{now};
        const int dabs_before = session_.dabs();
        attempt([&] {
            hand_.placing_gauge = state_.placing_gauge;
            hand_.act(session_, mouse - glm::dvec2(area.corner), passed_s, area.size, may);
            state_.placing_gauge = hand_.placing_gauge;
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
        // A dialog that was closed without a name: what should have come after saving does not.
        if (state_.dialog.purpose == FileDialog::Purpose::none && !requests_.save) after_saving_ = nullptr;
        serve_requests();
        frame_s_ = glfwGetTime() - now;
    }

    void draw_picture(glm::dvec2 mouse, glm::ivec2 size, glm::ivec2 drawn_size, bool moving) {
        settings_ = view_settings(session_.view());
        settings_.quick = moving && scale_ < 0.6;
        if (hand_.cursor() && !ImGui::GetIO().WantCaptureMouse)
            settings_.ring_m = {hand_.cursor()->x, hand_.cursor()->y,
                                session_.view().number("brush.radius_m")};
        // A shader that does not compile is told, and the last picture stays.
        try {
            Terrain& terrain = session_.simulation().terrain();
            const Drawn drawn =
                session_.renderer().draw(terrain, session_.camera(), settings_, drawn_size.x, drawn_size.y);
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
        PanelContext context{session_, state_, requests_, work_};
        draw_panels(context, figures, size);
        bool cancelled = false;
        draw_work(work_, cancelled);
        if (cancelled) {
            work_.cancel();
            after_saving_ = nullptr;
        }
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
    Recovery recovery_;
    std::optional<LeftBehind> recovering_;  // what the session was recovered from, until it is saved
    std::string journal_path_;
    std::string frame_log_path_;
    std::vector<FrameTimes> frames_;
    std::string rects_path_;
    std::vector<WidgetRect> rects_;
    PanelState state_;
    PanelRequests requests_;
    std::function<void()> after_saving_;
    bool closing_ = false;
    ViewSettings settings_;
    bool profiling_ = false;
    std::vector<gpu::PassTime> passes_;
    double passes_s_ = 0;
    bool first_picture_shown_ = false;
    std::string message_;
    double message_until_s_ = 0;

    glm::dvec2 mouse_{0};
    struct Typed {
        int key;
        int code;
        int action;
        int mods;
        unsigned letter;  // 0: it is a key
    };
    std::vector<Typed> typed_;  // since the last frame
    bool refining_ = false;
    double last_s_ = 0;
    double frame_s_ = frame_goal_s;
    double rest_s_ = frame_goal_s / 2;  // a frame without its ticks, lately
    double scale_ = 1.0;
    bool moved_before_ = false;
    int frames_left_ = 3;
    Work work_;  // last: its thread ends before what it looks at goes
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
