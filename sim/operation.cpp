#include "sim/operation.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "sim/terrain/blur.h"

namespace talus {
namespace {

std::string file_name(const Source& source) {
    return std::filesystem::path(source.path).filename().string();
}

struct Namer {
    std::string operator()(const Ticks&) const { return "run"; }
    std::string operator()(const Dab& dab) const {
        const bool takes = dab.as<LowerDab>() != nullptr;
        const std::string& material = material_names()[static_cast<std::size_t>(dab.material)];
        if (dab.is_water()) return takes ? "take water" : "add water";
        if (dab.is_paint()) return (takes ? "wipe " : "paint ") + material;
        if (const auto* path = dab.as<PathDab>())
            return path_kind_names()[static_cast<std::size_t>(path->kind)];
        return brush_mode_names()[dab.effect.index()];
    }
    std::string operator()(const SetParameter& set) const { return set.name; }
    std::string operator()(const PlaceSpring&) const { return "spring"; }
    std::string operator()(const DriveParameter& drive) const {
        return (drive.series.empty() ? "end table of " : "table of ") + drive.parameter;
    }
    std::string operator()(const SetEvents& set) const {
        const auto open = std::count_if(set.events.begin(), set.events.end(),
                                        [](const Event& event) { return !event.done; });
        return fmt::format("events: {} to come", open);
    }
    std::string operator()(const Resample& to) const {
        return fmt::format("resample to {} × {}", to.nx, to.ny);
    }
    std::string operator()(const Crop&) const { return "crop"; }
    std::string operator()(const Turn& turn) const {
        return fmt::format("rotate by {}°", 90 * turn.quarters);
    }
    std::string operator()(const Import& import) const { return "import " + file_name(import.source); }
    std::string operator()(const ChooseStamp& choose) const {
        const std::string& path = choose.source.path;
        if (path.starts_with(stamp_shelf)) return "stamp: " + label_of_name(path.substr(stamp_shelf.size()));
        return path.empty() ? "stamp from here" : "stamp " + file_name(choose.source);
    }
    std::string operator()(const MakeMask& make) const {
        return "mask: " + mask_source_names()[static_cast<std::size_t>(make.source)];
    }
    std::string operator()(const TakeRaster& take) const {
        return fmt::format("{} from {}", take.number, file_name(take.source));
    }
    std::string operator()(const Blur& blur) const { return blur.of_mask ? "mask: blur" : "blur"; }
};

}  // namespace

TerrainState made_of(const Resample& to, const TerrainState& state) {
    return resampled(state, to.nx, to.ny);
}

TerrainState made_of(const Crop& crop, const TerrainState& state) {
    return cropped(state, crop.rectangle);
}

TerrainState made_of(const Turn& turn, const TerrainState& state) {
    return turned(state, turn.quarters);
}

TerrainState made_of(const Blur& blur, const TerrainState& state) {
    return blur.of_mask ? with_blurred_mask(state, blur.deviation_m)
                        : with_blurred_ground(state, blur.deviation_m, blur.masked);
}

bool makes_terrain(const Operation& operation) {
    return std::visit(
        [](const auto& one) {
            return requires {
                made_of(one, TerrainState());
            };
        },
        operation);
}

Operation made_ready(Operation operation, const TerrainState& state) {
    std::visit(
        [&](auto& one) {
            if constexpr (requires { made_of(one, state); })
                one.made = std::make_shared<TerrainState>(made_of(std::as_const(one), state));
        },
        operation);
    return operation;
}

void forget_made(Operation& operation) {
    std::visit(
        [](auto& one) {
            if constexpr (requires { one.made.reset(); }) one.made.reset();
            if constexpr (requires { one.state.reset(); }) one.state.reset();
            if constexpr (requires { one.stamp.reset(); }) one.stamp.reset();
            if constexpr (requires { one.values.reset(); }) one.values.reset();
        },
        operation);
}

std::string name_of(const Operation& operation) {
    return std::visit(Namer(), operation);
}

}  // namespace talus
