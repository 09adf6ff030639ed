#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/book_copies.h"
#include "sim/gpu/readback.h"
#include "sim/journal.h"
#include "sim/ledger.h"
#include "sim/moment.h"
#include "sim/operation.h"
#include "sim/parameters.h"
#include "sim/passes/pass.h"
#include "sim/terrain/terrain.h"
#include "sim/undo.h"

namespace talus {

/// The terrain and all that changes it. Every change comes in as an Operation and is recorded; window,
/// command line and replay differ in nothing else.
///
///     Simulation simulation(state, parameters);
///     simulation.apply(Ticks{300});
///     const std::uint64_t hash = state_hash(simulation.read());
class Simulation {
  public:
    /// undo_bytes 0: no undo, as in headless runs.
    Simulation(const TerrainState& state, const Parameters& parameters, std::size_t undo_bytes = 0);

    /// Another number for every terrain that took the place of the one before: whoever keeps something of its
    /// size makes it anew.
    int terrain_number() const { return terrain_number_; }
    /// None took the place of the one that it was made with.
    bool stands_on_its_first_terrain() const { return terrain_number_ == 0; }
    Terrain& terrain() { return terrain_; }
    const Terrain& terrain() const { return terrain_; }
    const Parameters& parameters() const { return moment_.parameters; }
    const Clock& clock() const { return moment_.clock; }
    const Journal& journal() const { return journal_; }

    /// Does it and records it. Throws talus::Error, with nothing changed, for a parameter that cannot be set
    /// so, for a spring off the map, for a table that no parameter can follow, for a terrain that cannot be,
    /// and while a tick is half done for anything but ticks.
    void apply(const Operation& operation);

    /// A tick in parts: runs up to `substeps` sub-steps of the present tick, or of the next one, and says
    /// whether a tick was completed (and recorded).
    bool advance(int substeps);
    bool mid_tick() const { return in_tick_; }
    /// Sub-steps that advance() sent to the device so far. Does not wait.
    std::uint64_t substeps_sent() const;

    /// A stroke is one entry of undo; ticks between belong to it.
    void begin_stroke(const std::string& name);
    /// Ends a stroke or a run of ticks.
    void end_entry();
    bool can_undo() const { return undo_.can_undo(); }
    bool can_redo() const { return undo_.can_redo(); }
    const Undo& undo_history() const { return undo_; }
    /// Moves on what undo packs behind the acts' back, without waiting. Once a frame.
    void poll_undo() { undo_.poll(); }
    /// Waits for that.
    void settle_undo() { undo_.settle(); }
    void set_undo_capacity(std::size_t bytes) { undo_.set_capacity(bytes); }
    /// To the bit: layers, residual words, clock, parameters, ledger, journal. A half done tick is completed
    /// first.
    void undo();
    void redo();
    /// Takes back all since the open entry of undo began, and leaves a tick that is half done; it cannot be
    /// redone. For a tick that takes longer than anybody waits, and for acts of which only some could be
    /// done.
    void take_back_entry();

    /// Waits for the device.
    LedgerReading ledger();
    /// Asks for it without waiting, between ticks; poll_ledger() gives it once it is there.
    void ask_ledger();
    std::optional<LedgerReading> poll_ledger();
    bool awaits_ledger() const { return asked_.sums.pending(); }
    const std::vector<Spring>& springs() const { return moment_.springs; }
    const std::vector<Drive>& drives() const { return moment_.drives; }
    const std::vector<Event>& events() const { return moment_.events; }
    /// What dabs of a stamp press; none: nothing was chosen.
    const std::shared_ptr<const Stamp>& stamp() const { return moment_.stamp; }
    /// From now on the water that passes these sections is counted; it changes nothing. One that was there
    /// goes on counting. Another terrain has none. Throws talus::Error where one lies off the map; then it
    /// goes on with those it had.
    void follow_sections(const std::vector<Section>& sections);
    /// What passed each so far, m³, to the right of its line as positive; undo takes it back. Waits for the
    /// device.
    std::vector<double> section_volumes_m3() const;
    /// Asks for that without waiting, between ticks; poll_section_volumes() gives it once it is there.
    void ask_section_volumes();
    std::optional<std::vector<double>> poll_section_volumes();
    /// What the pass of this name did so far. Waits for the device. Throws talus::Error where there is none.
    PassWork work(const std::string& pass) const;
    /// The whole state. Waits for the device.
    TerrainState read() const;
    /// The state but for its layers: what read() adds to them, without waiting.
    TerrainState moment_state() const;

  private:
    void act(const SetParameter& set);
    void act(const PlaceSpring& spring);
    void act(const DriveParameter& drive);
    void act(const SetEvents& set);
    void act(const Dab& dab);
    void act(const Resample& to);
    void act(const Crop& crop);
    void act(const Turn& turn);
    void act(const Import& import);
    void act(const ChooseStamp& choose);
    void act(const MakeMask& make);
    void act(const Blur& blur);
    void act(const TakeRaster& take);
    void act_by_pass(const PassAct& act);
    /// As name_of(), with parameters by their labels and values.
    std::string history_name(const Operation& operation) const;
    /// Does `change` as an entry of undo, or as part of the open one, and records the operation.
    template <typename Change>
    void record(const Operation& operation, Change&& change);
    /// A terrain with what is made for it.
    struct Site;
    /// Another terrain in place of this one, recorded as the operation.
    void replace_terrain(const Operation& operation, const TerrainState& next, Parameters parameters);
    void stand_on(Site site);
    /// Gives parameters that hang on the terrain their values. Throws talus::Error when a tick with them, or
    /// with the lowest or the highest value of one of the tables, cannot be run.
    void fit(const Grid& grid, Parameters& parameters, const std::vector<Drive>& drives) const;
    /// The passes take note of layers that none of them wrote.
    void observe();
    void exchange(bool forth);
    TerrainState with_moment(TerrainState layers) const;
    std::vector<Book> books();
    Snapshot snapshot() { return {BookCopies(books()), moment_, {}}; }
    /// Runs `change` and books the solid (m³) that no pass books. Waits for the device.
    template <typename Change>
    void book(Change&& change);
    /// Books the apparent gain or loss of solid when parameters change the solid weights.
    void reweigh(const Parameters& changed);
    void fill_sea_now();
    /// Undoes the last act, and says so, if it set this sea level too, so that its water does not stay under
    /// the new level.
    bool withdraw_sea(const std::string& level);
    void begin_tick();
    /// Throws talus::Error where a tick with what an event sets cannot be run.
    void fit_events(const Grid& grid, const Parameters& parameters, const std::vector<Drive>& drives,
                    const std::vector<Event>& events) const;
    /// Does those events that are due: those of parameters, or the breaches.
    void set_by_events();
    void breach_by_events();
    /// Driven parameters take what their tables say of the tick that begins.
    void follow_tables();

    Terrain terrain_;
    std::vector<std::unique_ptr<Pass>> passes_;
    int terrain_number_ = 0;
    std::unique_ptr<Ledger> ledger_;  // since the sea was filled
    Moment moment_;
    Journal journal_;
    Undo undo_;
    bool keeps_undo_;
    // The ledger that was asked for, as it stood then.
    struct AskedLedger {
        BookCopies books;
        gpu::Readback sums;
        SolidWeights weights;
        double sea_m3 = 0;
        double booked_m3 = 0;
        LedgerStart start;
    };
    LedgerReading reading_of(const AskedLedger& asked, const std::vector<glm::dvec4>& tile_sums) const;
    void copy_books(AskedLedger& asked);
    AskedLedger asked_;
    std::vector<double> section_volumes_of(std::span<const double> words) const;
    void forget_asked_sections();
    bool asked_sections_ = false;
    gpu::Readback section_words_;  // not started: nothing has passed any

    bool in_tick_ = false;
    std::size_t pass_ = 0;  // whose part of the tick it is
};

}  // namespace talus
