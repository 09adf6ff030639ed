#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/gpu/readback.h"
#include "sim/journal.h"
#include "sim/ledger.h"
#include "sim/operation.h"
#include "sim/parameters.h"
#include "sim/passes/brush.h"
#include "sim/passes/erode_brush.h"
#include "sim/passes/inundation.h"
#include "sim/passes/mask.h"
#include "sim/passes/paint.h"
#include "sim/passes/thermal.h"
#include "sim/passes/water.h"
#include "sim/passes/water_brush.h"
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
    Terrain& terrain() { return terrain_; }
    const Terrain& terrain() const { return terrain_; }
    const Parameters& parameters() const { return moment_.parameters; }
    const Clock& clock() const { return moment_.clock; }
    const Journal& journal() const { return journal_; }

    /// Does it and records it. Throws talus::Error, with nothing changed, for a parameter that cannot be set
    /// so, for a spring off the map, for a terrain that cannot be, and while a tick is half done for anything
    /// but ticks.
    void apply(const Operation& operation);

    /// A tick in parts: runs up to `substeps` sub-steps of the present tick, or of the next one, and says
    /// whether a tick was completed (and recorded).
    bool advance(int substeps);
    bool mid_tick() const { return in_tick_; }
    /// Sub-steps that advance() sent to the device so far. Does not wait.
    std::uint64_t substeps_sent() const { return thermal_sent_ + (water_ ? water_->sent() : 0); }

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

    /// Waits for the device.
    LedgerReading ledger();
    /// Asks for it without waiting, between ticks; poll_ledger() gives it once it is there.
    void ask_ledger();
    std::optional<LedgerReading> poll_ledger();
    bool awaits_ledger() const { return asked_.sums.pending(); }
    const std::vector<Spring>& springs() const { return moment_.springs; }
    /// What dabs of a stamp press; none: nothing was chosen.
    const Stamp* stamp() const { return moment_.stamp.get(); }
    /// Its heights on the device; there must be one.
    const gpu::Texture& stamp_texture();
    /// Sub-steps of water so far. Waits for the device.
    Water::Work water_work() const;
    /// The whole state. Waits for the device.
    TerrainState read() const;
    /// The state but for its layers: what read() adds to them, without waiting.
    TerrainState moment_state() const;

  private:
    void act(const SetParameter& set);
    void act(const PlaceSpring& spring);
    void act(const Dab& dab);
    void erode(const Dab& dab);
    void act(const Resample& to);
    void act(const Crop& crop);
    void act(const Turn& turn);
    void act(const Import& import);
    void act(const ChooseStamp& choose);
    void act(const MakeMask& make);
    void act(const Blur& blur);
    /// Does `change` as an entry of undo, or as part of the open one, and records the operation.
    template <typename Change>
    void record(const Operation& operation, Change&& change);
    /// Another terrain in place of this one, recorded as the operation.
    void replace_terrain(const Operation& operation, const TerrainState& next, Parameters parameters);
    void stand_on(Terrain next);
    void place(const Spring& spring);
    /// Throws talus::Error when a tick with these parameters cannot be run.
    void check_tick(const Grid& grid, const Parameters& parameters) const;
    using UndoWay = void (Undo::*)(Terrain&, const std::function<Books()>&, Journal&, Moment&,
                                   const Undo::ExchangeTerrain&);
    void exchange(UndoWay way);
    Books books();
    WaterSettings water_settings() const;
    /// Books what a change brings or takes that no pass books. Waits for the device.
    template <typename Change>
    void book(Change&& change);
    /// A change of what a metre of regolith or load counts brings or takes no solid: it is booked.
    void reweigh(const Parameters& changed);
    /// Whether water is there, or may come in the next tick.
    bool has_water() const;
    void add_water();
    void fill_sea_now();
    /// A sea level that is set again at once takes the place of the one before, and its water with it.
    void withdraw_sea(const std::string& level);
    void begin_tick();

    Terrain terrain_;
    Brush brush_;
    Thermal thermal_;
    std::unique_ptr<Water> water_;             // none: no water was ever here
    std::unique_ptr<WaterBrush> water_brush_;  // with it
    std::unique_ptr<Inundation> inundation_;   // with it
    std::unique_ptr<ErodeBrush> erode_brush_;  // none: nothing was eroded by hand
    Paint paint_;
    Mask mask_;
    gpu::Texture stamp_texture_;  // of stamp_there_
    std::shared_ptr<const Stamp> stamp_there_;
    int terrain_number_ = 0;
    bool rain_painted_ = false;       // once, though it may have been undone
    std::unique_ptr<Ledger> ledger_;  // since the sea was filled
    Moment moment_;
    Journal journal_;
    Undo undo_;
    bool keeps_undo_;
    // The ledger that was asked for, as it stood then.
    struct AskedLedger {
        std::vector<gpu::Buffer> books;
        gpu::Readback sums;
        SolidWeights weights;
        double sea_m3 = 0;
        double booked_m3 = 0;
        LedgerStart start;
    };
    LedgerReading reading_of(const AskedLedger& asked, const std::vector<glm::dvec4>& tile_sums) const;
    void copy_books(AskedLedger& asked);
    AskedLedger asked_;

    bool in_tick_ = false;
    int thermal_left_ = 0;  // sub-steps of this tick
    std::uint64_t thermal_sent_ = 0;
    ThermalStep step_;
    bool water_begun_ = false;
};

}  // namespace talus
