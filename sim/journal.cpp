#include "sim/journal.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "sim/error.h"
#include "sim/events.h"

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

struct WriteField {
    json& line;
    template <typename Number>
    void operator()(const char* name, Number value, double, double) const {
        line[name] = value;
    }
    void operator()(const char* name, glm::dvec2 pair, double, double) const {
        line[name] = {pair.x, pair.y};
    }
    void operator()(const char* name, const std::vector<glm::dvec3>& points, double, double) const {
        line[name] = json::array();
        for (const glm::dvec3& point : points) line[name].push_back({point.x, point.y, point.z});
    }
    template <typename Choice>
    void operator()(const char* name, Choice choice, const std::vector<std::string>& names) const {
        line[name] = name_in(names, choice);
    }
    void operator()(const char* name, bool on) const { line[name] = on; }
};

json to_json(const Dab& dab) {
    const std::string& mode = brush_mode_names()[dab.effect.index()];
    json line = {{"op", "dab"}, {"mode", mode}};
    visit_footprint(dab, WriteField{line});
    visit_own(dab, WriteField{has_object(dab.effect) ? line[mode] : line});
    return line;
}

// Leaves what is missing as it is: choices and switches came later than the numbers.
struct ReadField {
    const json& line;
    bool all_numbers;  // must be there
    template <typename Number>
    void operator()(const char* name, Number& value, double, double) const {
        if (all_numbers || line.contains(name)) value = line.at(name).get<Number>();
    }
    void operator()(const char* name, glm::dvec2& pair, double, double) const {
        if (all_numbers || line.contains(name)) pair = {line.at(name).at(0), line.at(name).at(1)};
    }
    void operator()(const char* name, std::vector<glm::dvec3>& points, double, double) const {
        points.clear();
        for (const json& point : line.at(name)) points.emplace_back(point.at(0), point.at(1), point.at(2));
    }
    template <typename Choice>
    void operator()(const char* name, Choice& choice, const std::vector<std::string>& names) const {
        if (line.contains(name)) choice = value_in<Choice>(names, line.at(name), name);
    }
    void operator()(const char* name, bool& on) const { on = line.value(name, on); }
};

Dab to_dab(const json& line) {
    Dab dab;
    const std::string mode = line.at("mode");
    dab.effect = effect_of(value_in<BrushMode>(brush_mode_names(), mode, "brush mode"));
    // Journals of 0.1.0 say on_regolith.
    if (line.value("on_regolith", false)) dab.material = Material::regolith;
    visit_footprint(dab, ReadField{line, true});
    if (!has_object(dab.effect)) {
        visit_own(dab, ReadField{line, false});
    } else {
        json own = line.at(mode);
        // Older journals stand stamps on their lowest sample.
        if (dab.as<StampDab>() && !own.contains("zero")) own["zero"] = 0.0;
        visit_own(dab, ReadField{own, true});
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
    json operator()(const DriveParameter& drive) const {
        json rows = json::array();
        for (const TimeSeries::Row& row : drive.series.rows()) rows.push_back({row.time_s, row.value});
        return {{"op", "drive"}, {"name", drive.parameter}, {"rows", rows}};
    }
    json operator()(const SetEvents& set) const {
        return {{"op", "events"}, {"events", to_text(set.events)}};
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
        json line = {{"op", "mask"},
                     {"from", name_in(mask_source_names(), make.source)},
                     {"low", make.low},
                     {"high", make.high},
                     {"fade", make.fade},
                     {"join", name_in(mask_join_names(), make.join)},
                     {"inverted", make.inverted}};
        if (make.source == MaskSource::rectangle) line["rectangle"] = to_json(make.rectangle);
        return line;
    }
    json operator()(const TakeRaster& take) const {
        return {{"op", "raster"}, {"number", take.number}, {"source", to_json(take.source)}};
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
    if (op == "drive") {
        std::vector<TimeSeries::Row> rows;
        rows.reserve(line.at("rows").size());
        for (const json& row : line.at("rows")) rows.push_back({row.at(0), row.at(1)});
        return DriveParameter{line.at("name"), rows.empty() ? TimeSeries() : TimeSeries(std::move(rows))};
    }
    if (op == "events") return SetEvents{events_from_text(line.at("events").get<std::string>())};
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
                        line.at("inverted"),
                        line.contains("rectangle") ? to_rectangle(line.at("rectangle")) : Rectangle()};
    if (op == "raster")
        return TakeRaster{painted_number_named(line.at("number")).name, to_source(line.at("source")),
                          nullptr};
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
    json first = {{"talus_journal", 1},
                  {"input", start.input},
                  {"import", start.import_guess},
                  {"parameters", start.parameters},
                  {"hash", fmt::format("{:016x}", start.hash)}};
    if (!start.events.empty()) first["events"] = start.events;
    if (!start.ended_tables.empty()) first["ended_tables"] = start.ended_tables;
    std::string text = first.dump(-1, ' ', false, json::error_handler_t::replace) + '\n';
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
            file.start.events = parsed.value("events", std::string());
            file.start.ended_tables = parsed.value("ended_tables", std::vector<std::string>());
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
