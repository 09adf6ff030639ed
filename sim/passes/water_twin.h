#pragma once
#include <bit>
#include <vector>

#include "shaders/maths/twin.h"
#include "sim/passes/sediment_step.h"
#include "sim/passes/tick_series.h"
#include "sim/passes/water_numbers.h"
#include "sim/passes/water_schedule.h"
#include "sim/terrain/grid.h"
#include "sim/terrain/springs.h"

namespace talus::maths {

/// The CPU twin of the water's sub-step, over every sample: the same schedule (sim/passes/water_schedule.h)
/// and the same maths as on the device, without its list of tiles and its books. In float it agrees bit for
/// bit with a device that rounds as IEEE 754 asks, as llvmpipe does; in double it says what float costs.
template <typename Real>
class WaterTwin {
  public:
    TALUS_TWIN_NAMES(Real)

    /// Rows of samples, and the bed beyond, as in TerrainState.
    WaterTwin(const Grid& grid, const std::vector<real>& beds, const std::vector<real4>& water,
              const WaterSettings& settings, const std::vector<glm::vec4>& painted = {},
              const std::vector<Spring>& springs = {}, const std::vector<float>& bed_beyond = {})
        : nx(grid.nx),
          ny(grid.ny),
          water_order(settings.order),
          grid_(grid),
          settings_(settings),
          front_(static_cast<std::size_t>(nx + 2 * glsl::water_ghosts) * (ny + 2 * glsl::water_ghosts),
                 real4(0)),
          back_(front_),
          bed_(front_.size(), 0),
          painted_(painted),
          springs_(springs),
          bed_beyond_(bed_beyond) {
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) {
                const auto i = static_cast<std::size_t>(y) * nx + x;
                front_[texel(int2(x, y))] = water[i];
                bed_[texel(int2(x, y))] = beds[i];
            }
    }

    /// From now on the water carries a load and exchanges it with this solid: rows of (bedrock, its low word,
    /// regolith, its low word) and of loads, m. The settings' sediment must be carried.
    void carry(const std::vector<real4>& solid, const std::vector<real2>& load) {
        solid_ = solid;
        load_front_.assign(front_.size(), real2(0));
        load_back_ = load_front_;
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x)
                load_front_[texel(int2(x, y))] = load[static_cast<std::size_t>(y) * nx + x];
        take(sediment_numbers(settings_));
    }
    const std::vector<real4>& solid() const { return solid_; }
    std::vector<real2> read_load() const { return samples_of(load_front_); }

    /// From now on roughness and infiltration are as these texels say, rows as in TerrainState.
    void cover_land(const std::vector<glm::vec4>& land_cover) { land_cover_ = land_cover; }

    /// From now on it counts the flow, and, where a load is carried, wear and deposition.
    void count_maps() {
        flow_.assign(static_cast<std::size_t>(nx) * ny, real2(0));
        worn_.assign(solid_.size(), real4(0));
    }
    const std::vector<real2>& flow() const { return flow_; }
    const std::vector<real4>& worn() const { return worn_; }

    /// One tick that begins at a time since the start.
    void tick(double whole_s, double start_s) {
        series_ = tick_series(settings_, grid_, whole_s, start_s);
        edge_speed_ = 0;
        take(water_numbers(grid_, {0, 0}, settings_, whole_s, springs_.size(), series_));
        if (spreads_by_conveyance(settings_)) find_inflow_shares();
        real left = tick_s;
        while (left > 0) left = substep(left);
    }

    std::vector<real4> read() const { return samples_of(front_); }

  private:
    int nx;
    int ny;
    int water_order;
    real2 water_share{0};
    real water_drain = 0;
    real water_friction = 0;
    real edge_inflow = 0;
    real edge_wave_m = 0;
    real edge_level_m = 0;
    real edge_sea_m = 0;
    real sediment_dt = 0;
#define NUMBER TALUS_MEMBER
#include "maths/sediment_numbers.glsl"
#include "maths/water_numbers.glsl"
#undef NUMBER
    const std::vector<real4>* shown_ = nullptr;  // the image that edges see

    real4 load_water(int2 at) const {
        return (*shown_)[texel(at)];
    }
    real load_bed(int2 at) const {
        return bed_[texel(at)];
    }
    real load_bed_beyond(int at) const {
        return bed_beyond_.empty() ? unknown_bed : bed_beyond_[static_cast<std::size_t>(at)];
    }
    real load_tick_series(int at) const {
        return series_[static_cast<std::size_t>(at)];
    }
    static real inverse_cube_root_seed(real x) {
        const auto bits = static_cast<float>(std::bit_cast<std::int32_t>(static_cast<float>(x)));
        const float seed = bits * -0.33333333333333333F + 1419967116.0F;
        return static_cast<real>(std::bit_cast<float>(static_cast<std::int32_t>(seed)));
    }

#include "maths/conveyance.glsl"
#include "maths/ground_height.glsl"
#include "maths/land_cover.glsl"
#include "maths/rise.glsl"
#include "maths/sediment_exchange.glsl"
#include "maths/sediment_transport.glsl"
#include "maths/water.glsl"
#include "maths/water_edge.glsl"
#include "maths/water_flow.glsl"
#include "maths/water_ghosts.glsl"
#include "maths/water_given_face.glsl"
#include "maths/water_sources.glsl"
#include "maths/water_spring.glsl"
#include "maths/water_stage.glsl"
#include "maths/water_step.glsl"
#include "maths/wear.glsl"

    template <typename Texel>
    std::vector<Texel> samples_of(const std::vector<Texel>& texels) const {
        std::vector<Texel> read;
        read.reserve(static_cast<std::size_t>(nx) * ny);
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) read.push_back(texels[texel(int2(x, y))]);
        return read;
    }

    std::size_t texel(int2 at) const {
        const int2 inside = at + glsl::water_ghosts;
        return static_cast<std::size_t>(inside.y) * (nx + 2 * glsl::water_ghosts) +
               static_cast<std::size_t>(inside.x);
    }

    real substep(real left) {
        real speed = 0;
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) speed = max(speed, water_speed(front_[texel(int2(x, y))]));
        speed = max(speed, edge_speed_);
        edge_speed_ = 0;
        step_ = water_next_substep(left, speed);
        water_share = step_.share;
        water_drain = step_.drain;
        water_friction = step_.friction;
        run_substep(
            settings_, [&](int number) { fill_ghosts(number); },
            [&](int number) {
                number == 1 ? stage(front_, back_, load_front_, load_back_, 1)
                            : stage(back_, front_, load_back_, load_front_, 2);
            },
            [&] { exchange(step_.dt * real(water_eulers)); });
        return step_.left;
    }

    void exchange(real span) {
        sediment_dt = span;
        const std::vector<real> beds = bed_;
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) {
                const auto i = static_cast<std::size_t>(y) * nx + x;
                const std::size_t at = texel(int2(x, y));
                const real hardness = painted_.empty() ? real(0) : sediment_hardness(real4(painted_[i]));
                const auto bed = [&](int dx, int dy) { return beds[texel(int2(x + dx, y + dy))]; };
                const real drop = bed(0, 0) - min(min(bed(-1, 0), bed(1, 0)), min(bed(0, -1), bed(0, 1)));
                const real rise = max(max(bed(-1, 0), bed(1, 0)), max(bed(0, -1), bed(0, 1))) - bed(0, 0);
                const bool is_base = x == 0 || y == 0 || x == nx - 1 || y == ny - 1;
                const SedimentSample after = sediment_exchange(
                    front_[at], sediment_shear(front_[at], drag_at(i)),
                    SedimentSample{solid_[i], load_front_[at]}, hardness, is_base, drop, rise);
                load_front_[at] = after.load;
                if (after.solid == solid_[i]) continue;
                if (!worn_.empty()) worn_[i] = wear_counted(worn_[i], solid_[i], after.solid);
                solid_[i] = after.solid;
                bed_[at] = ground_height(after.solid);
            }
    }

    void stage(const std::vector<real4>& from, std::vector<real4>& to, const std::vector<real2>& load_from,
               std::vector<real2>& load_to, int number) {
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) {
                const int2 at(x, y);
                const real4 here = from[texel(at)];
                const WaterFace west = face(from, at + int2(-1, 0), int2(1, 0));
                const WaterFace east = face(from, at, int2(1, 0));
                const WaterFace south = face(from, at + int2(0, 1), int2(0, -1));
                const WaterFace north = face(from, at, int2(0, -1));
                const auto i = static_cast<std::size_t>(y) * nx + x;
                if (!land_cover_.empty())
                    water_friction = step_.dt * land_cover_roughness(real4(land_cover_[i]));
                const WaterChange change = water_change(here.x, west, east, south, north);
                real4 after = water_after_stage(number, to[texel(at)], here, change);
                if (has_sources(settings_, number))
                    after = water_with_sources(after, rain_at(at) * step_.dt,
                                               water_loss(after, loss_at(i), step_.dt));
                to[texel(at)] = after;
                if (!flow_.empty()) {
                    real2& flow = flow_[i];
                    const real outflow = water_outflow(west, east, south, north);
                    if (outflow > real(0)) flow = flow_counted(flow, outflow);
                }
                if (solid_.empty()) continue;
                const auto concentration = [&](int2 place) {
                    return sediment_concentration(from[texel(place)].x, load_from[texel(place)].x);
                };
                const real mine = concentration(at);
                const real gain =
                    sediment_gain(sediment_flux(west.mass, concentration(at + int2(-1, 0)), mine),
                                  sediment_flux(east.mass, mine, concentration(at + int2(1, 0))),
                                  sediment_flux(south.mass, concentration(at + int2(0, 1)), mine),
                                  sediment_flux(north.mass, mine, concentration(at + int2(0, -1))));
                real2& load = load_to[texel(at)];
                load = sediment_after_stage(number, load, load_from[texel(at)], gain);
            }
    }

    real loss_at(std::size_t i) {
        return land_cover_.empty() ? loss_m_per_s : land_cover_loss(real4(land_cover_[i]));
    }

    real drag_at(std::size_t i) {
        if (land_cover_.empty() || land_cover_[i].y == 0) return sediment_drag;
        return sediment_drag_of(land_cover_roughness(real4(land_cover_[i])));
    }

    real rain_at(int2 at) {
        if (painted_.empty()) return step_.rain;
        const glm::vec4 painted = painted_[static_cast<std::size_t>(at.y) * nx + at.x];
        return water_rain(step_.rain, real(painted.y), real(painted.z));
    }

    WaterCell cell_at(const std::vector<real4>& from, int2 at, bool turned) {
        const real4 water = from[texel(at)];
        const WaterCell cell =
            water_cell(water, bed_[texel(at)], water_velocity(water.x, real2(water.z, water.w)));
        return turned ? water_turned(cell) : cell;
    }

    // The face behind a sample along (1, 0) or (0, -1).
    WaterFace face(const std::vector<real4>& from, int2 at, int2 step) {
        const bool turned = step.x == 0;
        const WaterCell before = cell_at(from, at - step, turned);
        const WaterCell a = cell_at(from, at, turned);
        const WaterCell b = cell_at(from, at + step, turned);
        const WaterCell behind = cell_at(from, at + 2 * step, turned);
        const WaterSlope slope_a = water_slope(before, a, b);
        WaterFace face =
            water_face(a, slope_a, b, water_slope(a, b, behind), water_face_rests(before, a, b, behind));
        // At the map's edges what comes in is given: by columns from west to east, by rows from south to
        // north.
        const int2 next = at + step;
        const auto give = [&](bool at_edge, int kind, real given) {
            face = water_given_face(face, at_edge, kind, given);
        };
        if (!turned && at.x < 0) give(true, edge_kind_west, inflow_at(edge_index(2, at.y)));
        if (!turned && next.x >= nx) give(true, edge_kind_east, -inflow_at(edge_index(3, at.y)));
        if (turned && at.y >= ny) give(true, edge_kind_south, inflow_at(edge_index(1, at.x)));
        if (turned && next.y < 0) give(true, edge_kind_north, -inflow_at(edge_index(0, at.x)));
        return face;
    }

    real inflow_at(int place) const {
        return inflow_shares_.empty() ? step_.inflow
                                      : step_.inflow * inflow_shares_[static_cast<std::size_t>(place)];
    }

    real load_manning(int2 at) {
        if (land_cover_.empty() || !settings_.manning_painted) return water_manning;
        const real4 cover(land_cover_[static_cast<std::size_t>(at.y) * nx + at.x]);
        return land_cover_manning(cover);
    }

    // Lane after lane, as the device's sum goes.
    real conveyance_of_side(int side, real lowest, real level) {
        real sum = 0;
        for (int lane = 0; lane < conveyance_lanes; ++lane)
            sum = sum + conveyance_sum(side, lane, lowest, level);
        return sum;
    }

    void find_inflow_shares() {
        inflow_shares_.resize(static_cast<std::size_t>(edge_places()));
        for (int side = 0; side < 4; ++side) {
            if (edge_kind_of(side) != edge_inflow_kind) continue;
            real lowest = conveyance_lowest(side, 0);
            for (int lane = 1; lane < conveyance_lanes; ++lane)
                lowest = min(lowest, conveyance_lowest(side, lane));
            ConveyanceSearch search = conveyance_search();
            int halvings = 0;
            for (int i = 0; i < conveyance_doublings + conveyance_halvings && halvings < conveyance_halvings;
                 ++i) {
                search = conveyance_next(search, side, conveyance_of_side(side, lowest, search.level));
                halvings += search.doubles ? 0 : 1;
            }
            const real sum = conveyance_of_side(side, lowest, search.high);
            edge_speed_ = max(edge_speed_, conveyance_speed(search.high));
            for (int i = 0; i < conveyance_count(side); ++i) {
                const int place = edge_index(side, i);
                inflow_shares_[static_cast<std::size_t>(place)] =
                    conveyance_share(side, place, lowest, search.high, sum);
            }
        }
    }

    void run_springs() {
        for (const Spring& spring : springs_) {
            real4& water = front_[texel(sample_of(grid_, spring))];
            const auto rate = static_cast<float>(spring.rate_m3_per_s / (grid_.dx * grid_.dy));
            water = water_with_spring(water, spring_gain(rate, step_.dt));
        }
    }

    void fill_ghosts(int number) {
        if (number == 1) run_springs();
        std::vector<real4>& state = number == 1 ? front_ : back_;
        std::vector<real2>& loads = number == 1 ? load_front_ : load_back_;
        shown_ = &state;
        const real share = number == 1 ? step_.at : step_.at + step_.part;
        edge_wave_m = tick_series_at(series_wave, share);
        edge_level_m = tick_series_at(series_level, share);
        edge_sea_m = has_sea == 1 ? edge_level_m : real(no_sea);
        const auto store = [&](int2 at, int2 outward, const EdgeSample& ghost) {
            state[texel(at)] = edge_water(ghost, outward);
            bed_[texel(at)] = ghost.bed;
        };
        for (int index = 0; index < edge_places(); ++index) {
            edge_inflow = inflow_at(index);
            const EdgeGhosts made = edge_ghosts(index);
            const EdgePlace& place = made.place;
            store(place.at + place.outward, place.outward, made.ghost);
            store(place.at + 2 * place.outward, place.outward, made.ghost_2);
            if (!solid_.empty())
                loads[texel(place.at + place.outward)] =
                    real2(edge_load(made, loads[texel(made.shown_at)].x, sediment_inflow), 0);
            if (!edge_mirrors(made.kind))
                edge_speed_ =
                    max(edge_speed_,
                        water_speed(real4(made.ghost.depth, 0, made.ghost.outward, made.ghost.beside)));
        }
    }

    Grid grid_;
    WaterSettings settings_;
    std::vector<float> series_;
    WaterSubstep step_;
    real edge_speed_ = 0;
    std::vector<real4> front_;
    std::vector<real4> back_;
    std::vector<real> bed_;
    std::vector<glm::vec4> painted_;
    std::vector<glm::vec4> land_cover_;  // empty: all is as the settings say
    std::vector<Spring> springs_;
    std::vector<float> bed_beyond_;
    std::vector<real> inflow_shares_;  // empty: even
    std::vector<real4> solid_;         // empty: no load is carried
    std::vector<real2> load_front_;
    std::vector<real2> load_back_;
    std::vector<real2> flow_;  // empty: not counted
    std::vector<real4> worn_;

    void take(const WaterNumbers& numbers) {
#define NUMBER TALUS_TAKE
#include "maths/water_numbers.glsl"
#undef NUMBER
    }
    void take(const SedimentNumbers& numbers) {
#define NUMBER TALUS_TAKE
#include "maths/sediment_numbers.glsl"
#undef NUMBER
    }
};

}  // namespace talus::maths
