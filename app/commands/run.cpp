#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "app/commands/commands.h"
#include "app/core/gauges.h"
#include "app/core/outputs.h"
#include "app/core/sections.h"
#include "app/core/sources.h"
#include "app/core/wave_note.h"
#include "sim/error.h"
#include "sim/gpu/fence.h"
#include "sim/io/atomic_file.h"
#include "sim/terrain/state_hash.h"

namespace talus::app {
namespace {

using Clock_ = std::chrono::steady_clock;
constexpr std::int64_t default_ticks = 600;

double seconds_since(Clock_::time_point start) {
    return std::chrono::duration<double>(Clock_::now() - start).count();
}

// A line on stderr that says how far a run is: a bar on a terminal, a line every tenth elsewhere.
class RunProgress {
  public:
    explicit RunProgress(std::int64_t total) : total_(total), terminal_(isatty(STDERR_FILENO) != 0) {}
    void show(std::int64_t done) {
        const std::int64_t tenth = 10 * done / total_;
        if (terminal_ ? (done < total_ && seconds_since(last_) < 0.1) : tenth == tenth_) return;
        last_ = Clock_::now();
        tenth_ = tenth;
        const auto filled = static_cast<int>(3 * 10 * done / total_);
        fmt::print(stderr, "{}[{}{}] {} of {}{}", terminal_ ? "\r" : "", std::string(filled, '='),
                   std::string(30 - filled, ' '), done, total_, !terminal_ || done == total_ ? "\n" : "");
    }

  private:
    std::int64_t total_;
    bool terminal_;
    std::int64_t tenth_ = 0;
    Clock_::time_point last_{};
};

void follow_tables(Simulation& simulation, const std::vector<TableOption>& tables) {
    std::vector<std::string> followed;
    for (const TableOption& table : tables) try {
            const std::string& name = simulation.parameters().declaration(table.drive.parameter).name;
            if (std::find(followed.begin(), followed.end(), name) != followed.end())
                throw Error(fmt::format("--drive gives {} a second table, a number follows one", name));
            followed.push_back(name);
            simulation.apply(table.drive);
        } catch (const Error& error) {
            throw Error(fmt::format("'{}': {}", table.file, error.what()));
        }
}

void take_rasters(Simulation& simulation, const std::vector<RasterOption>& rasters) {
    for (const RasterOption& raster : rasters) {
        const ReadRaster read = read_raster(raster.number, raster.file, simulation.terrain().grid(),
                                            simulation.moment_state().georeference);
        for (const std::string& note : read.notes) say("note: " + note);
        simulation.apply(read.take);
    }
}

void say_notes(const Scene& scene) {
    for (const std::string& note : scene.document.notes) say("note: " + note);
}

// What a run writes beside its terrain: what fails takes none of the others with it.
class Failures {
  public:
    template <typename Do>
    bool attempt(Do&& act) {
        try {
            act();
            return true;
        } catch (const Error& error) {
            text_ += (text_.empty() ? "" : "; ") + std::string(error.what());
            return false;
        }
    }
    /// Throws talus::Error of all that failed.
    void tell() const {
        if (!text_.empty()) throw Error(text_);
    }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

// The recording of a run, if there is one. Should it fail, the run goes on without it.
class RunRecording {
  public:
    RunRecording(const RecordingOptions& options, const Scene& scene, Simulation& simulation,
                 const gpu::Device& device, std::int64_t ticks) {
        if (options.files.empty() && options.image.empty() && options.film.empty()) return;
        timed([&] { recording_.emplace(options, scene, simulation, device, ticks); });
    }
    void record(Failures& failures) {
        if (!recording_ || !goes_on_ || !recording_->is_due()) return;
        goes_on_ = failures.attempt([&] { timed([&] { recording_->write(); }); });
        if (!goes_on_) say("note: the recording ends here: " + failures.text());
    }
    // A film that ends early is completed all the same.
    void finish(Failures& failures) {
        if (!recording_) return;
        const bool done = failures.attempt([&] { timed([&] { recording_->finish(); }); });
        if (done)
            say(fmt::format("{} records were written, every {:g} s", recording_->count(),
                            recording_->every_s()));
    }
    // What it took.
    double wall_s() const { return wall_s_; }
    double cpu_s() const { return cpu_s_; }

  private:
    template <typename Do>
    void timed(Do&& act) {
        // The device first does the ticks that it was sent.
        gpu::Fence::now().wait();
        const auto start = Clock_::now();
        const double cpu_start = process_cpu_s();
        act();
        wall_s_ += seconds_since(start);
        cpu_s_ += process_cpu_s() - cpu_start;
    }

    std::optional<Recording> recording_;
    bool goes_on_ = true;
    double wall_s_ = 0;
    double cpu_s_ = 0;
};

// Files and picture whose names number them are written on the way, the others at the end.
void record_series(RunOptions& options) {
    Outputs& outputs = options.outputs;
    RecordingOptions& recording = options.recording;
    const auto single = std::stable_partition(outputs.files.begin(), outputs.files.end(), is_series);
    recording.files.assign(outputs.files.begin(), single);
    outputs.files.erase(outputs.files.begin(), single);
    if (is_series(outputs.image)) recording.image = std::exchange(outputs.image, "");
    recording.layer = outputs.layer;
}

}  // namespace

void run(const RunOptions& asked) {
    RunOptions options = asked;
    record_series(options);
    check_outputs(asked.outputs);
    check_recording(options.recording);
    if (!options.gauges.empty()) check_folder(options.gauge_table);
    if (!options.sections.empty()) check_folder(options.section_table);
    const gpu::Context context(options.gpu);
    say(gpu::describe(context.device()));
    Scene scene = make_scene(options.scene);
    say_notes(scene);
    const std::string waves = wave_note(scene.document.state, scene.simulation);
    if (!waves.empty()) say(waves);
    scene.start.hash = state_hash(scene.document.state);
    std::int64_t ticks = options.ticks.value_or(default_ticks);
    if (options.time_s) {
        const double needed = std::ceil(*options.time_s / scene.simulation.number("time.tick_s") - 1e-9);
        if (needed > 1e9)
            throw Error(fmt::format("--time {} takes {:.3g} ticks of time.tick_s = {} s, at most 1e9 are run",
                                    *options.time_s, needed, scene.simulation.number("time.tick_s")));
        ticks = static_cast<std::int64_t>(needed);
    }
    const auto start = Clock_::now();
    const double cpu_start = process_cpu_s();
    Gauges gauges(scene.document.state.grid);
    for (const glm::dvec2 place : options.gauges) gauges.place(place);
    Simulation simulation(scene.document.state, scene.simulation);
    for (const Spring& spring : options.springs) simulation.apply(spring);
    take_rasters(simulation, options.rasters);
    follow_tables(simulation, options.tables);
    if (!gauges.all().empty()) gauges.record(simulation.terrain(), simulation.clock().simulated_s);
    Sections sections;
    for (const Section& section : options.sections) sections.place(simulation, section);
    if (!sections.all().empty()) sections.record(simulation);
    Failures failures;
    RunRecording recording(options.recording, scene, simulation, context.device(), ticks);
    RunProgress progress(ticks);
    for (std::int64_t done = 0; done < ticks; ++done) {
        simulation.apply(Ticks{1});
        recording.record(failures);
        if (!sections.all().empty()) sections.record(simulation);
        if (!gauges.all().empty()) gauges.record(simulation.terrain(), simulation.clock().simulated_s);
        progress.show(done + 1);
    }
    recording.finish(failures);
    if (!gauges.all().empty() &&
        failures.attempt([&] { io::write_atomically(options.gauge_table, gauges.to_csv()); }))
        say(fmt::format("what the gauges showed is in {}", options.gauge_table));
    if (!sections.all().empty() &&
        failures.attempt([&] { io::write_atomically(options.section_table, sections.to_csv()); }))
        say(fmt::format("what passed the sections is in {}", options.section_table));
    const RunFigures figures{context.device(), ticks, seconds_since(start) - recording.wall_s(),
                             process_cpu_s() - cpu_start - recording.cpu_s()};
    failures.attempt([&] { write_outputs(options.outputs, scene, simulation, figures); });
    failures.tell();
}

void replay(const ReplayOptions& options) {
    check_outputs(options.outputs);
    std::vector<std::string> files = options.outputs.files;
    files.push_back(options.outputs.image);
    for (const std::string& file : files)
        if (is_series(file))
            throw Error(
                fmt::format("'{}' numbers files, which 'talus run --every' writes: give one name", file));
    const JournalFile journal = read_journal(io::read_text(options.journal), options.journal);
    const gpu::Context context(options.gpu);
    say(gpu::describe(context.device()));
    Scene scene = make_scene(journal, options.journal, options.size);
    const auto start = Clock_::now();
    const double cpu_start = process_cpu_s();
    Simulation simulation(scene.document.state, scene.simulation);
    const Grid& grid = scene.document.state.grid;
    glm::dvec2 ratio = glm::dvec2(grid.nx - 1, grid.ny - 1) / glm::dvec2(scene.recorded_samples - 1);
    RunProgress progress(static_cast<std::int64_t>(journal.operations.size()));
    std::int64_t done = 0;
    for (Operation operation : journal.operations) {
        read_sources(operation, simulation, !options.size);
        if (options.size) rescale(operation, ratio);
        if (const auto* turn = std::get_if<Turn>(&operation); turn && turn->quarters % 2 != 0)
            std::swap(ratio.x, ratio.y);
        simulation.apply(operation);
        progress.show(++done);
    }
    const RunFigures figures{context.device(), simulation.clock().ticks - scene.document.state.clock.ticks,
                             seconds_since(start), process_cpu_s() - cpu_start};
    write_outputs(options.outputs, scene, simulation, figures);
}

}  // namespace talus::app
