#include "sim/passes/map_settings.h"
#include "sim/passes/passes.h"
#include "sim/passes/thermal.h"

namespace talus {
namespace {

// Slopes slide in every tick.
class ThermalPass : public Pass {
  public:
    explicit ThermalPass(const Terrain& terrain) : thermal_(terrain) {}

    std::string name() const override { return "thermal"; }

    // Unless somebody set it, the rate makes a tick one sub-step.
    void fit(const Grid& grid, Parameters& parameters) const override {
        const double tick_s = parameters.number("time.tick_s");
        parameters.suggest("thermal.rate_m2_per_s",
                           natural_thermal_rate(grid, tick_s, parameters.number("erosion.porosity")));
        if (parameters.toggle("thermal.on")) thermal_substeps(grid, thermal_settings(parameters), tick_s);
    }

    void prepare_tick(Terrain& terrain, const Moment& at) override {
        left_ = 0;
        if (!at.parameters.toggle("thermal.on")) return;
        const bool counts = counts_maps(at.parameters);
        if (counts) terrain.add(&Terrain::worn_by_slopes);
        const double tick_s = at.parameters.number("time.tick_s");
        const ThermalSettings settings = thermal_settings(at.parameters);
        left_ = thermal_substeps(terrain.grid(), settings, tick_s);
        step_ = thermal_step(terrain.grid(), settings, tick_s, left_);
        step_.counts_wear = counts;
    }

    bool advance(Terrain& terrain, const Moment& /*at*/, int& substeps) override {
        for (; substeps > 0 && left_ > 0; --substeps, --left_, ++sent_) thermal_.substep(terrain, step_);
        return left_ == 0;
    }

    std::uint64_t substeps_sent() const override { return sent_; }
    PassWork work() const override { return {sent_, 0}; }

  private:
    Thermal thermal_;
    ThermalStep step_;
    int left_ = 0;  // sub-steps of this tick
    std::uint64_t sent_ = 0;
};

}  // namespace

PassKind thermal_pass() {
    return {[](const Terrain& terrain) -> std::unique_ptr<Pass> {
                return std::make_unique<ThermalPass>(terrain);
            },
            declared(thermal_parameters())};
}

}  // namespace talus
