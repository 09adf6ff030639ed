#include "app/tools/brush_stroke.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/operation.h"

namespace talus {
const std::vector<std::string>& tool_names() {
    static const std::vector<std::string> names = {"raise", "lower", "smooth",   "flatten", "height",
                                                   "ramp",  "noise", "terrace",  "stamp",   "erode",
                                                   "water", "rain",  "hardness", "mask"};
    return names;
}

const char* strength_of(const std::string& tool) {
    if (tool == "raise" || tool == "lower" || tool == "noise" || tool == "water") return "brush.rate_m_per_s";
    if (tool == "erode") return "erode.acceleration";
    if (tool == "stamp") return "stamp.relief_m";
    return tool == "ramp" ? nullptr : "brush.blend_per_s";
}

Dab tool_dab(const Parameters& view, const Modifiers& modifiers, double ground_m, double wall_s,
             const Stamp* stamp) {
    const std::string& tool = modifiers.smooth ? "smooth" : view.choice("brush.tool");
    Dab dab;
    dab.radius_m = view.number("brush.radius_m");
    dab.falloff = view.number("brush.falloff");
    dab.curve = view.choice_as<FalloffCurve>("brush.curve");
    dab.masked = view.choice("brush.over") == "mask" && tool != "mask";
    dab.amount_m = view.number("brush.rate_m_per_s") * wall_s;
    dab.blend = -std::expm1(-view.number("brush.blend_per_s") * wall_s);
    dab.material = view.choice("brush.material") == "regolith" ? Material::regolith : Material::bedrock;
    dab.target_m = ground_m;
    const auto paint = [&](Material material, double value) {
        dab.material = material;
        dab.mode = modifiers.inverted ? BrushMode::lower : BrushMode::raise;
        dab.target_m = modifiers.inverted ? 0 : value;
    };
    if (tool == "raise" || tool == "lower") {
        dab.mode = (tool == "lower") != modifiers.inverted ? BrushMode::lower : BrushMode::raise;
    } else if (tool == "smooth") {
        dab.mode = BrushMode::smooth;
    } else if (tool == "flatten") {
        dab.mode = BrushMode::flatten;
    } else if (tool == "height") {
        dab.mode = BrushMode::flatten;
        dab.target_m = view.number("brush.height_m");
    } else if (tool == "ramp") {
        dab.mode = BrushMode::ramp;
        dab.blend = 1;
    } else if (tool == "noise") {
        dab.mode = BrushMode::noise;
        if (modifiers.inverted) dab.amount_m = -dab.amount_m;
        dab.noise = {view.choice_as<int>("noise.kind"), view.number("noise.wavelength_m"),
                     view.whole("noise.octaves"),       view.number("noise.gain"),
                     view.number("noise.warp"),         static_cast<std::uint32_t>(view.whole("noise.seed"))};
    } else if (tool == "terrace") {
        dab.mode = BrushMode::terrace;
        dab.target_m = 0;
        dab.step_m = view.number("terrace.step_m");
        dab.flat = view.number("terrace.flat");
    } else if (tool == "stamp") {
        dab.mode = BrushMode::stamp;
        dab.blend = 1;
        dab.amount_m =
            view.is_given("stamp.relief_m") || !stamp ? view.number("stamp.relief_m") : stamp->relief_m;
        if (modifiers.inverted) dab.amount_m = -dab.amount_m;
        dab.stamp.mode = view.choice_as<StampMode>("stamp.mode");
        dab.stamp.turn_deg = view.number("stamp.turn_deg");
        dab.stamp.mirrored = view.toggle("stamp.mirrored");
        // The longer side is as wide as the brush; the corners lie within its reach.
        dab.stamp.half_m = glm::dvec2(dab.radius_m);
        if (stamp) {
            dab.stamp.zero = zero_of(*stamp, view.choice_as<StampZero>("stamp.zero"));
            const glm::dvec2 size(stamp->grid.width_m(), stamp->grid.height_m());
            dab.stamp.half_m = dab.radius_m * size / std::max(size.x, size.y);
        }
        dab.radius_m = 1.001 * glm::length(dab.stamp.half_m);
    } else if (tool == "erode") {
        dab.mode = BrushMode::erode;
        dab.erode.rain_mm_per_h = view.number("erode.rain");
        dab.erode.acceleration = view.number("erode.acceleration");
        // That of a click ends when its load has settled.
        constexpr double shortest_s = 1e-3;
        dab.erode.time_s = std::max(view.number("erode.speed") * wall_s, shortest_s);
    } else if (tool == "water") {
        dab.material = Material::water;
        dab.mode = modifiers.inverted ? BrushMode::lower : BrushMode::raise;
    } else if (tool == "rain") {
        paint(Material::rain, view.number("brush.rain"));
    } else if (tool == "hardness") {
        paint(Material::hardness, view.number("brush.value"));
    } else {
        paint(Material::mask, view.number("brush.value"));
    }
    return dab;
}

BrushStroke::BrushStroke(const Parameters& view, const Modifiers& modifiers, glm::dvec3 at, unsigned number)
    : modifiers_(modifiers),
      tool_(modifiers.smooth ? "smooth" : view.choice("brush.tool")),
      begin_(at),
      at_(at),
      random_(static_cast<unsigned>(view.whole("brush.seed")) * 7919U + number) {
    // As an operation of its own would be called, but for the tools that share a mode.
    const Dab dab = tool_dab(view, modifiers, at.z, 0, nullptr);
    name_ = tool_ == "height" ? tool_ : name_of(dab);
}

const Parameters& BrushStroke::settings(const Parameters& view) {
    if (tool_ == "erode") {
        if (!held_) held_ = view;
        return *held_;
    }
    if (modifiers_.smooth || view.choice("brush.tool") == tool_) return view;
    held_ = view;
    held_->set("brush.tool", tool_);
    return *held_;
}

double BrushStroke::unit() {
    return random_() / 4294967296.0;
}

Dab BrushStroke::jittered(const Parameters& view, Dab dab, glm::dvec2 place) {
    // Water that jumps about would be cut off on the way.
    const double jitter = tool_ == "erode" ? 0 : view.number("brush.jitter");
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
    const int most = tool_ == "erode" ? 3 : 64;
    if (tool_ == "ramp") {
        at_ = at;
        return dabs;
    }
    if (tool_ == "stamp") {
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
        dab.erode.begins = !std::exchange(begun_, true);
        dab.erode.ends = false;
        dabs.push_back(jittered(view, dab, at_ + (at - at_) * (static_cast<double>(i) / count)));
    }
    at_ = at;
    return dabs;
}

std::optional<Dab> BrushStroke::end(const Parameters& present) {
    if (tool_ != "ramp" && tool_ != "erode") return std::nullopt;
    const Parameters& view = settings(present);
    Dab dab = tool_dab(view, modifiers_, begin_.z, 0, nullptr);
    if (tool_ == "erode") {
        if (!begun_) return std::nullopt;
        dab.x_m = at_.x;
        dab.y_m = at_.y;
        dab.erode.begins = false;
        return dab;
    }
    dab.x_m = begin_.x;
    dab.y_m = begin_.y;
    dab.way_m = glm::dvec2(at_) - glm::dvec2(begin_);
    dab.rise_m = at_.z - begin_.z;
    return dab;
}

}  // namespace talus
