#include <optional>

#include "sim/error.h"
#include "sim/passes/brush.h"
#include "sim/passes/dab_region.h"
#include "sim/passes/erode_brush.h"
#include "sim/passes/map_settings.h"
#include "sim/passes/passes.h"
#include "sim/passes/stamp_image.h"

namespace talus {
namespace {

// Dabs that change the ground.
class GroundBrushPass : public Pass {
  public:
    explicit GroundBrushPass(const Terrain& terrain) : brush_(terrain) {}

    std::string name() const override { return "ground brush"; }

    void complete(Dab& dab, const Moment& at) const override {
        if (auto* erode = dab.as<ErodeDab>(); erode && !(erode_ && erode_->is_going())) erode->begins = true;
        if (dab.as<StampDab>() && !at.stamp)
            throw Error("there is no stamp yet: choose a file or a piece of the terrain first");
    }

    bool act(Terrain& terrain, const Moment& at, const PassAct& act) override {
        const auto* dab = std::get_if<Dab>(&act);
        if (!dab || dab->is_paint() || dab->is_water()) return false;
        brush_.count_wear(counts_maps(at.parameters));
        if (const auto* eroding = dab->as<ErodeDab>())
            erode(terrain, at.parameters, *dab, *eroding);
        else if (!is_masked_out(terrain, *dab))
            brush_.dab(terrain, *dab, dab->as<StampDab>() ? &stamp_.of(at.stamp) : nullptr);
        return true;
    }

    // The water of an erode stroke belongs to acts that may be undone now.
    void forget_act() override {
        if (erode_) erode_->set_going(false);
    }

    std::vector<Book> books() override { return {brush_.book()}; }

  private:
    void erode(Terrain& terrain, Parameters parameters, const Dab& dab, const ErodeDab& how) {
        if (!erode_) erode_.emplace();
        parameters.set("erosion.on", true);
        std::optional<ThermalSettings> thermal;
        if (parameters.toggle("thermal.on")) thermal = thermal_settings(parameters);
        const Terrain& eroded = erode_->erode(terrain, dab, how, water_settings_of(parameters), thermal);
        const double settled =
            how.ends ? how.acceleration * bulking_of(parameters.number("erosion.porosity")) : 0;
        brush_.take_over(terrain, dab, eroded, settled);
        erode_->set_going(!how.ends);
    }

    Brush brush_;
    StampImage stamp_;
    std::optional<ErodeBrush> erode_;  // none: nothing was eroded by hand
};

}  // namespace

PassKind ground_brush_pass() {
    return {[](const Terrain& terrain) -> std::unique_ptr<Pass> {
                return std::make_unique<GroundBrushPass>(terrain);
            },
            map_parameters()};
}

}  // namespace talus
