#include "sim/journal.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "sim/gpu/error.h"

namespace talus {
namespace {

using nlohmann::json;

template <typename Enum>
const std::string& name_in(const std::vector<std::string>& names, Enum value) {
    return names[static_cast<std::size_t>(value)];
}

template <typename Enum>
Enum value_in(const std::vector<std::string>& names, const json& name, const char* what) {
    const auto found = std::find(names.begin(), names.end(), name.get<std::string>());
    if (found == names.end()) throw Error(fmt::format("unknown {} '{}'", what, name.get<std::string>()));
    return static_cast<Enum>(found - names.begin());
}

json to_json(const Source& source) {
    return {{"path", source.path},
            {"import", source.import_guess},
            {"hash", fmt::format("{:016x}", source.hash)}};
}

Source to_source(const json& line) {
    return {line.at("path"), line.at("import"), std::stoull(line.at("hash").get<std::string>(), nullptr, 16)};
}

json to_json(const Rectangle& r) {
    return {{"west_m", r.west_m}, {"south_m", r.south_m}, {"east_m", r.east_m}, {"north_m", r.north_m}};
}

Rectangle to_rectangle(const json& line) {
    return {line.at("west_m"), line.at("south_m"), line.at("east_m"), line.at("north_m")};
}

// What every dab has, and what its mode needs besides.
json to_json(const Dab& dab) {
    json line = {{"op", "dab"},
                 {"mode", name_in(brush_mode_names(), dab.mode)},
                 {"x_m", dab.x_m},
                 {"y_m", dab.y_m},
                 {"radius_m", dab.radius_m},
                 {"falloff", dab.falloff},
                 {"amount_m", dab.amount_m},
                 {"blend", dab.blend},
                 {"target_m", dab.target_m},
                 {"material", name_in(material_names(), dab.material)}};
    if (dab.curve != FalloffCurve::smooth) line["curve"] = name_in(falloff_curve_names(), dab.curve);
    if (dab.masked) line["masked"] = true;
    if (dab.mode == BrushMode::ramp) {
        line["way_m"] = {dab.way_m.x, dab.way_m.y};
        line["rise_m"] = dab.rise_m;
    }
    if (dab.mode == BrushMode::terrace) {
        line["step_m"] = dab.step_m;
        line["flat"] = dab.flat;
    }
    if (dab.mode == BrushMode::noise)
        line["noise"] = {{"kind", name_in(noise_kind_names(), dab.noise.kind)},
                         {"wavelength_m", dab.noise.wavelength_m},
                         {"octaves", dab.noise.octaves},
                         {"gain", dab.noise.gain},
                         {"warp", dab.noise.warp},
                         {"seed", dab.noise.seed}};
    if (dab.mode == BrushMode::stamp)
        line["stamp"] = {{"mode", name_in(stamp_mode_names(), dab.stamp.mode)},
                         {"half_m", {dab.stamp.half_m.x, dab.stamp.half_m.y}},
                         {"turn_deg", dab.stamp.turn_deg},
                         {"mirrored", dab.stamp.mirrored},
                         {"zero", dab.stamp.zero}};
    if (dab.mode == BrushMode::erode)
        line["erode"] = {{"rain_mm_per_h", dab.erode.rain_mm_per_h},
                         {"time_s", dab.erode.time_s},
                         {"acceleration", dab.erode.acceleration},
                         {"begins", dab.erode.begins},
                         {"ends", dab.erode.ends}};
    return line;
}

Dab to_dab(const json& line) {
    Dab dab;
    dab.mode = value_in<BrushMode>(brush_mode_names(), line.at("mode"), "brush mode");
    dab.x_m = line.at("x_m");
    dab.y_m = line.at("y_m");
    dab.radius_m = line.at("radius_m");
    dab.falloff = line.at("falloff");
    dab.amount_m = line.at("amount_m");
    dab.blend = line.at("blend");
    dab.target_m = line.at("target_m");
    // Journals of 0.1.0 say on_regolith.
    const char* otherwise = line.value("on_regolith", false) ? "regolith" : "bedrock";
    dab.material = value_in<Material>(material_names(), line.value("material", otherwise), "material");
    dab.curve = value_in<FalloffCurve>(falloff_curve_names(), line.value("curve", "smooth"), "falloff curve");
    dab.masked = line.value("masked", false);
    if (line.contains("way_m")) dab.way_m = {line["way_m"].at(0), line["way_m"].at(1)};
    dab.rise_m = line.value("rise_m", 0.0);
    dab.step_m = line.value("step_m", 1.0);
    dab.flat = line.value("flat", 0.5);
    if (line.contains("noise")) {
        const json& noise = line["noise"];
        dab.noise = {value_in<int>(noise_kind_names(), noise.at("kind"), "noise"),
                     noise.at("wavelength_m"),
                     noise.at("octaves"),
                     noise.at("gain"),
                     noise.at("warp"),
                     noise.at("seed")};
    }
    if (line.contains("stamp")) {
        const json& stamp = line["stamp"];
        dab.stamp.mode = value_in<StampMode>(stamp_mode_names(), stamp.at("mode"), "stamp mode");
        dab.stamp.half_m = {stamp.at("half_m").at(0), stamp.at("half_m").at(1)};
        dab.stamp.turn_deg = stamp.at("turn_deg");
        dab.stamp.mirrored = stamp.at("mirrored");
        // Older journals stand stamps on their lowest sample.
        dab.stamp.zero = stamp.value("zero", 0.0);
    }
    if (line.contains("erode")) {
        const json& erode = line["erode"];
        dab.erode = {erode.at("rain_mm_per_h"), erode.at("time_s"), erode.at("acceleration"),
                     erode.at("begins"), erode.at("ends")};
    }
    check_dab(dab);
    return dab;
}

struct Writer {
    json operator()(const Ticks& ticks) const { return {{"op", "ticks"}, {"count", ticks.count}}; }
    json operator()(const Dab& dab) const { return to_json(dab); }
    json operator()(const SetParameter& set) const {
        json line = {{"op", "set"}, {"name", set.name}};
        line["value"] = nullptr;
        if (set.value) std::visit([&](const auto& v) { line["value"] = v; }, *set.value);
        return line;
    }
    json operator()(const PlaceSpring& spring) const {
        return {{"op", "spring"},
                {"x_m", spring.x_m},
                {"y_m", spring.y_m},
                {"rate_m3_per_s", spring.rate_m3_per_s}};
    }
    json operator()(const Resample& to) const { return {{"op", "resample"}, {"nx", to.nx}, {"ny", to.ny}}; }
    json operator()(const Crop& crop) const {
        return {{"op", "crop"}, {"rectangle", to_json(crop.rectangle)}};
    }
    json operator()(const Turn& turn) const { return {{"op", "turn"}, {"quarters", turn.quarters}}; }
    json operator()(const Import& import) const {
        return {{"op", "import"}, {"source", to_json(import.source)}};
    }
    json operator()(const ChooseStamp& choose) const {
        if (choose.source.path.empty()) return {{"op", "stamp"}, {"piece", to_json(choose.piece)}};
        return {{"op", "stamp"}, {"source", to_json(choose.source)}};
    }
    json operator()(const MakeMask& make) const {
        return {{"op", "mask"},
                {"from", name_in(mask_source_names(), make.source)},
                {"low", make.low},
                {"high", make.high},
                {"fade", make.fade},
                {"join", name_in(mask_join_names(), make.join)},
                {"inverted", make.inverted}};
    }
    json operator()(const Blur& blur) const {
        return {{"op", "blur"},
                {"deviation_m", blur.deviation_m},
                {"of", blur.of_mask ? "mask" : "ground"},
                {"masked", blur.masked}};
    }
};

Operation to_operation(const json& line) {
    const std::string op = line.at("op");
    if (op == "ticks") {
        const std::int64_t count = line.at("count");
        if (count < 0 || count > 1000000000) throw Error("count must be 0 to 1000000000");
        return Ticks{count};
    }
    if (op == "set") {
        const json& value = line.at("value");
        const std::string name = line.at("name");
        if (value.is_null()) return SetParameter{name, std::nullopt};
        if (value.is_boolean()) return SetParameter{name, value.get<bool>()};
        if (value.is_number()) return SetParameter{name, value.get<double>()};
        return SetParameter{name, value.get<std::string>()};
    }
    if (op == "spring") return PlaceSpring{line.at("x_m"), line.at("y_m"), line.at("rate_m3_per_s")};
    if (op == "resample") return Resample{line.at("nx"), line.at("ny")};
    if (op == "crop") return Crop{to_rectangle(line.at("rectangle"))};
    if (op == "turn") return Turn{line.at("quarters")};
    if (op == "import") return Import{to_source(line.at("source")), nullptr};
    if (op == "stamp") {
        ChooseStamp choose;
        if (line.contains("source"))
            choose.source = to_source(line.at("source"));
        else
            choose.piece = to_rectangle(line.at("piece"));
        return choose;
    }
    if (op == "mask")
        return MakeMask{value_in<MaskSource>(mask_source_names(), line.at("from"), "mask"),
                        line.at("low"),
                        line.at("high"),
                        line.at("fade"),
                        value_in<MaskJoin>(mask_join_names(), line.at("join"), "way to join masks"),
                        line.at("inverted")};
    if (op == "blur")
        return Blur{line.at("deviation_m"), line.at("of") == "mask", line.at("masked").get<bool>()};
    if (op == "dab") return to_dab(line);
    throw Error(fmt::format("unknown operation '{}'", op));
}

}  // namespace

void Journal::record(const Operation& operation) {
    ++revision_;
    if (const auto* ticks = std::get_if<Ticks>(&operation); ticks && !operations_.empty())
        if (auto* last = std::get_if<Ticks>(&operations_.back())) {
            last->count += ticks->count;
            return;
        }
    operations_.push_back(operation);
    // What was made of the terrain, or came from files, is there again when it is replayed: it need not stay
    // here.
    forget_made(operations_.back());
}

Journal::Mark Journal::mark() const {
    return {operations_.size(), operations_.empty() ? Operation(Ticks{0}) : operations_.back()};
}

std::vector<Operation> Journal::cut(const Mark& mark) {
    ++revision_;
    // The tail begins with the operation that stood last at the mark, as it is now.
    const auto from = operations_.begin() + static_cast<std::ptrdiff_t>(mark.count > 0 ? mark.count - 1 : 0);
    std::vector<Operation> tail(from, operations_.end());
    operations_.resize(mark.count);
    if (mark.count > 0) operations_.back() = mark.last;
    return tail;
}

void Journal::restore(const Mark& mark, const std::vector<Operation>& tail) {
    ++revision_;
    operations_.resize(mark.count > 0 ? mark.count - 1 : 0);
    operations_.insert(operations_.end(), tail.begin(), tail.end());
}

std::string write_journal(const JournalStart& start, const Journal& journal) {
    std::string text = json{{"talus_journal", 1},
                            {"input", start.input},
                            {"import", start.import_guess},
                            {"parameters", start.parameters},
                            {"hash", fmt::format("{:016x}", start.hash)}}
                           .dump(-1, ' ', false, json::error_handler_t::replace) +
                       '\n';
    for (const Operation& operation : journal.operations())
        text += std::visit(Writer(), operation).dump() + '\n';
    return text;
}

JournalFile read_journal(const std::string& text, const std::string& source) {
    JournalFile file;
    std::istringstream lines(text);
    std::string line;
    for (int at = 1; std::getline(lines, line); ++at) {
        try {
            const json parsed = json::parse(line);
            if (at > 1) {
                file.operations.push_back(to_operation(parsed));
                continue;
            }
            if (parsed.at("talus_journal").get<int>() != 1) throw Error("a journal of another version");
            file.start.input = parsed.at("input");
            file.start.import_guess = parsed.at("import");
            file.start.parameters = parsed.at("parameters");
            file.start.hash = std::stoull(parsed.at("hash").get<std::string>(), nullptr, 16);
        } catch (const std::exception& error) {
            throw Error(
                fmt::format("{}: line {} is not part of a Talus journal: {}", source, at, error.what()));
        }
    }
    if (line.empty() && text.empty())
        throw Error(fmt::format("{}: is empty where a Talus journal was expected", source));
    return file;
}

}  // namespace talus
