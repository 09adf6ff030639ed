#include "app/tools/brush_stroke.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/operation.h"

namespace talus::app {

Dab tool_dab(const Parameters& view, const Modifiers& modifiers, double ground_m, double wall_s,
             const Stamp* stamp) {
    const Tool& tool = tool_named(modifiers.smooth ? "smooth" : view.choice("brush.tool"));
    Dab dab;
    dab.radius_m = view.number("brush.radius_m");
    dab.falloff = view.number("brush.falloff");
    dab.curve = view.choice_as<FalloffCurve>("brush.curve");
    dab.masked = tool.limited_by_mask && view.choice("brush.over") == "mask";
    dab.amount_m = view.number("brush.rate_m_per_s") * wall_s;
    dab.blend = -std::expm1(-view.number("brush.blend_per_s") * wall_s);
    dab.material = view.choice_as<Material>("brush.material");
    dab.target_m = ground_m;
    tool.shape({view, modifiers.inverted, ground_m, wall_s, stamp}, dab);
    return dab;
}

BrushStroke::BrushStroke(const Parameters& view, const Modifiers& modifiers, glm::dvec3 at, unsigned number)
    : modifiers_(modifiers),
      tool_(&tool_named(modifiers.smooth ? "smooth" : view.choice("brush.tool"))),
      begin_(at),
      at_(at),
      random_(static_cast<unsigned>(view.whole("brush.seed")) * 7919U + number) {
    name_ = tool_->history_name.empty() ? name_of(tool_dab(view, modifiers, at.z, 0, nullptr))
                                        : tool_->history_name;
}

const Parameters& BrushStroke::settings(const Parameters& view) {
    if (tool_->course == StrokeCourse::flows) {
        if (!held_) held_ = view;
        return *held_;
    }
    if (modifiers_.smooth || view.choice("brush.tool") == tool_->name) return view;
    held_ = view;
    held_->set("brush.tool", tool_->name);
    return *held_;
}

double BrushStroke::unit() {
    return random_() / 4294967296.0;
}

Dab BrushStroke::jittered(const Parameters& view, Dab dab, glm::dvec2 place) {
    // Water that jumps about would be cut off on the way.
    const double jitter = tool_->course == StrokeCourse::flows ? 0 : view.number("brush.jitter");
    const double reach_m = jitter * view.number("brush.radius_m");
    if (reach_m > 0) {
        // A point of the disc, by rejection: without sine or cosine.
        glm::dvec2 offset(1);
        while (glm::dot(offset, offset) > 1) {
            offset.x = 2 * unit() - 1;
            offset.y = 2 * unit() - 1;
        }
        place += reach_m * offset;
    }
    dab.x_m = place.x;
    dab.y_m = place.y;
    return dab;
}

std::vector<Dab> BrushStroke::move(const Parameters& present, glm::dvec3 at, double wall_s,
                                   const Stamp* stamp) {
    const Parameters& view = settings(present);
    const double spacing_m = view.number("brush.spacing") * view.number("brush.radius_m");
    std::vector<Dab> dabs;
    // Each dab of erosion runs solvers: a few of them follow the hand.
    const int most = tool_->course == StrokeCourse::flows ? 3 : 64;
    if (tool_->course == StrokeCourse::at_end) {
        at_ = at;
        return dabs;
    }
    if (tool_->course == StrokeCourse::stamps) {
        // One where the stroke begins, then one a spacing further each.
        const Dab dab = tool_dab(view, modifiers_, begin_.z, 0, stamp);
        if (!stamped_) {
            stamped_ = glm::dvec2(begin_);
            dabs.push_back(jittered(view, dab, *stamped_));
        }
        while (glm::distance(*stamped_, glm::dvec2(at)) >= spacing_m &&
               static_cast<int>(dabs.size()) < most) {
            *stamped_ += spacing_m * glm::normalize(glm::dvec2(at) - *stamped_);
            dabs.push_back(jittered(view, dab, *stamped_));
        }
        at_ = at;
        return dabs;
    }
    const double way_m = glm::distance(glm::dvec2(at), glm::dvec2(at_));
    const int count = std::clamp(static_cast<int>(std::ceil(way_m / spacing_m)), 1, most);
    Dab dab = tool_dab(view, modifiers_, begin_.z, wall_s / count, stamp);
    for (int i = 1; i <= count; ++i) {
        // The water of a stroke goes on from dab to dab.
        if (auto* erode = dab.as<ErodeDab>()) {
            erode->begins = !std::exchange(begun_, true);
            erode->ends = false;
        }
        dabs.push_back(jittered(view, dab, at_ + (at - at_) * (static_cast<double>(i) / count)));
    }
    at_ = at;
    return dabs;
}

std::optional<Dab> BrushStroke::end(const Parameters& present) {
    if (tool_->course != StrokeCourse::at_end && tool_->course != StrokeCourse::flows) return std::nullopt;
    const Parameters& view = settings(present);
    Dab dab = tool_dab(view, modifiers_, begin_.z, 0, nullptr);
    if (tool_->course == StrokeCourse::flows) {
        if (!begun_) return std::nullopt;
        dab.x_m = at_.x;
        dab.y_m = at_.y;
        if (auto* erode = dab.as<ErodeDab>()) erode->begins = false;
        return dab;
    }
    dab.x_m = begin_.x;
    dab.y_m = begin_.y;
    if (auto* ramp = dab.as<RampDab>()) *ramp = {glm::dvec2(at_) - glm::dvec2(begin_), at_.z - begin_.z};
    return dab;
}

}  // namespace talus::app
