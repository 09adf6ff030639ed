#include <algorithm>
#include <optional>

#include "sim/drives.h"
#include "sim/events.h"
#include "sim/passes/dab_region.h"
#include "sim/passes/inundation.h"
#include "sim/passes/map_settings.h"
#include "sim/passes/passes.h"
#include "sim/passes/water.h"
#include "sim/passes/water_brush.h"

namespace talus {
namespace {

// Runs the water with its suspended load, the dabs of water, and the inundation map.
class WaterPass : public Pass {
  public:
    explicit WaterPass(const Terrain& terrain) {
        if (terrain.water) made_.emplace(terrain);
    }

    std::string name() const override { return "water"; }

    void turn(Parameters& parameters, std::vector<Event>& events, int quarters) const override {
        turn_edges(parameters, quarters);
        for (Event& event : events)
            if (!event.breach) set_parameter_of(event, turned_edge_parameter(parameter_of(event), quarters));
    }

    void prepare_tick(Terrain& terrain, const Moment& at) override {
        flows_ = is_expected(terrain, at);
        begun_ = false;
        if (!flows_) return;
        solver(terrain);
        const bool counts = counts_maps(at.parameters);
        if (counts) terrain.add(&Terrain::flow);
        if (at.parameters.toggle("erosion.on")) terrain.add(&Terrain::suspended);
        // A load settles where erosion is off too.
        if (counts && terrain.suspended) terrain.add(&Terrain::worn_by_water);
    }

    bool advance(Terrain& terrain, const Moment& at, int& substeps) override {
        if (!flows_) return true;
        const double tick_s = at.parameters.number("time.tick_s");
        if (!begun_)
            made_->water.begin_tick(terrain, settings_for(terrain, at), at.springs, tick_s,
                                    at.clock.simulated_s - at.edges_since_s);
        begun_ = true;
        if (!made_->water.advance(terrain, substeps)) return false;
        made_->inundation.record(terrain, at.clock.simulated_s + tick_s);
        return true;
    }

    bool act(Terrain& terrain, const Moment& at, const PassAct& act) override {
        const auto* dab = std::get_if<Dab>(&act);
        if (!dab || !dab->is_water()) return false;
        if (is_masked_out(terrain, *dab)) return true;
        solver(terrain).brush.dab(terrain, *dab);
        observe(terrain, at);
        return true;
    }

    void observe(Terrain& terrain, const Moment& at) override {
        if (terrain.water) solver(terrain).inundation.record(terrain, at.clock.simulated_s);
    }

    void follow_sections(const Terrain& terrain, const std::vector<Section>& sections) override {
        for (const Section& section : sections) check_section(terrain.grid(), section);
        sections_ = sections;
        if (made_) made_->water.sections.follow(terrain.grid(), sections_);
    }

    std::optional<gpu::Buffer> section_words() const override {
        return made_ ? made_->water.sections.copy_of_words() : std::nullopt;
    }

    std::vector<double> section_volumes_m3(const Grid& grid, std::span<const double> words) const override {
        if (made_) return made_->water.sections.volumes_m3(grid, words);
        return std::vector<double>(sections_.size(), 0);
    }

    std::vector<Book> books() override {
        if (!made_) return {};
        std::vector<Book> books = made_->water.books();
        books.push_back(made_->brush.book());
        return books;
    }

    std::uint64_t substeps_sent() const override { return made_ ? made_->water.sent() : 0; }
    PassWork work() const override { return made_ ? made_->water.work() : PassWork(); }

  private:
    struct Made {
        explicit Made(const Terrain& terrain) : water(terrain), brush(terrain), inundation(terrain) {}
        Water water;
        WaterBrush brush;
        Inundation inundation;
    };

    // Whether water is there, or may come in the next tick.
    static bool is_expected(const Terrain& terrain, const Moment& at) {
        const Parameters& parameters = at.parameters;
        if (!parameters.toggle("water.on")) return false;
        if (terrain.water || !at.springs.empty() || parameters.number("water.rain_mm_per_h") > 0) return true;
        if (terrain.was_painted(PaintedNumber::rain)) return true;
        const WaterSettings settings = water_settings_of(parameters);
        return std::any_of(settings.edges.begin(), settings.edges.end(), [](EdgeKind kind) {
            return kind == EdgeKind::inflow || kind == EdgeKind::level || kind == EdgeKind::wave;
        });
    }

    static WaterDrives drives_of(const Moment& at) {
        WaterDrives driven;
        for (const WaterDrive& one : water_drives())
            if (const TimeSeries* series = series_of(at.drives, one.parameter)) driven.*one.table = *series;
        driven.since_s = at.edges_since_s;
        return driven;
    }

    // What the parameters say, as far as the layers that are there let it be.
    static WaterSettings settings_for(const Terrain& terrain, const Moment& at) {
        WaterSettings settings = water_settings_of(at.parameters);
        settings.driven = drives_of(at);
        settings.rain_masked = settings.rain_masked && settings.rain_m_per_s > 0;
        // Where nothing was painted the mask is 0, and no rain falls by it.
        if (settings.rain_masked && !terrain.painted) settings.rain_m_per_s = 0;
        SedimentSettings& sediment = settings.sediment;
        sediment.carried = terrain.suspended.has_value();
        if (sediment.masked && !terrain.painted)
            sediment.regolith_m_per_s_pa = sediment.bedrock_m_per_s_pa = 0;
        const auto is_painted_on = [&](PaintedNumber number, const std::optional<DeviceLayer>& layer) {
            return layer.has_value() && terrain.was_painted(number);
        };
        settings.rain_painted = is_painted_on(PaintedNumber::rain, terrain.painted);
        settings.manning_painted = is_painted_on(PaintedNumber::manning, terrain.land_cover);
        settings.infiltration_painted = is_painted_on(PaintedNumber::infiltration, terrain.land_cover);
        return settings;
    }

    Made& solver(Terrain& terrain) {
        terrain.add(&Terrain::water);
        if (made_) return *made_;
        made_.emplace(terrain);
        made_->water.sections.follow(terrain.grid(), sections_);
        return *made_;
    }

    std::optional<Made> made_;  // none: no water was ever here
    std::vector<Section> sections_;
    bool flows_ = false;  // in this tick
    bool begun_ = false;
};

}  // namespace

PassKind water_pass() {
    return {
        [](const Terrain& terrain) -> std::unique_ptr<Pass> { return std::make_unique<WaterPass>(terrain); },
        declared(sediment_parameters(), water_parameters())};
}

}  // namespace talus
