#include "app/claims/claims.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/claims/arithmetic.h"
#include "app/claims/exact_solutions.h"
#include "app/claims/histories.h"
#include "app/claims/picture_agreement.h"
#include "app/claims/twin_agreement.h"
#include "sim/terrain/generate.h"

namespace talus::claims {
namespace {

// A device that rounds as C++ does gives the float twin's bits (law 4). Others divide and take roots by rules
// of their own: they are held to the twin in double.
Finding of_twin(const TwinAgreement& agreement, double bound) {
    if (agreement.changed == 0) return {HUGE_VAL, 0, "nothing moved"};
    if (arithmetic_of_device().rounds_as_ieee())
        return {static_cast<double>(agreement.differing), 0, "samples with other bits"};
    return {agreement.of_double, bound, "of what moves, from double"};
}

Finding count(double number, const char* unit) {
    return {number, 0, unit};
}

// A terrain for pictures.
struct Ground {
    Grid grid{257, 193, 20, 25};
    std::vector<float> heights = generate_heights(grid, {"mountains", 9, 1300});
};

Finding picture(const char* method, double tolerance_px) {
    const Ground ground;
    const SurveyError error = survey_error(ground.grid, ground.heights, method, tolerance_px, {240, 135}, 8);
    if (error.all.pixels_hit < 240 * 135) return {HUGE_VAL, 0, "nothing was hit"};
    return count(error.all.beyond, "pixels beyond the tolerance");
}

Finding cone() {
    const ConeError cone = collapsed_column(257, 22, 120);
    const double radii =
        std::max(std::abs(cone.axis_m / cone.exact_m - 1), std::abs(cone.diagonal_m / cone.exact_m - 1));
    const bool is_steep = cone.steepest_deg > 34.5 || std::abs(cone.peak_m / cone.exact_peak_m - 1) > 0.005;
    return {is_steep ? HUGE_VAL : radii, 0.01, "of the cone's radius"};
}

}  // namespace

const std::vector<Claim>& claims() {
    static const std::vector<Claim> all = {
        {"brush and slopes", "dabs of all kinds and slides are those of the processor's twin",
         [] { return of_twin(brush_and_slopes_against_twin(100), 1e-4); }},
        {"water", "the water's sub-steps are those of the twin",
         [] {
             return of_twin(water_against_twin({2, 0.03, 2e-4, EdgeKind::open, EdgeKind::level,
                                                EdgeKind::wall, EdgeKind::open}),
                            1e-4);
         }},
        {"water, first order", "so are those of the cheaper scheme, with a wave maker and an inflow",
         [] {
             return of_twin(water_against_twin({1, 0, 0, EdgeKind::inflow, EdgeKind::wave, EdgeKind::open,
                                                EdgeKind::inflow}),
                            1e-4);
         }},
        {"sediment", "what water takes, carries and lays down is the twin's",
         [] {
             return of_twin(sediment_against_twin({2, 0, 2e-4, EdgeKind::open, EdgeKind::level,
                                                   EdgeKind::inflow, EdgeKind::open}),
                            1e-3);
         }},
        {"exact picture", "rays meet the bilinear surface, within a thousandth of a pixel",
         [] { return picture("exact", 0); }},
        {"hybrid picture", "mesh and rays meet it within the tolerance of half a pixel",
         [] { return picture("hybrid", 0.5); }},
        {"pyramid", "bounds updated tile by tile equal bounds built anew",
         [] {
             return count(static_cast<double>(pyramid_texels_differing({130, 257, 4, 6}, 150)), "texels");
         }},
        {"kept pictures", "pictures redrawn only where the ground changed equal pictures drawn anew",
         [] {
             return count(kept_frames({300, 257, 20, 20}, "hybrid", 40, {320, 180}).differing,
                          "frames of 40");
         }},
        {"skipping", "water at rest is skipped and changes no bit",
         [] { return count(static_cast<double>(skipped_rest(2, true, 20).differing), "samples"); }},
        {"history", "undo, redo, a replay of the journal, and a document read again lead to the same bits",
         [] {
             const HistoryFaults faults = history_faults();
             return count(faults.undo + faults.redo + (faults.replay ? 1 : 0) + (faults.reload ? 1 : 0),
                          "states that are others");
         }},
        {"lake at rest", "still water over rough ground at 1000 m stays still, all sub-steps done",
         [] {
             return Finding{lake_at_rest(1000, 500).fastest_m_per_s, 1e-4, "m/s"};
         }},
        {"dry dam break", "a dam that breaks over dry ground (Ritter)",
         [] {
             return Finding{error_after(scenes::ritter(100)).relative_l1, 9e-3, "of the depth"};
         }},
        {"wet dam break", "a dam that breaks over water (Stoker)",
         [] {
             return Finding{error_after(scenes::stoker(100)).relative_l1, 6e-3, "of the depth"};
         }},
        {"round bowl", "a round wave in a bowl (Thacker)",
         [] {
             return Finding{error_after(scenes::thacker_radial(128)).relative_l1, 2.0e-2, "of the depth"};
         }},
        {"planar bowl", "a plane of water that swings in a bowl (Thacker)",
         [] {
             return Finding{error_after(scenes::thacker_planar(128)).relative_l1, 1.5e-2, "of the depth"};
         }},
        {"small waves", "waves across the grid travel at √(gd)",
         [] {
             return Finding{std::abs(small_wave_error(1, 1).speed), 0.005, "of the speed"};
         }},
        {"column", "a column of loose ground falls into the cone of its angle of repose",
         [] { return cone(); }},
        {"ledger of rock", "no rock is lost to slides, brushes, erosion and edges",
         [] {
             return Finding{ledger_errors().solid, 1e-6, "of what moved"};
         }},
        {"tables", "rain and inflow that follow tables bring the tables' integrals",
         [] {
             return Finding{table_error(), 1e-6, "of the integral"};
         }},
        {"ledger of water", "no water is lost to rain, springs, brushes and edges",
         [] {
             return Finding{ledger_errors().water, 1e-6, "of all water"};
         }},
    };
    return all;
}

Verdict verdict_on(const Claim& claim) {
    Verdict verdict{claim.name, claim.says, {}, {}, 0};
    const auto begin = std::chrono::steady_clock::now();
    try {
        verdict.finding = claim.check();
    } catch (const std::exception& error) {
        verdict.error = error.what();
    }
    verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return verdict;
}

}  // namespace talus::claims
