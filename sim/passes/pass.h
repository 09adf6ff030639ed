#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "sim/budget.h"
#include "sim/gpu/buffer.h"
#include "sim/moment.h"
#include "sim/passes/dab.h"
#include "sim/passes/mask_settings.h"
#include "sim/passes/pass_work.h"
#include "sim/terrain/section.h"
#include "sim/terrain/terrain.h"

namespace talus {

/// What the hand does to a terrain by a pass, between ticks.
using PassAct = std::variant<Dab, MaskSettings>;

/// A part of the simulation: a process of every tick, or what one kind of act does, with the books of what it
/// brings and takes. It is made for one terrain. A new pass is its file and a line of `pass_kinds()`.
class Pass {
  public:
    Pass() = default;
    Pass(const Pass&) = delete;
    Pass& operator=(const Pass&) = delete;
    virtual ~Pass() = default;

    virtual std::string name() const = 0;

    /// Sets parameters that follow the grid, unless somebody set them. Throws talus::Error where no tick can
    /// be run with these parameters.
    virtual void fit(const Grid& /*grid*/, Parameters& /*parameters*/) const {}
    /// Turns parameters that name edges of the map with the terrain, by quarters of a circle,
    /// counterclockwise, and events that set them.
    virtual void turn(Parameters& /*parameters*/, std::vector<Event>& /*events*/, int /*quarters*/) const {}
    /// Before a tick's first pass: adds the layers that this one will need in it.
    virtual void prepare_tick(Terrain& /*terrain*/, const Moment& /*at*/) {}
    /// Runs up to `substeps` sub-steps of its part of the tick, and lowers the number by those that it ran.
    /// True when its part is done. Does not wait for the device.
    virtual bool advance(Terrain& /*terrain*/, const Moment& /*at*/, int& /*substeps*/) { return true; }

    /// Sets what a dab takes over from the dabs before it. Throws talus::Error where the dab cannot be made.
    virtual void complete(Dab& /*dab*/, const Moment& /*at*/) const {}
    /// Does the act, where it is one of its own, and says so.
    virtual bool act(Terrain& /*terrain*/, const Moment& /*at*/, const PassAct& /*act*/) { return false; }
    /// Called after water came by no pass: with another terrain, an import or the sea.
    virtual void observe(Terrain& /*terrain*/, const Moment& /*at*/) {}
    /// Called after undo and redo: a stroke that was going on is over.
    virtual void forget_act() {}

    /// From now on it counts what passes these sections, if that is its matter. Throws talus::Error where one
    /// lies off the map.
    virtual void follow_sections(const Terrain& /*terrain*/, const std::vector<Section>& /*sections*/) {}
    /// A copy of what it counted of them so far, words on the device; none: nothing.
    virtual std::optional<gpu::Buffer> section_words() const { return std::nullopt; }
    /// Of such words, the water that passed each, m³; empty: it counts none.
    virtual std::vector<double> section_volumes_m3(const Grid& /*grid*/,
                                                   std::span<const double> /*words*/) const {
        return {};
    }

    /// The list may grow by a tick or an act.
    virtual std::vector<Book> books() { return {}; }
    /// Sub-steps that were sent to the device. Does not wait.
    virtual std::uint64_t substeps_sent() const { return 0; }
    /// Waits for the device.
    virtual PassWork work() const { return {}; }
};

}  // namespace talus
