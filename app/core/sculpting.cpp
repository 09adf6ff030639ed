#include "app/core/sculpting.h"

#include <algorithm>
#include <utility>

#include "sim/passes/dab_numbers.h"
#include "sim/passes/erode_brush.h"

namespace talus::app {

void Sculpting::begin(const Parameters& view, glm::dvec3 at, const Modifiers& modifiers) {
    stroke_.emplace(view, modifiers, at, strokes_++);
    owed_s_ = 0;
    begun_ = false;
}

void Sculpting::move(Simulation& simulation, const Parameters& view, glm::dvec3 at, double wall_s) {
    owed_s_ += wall_s;
    if (simulation.mid_tick()) return;
    if (!begun_) simulation.begin_stroke(stroke_->name());
    begun_ = true;
    dabs_waited_s_ = owed_s_;
    std::vector<Dab> dabs = stroke_->move(view, at, std::exchange(owed_s_, 0), simulation.stamp().get());
    for (Dab& dab : dabs) {
        // What a frame has no room for erodes more slowly.
        if (auto* erode = dab.as<ErodeDab>())
            erode->time_s = std::min(erode->time_s, erode_longest_s(simulation.terrain().grid(), dab));
        simulation.apply(dab);
    }
    dabs_ += static_cast<int>(dabs.size());
}

void Sculpting::end(Simulation& simulation, const Parameters& view) {
    if (!stroke_) return;
    while (simulation.mid_tick()) simulation.advance(1 << 20);
    if (owed_s_ > 0) move(simulation, view, stroke_->at(), 0);
    const std::optional<Dab> last = stroke_->end(view);
    stroke_.reset();
    if (last) simulation.apply(*last);
    simulation.end_entry();
}

render::Ring Sculpting::ring(const Simulation& simulation, const Parameters& view, glm::dvec2 at_m) {
    render::Ring ring;
    ring.at_m = at_m;
    ring.radius_m = view.number("brush.radius_m");
    const std::shared_ptr<const Stamp>& stamp = simulation.stamp();
    if (!stamp || tool_named(view.choice("brush.tool")).course != StrokeCourse::stamps) return ring;
    const Dab dab = tool_dab(view, {}, 0, 0, stamp.get());
    const DabNumbers numbers =
        dab_numbers(simulation.terrain().grid(), dab, {stamp->grid.nx, stamp->grid.ny});
    ring.radius_m = dab.radius_m;
    ring.stamp = &stamp_image_.of(stamp);
    // A dab counts rows southwards.
    ring.stamp_columns = {numbers.stamp_columns.x, -numbers.stamp_columns.y};
    ring.stamp_rows = {numbers.stamp_rows.x, -numbers.stamp_rows.y};
    return ring;
}

}  // namespace talus::app
